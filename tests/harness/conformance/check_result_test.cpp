#include "harness/conformance/check_result.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace signorini {
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

}  // namespace
}  // namespace signorini
