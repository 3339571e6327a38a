#include "harness/judge/measures/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "harness/judge/measures/contact_response.hpp"
#include "methods/structure/periodic_response.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/support/damped_chain.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::measures_test {
namespace {

using test::FormulaMotion;

constexpr double kPi = std::numbers::pi;
constexpr double kPeriod = kPi;  // of one_mass(): omega = 2

/// A motion of a problem driven as one_mass() is.
Motion sampled(const Trajectory& motion) { return sample_motion(test::one_mass(), motion); }

Motion sine(double mean, double size) {
  return sampled(FormulaMotion(
      kPeriod, [=](double t) { return mean + size * std::sin(2.0 * t); },
      [=](double t) { return 2.0 * size * std::cos(2.0 * t); }));
}

TEST(MeasurePhysics, FindsThePenetrationOfASine) {
  // mean 0.1 m, amplitude 0.4 m, stop at 0.3 m: 0.2 m deep.
  const Physics physics = measure_physics(test::one_mass(0.3), Restitution{1.0}, sine(0.1, 0.4));
  EXPECT_NEAR(physics.penetration.value(), 0.5, 1e-12);
  // Without force, |min(0, g - x)| is the part above the stop: (1/pi)(A cos a - d (pi/2 - a)), a = asin(d/A),
  // d = 0.2.
  const double a = std::asin(0.5);
  const double mean = (0.4 * std::cos(a) - 0.2 * (kPi / 2.0 - a)) / kPi;
  EXPECT_NEAR(physics.complementarity.value(), mean / 0.4, 1e-6);
  EXPECT_EQ(physics.contact_ratio.value(), 0.0);
  EXPECT_TRUE(physics.effective_restitution.empty());
}

TEST(MeasurePhysics, MeasuresAContactAtRestByTheContactFreeMotion) {
  // |F / (k - m w^2 + i d w)| = 1 / |-3 + 0.2 i|, so the contact-free motion gets 0.3 m + that from the stop.
  const double scale = 0.1 * (0.3 + 1.0 / std::hypot(3.0, 0.2));
  const Physics physics = measure_physics(test::one_mass(0.3), Restitution{1.0}, sine(0.3 + 1e-9, 0.0));
  EXPECT_NEAR(physics.penetration.value(), 1e-9 / scale, 1e-5 * 1e-9 / scale);
}

TEST(MeasurePhysics, MeasuresALooseMassAtRestByItsLoad) {
  Problem loose = test::one_mass(0.0, 0.5);
  loose.edit_structure([](Structure& s) { s.stiffness.coeffRef(0, 0) = s.damping.coeffRef(0, 0) = 0.0; });
  loose.force.push_back({.dof = 0, .harmonic = 0, .cos = 6.0});  // presses, whatever cos 2 t does
  const Motion rest = sampled(FormulaMotion(
      kPeriod, [](double) { return 1e-17; }, [](double) { return 0.0; },
      [](double t) { return -6.0 - std::cos(2.0 * t); }));
  const Physics physics = measure_physics(loose, Restitution{0.5}, rest);
  const double scale = 0.1 * 0.25 / std::numbers::sqrt2;  // of 1/4 cos 2 t, its motion without the stop
  EXPECT_NEAR(physics.penetration.value(), 1e-17 / scale, 1e-3 * 1e-17 / scale);
  EXPECT_LT(physics.complementarity.value(), 1e-14);
}

// A sprung mass and one that lies on it: no coordinate holds the latter but the contact.
TEST(MeasurePhysics, MeasuresAMassThatLiesOnAnotherByTheMotionOfThese) {
  Problem pair = test::one_mass(0.0, 0.5);
  const auto matrix = [](double a, double b) {
    SparseMatrix m(2, 2);
    m.insert(0, 0) = a;
    if (b != 0.0) m.insert(1, 1) = b;
    m.makeCompressed();
    return m;
  };
  pair.edit_structure([&](Structure& s) {
    s.mass = matrix(1.0, 0.5);
    s.damping = matrix(0.8, 0.0);
    s.stiffness = matrix(400.0, 0.0);
  });
  pair.force = {{.dof = 0, .harmonic = 0, .cos = -9.81},
                {.dof = 1, .harmonic = 0, .cos = -4.905},
                {.dof = 0, .cos = 2.0}};
  pair.contacts = {{.normal = {{0, 1.0}, {1, -1.0}}, .gap = 0.0}};
  const Motion rest = sample_motion(pair, FormulaMotion(
                                              kPeriod, [](double) { return -1e-16; },
                                              [](double) { return 0.0; }, [](double) { return -4.9; }));
  const Physics physics = measure_physics(pair, Restitution{0.5}, rest);
  // The sprung mass alone swings by 2 / |400 - 4 + 1.6 i|.
  const double scale = 0.1 * 2.0 / std::hypot(396.0, 1.6) / std::numbers::sqrt2;
  EXPECT_NEAR(physics.complementarity.value(), 1e-16 / scale, 0.01 * 1e-16 / scale);
}

TEST(MeasurePhysics, IsEmptyWithoutContacts) {
  Problem problem = test::one_mass();
  problem.contacts.clear();
  problem.set_law(std::monostate{});
  const Physics physics =
      measure_physics(problem, std::monostate{}, sampled(FormulaMotion(kPeriod, {}, {}, {}, {}, 1, 0)));
  EXPECT_FALSE(physics.penetration.has_value());
  EXPECT_FALSE(physics.complementarity.has_value());
  EXPECT_FALSE(physics.contact_ratio.has_value());
  EXPECT_TRUE(physics.energy_defect.has_value());
}

TEST(MeasurePhysics, JudgesASpringStopByTheSpring) {
  const double k = 30.0;
  Problem problem = test::one_mass(0.3);
  problem.set_law(Penalty{{k}});
  const auto x = [](double t) { return 0.1 + 0.4 * std::sin(2.0 * t); };
  const auto v = [](double t) { return 0.8 * std::cos(2.0 * t); };
  const FormulaMotion exact(kPeriod, x, v, [=](double t) { return -k * std::max(0.0, x(t) - 0.3); });
  EXPECT_NEAR(
      measure_physics(problem, problem.law().index() == 0 ? RepresentedLaw{} : RepresentedLaw{Penalty{{k}}},
                      sampled(exact))
          .complementarity.value(),
      0.0, 1e-14);
  const FormulaMotion half(kPeriod, x, v, [=](double t) { return -0.5 * k * std::max(0.0, x(t) - 0.3); });
  EXPECT_GT(measure_physics(problem, Penalty{{k}}, sampled(half)).complementarity.value(), 0.01);
}

TEST(ImpulsePerForcingPeriod, AddsForceAndImpulses) {
  // A half sine of 3 N over half the period and one impulse of 0.25 N s.
  const FormulaMotion motion(
      kPeriod, [](double) { return 0.0; }, [](double) { return 0.0; },
      [](double t) { return std::min(0.0, -3.0 * std::sin(2.0 * t)); },
      {{.contact = 0, .time = 1.0, .value = -0.25}});
  EXPECT_NEAR(impulse_per_forcing_period(sampled(motion))[0], -3.0 - 0.25, 1e-5);
}

TEST(MeasureErrors, AreRelativeToTheOrbit) {
  const Problem problem = test::one_mass();
  const Motion orbit = sine(0.0, 0.5);
  const Errors errors = measure_errors(problem, sine(0.0, 0.6), orbit);
  EXPECT_NEAR(errors.x_l2.value(), 0.2, 1e-12);
  EXPECT_NEAR(errors.x_max.value(), 0.2, 1e-12);
  EXPECT_NEAR(errors.velocity_l2.value(), 0.2, 1e-12);
  EXPECT_FALSE(errors.impulse.has_value());  // no contact in the orbit: no scale
  EXPECT_FALSE(errors.u_l2.has_value());     // the contact is the whole structure
  EXPECT_FALSE(measure_errors(problem, sine(0.0, 0.6), sine(0.0, 0.0)).x_l2.has_value());
}

TEST(MeasureErrors, TakeTheImpulseOfTheWorstContact) {
  const auto push = [](double size) {
    return sampled(FormulaMotion(
        kPeriod, [](double t) { return std::sin(2.0 * t); }, [](double t) { return 2.0 * std::cos(2.0 * t); },
        [](double) { return 0.0; }, {{.contact = 0, .time = 1.0, .value = size}}));
  };
  EXPECT_NEAR(measure_errors(test::one_mass(), push(-1.5), push(-2.0)).impulse.value(), 0.25, 1e-12);
}

TEST(MeasureErrors, CompareTheWholeFieldWhereThereIsMoreThanTheContacts) {
  Problem problem = test::one_mass();
  problem.contacts.clear();
  problem.set_law(std::monostate{});
  const Motion nothing = sampled(FormulaMotion(kPeriod, {}, {}, {}, {}, 1, 0));
  const Errors errors = measure_errors(problem, nothing, nothing);
  EXPECT_FALSE(errors.x_l2.has_value());
  EXPECT_EQ(errors.u_l2.value(), 0.0);
}

// Against both fields at the instants of the longer period.
TEST(MeasureErrors, CompareFieldsOfDifferentOrders) {
  constexpr int kInstants = 64;
  Problem chain = test::damped_chain(4, 1);
  chain.frequency = 2.0;
  const auto none = [](double) { return 0.0; };
  const FormulaMotion answer(
      kPeriod, none, none, [](double t) { return -0.3 - 0.2 * std::cos(2.0 * t) - 0.1 * std::sin(4.0 * t); },
      {}, 2);
  const FormulaMotion orbit(
      2.0 * kPeriod, none, none, [](double t) { return -0.2 - 0.1 * std::cos(t) - 0.2 * std::sin(2.0 * t); },
      {}, 2);
  const Eigen::MatrixXd half = PeriodicResponse(chain, answer).displacement(kInstants);
  const Eigen::MatrixXd exact = PeriodicResponse(chain, orbit).displacement(2 * kInstants);
  const Eigen::MatrixXd apart = exact - half.replicate(2, 1);
  const Eigen::MatrixXd moving = exact.rowwise() - exact.colwise().mean();
  const double expected = apart.norm() / moving.norm();
  ASSERT_GT(expected, 0.01);
  const Errors errors = measure_errors(chain, sample_motion(chain, answer), sample_motion(chain, orbit));
  EXPECT_NEAR(errors.u_l2.value(), expected, 1e-12 * expected);
}

/// A motion of period T between impacts at t = 0: x = g - t (T - t)(b + c t), v_- = T (b + c T), v_+ = -T b.
FormulaMotion bounce(double gap, double b, double c, std::vector<Impulse> impulses,
                     std::optional<int> bandwidth, FormulaMotion::Formula force) {
  const double T = kPeriod;
  return {T,
          [=](double t) { return gap - t * (T - t) * (b + c * t); },
          [=](double t) { return -(T - 2.0 * t) * (b + c * t) - t * (T - t) * c; },
          std::move(force),
          std::move(impulses),
          bandwidth};
}

TEST(MeasurePhysics, FindsTheRestitutionOfAListedImpact) {
  const double b = 0.5, c = 0.5 / kPeriod;  // v_- = T, v_+ = -T / 2
  const FormulaMotion motion =
      bounce(0.2, b, c, {{.contact = 0, .time = 0.0, .value = -1.0}}, {}, [](double) { return 0.0; });
  const Physics physics = measure_physics(test::one_mass(0.2), Restitution{0.5}, sampled(motion));
  ASSERT_EQ(physics.effective_restitution.size(), 1U);
  EXPECT_NEAR(physics.effective_restitution[0], 0.5, 1e-6);
}

TEST(MeasurePhysics, FindsTheRestitutionOfAnImpactSpreadOverTheResolution) {
  const int bandwidth = 100;
  const double width = kPeriod / (2.0 * bandwidth);
  const auto force = [=](double t) { return t < 0.5 * width || t > kPeriod - 0.5 * width ? -1.0 : 0.0; };
  const FormulaMotion motion = bounce(0.2, 0.5, 0.5 / kPeriod, {}, bandwidth, force);
  const Physics physics = measure_physics(test::one_mass(0.2), Restitution{0.5}, sampled(motion));
  ASSERT_EQ(physics.effective_restitution.size(), 1U);
  // Speeds are means over period / bandwidth beside the contact.
  EXPECT_NEAR(physics.effective_restitution[0], 0.5, 3.0 / bandwidth);
  EXPECT_NEAR(physics.contact_ratio.value(), 0.5 / bandwidth, 2.0 / kGrid);
}

TEST(EnergyDefect, VanishesForTheLinearResponse) {
  const Problem problem = test::one_mass();
  EXPECT_LT(energy_defect(problem, Restitution{1.0}, sampled(*test::free_motion(problem))).value.value(),
            1e-13);
}

// The mean of a part that no spring holds does no work, whatever it is.
TEST(EnergyDefect, OfALooseMassIsMeasuredThough) {
  Problem loose = test::one_mass(0.0, 0.5);  // m = 1, omega = 2
  loose.edit_structure([](Structure& s) {
    s.stiffness.coeffRef(0, 0) = 0.0;
    s.damping.coeffRef(0, 0) = 0.2;
  });
  loose.force.push_back({.dof = 0, .harmonic = 0, .cos = 6.0});
  // A stop that pushes with 6 N throughout lets the mass follow the load as if it were free.
  const std::complex<double> amplitude = 1.0 / std::complex<double>(-4.0, 0.4);
  const auto x = [=](double t) { return (amplitude * std::polar(1.0, 2.0 * t)).real(); };
  const auto v = [=](double t) {
    return (amplitude * std::complex<double>(0.0, 2.0) * std::polar(1.0, 2.0 * t)).real();
  };
  const Motion motion = sample_motion(loose, FormulaMotion(kPeriod, x, v, [](double) { return -6.0; }));
  const EnergyDefect defect = energy_defect(loose, Penalty{{1.0}}, motion);
  ASSERT_TRUE(defect.value) << defect.reason;
  EXPECT_LT(*defect.value, 1e-9);
}

// No impulse reaches a coordinate without mass that no contact touches.
TEST(VelocityJumps, AreKnownBesideCoordinatesWithoutMass) {
  Problem problem = test::one_mass(0.0, 0.5);
  problem.edit_structure([](Structure& s) {
    for (SparseMatrix* matrix : {&s.mass, &s.damping, &s.stiffness}) matrix->conservativeResize(2, 2);
    s.stiffness.coeffRef(1, 1) = 1.0;
  });
  const Eigen::MatrixXd jumps = velocity_jumps(problem);
  EXPECT_DOUBLE_EQ(jumps(0, 0), 1.0 / problem.mass().coeff(0, 0));
  EXPECT_DOUBLE_EQ(jumps(1, 0), 0.0);
}

TEST(EnergyDefect, IsAbsentWithoutWorkOrLaw) {
  Problem problem = test::one_mass();
  EXPECT_FALSE(
      energy_defect(problem, Undetermined{}, sampled(*test::free_motion(problem))).value.has_value());
  problem.force.front().harmonic = 0;  // a constant load does no work over a period
  const EnergyDefect still = energy_defect(problem, Restitution{1.0}, sine(1.0, 0.0));
  EXPECT_FALSE(still.value.has_value());
  EXPECT_EQ(still.reason, "the load does no work");
}

// A contact that never opens holds the mass: what is left of its motion is round-off, and so is the work.
TEST(EnergyDefect, IsAbsentWhereAContactHoldsWhatIsLoaded) {
  Problem problem = test::one_mass(0.0);
  problem.force.push_back({.dof = 0, .harmonic = 0, .cos = 5.0});
  const double noise = 1e-15;
  const FormulaMotion held(
      kPeriod, [=](double t) { return noise * std::sin(2.0 * t); },
      [=](double t) { return 2.0 * noise * std::cos(2.0 * t); },
      [=](double t) { return -5.0 - std::cos(2.0 * t) + noise * std::cos(2.0 * t + 1.0); });
  const EnergyDefect defect = energy_defect(problem, Restitution{0.5}, sample_motion(problem, held));
  EXPECT_FALSE(defect.value.has_value()) << *defect.value;
  EXPECT_EQ(defect.reason, "the load does no work");
}

// On a grid the force that holds is coarse, and the response to it moves where the contact does not.
TEST(EnergyDefect, IsAbsentWhereACoarseForceHoldsThroughout) {
  Problem problem = test::one_mass(0.1);
  problem.force.push_back({.dof = 0, .harmonic = 0, .cos = 5.0});
  const FormulaMotion held(
      kPeriod, [](double) { return 0.0; }, [](double) { return 0.0; },
      [](double t) { return -5.0 - 0.999 * std::cos(2.0 * t); });
  const Motion motion = sample_motion(problem, held);
  const EnergyDefect defect = energy_defect(problem, Restitution{1.0}, motion);
  EXPECT_FALSE(defect.value.has_value()) << *defect.value;
  EXPECT_EQ(defect.reason, "the contacts hold throughout");
  // A spring gives way: its force is judged.
  EXPECT_TRUE(energy_defect(problem, Penalty{{1e6}}, motion).value.has_value());
}

Motion motion_of(const test::SingleImpactOrbit& orbit, const Problem& problem) {
  const FormulaMotion motion(
      orbit.period, [orbit](double t) { return orbit.x(t); }, [orbit](double t) { return orbit.velocity(t); },
      [](double) { return 0.0; }, {{.contact = 0, .time = orbit.impact_time, .value = -orbit.impulse}});
  return sample_motion(problem, motion);
}

class ClosedFormOrbits : public testing::TestWithParam<double> {
 protected:
  test::ImpactOscillator oscillator_{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = GetParam()};
  test::SingleImpactOrbit orbit_ = test::single_impact_orbits(oscillator_).front();
  Problem problem_ = test::to_problem(oscillator_);
};

TEST_P(ClosedFormOrbits, BalanceEnergyUnderTheirOwnLaw) {
  const Motion motion = motion_of(orbit_, problem_);
  EXPECT_LT(energy_defect(problem_, Restitution{GetParam()}, motion).value.value(), 1e-6);
}

TEST_P(ClosedFormOrbits, MissUnderAnotherLawWhatTheLawsDifferBy) {
  const Motion motion = motion_of(orbit_, problem_);
  const double e = GetParam();
  const double other = e == 1.0 ? 0.0 : 1.0;
  // (1 - e)/(2 (1 + e)) J^2 / m is what each law loses with this impulse; the work is what damping and the
  // true law take, here by Simpson's rule over the closed form.
  const auto loss = [&](double law) {
    return (1.0 - law) / (2.0 * (1.0 + law)) * orbit_.impulse * orbit_.impulse;
  };
  const int steps = 20000;
  double damped = 0.0;
  for (int i = 0; i <= steps; ++i) {
    // Over one flight, which begins and ends just beside the impact.
    const double inside = 1e-9 + (1.0 - 2e-9) * i / steps;
    const double v = orbit_.velocity(std::fmod(orbit_.impact_time + inside * orbit_.period, orbit_.period));
    damped += (i == 0 || i == steps ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0)) * v * v;
  }
  damped *= oscillator_.damping * orbit_.period / (3.0 * steps);
  const double expected = std::abs(loss(e) - loss(other)) / (damped + loss(e));
  EXPECT_NEAR(energy_defect(problem_, Restitution{other}, motion).value.value(), expected, 1e-5);
}

TEST_P(ClosedFormOrbits, ShowTheirRestitution) {
  const Physics physics = measure_physics(problem_, Restitution{GetParam()}, motion_of(orbit_, problem_));
  ASSERT_EQ(physics.effective_restitution.size(), 1U);
  EXPECT_NEAR(physics.effective_restitution[0], GetParam(), 1e-5);
  EXPECT_LT(physics.penetration.value(), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(EachRestitution, ClosedFormOrbits, testing::Values(1.0, 0.8, 0.5));

}  // namespace
}  // namespace signorini::measures_test
