#include "harness/conformance/check_result.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "tests/harness/conformance/flawed_method.hpp"

namespace signorini::check_result_test {

namespace {

TEST(CheckResult, ReadsBackFromJsonWhatItWrote) {
  for (CheckResult result : {passed(), remarked("odd"), failed("it differs"), not_applicable("no contact")}) {
    for (const char* scene : {"", "sdof-stop"}) {
      result.check = "order";
      result.promise = "errs less";
      result.scene = scene;
      result.reproduce = "signorini solve sdof-stop";
      const CheckResult back = check_result_from_json(to_json(result));
      EXPECT_EQ(back.outcome, result.outcome);
      EXPECT_EQ(back.why, result.why);
      EXPECT_EQ(back.reproduce, result.reproduce);
      EXPECT_EQ(back.check, result.check);
      EXPECT_EQ(back.promise, result.promise);
      EXPECT_EQ(back.scene, result.scene);
    }
  }
}

TEST(CheckResult, LeavesEmptyFieldsOutOfItsJson) {
  EXPECT_EQ(to_json(passed()).dump(), R"({"outcome":"passed"})");
  EXPECT_EQ(to_json(not_applicable("no contact")).dump(),
            R"({"outcome":"not-applicable","why":"no contact"})");
}

using test::Flaw;

CheckResult of_order(std::string scene, CheckResult result) {
  result.check = "order";
  result.promise = "errs less";
  result.scene = std::move(scene);
  return result;
}

TEST(Review, TellsWhatFailedWhereWhyAndHowToSeeItAgain) {
  const MethodEntry entry = test::flawed_method(Flaw::none);
  const std::vector<CheckResult> results{{.check = "echo", .promise = "echoes"},
                                         of_order("a", passed()),
                                         of_order("b", failed("it does not")),
                                         of_order("c", not_applicable("nothing there")),
                                         of_order("d", remarked("odd"))};
  const std::string text = review_text(entry, results);
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

}  // namespace signorini::check_result_test
