#include <gtest/gtest.h>

#include <set>

#include "harness/run/runner.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::problem_digest_test {
namespace {

TEST(ProblemDigest, AsksForTheRepresentedLawAndNotForTheScenesOwn) {
  Problem one = test::one_mass(0.3);
  Problem other = one;
  other.name = "another-name";
  other.title = "another title";
  other.set_law(Restitution{0.5});
  EXPECT_EQ(problem_digest(one, Restitution{1.0}), problem_digest(other, Restitution{1.0}));
  EXPECT_NE(problem_digest(one, Restitution{1.0}), problem_digest(one, Restitution{0.5}));
  EXPECT_NE(problem_digest(one, Restitution{1.0}), problem_digest(one, Undetermined{}));
  EXPECT_EQ(problem_digest(one, Restitution{1.0}).size(), 16U);
}

TEST(ProblemDigest, TellsEveryPartOfAProblemApart) {
  const Problem problem = test::one_mass(0.3);
  std::set<std::string> digests{problem_digest(problem, Restitution{1.0})};
  const auto expect_new = [&](const char* what, const auto& change) {
    Problem changed = problem;
    change(changed);
    EXPECT_TRUE(digests.insert(problem_digest(changed, Restitution{1.0})).second) << what;
  };
  expect_new("mass", [](Problem& p) { p.edit_structure([](Structure& s) { s.mass *= 1.0 + 1e-15; }); });
  expect_new("damping", [](Problem& p) { p.edit_structure([](Structure& s) { s.damping *= 2.0; }); });
  expect_new("stiffness", [](Problem& p) { p.edit_structure([](Structure& s) { s.stiffness *= 2.0; }); });
  expect_new("frequency", [](Problem& p) { p.frequency *= 1.01; });
  expect_new("order", [](Problem& p) { p.subharmonic = 2; });
  expect_new("load", [](Problem& p) { p.force.front().sin += 0.1; });
  expect_new("gap", [](Problem& p) { p.contacts.front().gap += 0.1; });
  expect_new("direction", [](Problem& p) { p.contacts.front().normal.front().second = -1.0; });
}

}  // namespace
}  // namespace signorini::problem_digest_test
