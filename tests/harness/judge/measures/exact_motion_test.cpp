#include "harness/judge/measures/exact_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "harness/judge/measures/measures.hpp"
#include "harness/plan/plan.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "harness/summary/coordinate_motion.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::exact_motion_test {
namespace {

struct Found {
  Problem problem;
  std::shared_ptr<const Trajectory> orbit;
  Motion motion;
};

Found exact_orbit_of(const Problem& problem) {
  const Solution solution = ExactOrbitMethod({}).prepare(problem)->solve({});
  EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
  return {problem, solution.trajectory, sample_motion(problem, *solution.trajectory)};
}

// The law says what follows a speed; the closed form says the speed.
TEST(ExactMotion, KnowsTheSpeedsOfItsImpactsToRounding) {
  for (const double e : {0.5, 0.8, 1.0}) {
    const test::ImpactOscillator oscillator{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = e};
    const Found found = exact_orbit_of(test::to_problem(oscillator));
    const Physics physics = measure_physics(found.problem, Restitution{e}, found.motion);
    ASSERT_EQ(physics.effective_restitution.size(), 1U);
    EXPECT_NEAR(physics.effective_restitution.front(), e, 1e-13);
    double nearest = 1.0;
    for (const test::SingleImpactOrbit& orbit : test::single_impact_orbits(oscillator))
      nearest = std::min(nearest, std::abs(*found.motion.speeds.front().before - orbit.approach));
    EXPECT_LT(nearest, 1e-12);
  }
}

// Of one mass the coordinate is the contact's: by its own state, and by the integrals of its force.
TEST(ExactMotion, HasTheSameCoordinateAsContact) {
  for (const char* scene : {"sdof-penalty-stiff", "stiff-penalty@1e8", "sdof-stick", "sdof-stop-e05"}) {
    const Found found = exact_orbit_of(read_scene(find_scene(scene)).problem);
    const double size = amplitude(found.motion);
    const CoordinateMotion own(found.problem, *found.orbit, found.motion, std::array{0});
    EXPECT_FALSE(own.error()) << scene;
    const auto count = static_cast<int>(found.motion.count());
    EXPECT_LT((own.displacement(count) - found.motion.samples.x).cwiseAbs().maxCoeff(), 1e-12 * size)
        << scene;
    EXPECT_LT((own.velocity(count) - found.motion.samples.velocity).cwiseAbs().maxCoeff(),
              1e-11 * found.motion.samples.velocity.cwiseAbs().maxCoeff())
        << scene;
  }
}

// The face of a damped stop has no mass: spring, damper and contact force balance there at every instant. Of
// a coordinate that only a response tells, the others are none the worse.
TEST(ExactMotion, HasTheFacesOfDampedStopsAndTheOthersBesideAny) {
  const Found found = exact_orbit_of(read_scene(find_scene("sdof-damped-stop")).problem);
  const CoordinateMotion both(found.problem, *found.orbit, found.motion, std::array{0, 1});
  EXPECT_FALSE(both.error());
  const auto count = static_cast<int>(found.motion.count());
  const Eigen::MatrixXd u = both.displacement(count), v = both.velocity(count);
  const Eigen::VectorXd force = found.motion.samples.force.col(0);
  const Eigen::VectorXd balance = u * Eigen::MatrixXd(found.problem.stiffness()).row(1).transpose() +
                                  v * Eigen::MatrixXd(found.problem.damping()).row(1).transpose() - force;
  ASSERT_GT(force.cwiseAbs().maxCoeff(), 0.0);
  EXPECT_LT(balance.cwiseAbs().maxCoeff(), 1e-9 * force.cwiseAbs().maxCoeff());

  Problem middle =
      found.problem;  // a third coordinate, without mass and contact, between the mass and ground
  middle.edit_structure([](Structure& s) {
    for (SparseMatrix* matrix : {&s.mass, &s.damping, &s.stiffness}) matrix->conservativeResize(3, 3);
    const double beta = s.damping.coeff(1, 1) / s.stiffness.coeff(1, 1);
    const auto add = [](SparseMatrix& A, double k) {
      A.coeffRef(0, 0) += k;
      A.coeffRef(0, 2) -= k;
      A.coeffRef(2, 0) -= k;
      A.coeffRef(2, 2) += 2.0 * k;
    };
    add(s.stiffness, 1.0);
    add(s.damping, beta);
  });
  const Found wider = exact_orbit_of(middle);
  const CoordinateMotion alone(middle, *wider.orbit, wider.motion, std::array{0});
  const CoordinateMotion beside(middle, *wider.orbit, wider.motion, std::array{2, 0});
  EXPECT_TRUE(beside.error());
  EXPECT_LT((beside.displacement(count).col(1) - alone.displacement(count).col(0)).cwiseAbs().maxCoeff(),
            1e-15 * amplitude(wider.motion));
}

// What is computed from samples says how far it may be off, and is not farther.
TEST(CoordinateMotionOfSamples, IsAsGoodAsItSays) {
  for (const char* scene : {"sdof-penalty-stiff", "sdof-stick"}) {
    const Found found = exact_orbit_of(read_scene(find_scene(scene)).problem);
    const SampledTrajectory sampled(*found.orbit, 8 * kGrid * found.motion.order);
    const Motion motion = sample_motion(found.problem, sampled);
    const CoordinateMotion field(found.problem, sampled, motion, std::array{0});
    const double apart = (field.displacement(motion.count()) - found.motion.samples.x).cwiseAbs().maxCoeff();
    EXPECT_LT(apart, field.error().value()) << scene;
    EXPECT_LT(*field.error(), 1e-4 * amplitude(found.motion)) << scene;
  }
}

}  // namespace
}  // namespace signorini::exact_motion_test
