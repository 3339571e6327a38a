// `signorini run` on a suite of frequency responses, and what the other commands make of its folder.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "harness/files.hpp"
#include "harness/run_folder/record_store.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"
#include "tests/harness/stored_records.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::run_responses_test {
namespace {

using Json = nlohmann::ordered_json;
using test::Outcome;

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
scene = "sdof-stop-e08"
from = 2.3
to = 2.6
[limits]
timeout = 20.0
repetitions = 1
)";

/// What does not depend on the clock.
std::map<std::string, std::string> answers_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> answers;
  std::ifstream lines(folder / "records.jsonl");
  for (std::string line; std::getline(lines, line);) {
    const Json record = Json::parse(line);
    EXPECT_TRUE(
        answers.emplace(record["case"], record["status"].get<std::string>() + record["response"].dump())
            .second)
        << "twice: " << record["case"];
  }
  return answers;
}

class RunResponses : public testing::Test {
 protected:
  [[nodiscard]] Outcome run(const std::string& options) const {
    return test::run_program("run " + suite_ + " --methods 'exact-orbit:fourier*' " + options);
  }
  [[nodiscard]] std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }

  test::TemporaryFolder folder_;
  std::string suite_ = folder_.write("curves.toml", kSuite).string();
};

TEST_F(RunResponses, MeasuresReportsAndResumes) {
  const std::string out = at("out").string();
  const Outcome first = run("--out " + out);
  ASSERT_EQ(first.code, 0) << first.err << first.out;
  EXPECT_NE(first.out.find("8 cases run, 0 already there"), std::string::npos) << first.out;
  EXPECT_NE(first.out.find("\nRigid stop (e = 1), 1 response: too few scenes to recommend\n"),
            std::string::npos)
      << first.out;
  const std::string table = read_file(at("out") / "table.md");
  EXPECT_NE(table.find("e = 1"), std::string::npos) << "the law of harmonic balance on sdof-stop-e08";
  const std::string records = read_file(at("out") / "records.jsonl");
  const Outcome second = run("--resume --out " + out);
  EXPECT_NE(second.out.find("0 cases run, 8 already there"), std::string::npos) << second.out;
  EXPECT_EQ(read_file(at("out") / "records.jsonl"), records);
  EXPECT_EQ(test::run_program("report " + out + " --format md,html").code, 0);
  EXPECT_EQ(read_file(at("out") / "table.md"), table);
  EXPECT_NE(read_file(at("out") / "report.html").find("id=\"response-verdict\""), std::string::npos);
  EXPECT_NE(test::run_program("status " + out).out.find("done"), std::string::npos);
  const Outcome compared = test::run_program(fmt::format("compare {0} {0}", out));
  EXPECT_EQ(compared.code, 0) << compared.out;
  EXPECT_NE(compared.out.find("8 cases compared"), std::string::npos) << compared.out;
}

TEST_F(RunResponses, GiveTheSameInShardsAndSideBySideAsInOne) {
  ASSERT_EQ(run("--out " + at("whole").string()).code, 0);
  for (const char* shard : {"1/2", "2/2"}) {
    const Outcome part =
        run(fmt::format("--shard {} --out {}", shard, at(std::string("part-") + shard[0]).string()));
    ASSERT_EQ(part.code, 0) << part.err;
  }
  const Outcome merged = test::run_program(
      fmt::format("merge {} {} --out {}", at("part-1").string(), at("part-2").string(), at("all").string()));
  ASSERT_EQ(merged.code, 0) << merged.err;
  const auto whole = answers_of(at("whole"));
  EXPECT_EQ(whole.size(), 8U);
  EXPECT_EQ(answers_of(at("all")), whole);
  ASSERT_EQ(run("--jobs 2 --out " + at("beside").string()).code, 0);
  EXPECT_EQ(answers_of(at("beside")), whole);
  EXPECT_EQ(test::run_program(fmt::format("compare {} {}", at("whole").string(), at("all").string())).code,
            0);
}

TEST_F(RunResponses, LoseAndDoubleNothingWhereTheyAreKilledAndResumed) {
  const std::filesystem::path folder = at("killed");
  const std::string out = folder.string(), binary = SIGNORINI_BINARY;
  const pid_t child = fork();
  if (child == 0) {
    if (freopen("/dev/null", "w", stdout) == nullptr || freopen("/dev/null", "w", stderr) == nullptr)
      _exit(99);
    execl(binary.c_str(), binary.c_str(), "run", suite_.c_str(), "--methods", "exact-orbit:fourier*", "--out",
          out.c_str(), nullptr);
    _exit(98);
  }
  std::error_code none;
  for (int i = 0; i < 6000; ++i) {
    const auto size = std::filesystem::file_size(folder / "records.jsonl", none);
    if (!none && size > 0) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  const std::size_t before = read_records(folder / "records.jsonl").size();
  ASSERT_GE(before, 1U);
  ASSERT_LT(before, 8U);
  const Outcome rest = run("--resume --out " + out);
  EXPECT_EQ(rest.code, 0) << rest.err;
  EXPECT_NE(rest.out.find(fmt::format("{} already there", before)), std::string::npos) << rest.out;
  EXPECT_EQ(answers_of(folder).size(), 8U);
}

TEST_F(RunResponses, PrintTheirPlan) {
  const Outcome plan = test::run_program("run " + suite_ + " --dry-run");
  EXPECT_EQ(plan.code, 0);
  EXPECT_NE(plan.out.find("sdof-stop/event-driven[tolerance=1e-6] by steps\n"), std::string::npos);
  EXPECT_NE(plan.out.find("sdof-stop/exact response\n"), std::string::npos);
}

TEST_F(RunResponses, FindADifferenceWhereAMethodFindsLess) {
  const std::string options = "--scenes sdof-stop --methods exact-orbit --out ";
  ASSERT_EQ(test::run_program("run " + suite_ + " " + options + at("a").string()).code, 0);
  EXPECT_EQ(test::run_program("verify " + at("a").string()).code, 0);
  std::string lines = read_file(at("a") / "records.jsonl"), changed;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    Json record = Json::parse(line);
    if (record["response"].contains("comparison"))
      record["response"]["comparison"]["within_0.02"]["covered"] = 0.5;
    changed += record.dump() + "\n";
  }
  std::filesystem::copy(at("a"), at("b"), std::filesystem::copy_options::recursive);
  std::ofstream(at("b") / "records.jsonl") << changed;
  const Outcome worse = test::run_program(fmt::format("compare {} {}", at("a").string(), at("b").string()));
  EXPECT_EQ(worse.code, 4) << worse.out;
  EXPECT_NE(
      worse.out.find(
          "less accurate: sdof-stop/exact-orbit[samples=64] by arc length: found 100.0 % became 50.0 %"),
      std::string::npos)
      << worse.out;
  const Outcome differs = test::run_program("verify " + at("b").string());
  EXPECT_EQ(differs.code, 1);
  EXPECT_NE(differs.out.find("found 50.0 % became 100.0 %"), std::string::npos) << differs.out;
}

TEST(OldResponses, GetOneClearLine) {
  const test::TemporaryFolder folder;
  static_cast<void>(folder.write("responses.jsonl", "{}\n"));
  static_cast<void>(folder.write("manifest.json", "{}\n"));
  for (const char* command : {"report", "status", "verify"}) {
    const Outcome outcome = test::run_program(fmt::format("{} {}", command, folder.path().string()));
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_NE(outcome.err.find("responses.jsonl of an earlier version"), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

}  // namespace
}  // namespace signorini::run_responses_test
