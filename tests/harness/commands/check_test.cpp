// `signorini check`: its review, its JSON and its exit codes.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"

namespace signorini::check_test {
namespace {

TEST(CommandCheck, PrintsAReviewAndExitsOneWhereSomethingFailed) {
  const test::Outcome sound = test::run_program("check hat-lcp --scenes sdof-stop");
  EXPECT_EQ(sound.code, 0) << sound.err;
  EXPECT_NE(sound.out.find("hat-lcp: 18 passed, 0 failed"), std::string::npos) << sound.out;
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

/// A command that says it converged, to a motion that is none of the scene's.
void write_lying_method(const std::filesystem::path& folder) {
  std::ofstream(folder / "method.toml")
      << "schema = 1\nname = \"liar\"\ntitle = \"t\"\nladder = \"level=1\"\ncommand = [\"sh\", \"liar.sh\"]\n"
         "[represents]\nrestitution = \"scene\"\n[[option]]\nname = \"level\"\ndefault = 1\nleast = 1\n"
         "most = 3\nunit = \"[-]\"\nmeaning = \"1..3\"\n";
  std::ofstream(folder / "liar.sh") << "cat >/dev/null; echo '{\"verdict\": \"converged\"}'\n";
}

TEST(CommandCheck, PrintsCommandsThatLoadThePluginAgain) {
  const std::filesystem::path folder = test::fresh_folder("check-plugin");
  write_lying_method(folder);
  const std::string checks = " --scenes sdof-stop --checks trajectory";
  const test::Outcome review = test::run_program("check --plugin method.toml" + checks, folder.string());
  ASSERT_EQ(review.code, 1) << review.out << review.err;
  const std::size_t begin = review.out.find("      signorini "), end = review.out.find('\n', begin + 1);
  ASSERT_NE(begin, std::string::npos) << review.out;
  const std::string line = review.out.substr(begin + 16, end - begin - 16);
  EXPECT_TRUE(line.ends_with(" --plugin method.toml")) << line;
  const test::Outcome again = test::run_program(line, folder.string());
  EXPECT_EQ(again.code, 1) << line << again.out << again.err;
  EXPECT_EQ(test::run_program("--plugin method.toml check" + checks, folder.string()).out, review.out);
}

TEST(CommandShow, TakesAPluginBeforeTheCommandAndAfterIt) {
  const std::filesystem::path folder = test::fresh_folder("show-plugin");
  write_lying_method(folder);
  const test::Outcome before = test::run_program("--plugin method.toml show liar", folder.string());
  EXPECT_EQ(before.code, 0) << before.err;
  EXPECT_EQ(before.out, test::run_program("show liar --plugin method.toml", folder.string()).out);
  EXPECT_EQ(test::run_program("show liar", folder.string()).code, 2);
}

}  // namespace
}  // namespace signorini::check_test
