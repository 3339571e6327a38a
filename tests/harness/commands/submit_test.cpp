// `signorini submit`.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/files.hpp"
#include "harness/run_folder/record_store.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"
#include "tests/harness/stored_records.hpp"
#include "tests/support/other_programs.hpp"

namespace signorini::submit_test {
namespace {

using Json = nlohmann::ordered_json;
using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

TEST(CommandSubmit, PrintsTheScriptsOfASubmissionAndWritesNone) {
  const auto folder = test::fresh_folder("submit");
  const std::string out = (folder / "not-made").string();
  const Outcome outcome = run("submit slurm " + out + " --shards 3 --dry-run quick --scenes 'sdof*'");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("--array=1-3"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("--scenes 'sdof*'"), std::string::npos) << outcome.out;
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(CommandSubmit, RefusesASubmissionWhoseShardsCouldNotStart) {
  const std::string out = (test::fresh_folder("refused") / "not-made").string();
  for (const char* words : {"--out elsewhere", "--shard 1/2", "--timeout never"}) {
    const Outcome outcome = run("submit slurm " + out + " --shards 2 --dry-run smoke " + words);
    EXPECT_EQ(outcome.code, 2) << words;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  EXPECT_EQ(run("submit parallel " + out + " --shards 2 --dry-run smoke --beside 2").code, 2);
}

TEST(CommandSubmit, CallsASubmissionThatTheLauncherRefusesBadUsage) {
  const auto folder = test::fresh_folder("submit-refused");
  std::ofstream(folder / "sbatch") << "#!/bin/sh\nexit 1\n";
  std::filesystem::permissions(folder / "sbatch", std::filesystem::perms::owner_all);
  const std::string path = std::getenv("PATH");
  ASSERT_EQ(::setenv("PATH", (folder.string() + ":" + path).c_str(), 1), 0);
  const Outcome outcome = run(fmt::format(
      "submit slurm {}/out --shards 2 quick --scenes sdof-stop --methods hat-lcp", folder.string()));
  ASSERT_EQ(::setenv("PATH", path.c_str(), 1), 0);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err,
            fmt::format("launcher = sbatch (must take {}/out/submit.sh, which ended with exit code 1)\n",
                        folder.string()));
}

TEST(CommandSubmit, RunsShardsByGnuParallel) {
  // moreutils has another program of that name.
  if (!test::succeeds("parallel --version | grep '^GNU parallel'"))
    GTEST_SKIP() << "GNU parallel is not installed";
  const auto folder = test::fresh_folder("parallel");
  const Outcome outcome = run("submit parallel " + folder.string() +
                              " --shards 2 --at-once 2 quick --scenes sdof-stop:sdof-far-stop --methods "
                              "'hat-lcp[samples=64]' --repetitions 1");
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  const auto records = read_records(folder / "merged" / "records.jsonl");
  ASSERT_EQ(records.size(), 2U);
  for (const Record& record : records) {
    if (record.seconds) {
      EXPECT_EQ(record.seconds->jobs, 2);
    }
  }
  EXPECT_EQ(Json::parse(read_file(folder / "merged" / "manifest.json"))["times_comparable"], false);
}

}  // namespace
}  // namespace signorini::submit_test
