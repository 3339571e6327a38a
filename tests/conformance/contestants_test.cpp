// Contestants are what their names say: each solves its own equations by its own algorithm.

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

#include "harness/records/sampled_trajectory.hpp"
#include "methods/catalogue.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini::contestants_test {
namespace {

class Contestants : public testing::TestWithParam<const char*> {};

// Scenes of impacts on rigid stops. Where nothing is struck, or on springs, equations of several methods
// coincide; a method that declares the equations of another one may come to its very bits.
TEST_P(Contestants, GiveNoTwoTheSameAnswer) {
  const Problem problem = load_scene(find_scene(GetParam()));
  ASSERT_TRUE(std::holds_alternative<Restitution>(problem.law()));
  std::map<std::string, std::string> method_of;  // by the digest of the answer
  for (const MethodEntry& entry : method_catalogue()) {
    const std::unique_ptr<Method> method = entry.make({});
    if (!method->supports(problem).ok) continue;
    const Solution solution = method->prepare(problem)->solve({});
    if (solution.verdict != Verdict::converged) continue;
    const auto [known, fresh] = method_of.try_emplace(answer_digest(*solution.trajectory), entry.name);
    EXPECT_TRUE(fresh || known->second == same_equations_as(entry, method->options()))
        << entry.name << " answers as " << known->second << ": " << solution.message;
  }
  EXPECT_GE(method_of.size(), 6U);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Contestants,
                         testing::Values("sdof-stop", "sdof-light-damping", "sdof-two-sided", "sdof-zero-gap",
                                         "sdof-stop-e05", "chain2-stop", "chain3-stop"));

}  // namespace
}  // namespace signorini::contestants_test
