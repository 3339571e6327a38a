// The conformance suite on a sound method and on methods with one defect each.

#include "harness/conformance/conformance.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <ostream>
#include <set>

#include "harness/conformance/review.hpp"
#include "harness/failure.hpp"
#include "tests/harness/conformance/flawed_method.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"

namespace signorini {
namespace {

using test::Flaw;
using Names = std::set<std::string>;

std::vector<Scene> scenes(const std::vector<std::string>& names) {
  std::vector<Scene> found;
  for (const std::string& name : names) found.push_back(read_scene(find_scene(name)));
  return found;
}

Names failed_checks(const std::vector<CheckFinding>& findings) {
  Names names;
  for (const CheckFinding& finding : findings) {
    if (finding.result.outcome == CheckOutcome::failed) names.insert(finding.check);
  }
  return names;
}

const CheckFinding& finding_of(const std::vector<CheckFinding>& findings, const std::string& check) {
  for (const CheckFinding& finding : findings) {
    if (finding.check == check && finding.result.outcome == CheckOutcome::failed) return finding;
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
  const ConformanceQuest quest{.scenes = scenes({"sdof-zero-gap", "chain2-stop"})};
  const std::vector<CheckFinding> findings = check_method(test::flawed_method(GetParam().flaw), quest);
  EXPECT_EQ(failed_checks(findings), GetParam().found)
      << review_text(test::flawed_method(GetParam().flaw), findings);
  for (const std::string& check : GetParam().found) {
    const CheckFinding& finding = finding_of(findings, check);
    if (check != *GetParam().found.begin()) continue;
    EXPECT_NE(finding.result.why.find(GetParam().why), std::string::npos) << finding.result.why;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, Defects,
    testing::Values(
        Defect{Flaw::accepts_any_option, {"refusals"}, "flux_capacitance is accepted"},
        Defect{Flaw::claims_too_high_an_order, {"order"}, "and 8 is declared"},
        Defect{Flaw::crashes_when_repeated, {"determinism"}, "signal 11"},
        Defect{Flaw::depends_on_numbering, {"numbering"}, "differ by"},
        Defect{Flaw::depends_on_the_time_origin, {"time-shift"}, "differ by"},
        Defect{Flaw::depends_on_the_unit_of_force, {"structure-scaling"}, "differ by"},
        Defect{Flaw::depends_on_the_unit_of_length, {"load-scaling"}, "differ by"},
        Defect{Flaw::depends_on_the_unit_of_time, {"time-scaling"}, "differ by"},
        Defect{Flaw::drifts, {"determinism"}, "two solves of one set-up differ in their trajectories"},
        Defect{Flaw::gives_up, {"contact-free", "convergence"}, "it is too hard"},
        Defect{Flaw::has_a_ladder_that_it_refuses, {"declaration"}, "harmonics = 0"},
        Defect{Flaw::ignores_its_budget, {"time-budget"}, "after its time was up"},
        Defect{Flaw::passes_through_stops, {"certificate"}, "inaccurate"},
        Defect{Flaw::refuses_without_reason, {"applicability"}, "without a reason"}));

TEST(Conformance, ASoundMethodPasses) {
  const MethodEntry entry = test::flawed_method(Flaw::none);
  const std::vector<CheckFinding> findings =
      check_method(entry, {.scenes = scenes({"sdof-zero-gap", "chain2-stop", "sdof-contact-free"})});
  EXPECT_FALSE(any_failed(findings)) << review_text(entry, findings);
  // Each check of a scene on each scene, and each had something to look at on the scenes with a stop.
  std::size_t passed = 0;
  for (const CheckFinding& finding : findings)
    passed += finding.result.outcome == CheckOutcome::passed ? 1 : 0;
  EXPECT_EQ(findings.size(), 3U + 13U * 3U);
  EXPECT_GE(passed, 3U + 13U * 2U);
}

TEST(Conformance, ALawThatIsNotRepresentedIsFound) {
  const MethodEntry entry = test::flawed_method(Flaw::declares_another_law);
  const Names failed = failed_checks(check_method(entry, {.scenes = scenes({"sdof-stop"})}));
  EXPECT_EQ(failed, Names{"order"});
}

TEST(Conformance, AHangIsAFindingAndEndsTheQuestioningOnItsScene) {
  const MethodEntry entry = test::flawed_method(Flaw::hangs);
  const std::vector<CheckFinding> findings = check_method(
      entry,
      {.scenes = scenes({"sdof-zero-gap"}), .checks = "applicability:trajectory:numbering", .timeout = 0.2});
  ASSERT_EQ(findings.size(), 3U);
  EXPECT_EQ(findings[0].result.outcome, CheckOutcome::passed);
  EXPECT_EQ(findings[1].result.outcome, CheckOutcome::failed);
  EXPECT_NE(findings[1].result.why.find("time limit"), std::string::npos) << findings[1].result.why;
  EXPECT_EQ(findings[2].result.outcome, CheckOutcome::not_applicable);
}

TEST(Conformance, AsksOnlyWhatTheFilterTakesAndRefusesOneThatTakesNothing) {
  const MethodEntry entry = test::flawed_method(Flaw::none);
  const std::vector<CheckFinding> findings =
      check_method(entry, {.scenes = scenes({"sdof-stop"}), .checks = "load-scaling:time-s*"});
  ASSERT_EQ(findings.size(), 3U);
  EXPECT_EQ(findings.front().check, "load-scaling");
  EXPECT_THROW((void)check_method(entry, {.scenes = {}, .checks = "beauty"}), NothingMatched);
}

TEST(CommandCheck, PrintsAReviewAndExitsOneWhereSomethingFailed) {
  const test::Outcome sound = test::run_program("check hat-lcp --scenes sdof-stop");
  EXPECT_EQ(sound.code, 0) << sound.err;
  EXPECT_NE(sound.out.find("hat-lcp: 16 passed, 0 failed"), std::string::npos) << sound.out;
  // Sixty-four steps over two periods of the load are too few, as the suite quick says.
  const test::Outcome coarse =
      test::run_program("check hat-lcp --scenes sdof-subharmonic --checks certificate");
  EXPECT_EQ(coarse.code, 1);
  EXPECT_NE(coarse.out.find("signorini solve sdof-subharmonic --method hat-lcp --set samples=64"),
            std::string::npos)
      << coarse.out;
}

TEST(CommandCheck, PrintsFindingsAsJsonOnASceneOfOnesOwn) {
  const auto folder = test::fresh_folder("check-own");
  ASSERT_EQ(test::run_program("new scene own", folder.string()).code, 0);
  const test::Outcome outcome =
      test::run_program("check hat-lcp --scenes ./own.toml --checks echo:order --json", folder.string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto list = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[1]["check"], "order");
  EXPECT_EQ(list[1]["scene"], "./own.toml");
  EXPECT_EQ(list[1]["outcome"], "passed");
}

TEST(Review, TellsWhatFailedWhereWhyAndHowToSeeItAgain) {
  const MethodEntry entry = test::flawed_method(Flaw::none);
  const std::vector<CheckFinding> findings{
      {.check = "echo", .promise = "echoes", .scene = "", .result = passed()},
      {.check = "order", .promise = "errs less", .scene = "a", .result = passed()},
      {.check = "order", .promise = "errs less", .scene = "b", .result = failed("it does not")},
      {.check = "order", .promise = "errs less", .scene = "c", .result = not_applicable("nothing there")},
      {.check = "order", .promise = "errs less", .scene = "d", .result = remarked("odd")}};
  const std::string text = review_text(entry, findings);
  EXPECT_NE(text.find("echo               echoes: passed\n"), std::string::npos) << text;
  EXPECT_NE(text.find("errs less: FAILED on 1 scene, passed on 2 scenes, nothing to look at on 1 scene\n"
                      "    b: it does not\n"
                      "      signorini check flawed-method --checks order --scenes b\n"
                      "    d: odd\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("flawed-method: 2 passed, 1 failed, 1 remarks, 1 had nothing to look at\n"),
            std::string::npos);
}

}  // namespace
}  // namespace signorini
