#include "methods/hat_functions/hat_contact.hpp"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <numbers>
#include <optional>
#include <string>

#include "methods/structure/receptance.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "tests/support/damped_chain.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::hat_contact_test {
namespace {

const test::ImpactOscillator kImpacts{.damping = 0.1, .frequency = 1.5, .gap = 0.2, .restitution = 0.8};

Solution solve(const test::ImpactOscillator& oscillator, const HatSettings& grid) {
  const Problem scene = test::to_problem(oscillator);
  return hat_contact(scene, grid, {oscillator.restitution})->solve({});
}

TEST(HatContact, FindsTheSameContactByEverySolverThatConverges) {
  const Solution expected = solve(kImpacts, {.samples = 128});
  ASSERT_EQ(expected.verdict, Verdict::converged);
  EXPECT_LE(expected.residual.value(), 1e-10);
  const Solution by_pivots = solve(kImpacts, {.samples = 128, .solver = ComplementaritySolver::pivoting});
  ASSERT_EQ(by_pivots.verdict, Verdict::converged);
  const Eigen::MatrixXd force = expected.trajectory->sample(128).force;
  EXPECT_LE((by_pivots.trajectory->sample(128).force - force).norm(), 1e-8 * force.norm());
}

TEST(HatContact, KeepsToTheLimitOnPivots) {
  const Solution limited = solve(kImpacts, {.samples = 128, .max_iterations = 2});
  EXPECT_EQ(limited.verdict, Verdict::not_converged);
  EXPECT_EQ(limited.message, describe(LcpStatus::limit));
  EXPECT_EQ(limited.work.pivots, 2);
}

TEST(HatContact, RecognisesPermanentContactWithoutAPivot) {
  const Solution pressed =
      solve({.damping = 0.1, .frequency = 1.5, .gap = -3.0, .restitution = 0.0}, {.samples = 64});
  ASSERT_EQ(pressed.verdict, Verdict::converged);
  EXPECT_LT(pressed.trajectory->sample(64).force.maxCoeff(), 0.0);
  EXPECT_EQ(pressed.work.pivots, 0);
}

// A path of pivots and Newton's method from the march lead to one solution. At the spring there are too many
// unknowns in contact to factorise.
TEST(HatContact, MarchesToTheContactThatPivotingFindsOnFineGrids) {
  for (const bool massless : {false, true}) {
    Problem scene = test::to_problem(test::ImpactOscillator{.damping = 0.1, .frequency = 0.9, .gap = 0.0});
    scene.set_law(Penalty{{3.0}});
    if (massless) scene = test::massless_bar({.alpha = 0.2, .beta = 0.005}, 10);
    constexpr int kSamples = 4096;
    const Solution marched = hat_contact(scene, {.samples = kSamples}, {})->solve({});
    const Solution pivoted =
        hat_contact(scene, {.samples = kSamples, .solver = ComplementaritySolver::pivoting}, {})->solve({});
    ASSERT_EQ(marched.verdict, Verdict::converged) << massless << marched.message;
    ASSERT_EQ(pivoted.verdict, Verdict::converged) << massless;
    EXPECT_EQ(marched.work.pivots, 0);
    EXPECT_GT(pivoted.work.pivots.value(), 100);
    const Eigen::MatrixXd force = pivoted.trajectory->sample(kSamples).force;
    if (!massless) {
      EXPECT_GT((force.array() < 0.0).count(), 600) << "the limit of factorisations";
    }
    EXPECT_LE((marched.trajectory->sample(kSamples).force - force).norm(), 1e-8 * force.norm());
  }
}

// Complete chatter of an inelastic contact: the path is long, marching is not.
TEST(HatContact, LeavesALongPathForMarching) {
  const Solution chatter =
      solve({.damping = 0.02, .frequency = 0.25, .gap = 0.0, .restitution = 0.5}, {.samples = 512});
  ASSERT_EQ(chatter.verdict, Verdict::converged);
  EXPECT_LE(chatter.work.pivots.value(), 104 * 512);
  EXPECT_LE(chatter.residual.value(), 1e-10);
}

// Contact that lasts on a fine grid: a pivot costs the square of the pressures held.
TEST(HatContact, LeavesAPathOfManyPressuresForMarching) {
  constexpr int kSamples = 512;
  const test::ImpactOscillator sticking{.damping = 0.1, .frequency = 0.25, .gap = 0.0, .restitution = 0.0};
  const Solution marched = solve(sticking, {.samples = kSamples});
  const Solution pivoted = solve(sticking, {.samples = kSamples, .solver = ComplementaritySolver::pivoting});
  ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
  ASSERT_EQ(pivoted.verdict, Verdict::converged) << pivoted.message;
  const Eigen::MatrixXd force = pivoted.trajectory->sample(kSamples).force;
  EXPECT_GT((force.array() < 0.0).count(), 128);
  EXPECT_LT(marched.work.pivots.value(), pivoted.work.pivots.value());
  EXPECT_LE((marched.trajectory->sample(kSamples).force - force).norm(), 1e-8 * force.norm());
}

constexpr int kNodes = 24;

/// The ring of nodal equations A_+ u_{k+1} + A_0 u_k + A_- u_{k-1} = f_k, solved as one dense system: x per
/// node.
Eigen::MatrixXd ring_solution(const Problem& problem, HatScheme scheme) {
  const double dt = problem.period() / kNodes;
  const Eigen::MatrixXd m(problem.mass()), d(problem.damping()), k(problem.stiffness());
  const double outer = scheme == HatScheme::galerkin ? 1.0 / 6.0 : 0.0;
  const Eigen::Index size = m.rows();
  Eigen::MatrixXd ring = Eigen::MatrixXd::Zero(kNodes * size, kNodes * size);
  Eigen::VectorXd load(kNodes * size);
  const auto add = [&](int row, int column, const Eigen::MatrixXd& block) {
    ring.block(row * size, (column + kNodes) % kNodes * size, size, size) += block;
  };
  for (int i = 0; i < kNodes; ++i) {
    if (scheme == HatScheme::backward) {
      add(i, i, m / (dt * dt) + d / dt + k);
      add(i, i - 1, -2.0 * m / (dt * dt) - d / dt);
      add(i, i - 2, m / (dt * dt));
    } else {
      add(i, i + 1, m / (dt * dt) + d / (2.0 * dt) + outer * k);
      add(i, i, -2.0 * m / (dt * dt) + (1.0 - 2.0 * outer) * k);
      add(i, i - 1, m / (dt * dt) - d / (2.0 * dt) + outer * k);
    }
    load.segment(i * size, size) = outer * (load_at(problem, (i - 1) * dt) + load_at(problem, (i + 1) * dt)) +
                                   (1.0 - 2.0 * outer) * load_at(problem, i * dt);
  }
  const Eigen::VectorXd u = lu_solve(ring, load);
  const Eigen::MatrixXd directions(contact_directions(problem));
  return (directions.transpose() * u.reshaped(size, kNodes)).transpose();
}

TEST(HatContact, WithFarStopsIsTheRingOfNodalEquations) {
  Problem problem = test::damped_chain(3);
  for (Contact& contact : problem.contacts) contact.gap = 1e3;
  for (const HatScheme scheme : {HatScheme::galerkin, HatScheme::nodal, HatScheme::backward}) {
    const Solution solution =
        hat_contact(problem, {.samples = kNodes, .scheme = scheme}, {0.5, 0.5})->solve({});
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    const Samples samples = solution.trajectory->sample(kNodes);
    const Eigen::MatrixXd expected = ring_solution(problem, scheme);
    EXPECT_LE((samples.x - expected).norm(), 1e-10 * expected.norm());
    EXPECT_EQ(samples.force.norm(), 0.0);
    EXPECT_EQ(solution.work.pivots, 0);
  }
}

TEST(HatContact, SatisfiesTheContactConditionAtItsNodes) {
  constexpr double kRestitution = 0.7;
  const Problem problem =
      test::to_problem({.damping = 0.1, .frequency = 1.5, .gap = 0.2, .restitution = kRestitution});
  constexpr int kFine = 128;
  const Solution solution = hat_contact(problem, {.samples = kFine}, {kRestitution})->solve({});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  const Samples samples = solution.trajectory->sample(kFine);
  const double largest = samples.force.cwiseAbs().maxCoeff();
  EXPECT_GT(largest, 0.0);
  EXPECT_LE(samples.force.maxCoeff(), 0.0);
  for (int k = 0; k < kFine; ++k) {
    const double ahead = samples.x((k + 1) % kFine, 0);
    const double behind = samples.x((k + kFine - 1) % kFine, 0);
    const double room = 0.2 - (ahead + kRestitution * behind) / (1.0 + kRestitution);
    EXPECT_GE(room, -1e-8);
    EXPECT_LE(std::abs(room * samples.force(k, 0)), 1e-8 * largest);
  }
}

TEST(HatContact, OfASceneWithoutContactsIsItsLinearResponse) {
  Problem problem = test::damped_chain(3, 0);
  problem.set_law(std::monostate{});
  const Solution solution = hat_contact(problem, {.samples = kNodes}, {})->solve({});
  EXPECT_EQ(solution.verdict, Verdict::converged);
  EXPECT_NE(solution.message.find("no contact"), std::string::npos);
  EXPECT_EQ(solution.work.unknowns, 0);
}

Problem loaded_at(int harmonic, int subharmonic = 1) {
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 1.5, .gap = 0.2, .restitution = 0.8});
  problem.force = {{0, harmonic, 1.0, 0.0}};
  problem.subharmonic = subharmonic;
  return problem;
}

TEST(CoarsestHatGrid, HasSixteenNodesPerOscillationOfTheLoadFrom256To4096) {
  EXPECT_EQ(coarsest_hat_grid(loaded_at(1)), 256);
  EXPECT_EQ(coarsest_hat_grid(loaded_at(16)), 256);
  EXPECT_EQ(coarsest_hat_grid(loaded_at(17)), 512);
  EXPECT_EQ(coarsest_hat_grid(loaded_at(10, 4)), 1024);
  EXPECT_EQ(coarsest_hat_grid(loaded_at(10000)), 4096);
}

TEST(HatGrids, HaveFourTimesAsManyNodesEachUpToTheFinest) {
  const Problem problem = loaded_at(1);
  Resolutions grids = hat_grids(problem, {.samples = 7}, {0.8});
  ASSERT_EQ(grids.count(), 3U);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(grids.value(k), 256 << 2 * k);
  // Each prepared for its own number of nodes, not for that of the settings.
  EXPECT_EQ(grids.at(0).solve({}).work.unknowns, 256);
}

TEST(RefinedHatContact, AgreesOnTwoGridsBeforeItAnswers) {
  const Problem problem = loaded_at(1);
  const Solution solution = refined_hat_contact(problem, {}, {0.8})->solve({});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_GE(solution.work.unknowns, 1024);
  EXPECT_NE(solution.message.find("N = "), std::string::npos);
}

// Above 2000 coordinates the reduced structure marches to a motion so near that Newton's method ends at the
// solution, without a pivot: the one that pivoting finds cold.
TEST(HatContact, OfALargeStructureBeginsAtItsMarch) {
  const Problem block = test::padded_block_problem({});
  const Solution marched = hat_contact(block, {.samples = 64}, {})->solve({});
  ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
  EXPECT_EQ(marched.work.pivots, 0);
  const Solution pivoted =
      hat_contact(block, {.samples = 64, .solver = ComplementaritySolver::pivoting}, {})->solve({});
  ASSERT_EQ(pivoted.verdict, Verdict::converged) << pivoted.message;
  EXPECT_GT(pivoted.work.pivots.value_or(0), 0);
  const Eigen::MatrixXd x = marched.trajectory->sample(64).x;
  EXPECT_LT((x - pivoted.trajectory->sample(64).x).norm(), 1e-8 * x.norm());
}

}  // namespace
}  // namespace signorini::hat_contact_test
