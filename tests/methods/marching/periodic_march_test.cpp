#include "methods/marching/periodic_march.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/structure_scenes.hpp"

namespace signorini::periodic_march_test {
namespace {

/// A reduced structure and the stops before it.
struct ReducedScene {
  ContactReduction reduction;
  MarchGrid grid;
};

/// Largest amplitude of the contacts' free motion under the load's first harmonic [m].
double free_amplitude(const ContactReduction& reduction, double frequency) {
  const ContactReceptance receptance = contact_receptance(
      reduction, 2.0 * std::numbers::pi / frequency, 1, [&](int n) { return exact_weights(n * frequency); });
  return 2.0 * receptance.free_response.row(1).cwiseAbs().maxCoeff();
}

/// Blocks with 1, 9, 54 and 105 contacts on 60 vectors.
const std::vector<ContactReduction>& blocks() {
  static const std::vector<ContactReduction> reductions = [] {
    std::array<test::PaddedBlock, 4> blocks;
    blocks[0].patch = {{{2.0, 2.0}, {0.2, 0.2}}};
    blocks[2].patch = {{{1.2, 2.0}, {0.0, 0.5}}};
    blocks[3].elements = {30, 6, 6};
    blocks[3].lengths = {3.0, 0.6, 0.6};
    blocks[3].patch = {{{1.6, 3.0}, {0.0, 0.6}}};
    std::vector<ContactReduction> made;
    for (const test::PaddedBlock& block : blocks)
      made.push_back(reduce_to_contacts(test::padded_block_problem(block), {.vectors = 60}));
    return made;
  }();
  return reductions;
}

/// Frequency 0.4 to 2.6 times the lowest, damping ratio of the lowest vector 0.005 to 0.1 from mass and from
/// stiffness, the latter whole, a tenth or a hundredth of it; gaps -0.1 to 0.9 of the free amplitude.
ReducedScene random_scene(std::mt19937& random, int samples) {
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  constexpr std::array<double, 3> kParts{1.0, 0.1, 0.01};
  constexpr std::array<double, 6> kGaps{-0.1, 0.0, 0.15, 0.3, 0.6, 0.9};
  ReducedScene scene{blocks()[random() % 4], {}};
  const double lowest = std::sqrt(scene.reduction.squares[0]);
  const double frequency = lowest * uniform(0.4, 2.6);
  const double ratio = std::pow(10.0, uniform(-2.3, -1.0));
  scene.reduction.damp({ratio * lowest, ratio / lowest * kParts[random() % 3]});
  scene.reduction.rates[1] = frequency;
  const double gap = kGaps[random() % 6] * free_amplitude(scene.reduction, frequency);
  scene.grid = {.gap = Eigen::VectorXd::Constant(scene.reduction.contacts(), gap),
                .compliance = Eigen::VectorXd::Zero(scene.reduction.contacts()),
                .period = 2.0 * std::numbers::pi / frequency,
                .samples = samples};
  return scene;
}

/// What makes a motion one of the scene: marched once more it repeats, and Signorini's conditions hold.
void expect_periodic(const ReducedScene& scene, const PeriodicMarch& answer) {
  ContactMarch again(scene.reduction, scene.grid);
  const Eigen::VectorXd next = again.period(answer.state);
  EXPECT_LE((next - answer.state).norm(), 1e-9 * answer.state.norm());
  EXPECT_LE((again.motion() - answer.motion).norm(), 1e-8 * answer.motion.norm());
  EXPECT_LE(answer.force.maxCoeff(), 0.0);
  const Eigen::MatrixXd room = (-answer.motion).rowwise() + scene.grid.gap.transpose();
  EXPECT_GE(room.minCoeff(), -1e-12 * answer.motion.cwiseAbs().maxCoeff());
  EXPECT_LE(room.cwiseProduct(answer.force).cwiseAbs().maxCoeff(),
            1e-12 * room.cwiseAbs().maxCoeff() * answer.force.cwiseAbs().maxCoeff());
}

class RandomScenes : public testing::TestWithParam<unsigned> {};

TEST_P(RandomScenes, AreSolvedFortyOfForty) {
  constexpr int kScenes = 40;
  std::mt19937 random(GetParam());
  int found = 0, by_first_newton = 0;
  std::vector<long> periods;  // marched, for each scene
  for (int i = 0; i < kScenes; ++i) {
    const ReducedScene scene = random_scene(random, 128);
    ContactMarch march(scene.reduction, scene.grid);
    const PeriodicMarch answer = march_to_periodic_motion(march);
    EXPECT_TRUE(answer.found()) << "seed " << GetParam() << ", scene " << i << ": residual "
                                << answer.residual;
    if (!answer.found()) continue;
    ++found;
    if (answer.by == MarchedBy::newton) ++by_first_newton;
    periods.push_back((answer.work.steps + answer.work.tangent_steps) / 128);
    expect_periodic(scene, answer);
    EXPECT_LT(answer.force.minCoeff(), 0.0);
    EXPECT_LE(static_cast<double>(answer.work.sets), 1.6 * static_cast<double>(answer.work.steps));
  }
  EXPECT_EQ(found, kScenes);
  EXPECT_GE(by_first_newton, 32);
  // Three of 120 begin in a long irregular motion, whose length depends on rounding, and so on the processor.
  std::ranges::sort(periods);
  EXPECT_LE(periods.at(9 * periods.size() / 10), 500);
  EXPECT_LE(periods.back(), 10000);
  RecordProperty("seed", static_cast<int>(GetParam()));
  RecordProperty("solved", found);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomScenes, testing::Values(1U, 2U, 9U));

/// Contacts that press with the same force everywhere at rest and open in part when shaken.
ReducedScene conforming(const ContactReduction& reduction, int samples) {
  ReducedScene scene{reduction, {}};
  const double lowest = std::sqrt(reduction.squares[0]);
  const double frequency = 0.9 * lowest;
  scene.reduction.damp({0.05 * lowest, 0.02 / lowest});
  scene.reduction.rates[1] = frequency;
  const Eigen::MatrixXd statics =
      contact_receptance(scene.reduction, 1.0, 0, [](int) { return exact_weights(0.0); })
          .receptance.front()
          .real();
  const Eigen::VectorXd deflection = statics.rowwise().sum();
  const double amplitude = free_amplitude(scene.reduction, frequency);
  scene.grid = {.gap = -0.3 * amplitude * deflection / deflection.cwiseAbs().maxCoeff(),
                .compliance = Eigen::VectorXd::Zero(reduction.contacts()),
                .period = 2.0 * std::numbers::pi / frequency,
                .samples = samples};
  return scene;
}

double closed_share(const PeriodicMarch& answer) {
  return (answer.force.array() < 0.0).cast<double>().mean();
}

// Pivoting over a whole period counts its pivots by the closed nodes; the march does not mind.
TEST(MarchToPeriodicMotion, SolvesAConformingPreload) {
  for (const std::size_t block : {1U, 2U, 3U}) {
    const ReducedScene scene = conforming(blocks()[block], 256);
    ContactMarch march(scene.reduction, scene.grid);
    const PeriodicMarch answer = march_to_periodic_motion(march);
    ASSERT_TRUE(answer.found()) << block << ": " << answer.residual;
    expect_periodic(scene, answer);
    EXPECT_GT(closed_share(answer), 0.5);
    EXPECT_LT(closed_share(answer), 1.0);
  }
}

TEST(MarchToPeriodicMotion, SolvesAConformingPreloadOf420Contacts) {
  const test::PaddedBlock plate{
      .elements = {24, 24, 2}, .lengths = {1.0, 1.0, 0.1}, .patch = {{{5.0 / 24.0, 1.0}, {4.0 / 24.0, 1.0}}}};
  const ContactReduction reduction = reduce_to_contacts(test::padded_block_problem(plate), {.vectors = 60});
  ASSERT_EQ(reduction.obstacle, "");
  ASSERT_EQ(reduction.contacts(), 420);
  const ReducedScene scene = conforming(reduction, 256);
  ContactMarch march(scene.reduction, scene.grid);
  const PeriodicMarch answer = march_to_periodic_motion(march);
  ASSERT_TRUE(answer.found()) << answer.residual;
  expect_periodic(scene, answer);
  EXPECT_GT(closed_share(answer), 0.4);
  EXPECT_LT(closed_share(answer), 1.0);
  EXPECT_LE(answer.work.steps + answer.work.tangent_steps, 60 * 256);
}

// Steps, which cost the same each: four times the nodes are at most five times the work.
TEST(MarchToPeriodicMotion, IsLinearInTheNodes) {
  for (const std::size_t block : {1U, 2U, 3U}) {
    for (const bool preloaded : {false, true}) {
      std::array<double, 2> work{};
      for (const std::size_t fine : {0U, 1U}) {
        const int samples = fine == 0 ? 256 : 1024;
        ReducedScene scene = conforming(blocks()[block], samples);
        if (!preloaded) scene.grid.gap.setConstant(scene.grid.gap.cwiseAbs().maxCoeff());
        ContactMarch march(scene.reduction, scene.grid);
        const PeriodicMarch answer = march_to_periodic_motion(march);
        ASSERT_TRUE(answer.found());
        EXPECT_LT(answer.force.minCoeff(), 0.0);
        work[fine] = static_cast<double>(answer.work.steps + answer.work.tangent_steps + answer.work.sets);
      }
      EXPECT_LE(work[1], 5.0 * work[0]) << block << preloaded;
    }
  }
}

TEST(MarchToPeriodicMotion, IsDeterministic) {
  std::mt19937 random(5);
  const ReducedScene scene = random_scene(random, 128);
  ContactMarch first(scene.reduction, scene.grid), second(scene.reduction, scene.grid);
  const PeriodicMarch one = march_to_periodic_motion(first), other = march_to_periodic_motion(second);
  ASSERT_TRUE(one.found());
  EXPECT_EQ(one.state, other.state);
  EXPECT_EQ(one.force, other.force);
  EXPECT_EQ(one.work.steps, other.work.steps);
}

// A state does not depend on the grid: that of 256 nodes is a few Newton steps from that of 512.
TEST(MarchFrom, GoesOnFromTheStateOfACoarserGrid) {
  const ReducedScene coarse = conforming(blocks()[1], 256), fine = conforming(blocks()[1], 512);
  ContactMarch first(coarse.reduction, coarse.grid), second(fine.reduction, fine.grid);
  const PeriodicMarch start = march_to_periodic_motion(first);
  ASSERT_TRUE(start.found());
  const PeriodicMarch answer = march_from(second, start.state);
  ASSERT_TRUE(answer.found());
  EXPECT_EQ(answer.by, MarchedBy::newton);
  EXPECT_LE(answer.newton_steps, 8);
  expect_periodic(fine, answer);
  double largest = 0.0;
  for (int k = 0; k < 256; ++k)
    largest = std::max(largest, (answer.motion.row(2 * k) - start.motion.row(k)).cwiseAbs().maxCoeff());
  EXPECT_LE(largest, 0.05 * answer.motion.cwiseAbs().maxCoeff());
}

TEST(MarchToPeriodicMotion, EndsWithTheTimeAndSaysSo) {
  std::mt19937 random(1);
  const ReducedScene scene = random_scene(random, 128);
  ContactMarch march(scene.reduction, scene.grid);
  const PeriodicMarch late = march_to_periodic_motion(
      march, {.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1)});
  EXPECT_FALSE(late.found());
  EXPECT_EQ(late.work.steps, 0);
  EXPECT_EQ(describe(late.by), "no periodic motion");
  EXPECT_EQ(describe(MarchedBy::anderson), "Anderson's acceleration");
}

}  // namespace
}  // namespace signorini::periodic_march_test
