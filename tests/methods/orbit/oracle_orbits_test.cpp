// Exact orbits of one mass against closed forms: impacts, springs, lasting contact.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "methods/orbit/exact_orbit.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/reference/bilinear_orbit.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/orbit_check.hpp"

namespace signorini::oracle_orbits_test {
namespace {

using test::cold_orbit;
using test::ImpactOscillator;

constexpr double kAccuracy = 1e-10;  // relative to lengths, speeds and forces of order one

// One row of the table of single-impact orbits: figures computed independently of this repository.
struct TableRow {
  std::string name;
  ImpactOscillator oscillator;
  double impact_time, impulse;
  double tolerance;  // of these figures: the digits they are given with
};

void PrintTo(const TableRow& row, std::ostream* out) { *out << row.name; }

/// The closed form as a motion with its impulse.
class ClosedForm final : public Trajectory {
 public:
  explicit ClosedForm(test::SingleImpactOrbit orbit) : orbit_(std::move(orbit)) {}
  [[nodiscard]] int contact_count() const override { return 1; }
  [[nodiscard]] double period() const override { return orbit_.period; }
  [[nodiscard]] Samples sample(int count) const override {
    Samples samples{Eigen::MatrixXd(count, 1), Eigen::MatrixXd(count, 1), Eigen::MatrixXd::Zero(count, 1)};
    for (int i = 0; i < count; ++i) {
      samples.x(i, 0) = orbit_.x(orbit_.period * i / count);
      samples.velocity(i, 0) = orbit_.velocity(orbit_.period * i / count);
    }
    return samples;
  }
  [[nodiscard]] std::vector<Impulse> impulses() const override {
    return {{.contact = 0, .time = orbit_.impact_time, .value = -orbit_.impulse}};
  }

 private:
  test::SingleImpactOrbit orbit_;
};

class SingleImpact : public testing::TestWithParam<TableRow> {};

TEST_P(SingleImpact, IsFoundFromAColdStartWithItsStability) {
  const TableRow& row = GetParam();
  const auto found = cold_orbit(test::to_problem(row.oscillator));
  ASSERT_TRUE(found.orbit) << found.solution.message;
  EXPECT_LE(*found.solution.residual, 1e-12);
  const auto impulses = found.orbit->impulses();
  ASSERT_EQ(impulses.size(), 1U);
  const double forcing_period = 2.0 * std::numbers::pi / row.oscillator.frequency;
  // A subharmonic orbit may come shifted by whole forcing periods.
  const double late = std::remainder(impulses[0].time - row.impact_time, forcing_period);
  EXPECT_NEAR(late, 0.0, row.tolerance);
  EXPECT_NEAR(-impulses[0].value, row.impulse, row.tolerance);

  const auto orbits = test::single_impact_orbits(row.oscillator);
  ASSERT_FALSE(orbits.empty());
  const auto& exact = orbits.front();
  const double shift = std::round((impulses[0].time - exact.impact_time) / forcing_period) * forcing_period;
  EXPECT_NEAR(impulses[0].time - shift, exact.impact_time, kAccuracy);
  EXPECT_NEAR(-impulses[0].value, exact.impulse, kAccuracy);
  EXPECT_NEAR(test::trace(*found.orbit), exact.trace, kAccuracy);
  EXPECT_NEAR(test::determinant(*found.orbit), exact.determinant, kAccuracy);
  EXPECT_LT(test::relative_error(*found.orbit, [&](double t) { return exact.x(t - shift); }), kAccuracy);
}

INSTANTIATE_TEST_SUITE_P(
    Table, SingleImpact,
    testing::Values(
        TableRow{"SA", {.damping = 0.1, .frequency = 2.2, .gap = 0.2}, 1.380538076452, 0.823304275742, 1e-10},
        TableRow{"SA08",
                 {.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.8},
                 1.345701,
                 0.799844,
                 1e-6},
        TableRow{"SA05",
                 {.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.5},
                 1.287570,
                 0.714312,
                 1e-6},
        TableRow{"SA0",
                 {.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.0},
                 1.196831,
                 0.468272,
                 1e-6},
        TableRow{"SB",
                 {.damping = 0.1, .frequency = 1.0, .gap = 1.0, .restitution = 0.8},
                 0.075952164938,
                 1.8 * 1.695732937595,
                 1e-10},
        TableRow{"SE",
                 {.damping = 0.05, .frequency = 2.658787336024, .gap = 0.0, .restitution = 0.7},
                 1.104910368242,
                 1.7 * 0.464566874094,
                 1e-9},
        TableRow{"SF",
                 {.damping = 0.02, .frequency = 4.1, .gap = 0.01, .restitution = 0.8, .order = 2},
                 0.624435604230,
                 1.8 * 1.245271157551,
                 1e-10},
        TableRow{"SH",
                 {.damping = 0.0, .frequency = 2.0001, .gap = 0.001, .restitution = 0.4},
                 0.787042273003,
                 1.4 * 2.222024459632,
                 1e-10}),
    [](const auto& info) { return info.param.name; });

TEST(ExactOrbits, TracesAndDeterminantsOfTheTable) {
  const auto orbit = [](const ImpactOscillator& o) { return *cold_orbit(test::to_problem(o)).orbit; };
  const auto sa = orbit({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  EXPECT_NEAR(test::trace(sa), 0.2253257734, 1e-10);
  EXPECT_NEAR(test::determinant(sa), 0.7515636830, 1e-10);
  const auto sb = orbit({.damping = 0.1, .frequency = 1.0, .gap = 1.0, .restitution = 0.8});
  EXPECT_NEAR(test::trace(sb), -1.1685906287, 1e-10);
  EXPECT_NEAR(test::determinant(sb), 0.3414323783, 1e-10);
  const auto sf = orbit({.damping = 0.02, .frequency = 4.1, .gap = 0.01, .restitution = 0.8, .order = 2});
  EXPECT_NEAR(test::trace(sf), 1.4561967318, 1e-10);
  EXPECT_NEAR(test::determinant(sf), 0.6019466424, 1e-10);
  const auto sh = orbit({.damping = 0.0, .frequency = 2.0001, .gap = 0.001, .restitution = 0.4});
  EXPECT_NEAR(test::trace(sh), 0.7999995580, 1e-10);
  EXPECT_NEAR(test::determinant(sh), 0.16, 1e-10);
  // The period doubling: one multiplier is -1.
  const auto se = orbit({.damping = 0.05, .frequency = 2.658787336024, .gap = 0.0, .restitution = 0.7});
  EXPECT_NEAR(se.quality().multipliers.cwiseAbs().maxCoeff(), 1.0, 1e-9);
  EXPECT_NEAR(se.quality().multipliers.cwiseAbs().minCoeff(), 0.4353919, 1e-7);
}

TEST(ExactOrbits, TwoAlternatingImpactsPastThePeriodDoubling) {
  const ImpactOscillator o{.damping = 0.05, .frequency = 2.7, .gap = 0.0, .restitution = 0.7, .order = 2};
  const auto found = cold_orbit(test::to_problem(o));
  ASSERT_TRUE(found.orbit) << found.solution.message;
  const auto impulses = found.orbit->impulses();
  ASSERT_EQ(impulses.size(), 2U);
  const double T = 2.0 * std::numbers::pi / o.frequency;
  const bool first_is_stronger = -impulses[0].value > -impulses[1].value;
  EXPECT_NEAR(std::max(-impulses[0].value, -impulses[1].value) / 1.7, 0.48353373, 1e-8);
  EXPECT_NEAR(std::min(-impulses[0].value, -impulses[1].value) / 1.7, 0.45266174, 1e-8);
  const double interval = (impulses[1].time - impulses[0].time) / T;
  EXPECT_NEAR(first_is_stronger ? interval : 2.0 - interval, 1.149225, 1e-6);
}

// The coexisting pair: a stable subharmonic and an unstable orbit of period one.
TEST(ExactOrbits, ACoexistingPairOneOfThemUnstable) {
  ImpactOscillator o{.damping = 0.02, .frequency = 4.1, .gap = 0.01, .restitution = 0.8};
  const auto one = cold_orbit(test::to_problem(o));
  ASSERT_TRUE(one.orbit) << one.solution.message;
  ASSERT_EQ(one.orbit->impulses().size(), 1U);
  EXPECT_NEAR(-one.orbit->impulses()[0].value, 1.8 * 0.056924256179, 1e-10);
  EXPECT_GT(one.orbit->quality().multipliers.cwiseAbs().maxCoeff(), 1.0);
  o.order = 2;
  const auto two = cold_orbit(test::to_problem(o));
  ASSERT_TRUE(two.orbit) << two.solution.message;
  EXPECT_LT(two.orbit->quality().multipliers.cwiseAbs().maxCoeff(), 1.0);
  double lowest = 0.0;
  const Samples samples = two.orbit->sample(200000);
  lowest = samples.x.minCoeff();
  EXPECT_NEAR(lowest, -1.0911472789, 1e-8);
}

// Beside the fold where impacting motion begins, S-B of the table: F_SN = 0.0999707536, grazing at 0.1. Two
// orbits just above it, one of them unstable; none below.
TEST(ExactOrbits, ExistInPairsDownToTheFoldAndNotBelow) {
  ImpactOscillator o{.damping = 0.1, .load = 0.09998, .frequency = 1.0, .gap = 1.0, .restitution = 0.8};
  const auto pair = test::single_impact_orbits(o);
  ASSERT_EQ(pair.size(), 2U);
  int stable = 0;
  OrbitSearch last;
  for (const auto& closed : pair) {
    const Problem problem = test::to_problem(o);
    const OrbitSearch found = OrbitFinder(problem).find(ClosedForm(closed));
    ASSERT_TRUE(found.orbit.certified()) << describe(found.orbit.outcome) << ": " << found.orbit.reason;
    ASSERT_EQ(found.orbit.trajectory->impulses().size(), 1U);
    // Beside a fold the orbit is ill-conditioned: its own error bar is the measure.
    EXPECT_NEAR(-found.orbit.trajectory->impulses()[0].value, closed.impulse,
                std::max(1e-12, 10.0 * found.orbit.error_bar));
    EXPECT_EQ(largest_magnitude(found.orbit.multipliers.values) < 1.0, closed.stable());
    stable += closed.stable() ? 1 : 0;
    last = found;
  }
  EXPECT_EQ(stable, 1);
  o.load = 0.0999;
  EXPECT_TRUE(test::single_impact_orbits(o).empty());
  const ExactOrbit below = polish_sequence(std::make_shared<OrbitModel>(test::to_problem(o)),
                                           last.orbit.trajectory->orbit(), {.max_iterations = 60});
  EXPECT_FALSE(below.certified());
}

TEST(ExactOrbits, SpringStopsOfTheTable) {
  struct Row {
    double stiffness, l2, contact_time, penetration, trace;
  };
  const auto rigid = test::single_impact_orbits({.damping = 0.1, .frequency = 2.2, .gap = 0.2}).front();
  for (const Row& row : {Row{1e2, 1.6616e-1, 0.245530, 2.3858e-2, -1.634806},
                         Row{1e3, 7.9171e-2, 0.092719, 1.0300e-2, -0.541600},
                         Row{1e4, 2.9978e-2, 0.030802, 3.7828e-3, -0.028449},
                         Row{1e5, 1.0118e-2, 0.009875, 1.2658e-3, 0.144483},
                         Row{1e6, 3.2696e-3, 0.003136, 4.0795e-4, 0.199723},
                         Row{1e7, 1.0411e-3, 0.000993, 1.2978e-4, 0.217226},
                         Row{1e8, 3.2997e-4, 0.000314, 4.0461e-5, 0.222764}}) {
    SCOPED_TRACE(row.stiffness);
    const Problem problem = test::penalty_oscillator(row.stiffness);
    const auto found = cold_orbit(problem);
    ASSERT_TRUE(found.orbit) << found.solution.message;
    EXPECT_NEAR(test::trace(*found.orbit), row.trace, 1e-6);
    EXPECT_NEAR(test::determinant(*found.orbit), 0.7515636830, 1e-9);
    const auto& events = found.orbit->orbit().events;
    ASSERT_EQ(events.size(), 2U);
    const auto open = events[0].kind == ContactEvent::Kind::open ? 0U : 1U;
    double contact = events[open].time - events[1 - open].time;
    if (contact < 0.0) contact += problem.period();
    EXPECT_NEAR(contact, row.contact_time, 1e-6);
    const double size = std::sqrt(found.orbit->sample(8192).x.squaredNorm() / 8192);
    const double apart = size * test::relative_error(*found.orbit, [&](double t) { return rigid.x(t); });
    // relative_error divides by the norm of the rigid orbit, which differs from `size` by as much as the
    // orbits.
    EXPECT_NEAR(apart, row.l2, 2.0 * row.l2 * row.l2 / size + 1e-6);
    const auto check = test::check_orbit(problem, *found.orbit, 1e-9);
    EXPECT_TRUE(check.ok) << check.reason;
    // The check's own exponentials lose digits to the stiffness.
    EXPECT_LT(check.return_distance, 1e-10 * std::max(1.0, row.stiffness / 1e5));
    const test::BilinearOrbit closed_form = test::bilinear_orbit_of(rigid, row.stiffness);
    EXPECT_NEAR(test::trace(*found.orbit), closed_form.trace(), 4e-9 * std::max(1.0, row.stiffness / 1e7));
    EXPECT_LT(test::relative_error(*found.orbit, [&](double t) { return closed_form.x(t); }), kAccuracy);
    // Beyond 1e6 the table's penetration, taken on a grid, is short of digits.
    if (row.stiffness <= 1e6) {
      EXPECT_NEAR(closed_form.penetration(), row.penetration, 1e-4 * row.penetration);
    }
    const double middle =
        0.5 * (events[0].time + events[1].time) + (open == 0U ? 0.5 * problem.period() : 0.0);
    EXPECT_GT(found.orbit->at(middle).u[0] - 0.2, 0.9 * closed_form.penetration());
    EXPECT_LE(found.orbit->at(middle).u[0] - 0.2, (1.0 + 1e-9) * closed_form.penetration());
  }
}

TEST(ExactOrbits, PermanentContactHasItsStaticMultiplier) {
  const Problem problem =
      test::to_problem({.damping = 0.1, .load = 0.7, .frequency = 0.9, .gap = -1.2, .restitution = 0.5});
  const auto found = cold_orbit(problem);
  ASSERT_TRUE(found.orbit) << found.solution.message;
  EXPECT_TRUE(found.orbit->orbit().events.empty());
  const Samples samples = found.orbit->sample(64);
  for (int i = 0; i < 64; ++i) {
    const double t = problem.period() * i / 64;
    EXPECT_NEAR(samples.x(i, 0), -1.2, 1e-14);
    EXPECT_NEAR(samples.force(i, 0), -1.2 - 0.7 * std::cos(0.9 * t), 1e-13);
  }
  EXPECT_LT(found.orbit->quality().multipliers.cwiseAbs().maxCoeff(), 1e-15);
}

TEST(ExactOrbits, ContactFreeMotionIsTheLinearResponse) {
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.5});
  const auto found = cold_orbit(problem);
  ASSERT_TRUE(found.orbit) << found.solution.message;
  const std::complex<double> x = 1.0 / std::complex<double>(1.0 - 2.2 * 2.2, 0.22);
  EXPECT_LT(
      test::relative_error(*found.orbit, [&](double t) { return (x * std::polar(1.0, 2.2 * t)).real(); }),
      1e-13);
  EXPECT_NEAR(test::determinant(*found.orbit), std::exp(-0.1 * problem.period()), 1e-13);
}

// Complete chatter and sticking: release and first impact in closed form, the limit of the impacts summed.
TEST(ExactOrbits, StickingAndCompleteChatterOfTheTable) {
  struct Row {
    double damping, frequency, gap, e, release, impact, speed, limit, lowest;
  };
  for (const Row& row :
       {Row{0.02, 0.5, 0.2, 0.0, 2.7388768120, 9.4661871002, 1.2476540087, 10.5184268516, -1.7879233734},
        Row{0.02, 0.5, 0.2, 0.5, 2.7388768120, 9.4661871002, 1.2476540087, 14.4431813264, -1.7879233734},
        Row{0.02, 0.25, 0.0, 0.8, 6.2831853072, 18.8711841977, 0.5017858118, 26.9041317069, -1.2556097261},
        Row{0.1, 0.4, 0.0, 0.0, 3.9269908170, 11.3196847784, 0.6319648387, 12.6136929098, -1.5288868396}}) {
    SCOPED_TRACE(testing::Message() << "w = " << row.frequency << ", e = " << row.e);
    const Problem problem = test::to_problem(
        {.damping = row.damping, .frequency = row.frequency, .gap = row.gap, .restitution = row.e});
    const auto found = cold_orbit(problem);
    ASSERT_TRUE(found.orbit) << found.solution.message;
    EXPECT_EQ(found.solution.message.find("complete chattering") != std::string::npos, row.e > 0.0);
    const double T = problem.period();
    double release = -1.0, close = -1.0, first = 0.0, hit = -1.0;
    for (const SequenceEvent& event : found.orbit->orbit().events) {
      if (event.kind == ContactEvent::Kind::open) release = event.time;
      if (event.kind == ContactEvent::Kind::close) close = event.time;
    }
    for (const Impulse& impulse : found.orbit->impulses()) {  // the one nearest to the first of the table
      if (hit >= 0.0 && std::abs(std::remainder(impulse.time - row.impact, T)) >
                            std::abs(std::remainder(hit - row.impact, T)))
        continue;
      first = -impulse.value;
      hit = impulse.time;
    }
    EXPECT_NEAR(std::remainder(release - row.release, T), 0.0, 2e-10);
    EXPECT_NEAR(std::remainder(hit - row.impact, T), 0.0, 2e-10);
    EXPECT_NEAR(first, (1.0 + row.e) * row.speed, 2e-10);
    // What is left of the geometric sequence when it is summed takes 1e-5 of a period at most.
    EXPECT_NEAR(std::remainder(close - row.limit, T), 0.0, row.e == 0.0 ? 2e-9 : 2e-5);
    const Samples samples = found.orbit->sample(100000);
    EXPECT_NEAR(samples.x.minCoeff(), row.lowest, 1e-8);
    EXPECT_LT(found.orbit->quality().multipliers.cwiseAbs().maxCoeff(), 1e-12);
    const auto check = test::check_orbit(problem, *found.orbit, 1e-9);
    EXPECT_TRUE(check.ok) << check.reason;
  }
}

}  // namespace
}  // namespace signorini::oracle_orbits_test
