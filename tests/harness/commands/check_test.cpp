// `signorini check`: its review, its JSON and its exit codes.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"

namespace signorini {
namespace {

TEST(CommandCheck, PrintsAReviewAndExitsOneWhereSomethingFailed) {
  const test::Outcome sound = test::run_program("check hat-lcp --scenes sdof-stop");
  EXPECT_EQ(sound.code, 0) << sound.err;
  EXPECT_NE(sound.out.find("hat-lcp: 17 passed, 0 failed"), std::string::npos) << sound.out;
  // 128 steps over two periods of the load are too few, as the suite quick says.
  const test::Outcome coarse =
      test::run_program("check hat-lcp --scenes sdof-subharmonic --checks certificate");
  EXPECT_EQ(coarse.code, 1);
  EXPECT_NE(coarse.out.find("signorini solve sdof-subharmonic --method hat-lcp --set samples=128"),
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

}  // namespace
}  // namespace signorini
