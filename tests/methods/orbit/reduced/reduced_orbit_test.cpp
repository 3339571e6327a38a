#include "methods/orbit/reduced/reduced_orbit.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "methods/discretisation/trajectories.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::reduced_orbit_test {
namespace {

TEST(ReducedOrbit, IsWhatTheMethodAnswersWhereAClosedFormOfAllCoordinatesIsTooLarge) {
  const Problem bar = test::massless_bar({.alpha = 0.2, .beta = 0.005}, kMostInDenseFlow + 1);
  ASSERT_TRUE(ExactOrbitMethod({}).supports(bar).ok);
  const Solution solution = test::solve<ExactOrbitMethod>(bar, {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_NE(solution.message.find("vectors by marching"), std::string::npos) << solution.message;
  EXPECT_NE(solution.message.find("error bar"), std::string::npos) << solution.message;
  EXPECT_FALSE(ExactOrbitMethod({}).supports(test::stopped_chain(kMostInDenseFlow + 1, 0.5, 1)).ok);
}

// Another number of vectors to solve on leads to the same orbit within both bars, from a march and from the
// motion of the other.
TEST(ReducedOrbit, OfABlockAboveNineNodesHasTwelveEvents) {
  const Problem block = test::padded_block_problem({});
  const ContactSpace space(block);
  const ReducedOrbit found = find_reduced_orbit(block, space, {});
  const CorrectedOrbit& corrected = found.corrected;
  ASSERT_TRUE(corrected.bar) << corrected.refusal << corrected.orbit.reason;
  EXPECT_EQ(corrected.orbit.trajectory->orbit().events.size(), 12U);
  EXPECT_LT(*corrected.bar, 1e-7);
  EXPECT_LT(largest_magnitude(corrected.orbit.multipliers.values), 1.0);
  const ContactSpace fewer(block, {.small = 40, .whole = 120});
  const ReducedOrbit other = polish_reduced_orbit(block, fewer, *corrected.orbit.trajectory, {});
  ASSERT_TRUE(other.corrected.bar) << other.corrected.refusal << other.corrected.orbit.reason;
  const Eigen::MatrixXd x = corrected.orbit.trajectory->sample(1024).x;
  const double apart = (x - other.corrected.orbit.trajectory->sample(1024).x).norm();
  EXPECT_LE(apart, (*corrected.bar + *other.corrected.bar) * (x.rowwise() - x.colwise().mean()).norm());
}

// Prepared at one frequency and taken to another, from the orbit before and from rest: the orbit of a method
// that was prepared there.
TEST(ReducedOrbit, OfAnotherFrequencyNeedsNoOtherPreparation) {
  const Problem block = test::padded_block_problem({});
  Problem faster = block;
  faster.frequency *= 1.01;
  const ExactOrbitMethod method({});
  const auto prepared = method.prepare(block);
  const Solution before = prepared->solve({});
  ASSERT_EQ(before.verdict, Verdict::converged) << before.message;
  ASSERT_TRUE(prepared->take_frequency(faster));
  const Solution anew = method.prepare(faster)->solve({});
  ASSERT_EQ(anew.verdict, Verdict::converged) << anew.message;
  const Eigen::MatrixXd x = anew.trajectory->sample(512).x;
  const Samples start = before.trajectory->sample(1024);
  const auto stretched = std::make_shared<NodalTrajectory>(faster.period(), start.x, start.force);
  EXPECT_GT((before.trajectory->sample(512).x - x).norm(), 1e-3 * x.norm());
  for (const bool guessed : {true, false}) {
    const Solution taken = prepared->solve({.guess = guessed ? stretched : nullptr});
    ASSERT_EQ(taken.verdict, Verdict::converged) << taken.message;
    EXPECT_EQ(taken.message.find("the motion given") != std::string::npos, guessed) << taken.message;
    EXPECT_DOUBLE_EQ(taken.trajectory->period(), faster.period());
    EXPECT_LT((taken.trajectory->sample(512).x - x).norm(), 1e-6 * x.norm());
  }
}

// On the vectors of the orbit before, a step of a response needs no correction; a step of a tenth does, and
// its bar is of the same size. Both lead to the orbit found from rest within the bars.
TEST(ReducedOrbit, ContinuedIsSeldomCorrected) {
  const Problem block = test::padded_block_problem({});
  const ContactSpace space(block);
  const ReducedOrbit before = find_reduced_orbit(block, space, {});
  ASSERT_TRUE(before.corrected.bar) << before.corrected.refusal;
  ASSERT_TRUE(before.corrected.space);
  const Samples start = before.corrected.orbit.trajectory->sample(1024);
  for (const double step : {1e-3, 0.1}) {
    Problem faster = block;
    faster.frequency *= 1.0 + step;
    const ReducedOrbit anew = find_reduced_orbit(faster, space.of(faster), {});
    ASSERT_TRUE(anew.corrected.bar) << anew.corrected.refusal;
    EXPECT_GT(anew.corrected.defects.size(), 1U);
    const NodalTrajectory stretched(faster.period(), start.x, start.force);
    const ReducedOrbit next =
        continue_reduced_orbit(faster, before.corrected.space->of(faster), stretched, {});
    ASSERT_TRUE(next.corrected.bar) << next.corrected.refusal << next.corrected.orbit.reason;
    EXPECT_EQ(next.corrected.defects.size() == 1, step < 0.01) << next.corrected.defects.size();
    EXPECT_LT(*next.corrected.bar, 1e-7);
    const Eigen::MatrixXd x = anew.corrected.orbit.trajectory->sample(512).x;
    EXPECT_LE((next.corrected.orbit.trajectory->sample(512).x - x).norm(),
              (*next.corrected.bar + *anew.corrected.bar) * (x.rowwise() - x.colwise().mean()).norm());
  }
}

TEST(ReducedOrbit, SaysWhatItDoesNotStandFor) {
  EXPECT_EQ(reduction_obstacle(test::massless_bar({.beta = 0.01}, 10)), "");
  EXPECT_EQ(reduction_obstacle(test::stopped_chain(5, 0.5, 1)),
            "a contact with mass and an impact law is another one in a reduced structure");
  Problem other = test::massless_bar({.beta = 0.01}, 10);
  other.edit_structure([](Structure& s) { s.damping.coeffRef(0, 0) += 1.0; });
  EXPECT_EQ(reduction_obstacle(other), "the damping is not proportional to mass and stiffness");
}

TEST(ReducedOrbit, IsPreferredOfLargeStructuresAndOfManySpringsWhereItStandsForThem) {
  const ProportionalDamping damping{.beta = 0.01};
  EXPECT_FALSE(prefers_reduction(test::massless_bar(damping, 10)));
  EXPECT_TRUE(prefers_reduction(test::massless_bar(damping, kMostInDenseFlow + 1)));
  EXPECT_FALSE(prefers_reduction(test::stopped_chain(kMostInDenseFlow + 1, 0.5, 1)));
  Problem sprung = test::massless_beam(damping, 10);
  sprung.set_law(Penalty{std::vector<double>(10, 1e3)});
  EXPECT_EQ(prefers_reduction(sprung), reduction_obstacle(sprung).empty());
  Problem alone = test::massless_bar(damping, kMostInDenseFlow + 1);
  alone.contacts.clear();
  EXPECT_FALSE(prefers_reduction(alone));
  EXPECT_NE(ExactOrbitMethod({}).supports(alone).reason.find("there is no contact"), std::string::npos);
}

}  // namespace
}  // namespace signorini::reduced_orbit_test
