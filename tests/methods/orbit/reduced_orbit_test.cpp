#include "methods/orbit/reduced_orbit.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/methods/orbit/cold_orbit.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini {
namespace {

// A bar small enough for a closed form of all its coordinates: what the last vectors of a reduction change is
// more than what it still is wrong by, and more vectors are nearer.
TEST(ReducedOrbit, ConvergesToTheExactOrbitOfTheWholeBar) {
  const Problem bar = test::massless_bar({.alpha = 0.2, .beta = 0.005}, 60);
  const test::ColdOrbit whole = test::cold_orbit(bar);
  ASSERT_TRUE(whole.orbit) << whole.solution.message;
  ASSERT_GE(whole.orbit->orbit().events.size(), 2U);
  const Eigen::MatrixXd x = whole.orbit->sample(1024).x;
  double before = 1.0;
  for (const int vectors : {8, 12, 20}) {
    const ReducedPair pair(bar, vectors);
    ASSERT_GT(pair.fine.vectors(), pair.coarse.vectors());
    const ReducedOrbit found = find_reduced_orbit(bar, pair, {});
    ASSERT_TRUE(found.orbit.certified()) << found.orbit.reason;
    EXPECT_EQ(found.orbit.multipliers.size(), 2 * pair.fine.vectors() + 1);
    EXPECT_EQ(found.orbit.trajectory->orbit().events.size(), whole.orbit->orbit().events.size());
    const double error =
        (found.orbit.trajectory->sample(1024).x - x).cwiseAbs().maxCoeff() / x.cwiseAbs().maxCoeff();
    EXPECT_LT(error, found.change) << vectors;
    EXPECT_LT(error, 0.5 * before) << vectors;
    before = error;
  }
  EXPECT_LT(before, 1e-5);
}

TEST(ReducedOrbit, IsWhatTheMethodAnswersWhereAClosedFormOfAllCoordinatesIsTooLarge) {
  const Problem bar = test::massless_bar({.alpha = 0.2, .beta = 0.005}, kMostInDenseFlow + 1);
  ASSERT_TRUE(ExactOrbitMethod({}).supports(bar).ok);
  const Solution solution = test::solve<ExactOrbitMethod>(bar, {});
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_NE(solution.message.find("of the structure reduced to 90 vectors"), std::string::npos)
      << solution.message;
  EXPECT_FALSE(ExactOrbitMethod({}).supports(test::stopped_chain(kMostInDenseFlow + 1, 0.5, 1)).ok);
}

TEST(ReducedOrbit, OfABlockAboveNineNodesHasTwelveEvents) {
  const Problem block = test::to_problem(test::PaddedBlock{});
  const ReducedOrbit found = find_reduced_orbit(block, ReducedPair(block), {});
  ASSERT_TRUE(found.orbit.certified()) << found.orbit.reason;
  EXPECT_EQ(found.orbit.trajectory->orbit().events.size(), 12U);
  EXPECT_LT(found.orbit.error_bar, 1e-9);
  EXPECT_LT(found.change, 1e-4);
  EXPECT_LT(found.orbit.largest_multiplier(), 1.0);
}

TEST(ReducedOrbit, SaysWhatItDoesNotStandFor) {
  EXPECT_EQ(reduction_obstacle(test::massless_bar({.beta = 0.01}, 10)), "");
  EXPECT_EQ(reduction_obstacle(test::stopped_chain(5, 0.5, 1)),
            "a contact with mass and an impact law is another one in a reduced structure");
  Problem sprung = test::massless_bar({.beta = 0.01}, 10);
  sprung.law = Penalty{.stiffness = {10.0}};
  EXPECT_EQ(reduction_obstacle(sprung),
            "springs on a reduced structure whose damping grows with the stiffness");
  Problem other = test::massless_bar({.beta = 0.01}, 10);
  other.edit_structure([](Structure& s) { s.damping.coeffRef(0, 0) += 1.0; });
  EXPECT_EQ(reduction_obstacle(other), "the damping is not proportional to mass and stiffness");
}

}  // namespace
}  // namespace signorini
