#include "harness/responses/response_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/failure.hpp"
#include "problems/scene/scene_file.hpp"

namespace signorini::response_plan_test {
namespace {

constexpr const char* kSuite = R"(schema = 1
name = "curves"
title = "Curves"
methods = ["exact-orbit[samples=64]", "fourier-lipschitz[harmonics=10]", "event-driven[tolerance=1e-6]"]
by_steps = ["fourier-lipschitz[harmonics=10]"]
[[response]]
scene = "sdof-stop"
from = 2.3
to = 2.6
orders = 1
[[response]]
scene = "sdof-contact-free"
from = 2.3
to = 2.6
[limits]
timeout = 20.0
)";

std::vector<std::string> ids(const std::string& suite, const Narrowing& narrowing) {
  std::vector<std::string> found;
  const Plan plan =
      plan_of_suite(parse_suite(suite, "curves.toml"), narrowing, method_catalogue(), shipped_scenes());
  for (const Case& one : plan.cases) found.push_back(one.id);
  return found;
}

TEST(PlanOfSuite, TakesMethodsWithoutACurveByStepsAndOthersAsTheSuiteSays) {
  EXPECT_EQ(
      ids(kSuite, {.scenes = {"sdof-stop"}}),
      (std::vector<std::string>{"sdof-stop/exact response", "sdof-stop/exact-orbit[samples=64] by arc length",
                                "sdof-stop/fourier-lipschitz[harmonics=10] by arc length",
                                "sdof-stop/event-driven[tolerance=1e-6] by steps",
                                "sdof-stop/fourier-lipschitz[harmonics=10] by steps"}));
  EXPECT_EQ(ids(kSuite, {}).size(), 10U);
  EXPECT_EQ(ids(kSuite, {.methods = "exact-orbit", .scenes = {"sdof-stop"}}),
            (std::vector<std::string>{"sdof-stop/exact response",
                                      "sdof-stop/exact-orbit[samples=64] by arc length"}));
}

TEST(PlanOfSuite, RefusesFiltersThatLeaveNothing) {
  EXPECT_THROW(ids(kSuite, {.scenes = {"beam*"}}), NothingMatched);
  EXPECT_THROW(ids(kSuite, {.methods = "no-such-method"}), NothingMatched);
  EXPECT_THROW(ids(kSuite, {.scenes = {"own.toml"}}), std::runtime_error);
}

TEST(PlanOfSuite, MayHoldMotionsAndResponsesOfOneScene) {
  std::string both = kSuite;
  both.insert(both.find("[[response]]"), "scenes = [\"sdof-stop\", \"sdof-far-stop\"]\n");
  const Plan plan = plan_of_suite(parse_suite(both, "curves.toml"), {.methods = "exact-orbit"},
                                  method_catalogue(), shipped_scenes());
  EXPECT_EQ(plan.scenes.size(), 3U);  // sdof-stop once
  const auto motions = std::ranges::count_if(plan.cases, [](const Case& one) { return !one.response; });
  EXPECT_EQ(motions, 2);
  EXPECT_EQ(plan.cases.size(), 6U);
  EXPECT_EQ(ids(both, {.methods = "exact-orbit", .scenes = {"sdof-contact-free"}}).size(), 2U);
}

TEST(CaseKey, OfAResponseKnowsItsQuestionAndTheCodeOfWhatItIsMeasuredAgainst) {
  const Plan plan = plan_of_suite(parse_suite(kSuite, "curves.toml"), {.scenes = {"sdof-stop"}},
                                  method_catalogue(), shipped_scenes());
  const Scene& scene = plan.scenes.front();
  const auto key = [&](const Case& one) { return case_key(scene, one, {}, "v", "k"); };
  Case other = plan.cases[2];
  EXPECT_EQ(key(other), key(plan.cases[2]));
  EXPECT_NE(key(other), case_key(scene, other, {}, "v", "l"));
  other.response->to = 2.7;
  EXPECT_NE(key(other), key(plan.cases[2]));
  EXPECT_NE(key(plan.cases[2]), key(plan.cases[4])) << "by arc length and by steps";
  other.response.reset();
  EXPECT_NE(key(other), key(plan.cases[2])) << "a motion";
}

}  // namespace
}  // namespace signorini::response_plan_test
