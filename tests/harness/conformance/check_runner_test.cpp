// The checks on a sound method and on methods with one defect each.

#include "harness/conformance/check_runner.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <set>

#include "harness/conformance/check_result.hpp"
#include "harness/failure.hpp"
#include "tests/harness/conformance/flawed_method.hpp"

namespace signorini::check_runner_test {
namespace {

using test::Flaw;
using Names = std::set<std::string>;

std::vector<Scene> scenes(const std::vector<std::string>& names) {
  std::vector<Scene> found;
  for (const std::string& name : names) found.push_back(read_scene(find_scene(name)));
  return found;
}

Names failed_checks(const std::vector<CheckResult>& results) {
  Names names;
  for (const CheckResult& result : results) {
    if (result.outcome == CheckOutcome::failed) names.insert(result.check);
  }
  return names;
}

const CheckResult& failure_of(const std::vector<CheckResult>& results, const std::string& check) {
  for (const CheckResult& result : results) {
    if (result.check == check && result.outcome == CheckOutcome::failed) return result;
  }
  throw std::out_of_range(check);
}

struct Defect {
  Flaw flaw;
  Names found;
  const char* why;  // part of what is said of it
};

void PrintTo(const Defect& defect, std::ostream* out) {
  *out << static_cast<int>(defect.flaw) << ' ' << defect.why;
}

class Defects : public testing::TestWithParam<Defect> {};

TEST_P(Defects, AreFoundAndNothingElseIs) {
  const CheckOptions options{.scenes = scenes({"sdof-zero-gap", "chain3-stop"})};
  const std::vector<CheckResult> results = check_method(test::flawed_method(GetParam().flaw), options);
  EXPECT_EQ(failed_checks(results), GetParam().found)
      << review_text(test::flawed_method(GetParam().flaw), results);
  for (const std::string& check : GetParam().found) {
    const CheckResult& result = failure_of(results, check);
    if (check != *GetParam().found.begin()) continue;
    EXPECT_NE(result.why.find(GetParam().why), std::string::npos) << result.why;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, Defects,
    testing::Values(
        Defect{Flaw::accepts_any_option, {"refusals"}, "flux_capacitance is accepted"},
        Defect{Flaw::claims_too_high_an_order, {"order"}, "and 8 is declared"},
        Defect{Flaw::crashes_when_repeated, {"determinism"}, "signal 11"},
        Defect{Flaw::depends_on_numbering, {"numbering", "origin-shift"}, "differ by"},
        Defect{Flaw::depends_on_the_time_origin, {"time-shift", "origin-shift"}, "differ by"},
        Defect{Flaw::depends_on_the_unit_of_force, {"structure-scaling", "origin-shift"}, "differ by"},
        Defect{Flaw::depends_on_the_unit_of_length, {"load-scaling"}, "differ by"},
        Defect{Flaw::depends_on_the_unit_of_time, {"time-scaling", "origin-shift"}, "differ by"},
        Defect{Flaw::drifts, {"determinism"}, "two solves of one set-up differ in their trajectories"},
        Defect{Flaw::gives_up, {"contact-free", "convergence"}, "it is too hard"},
        Defect{Flaw::has_a_ladder_that_it_refuses, {"declaration"}, "harmonics = 0"},
        Defect{Flaw::ignores_its_budget, {"time-budget"}, "after its time was up"},
        Defect{Flaw::passes_through_stops, {"certificate"}, "inaccurate"},
        Defect{Flaw::refuses_without_reason, {"applicability"}, "without a reason"}));

TEST(Conformance, ASoundMethodPasses) {
  const MethodEntry entry = test::flawed_method(Flaw::none);
  const std::vector<CheckResult> results =
      check_method(entry, {.scenes = scenes({"sdof-zero-gap", "chain3-stop", "sdof-contact-free"})});
  EXPECT_FALSE(any_failed(results)) << review_text(entry, results);
  // Each check of a scene on each scene, and each had something to look at on the scenes with a stop.
  std::size_t passed = 0;
  for (const CheckResult& result : results) passed += result.outcome == CheckOutcome::passed ? 1 : 0;
  EXPECT_EQ(results.size(), 3U + 15U * 3U);
  EXPECT_GE(passed, 3U + 14U * 2U);
}

TEST(Conformance, ALawThatIsNotRepresentedIsFound) {
  const MethodEntry entry = test::flawed_method(Flaw::declares_another_law);
  const Names failed = failed_checks(check_method(entry, {.scenes = scenes({"sdof-stop"})}));
  EXPECT_EQ(failed, Names{"order"});
}

TEST(Conformance, AHangIsAFindingAndEndsTheQuestioningOnItsScene) {
  const MethodEntry entry = test::flawed_method(Flaw::hangs);
  const std::vector<CheckResult> results = check_method(
      entry,
      {.scenes = scenes({"sdof-zero-gap"}), .checks = "applicability:trajectory:numbering", .timeout = 0.2});
  ASSERT_EQ(results.size(), 3U);
  EXPECT_EQ(results[0].outcome, CheckOutcome::passed);
  EXPECT_EQ(results[1].outcome, CheckOutcome::failed);
  EXPECT_NE(results[1].why.find("time limit"), std::string::npos) << results[1].why;
  EXPECT_EQ(results[2].outcome, CheckOutcome::not_applicable);
}

TEST(Conformance, AsksOnlyWhatTheFilterTakesAndRefusesOneThatTakesNothing) {
  const MethodEntry entry = test::flawed_method(Flaw::none);
  const std::vector<CheckResult> results =
      check_method(entry, {.scenes = scenes({"sdof-stop"}), .checks = "load-scaling:time-s*"});
  ASSERT_EQ(results.size(), 3U);
  EXPECT_EQ(results.front().check, "load-scaling");
  EXPECT_THROW((void)check_method(entry, {.scenes = {}, .checks = "beauty"}), NothingMatched);
}

}  // namespace
}  // namespace signorini::check_runner_test
