// One orbit in several descriptions: other sections, repetitions, events put in and taken out.

#include "methods/orbit/family/sequenced_orbit.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "methods/orbit/family/orbit_section.hpp"
#include "tests/methods/orbit/closed_form_guess.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::sequenced_orbit_test {
namespace {

const test::ImpactOscillator kOscillator{.damping = 0.1, .frequency = 2.6, .gap = 0.2, .order = 2};

class DescriptionsOfAnOrbit : public testing::Test {
 protected:
  DescriptionsOfAnOrbit() : family_(over_frequency(test::to_problem(kOscillator), 2.0, 3.0)) {
    const auto orbit = test::single_impact_orbits(kOscillator).at(0);
    orbit_ = sequenced(family_, test::closed_form_guess(orbit, 0.3), orbit.period, kOscillator.frequency,
                       kOscillator.frequency);
  }
  double residual(const SequencedOrbit& orbit) {
    ExtendedEquations equations(family_, orbit);
    return equations.evaluate(orbit.x) ? equations.residual().lpNorm<Eigen::Infinity>() : 1.0;
  }
  SequencedOrbit moved(const SequencedOrbit& orbit, double phase) {
    ExtendedEquations equations(family_, orbit);
    EXPECT_TRUE(equations.evaluate(orbit.x));
    return with_section(orbit, equations, phase);
  }

  OrbitFamily family_;
  SequencedOrbit orbit_;
};

TEST_F(DescriptionsOfAnOrbit, AllSolveTheEquations) {
  EXPECT_EQ(orbit_.order, 2);
  EXPECT_LT(residual(orbit_), 1e-12);
  for (const double phase : {0.1, 3.0, 6.0, 12.0}) EXPECT_LT(residual(moved(orbit_, phase)), 1e-12) << phase;
  EXPECT_LT(residual(repeated(orbit_, 3)), 1e-11);
  EXPECT_LT(residual(moved(repeated(orbit_, 2), 17.0)), 1e-11);
}

TEST_F(DescriptionsOfAnOrbit, AreTheSameAgainAfterAWholePeriod) {
  const SequencedOrbit away = moved(orbit_, 5.0), back = moved(away, orbit_.end() - 5.0);
  EXPECT_LT((back.x - orbit_.x).lpNorm<Eigen::Infinity>(), 1e-12);
  EXPECT_NEAR(back.section, orbit_.section, 1e-12);
}

TEST_F(DescriptionsOfAnOrbit, HaveOneLeastPeriod) {
  const SequencedOrbit six = repeated(orbit_, 3);
  EXPECT_EQ(six.order, 6);
  EXPECT_EQ(six.count(), 3);
  ExtendedEquations equations(family_, six);
  ASSERT_TRUE(equations.evaluate(six.x));
  const SequencedOrbit least = of_least_period(six, equations);
  EXPECT_EQ(least.order, 2);
  EXPECT_LT((least.x - orbit_.x).lpNorm<Eigen::Infinity>(), 1e-12);
  ExtendedEquations own(family_, orbit_);
  ASSERT_TRUE(own.evaluate(orbit_.x));
  EXPECT_EQ(of_least_period(orbit_, own).order, 2);  // not a repetition of order 1
}

TEST_F(DescriptionsOfAnOrbit, TakeEventsInOrderAndGiveThemBack) {
  const SequencedOrbit more = with_more(orbit_, {{11.0, orbit_.events[0]}, {0.5, orbit_.events[0]}});
  ASSERT_EQ(more.count(), 3);
  EXPECT_EQ(more.phase(0), 0.5);
  EXPECT_EQ(more.phase(1), orbit_.phase(0));
  EXPECT_EQ(more.phase(2), 11.0);
  EXPECT_EQ(without_event(without_event(more, 2), 0).x, orbit_.x);
  EXPECT_EQ(describe_sequence(more), "order 2, events I0 I0 I0");
}

TEST_F(DescriptionsOfAnOrbit, TakePhasesOfContactAndBreaksOfThem) {
  const SequencedOrbit pressed = with_contact_phase(orbit_, 0, 2.0);
  EXPECT_EQ(describe_sequence(pressed), "order 2, events C0 O0 I0");
  EXPECT_TRUE(pressed.events[0].closed[0]);
  EXPECT_FALSE(pressed.events[1].closed[0]);
  SequencedOrbit longer = pressed;
  longer.x[longer.states() + 1] = 3.0;
  const SequencedOrbit broken = with_contact_phase(longer, 0, 2.5);
  EXPECT_EQ(describe_sequence(broken), "order 2, events C0 O0 C0 O0 I0");
  EXPECT_TRUE(broken.events[2].closed[0]);
  EXPECT_FALSE(broken.events[3].closed[0]);
}

TEST_F(DescriptionsOfAnOrbit, HaveTheirQuietPhaseFarFromEvents) {
  const double phase = quiet_phase(orbit_);
  const SequencedOrbit quiet = moved(orbit_, phase);
  EXPECT_NEAR(quiet.phase(0), 0.5 * orbit_.end(), 1e-12);
}

TEST(ContactFreeOrbit, IsTheReceptance) {
  OrbitFamily family(over_frequency(test::to_problem(kOscillator), 2.0, 3.0));
  const SequencedOrbit orbit = contact_free_orbit(family, 2.5).value();
  const std::complex<double> u = 1.0 / std::complex<double>(1.0 - 2.5 * 2.5, 0.1 * 2.5);
  EXPECT_NEAR(orbit.x[0] * family.units().displacement, u.real(), 1e-14);
  EXPECT_NEAR(orbit.x[1] * family.units().velocity, -2.5 * u.imag(), 1e-14);
  // Undamped at resonance there is none.
  OrbitFamily resonant(over_frequency(test::to_problem({.damping = 0.0, .gap = 1.0}), 0.5, 2.0));
  EXPECT_FALSE(contact_free_orbit(resonant, 1.0));
}

}  // namespace
}  // namespace signorini::sequenced_orbit_test
