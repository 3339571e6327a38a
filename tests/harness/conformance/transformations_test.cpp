#include "harness/conformance/transformations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/assembly/chain.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::transformations_test {
namespace {

constexpr double kPeriod = 2.0;

std::shared_ptr<const Trajectory> motion() {
  const double w = 2.0 * std::numbers::pi / kPeriod;
  return std::make_shared<test::FormulaMotion>(
      kPeriod, [w](double t) { return std::sin(w * t) + 0.3 * std::cos(3.0 * w * t); },
      [w](double t) { return w * std::cos(w * t) - 0.9 * w * std::sin(3.0 * w * t); },
      [w](double t) { return -1.0 - std::sin(w * t); },
      std::vector<Impulse>{{.contact = 0, .time = 0.25, .value = -2.0},
                           {.contact = 0, .time = 1.75, .value = -4.0}});
}

// Against the formula at shifted times: no grid enters.
TEST(MappedMotion, IsTheMotionLaterAndInOtherUnitsAtAnyNumberOfSamples) {
  const MotionMap map{.displacement = 3.0, .force = 5.0, .time = 0.5, .delay = 21, .grid = 64};
  const MappedMotion mapped(motion(), map);
  EXPECT_DOUBLE_EQ(mapped.period(), 1.0);
  const double w = std::numbers::pi;
  for (const int count : {1, 7, 64, 100}) {
    const Samples samples = mapped.sample(count);
    ASSERT_EQ(samples.x.rows(), count);
    for (int i = 0; i < count; ++i) {
      const double t = kPeriod * (static_cast<double>(i) / count - 21.0 / 64.0);
      EXPECT_NEAR(samples.x(i, 0), 3.0 * (std::sin(w * t) + 0.3 * std::cos(3.0 * w * t)), 1e-12);
      EXPECT_NEAR(samples.velocity(i, 0), 6.0 * w * (std::cos(w * t) - 0.9 * std::sin(3.0 * w * t)), 1e-11);
      EXPECT_NEAR(samples.force(i, 0), 5.0 * (-1.0 - std::sin(w * t)), 1e-12);
    }
  }
}

TEST(MappedMotion, OrdersItsImpulsesWithinThePeriod) {
  const MappedMotion mapped(motion(),
                            {.displacement = 1.0, .force = 5.0, .time = 0.5, .delay = 1, .grid = 2});
  const std::vector<Impulse> impulses = mapped.impulses();
  ASSERT_EQ(impulses.size(), 2U);
  EXPECT_DOUBLE_EQ(impulses[0].time, 0.375);  // 1.75 / 2 + 1 / 2, less the period
  EXPECT_DOUBLE_EQ(impulses[0].value, -10.0);
  EXPECT_DOUBLE_EQ(impulses[1].time, 0.625);
  EXPECT_DOUBLE_EQ(impulses[1].value, -5.0);
}

TEST(MappedMotion, IsUndoneByTheInverseMap) {
  const MotionMap map{.displacement = 3.0, .force = 5.0, .time = 0.5, .delay = 21, .grid = 64};
  const MappedMotion back(std::make_shared<MappedMotion>(motion(), map), map.inverse());
  const Samples before = motion()->sample(50), after = back.sample(50);
  EXPECT_LE((before.x - after.x).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LE((before.velocity - after.velocity).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_LE((before.force - after.force).cwiseAbs().maxCoeff(), 1e-12);
}

Problem two_masses_with_two_stops() {
  Problem problem;
  problem.structure = std::make_shared<const Structure>(
      assemble(Chain{.masses = {1.0, 2.0}, .dampers = {0.1, 0.2}, .springs = {3.0, 4.0}}));
  problem.frequency = 1.3;
  problem.force = {{.dof = 1, .harmonic = 0, .cos = 0.5, .sin = 0.0},
                   {.dof = 0, .harmonic = 1, .cos = 1.0, .sin = 0.0}};
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 0.2}, {.normal = {{1, -0.5}}, .gap = 0.4}};
  return problem;
}

// A motion u(t) of the scene leaves M u'' + D u' + K u - f; u + u_0 leaves the same of the moved scene.
TEST(WithOriginMoved, KeepsTheEquationsAndTheRoomBeforeEachStop) {
  const Problem problem = two_masses_with_two_stops();
  const Eigen::VectorXd u_0 = origin_before_stops(problem, 7.0);
  const Problem moved = with_origin_moved(problem, u_0);
  const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(problem.size(), 0.3, -1.1);
  const Eigen::VectorXd before = problem.stiffness() * u - load_harmonic(problem, 0).real();
  const Eigen::VectorXd after = moved.stiffness() * (u + u_0) - load_harmonic(moved, 0).real();
  EXPECT_LE((before - after).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_EQ(load_harmonic(problem, 1), load_harmonic(moved, 1));
  const Eigen::MatrixXd W = contact_directions(problem);
  EXPECT_LE((contact_gaps(problem) - W.transpose() * u - contact_gaps(moved) + W.transpose() * (u + u_0))
                .cwiseAbs()
                .maxCoeff(),
            1e-13);
  EXPECT_LE(((W.transpose() * u_0).cwiseAbs().array() - 7.0).abs().maxCoeff(), 1e-13);
}

// The same force at each phase, however slow.
TEST(WithTimeScaled, KeepsTheForceOfAnUnbalance) {
  Problem problem = two_masses_with_two_stops();
  problem.force.push_back({.dof = 1, .cos = 0.5, .omega_power = 2});
  const Problem slower = with_time_scaled(problem, 3.0);
  EXPECT_LE((load_harmonic(slower, 1) - load_harmonic(problem, 1)).norm(), 1e-14);
}

TEST(MappedMotion, MovesTheOriginAndBack) {
  const MotionMap map{.displacement = 2.0, .origin = Eigen::VectorXd::Constant(1, 5.0)};
  const auto moved = std::make_shared<MappedMotion>(motion(), map);
  const Samples before = motion()->sample(16), there = moved->sample(16);
  EXPECT_LE((there.x - 2.0 * before.x).array().cwiseAbs().maxCoeff(), 5.0 + 1e-14);
  EXPECT_GE((there.x - 2.0 * before.x).minCoeff(), 5.0 - 1e-14);
  EXPECT_LE((MappedMotion(moved, map.inverse()).sample(16).x - before.x).cwiseAbs().maxCoeff(), 1e-14);
}

}  // namespace
}  // namespace signorini::transformations_test
