
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "harness/judge/measures/impacts.hpp"
#include "harness/judge/measures/measures.hpp"
#include "harness/plan/plan.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::contact_work_test {
namespace {

using test::FormulaMotion;

constexpr double kPi = std::numbers::pi;
constexpr double kPeriod = kPi;  // of one_mass(): omega = 2

Motion with_events(Motion motion, std::vector<ContactEvent> events) {
  motion.integrated = true;
  motion.events = std::move(events);
  return motion;
}

class ClosedFormWork : public testing::TestWithParam<double> {};

// One impact takes (1 - e) / (2 (1 + e)) J^2 / m, wherever it falls between the samples.
TEST_P(ClosedFormWork, IsMinusTheLossOfAnImpact) {
  const double e = GetParam();
  const test::ImpactOscillator oscillator{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = e};
  const test::SingleImpactOrbit orbit = test::single_impact_orbits(oscillator).front();
  const Problem problem = test::to_problem(oscillator);
  const FormulaMotion formula(
      orbit.period, [orbit](double t) { return orbit.x(t); }, [orbit](double t) { return orbit.velocity(t); },
      [](double) { return 0.0; }, {{.contact = 0, .time = orbit.impact_time, .value = -orbit.impulse}});
  const Motion motion = with_events(sample_motion(problem, formula),
                                    {{.contact = 0, .time = orbit.impact_time, .impulse = -orbit.impulse}});
  const double loss = (1.0 - e) / (2.0 * (1.0 + e)) * orbit.impulse * orbit.impulse;
  EXPECT_NEAR(contact_work(motion, Restitution{e}, contact_gaps(problem)), -loss,
              1e-12 * orbit.impulse * orbit.impulse);
}

INSTANTIATE_TEST_SUITE_P(EachRestitution, ClosedFormWork, testing::Values(1.0, 0.8, 0.5, 0.0));

/// A motion as a command prints it: at so many instants, its events listed or not.
Motion told(const Problem& problem, const Trajectory& motion, int instants, bool listed, double force = 1.0) {
  SampledTrajectory::Data data{.period = motion.period(),
                               .samples = motion.sample(instants),
                               .impulses = motion.impulses(),
                               .bandwidth = {}};
  data.samples.force *= force;
  for (Impulse& impulse : data.impulses) impulse.value *= force;
  if (listed) data.events = motion.events();
  return sample_motion(problem, SampledTrajectory(std::move(data)));
}

/// With what it knows of its events.
class Listed final : public Trajectory {
 public:
  Listed(const Trajectory& motion, std::vector<ContactEvent> events)
      : motion_(motion), events_(std::move(events)) {}
  [[nodiscard]] int contact_count() const override { return motion_.contact_count(); }
  [[nodiscard]] double period() const override { return motion_.period(); }
  [[nodiscard]] Samples sample(int count) const override { return motion_.sample(count); }
  [[nodiscard]] std::vector<Impulse> impulses() const override { return motion_.impulses(); }
  [[nodiscard]] std::optional<std::vector<ContactEvent>> events() const override { return events_; }

 private:
  const Trajectory& motion_;
  std::vector<ContactEvent> events_;
};

// However many instants tell it, and whether its impact is listed twice or once.
TEST_P(ClosedFormWork, LeavesTheSameDefectHoweverTheMotionIsTold) {
  const double e = GetParam();
  const test::ImpactOscillator oscillator{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = e};
  const test::SingleImpactOrbit orbit = test::single_impact_orbits(oscillator).front();
  const Problem problem = test::to_problem(oscillator);
  const FormulaMotion formula(
      orbit.period, [orbit](double t) { return orbit.x(t); }, [orbit](double t) { return orbit.velocity(t); },
      [](double) { return 0.0; }, {{.contact = 0, .time = orbit.impact_time, .value = -orbit.impulse}});
  const Listed motion(formula, {{.contact = 0, .time = orbit.impact_time, .impulse = -orbit.impulse}});
  const auto defect = [&](int instants, bool listed, double force) {
    return energy_defect(problem, Restitution{e}, told(problem, motion, instants, listed, force))
        .value.value();
  };
  const double lie = defect(8192, false, 0.5);
  EXPECT_GT(lie, 0.01);
  for (const int instants : {8192, 4096, 1024, 300}) {
    for (const bool listed : {false, true}) {
      EXPECT_LT(defect(instants, listed, 1.0), 1e-9) << instants;
      EXPECT_NEAR(defect(instants, listed, 0.5), lie, 1e-9) << instants;
    }
    const Motion as_told = told(problem, motion, instants, true);
    const SpeedsBeside speeds = speeds_beside_impulses(as_told).front();
    EXPECT_NEAR(speeds.before.value(), orbit.approach, 1e-3 * orbit.approach) << instants;
    EXPECT_NEAR(speeds.after.value(), -e * orbit.approach, 1e-3 * orbit.approach) << instants;
  }
}

// A force that is told half: lambda / 2 moves the response half as far from the contact-free motion, on which
// alone a spring's force does work then.
TEST(EnergyOfASpring, MissesWhatItsForceMissesWithEventsAndWithout) {
  const Problem problem = read_scene(find_scene("sdof-penalty-soft")).problem;
  const ExactOrbitMethod method({});
  const Solution solution = method.prepare(problem)->solve({});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const Motion exact = sample_motion(problem, *solution.trajectory);
  const double w = problem.frequency;
  const std::complex<double> i(0.0, 1.0);
  const std::complex<double> stiffness = problem.stiffness().coeff(0, 0) -
                                         w * w * problem.mass().coeff(0, 0) +
                                         i * w * problem.damping().coeff(0, 0);
  double of_contact = 0.0, of_load = 0.0;  // on the contact-free motion; of the load on half the way there
  for (const ForceTerm& term : problem.force) {
    if (term.harmonic != 1) continue;
    const std::complex<double> load(term.cos, -term.sin), free = load / stiffness;
    for (int k = 0; k < exact.count(); ++k) {
      const std::complex<double> turn = std::polar(1.0, w * k * exact.step());
      const double free_speed = (i * w * free * turn).real(), speed = exact.samples.velocity(k, 0);
      of_contact += exact.step() * exact.samples.force(k, 0) * free_speed;
      of_load += exact.step() * (load * turn).real() * 0.5 * (speed + free_speed);
    }
  }
  const double expected = std::abs(0.25 * of_contact / of_load);
  EXPECT_GT(expected, 0.01);
  for (const int instants : {8192, 4096, 1024, 300}) {
    for (const bool listed : {false, true}) {
      const auto defect = [&](double force) {
        const Motion motion = told(problem, *solution.trajectory, instants, listed, force);
        return energy_defect(problem, method.law(problem), motion).value.value();
      };
      EXPECT_LT(defect(1.0), 5e3 / instants / instants) << "as straight lines are off: " << instants;
      EXPECT_NEAR(defect(0.5), expected, 0.02 * expected) << instants;
    }
  }
}

// x' = cos(2 t) but for the jumps; impacts one and a half steps apart, so that one side has but one sample.
TEST(ContactWork, TakesTheSidesThatItCanSee) {
  const double step = kPeriod / kGrid, first = 1000.25 * step, second = 1001.75 * step;
  const auto speed = [=](double t) { return t >= first && t < second ? -0.5 : t >= second ? 0.25 : 1.0; };
  const FormulaMotion formula(
      kPeriod, [](double) { return 0.0; }, speed, [](double) { return 0.0; },
      {{.contact = 0, .time = first, .value = -1.5}, {.contact = 0, .time = second, .value = -0.75}});
  const Motion motion = with_events(
      sample_motion(test::one_mass(), formula),
      {{.contact = 0, .time = first, .impulse = -1.5}, {.contact = 0, .time = second, .impulse = -0.75}});
  // -1.5 (1 - 0.5) / 2 - 0.75 (-0.5 + 0.25) / 2; t = 0, where the speed jumps too, is no event.
  EXPECT_NEAR(contact_work(motion, Restitution{0.5}, contact_gaps(test::one_mass())), -0.375 + 0.09375,
              1e-12);
}

TEST(ContactWork, HasNoFloorWhereAForceJumps) {
  // At rest on the stop for a third of the period, pressed by a force that begins and ends between two
  // samples.
  const auto pressed = [](double t) { return t > 1.00001 && t < 2.00001; };
  const FormulaMotion formula(
      kPeriod, [=](double t) { return pressed(t) ? 0.2 : 0.1; },
      [=](double t) { return pressed(t) ? 0.0 : std::sin(2.0 * t); },
      [=](double t) { return pressed(t) ? -1.0 : 0.0; });
  const Motion motion = with_events(sample_motion(test::one_mass(0.2), formula),
                                    {{.kind = ContactEvent::Kind::close, .contact = 0, .time = 1.00001},
                                     {.kind = ContactEvent::Kind::open, .contact = 0, .time = 2.00001}});
  EXPECT_EQ(contact_work(motion, Restitution{1.0}, contact_gaps(test::one_mass(0.2))), 0.0);
}

TEST(ContactWork, LeavesOutTheSpringAndFindsTheDamperBesideIt) {
  const double k = 30.0, c = 0.7;
  const auto x = [](double t) { return 0.1 + 0.4 * std::sin(2.0 * t); };
  const auto v = [](double t) { return 0.8 * std::cos(2.0 * t); };
  const auto closed = [=](double t) { return x(t) > 0.3; };
  const Motion motion = with_events(
      sample_motion(test::one_mass(0.3),
                    FormulaMotion(kPeriod, x, v,
                                  [=](double t) { return closed(t) ? -k * (x(t) - 0.3) - c * v(t) : 0.0; })),
      {});
  // c times the integral of x'^2 where sin 2t > 1/2: 0.32 (pi / 3 - sqrt(3) / 4).
  const double expected = -c * 0.32 * (kPi / 3.0 - std::sqrt(3.0) / 4.0);
  EXPECT_NEAR(contact_work(motion, Penalty{{k}}, contact_gaps(test::one_mass(0.3))), expected, 1e-3);
}

/// The energy defect of the scene's exact orbit.
double defect_of_exact_orbit(const std::string& scene) {
  const Problem problem = read_scene(find_scene(scene)).problem;
  const ExactOrbitMethod method({});
  const Solution solution = method.prepare(problem)->solve({});
  if (solution.verdict != Verdict::converged) {
    ADD_FAILURE() << solution.message;
    return 1.0;
  }
  const Motion motion = sample_motion(problem, *solution.trajectory);
  return energy_defect(problem, method.law(problem), motion).value.value();
}

class ExactOrbitsOf : public testing::TestWithParam<std::string> {};

// Long contact near resonance, stiff springs, contacts without mass: where the spectrum of the force is cut
// off is seen no more.
TEST_P(ExactOrbitsOf, BalanceTheirEnergyToRoundOff) { EXPECT_LT(defect_of_exact_orbit(GetParam()), 1e-10); }

INSTANTIATE_TEST_SUITE_P(Scenes, ExactOrbitsOf,
                         testing::Values("bar10-massless", "chain2-stick", "sdof-stick", "sdof-penalty-stiff",
                                         "sdof-preload-rest", "sdof-stop-e05", "stiff-penalty@1e8"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::erase_if(
                               name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
                           return name;
                         });

// A chatter is resolved down to impacts that the samples do not tell apart: what they take is all that is
// missed.
TEST(EnergyOfAChatter, MissesNoMoreThanItsLastImpacts) {
  EXPECT_LT(defect_of_exact_orbit("preload@-0.9"), 1e-5);
}

}  // namespace
}  // namespace signorini::contact_work_test
