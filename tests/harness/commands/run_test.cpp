// `signorini run`.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "harness/files.hpp"
#include "harness/run_folder/record_store.hpp"
#include "harness/terminal/run_output.hpp"
#include "problems/scene/scene_file.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"
#include "tests/harness/sample_records.hpp"
#include "tests/harness/stored_records.hpp"

namespace signorini::run_test {
namespace {

using Json = nlohmann::ordered_json;
using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

TEST(CommandRun, PrintsThePlanWithoutRunningIt) {
  const Outcome outcome =
      run("run quick --scenes sdof-stop --methods 'penalty-hbm[harmonics=31,penalty=1e4|1e6]' --dry-run");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(
      outcome.out,
      "sdof-stop/penalty-hbm[harmonics=31,penalty=1e4]\nsdof-stop/penalty-hbm[harmonics=31,penalty=1e6]\n");
}

TEST(CommandRun, RunsASceneFileInPlaceOfTheSuites) {
  const std::filesystem::path folder = test::fresh_folder("own-scene");
  std::string text = read_file(problems_folder() / "catalogue" / "sdof-stop.toml");
  text.replace(text.find("\"sdof-stop\""), 11, "\"my-stop\"");
  std::ofstream(folder / "own.toml") << text;
  const Outcome outcome = run("run quick --methods 'hat-lcp[samples=64]' --scenes " +
                              (folder / "own.toml").string() + " --dry-run");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "my-stop/hat-lcp[samples=64]\n");
}

TEST(CommandRun, RunsOwnSceneFilesBesideScenesOfTheSuite) {
  const std::filesystem::path folder = test::fresh_folder("own-scenes");
  const std::string text = read_file(problems_folder() / "catalogue" / "sdof-stop.toml");
  for (const std::string name : {"first", "second"}) {
    std::string own = text;
    own.replace(own.find("\"sdof-stop\""), 11, "\"" + name + "\"");
    std::ofstream(folder / (name + ".toml")) << own;
  }
  const std::string rest = " --methods 'hat-lcp[samples=64]' --dry-run";
  const auto planned = [&](const std::string& arguments) {
    const Outcome outcome = test::run_program("run " + arguments + rest, folder.string());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  };
  const std::string first = "first/hat-lcp[samples=64]\n", second = "second/hat-lcp[samples=64]\n",
                    shipped = "sdof-stop/hat-lcp[samples=64]\n";
  EXPECT_EQ(planned("quick --scenes first.toml:sdof-stop"), first + shipped);
  EXPECT_EQ(planned("quick --scenes sdof-stop:first.toml --scenes second.toml"), first + second + shipped);
  EXPECT_EQ(planned("--scenes '*.toml'"), first + second);
  std::filesystem::create_directory(folder / "suites");
  std::ofstream(folder / "suites" / "mine.toml")
      << "schema = 1\nname = \"mine\"\ntitle = \"t\"\nscenes = [\"../first.toml\", \"sdof-stop\"]\n";
  EXPECT_EQ(planned("suites/mine.toml"), first + shipped);
  EXPECT_EQ(planned("suites/mine.toml --scenes first"), first);
  const Outcome refused = test::run_program("run second.toml" + rest, folder.string());
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("a scene is no suite; give it to --scenes"), std::string::npos) << refused.err;
}

TEST(CommandRun, SaysThatThereIsNoRoomAndKeepsWhatItHas) {
  const auto folder = test::fresh_folder("no-room");
  const std::string arguments =
      "run quick --scenes sdof-stop --methods 'hat-lcp[samples=64|128|256|512]' --repetitions 1 --out run";
  // Four blocks of 1024 bytes: less than two records.
  const std::string binary = SIGNORINI_BINARY;
  const std::string limited =
      "cd '" + folder.string() + "' && ulimit -f 4 && '" + binary + "' " + arguments + " >out.txt 2>err.txt";
  const int status = std::system(("bash -c \"" + limited + "\"").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
  const std::string complaint = read_file(folder / "err.txt");
  EXPECT_NE(complaint.find("must have room: "), std::string::npos) << complaint;
  const auto resumed = test::run_program(arguments + " --resume", folder.string());
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(read_records(folder / "run" / "records.jsonl").size(), 4U);
}

TEST(CommandRun, RunsASuiteReportsAndResumesIt) {
  const auto folder = test::fresh_folder("run");
  const std::string command =
      "run smoke --scenes sdof-stop --methods 'hat-lcp[samples=64]:fourier-lipschitz[harmonics=5]' --out " +
      folder.string();
  const Outcome first = run(command);
  ASSERT_EQ(first.code, 0) << first.err << first.out;
  EXPECT_NE(first.out.find("sdof-stop: 2 cases, "), std::string::npos) << first.out;
  EXPECT_NE(first.out.find("\nRigid stop (e = 1), 1 scene: "), std::string::npos) << first.out;
  EXPECT_NE(first.out.find(folder.string()), std::string::npos);
  EXPECT_EQ(first.out.find("| scene"), std::string::npos) << first.out;
  EXPECT_EQ(first.out.find('\033'), std::string::npos) << first.out;
  EXPECT_LE(std::count(first.out.begin(), first.out.end(), '\n'), 41);
  EXPECT_EQ(read_records(folder / "records.jsonl").size(), 2U);
  const std::string records = read_file(folder / "records.jsonl");
  const std::string table = read_file(folder / "table.md");
  const std::string csv = read_file(folder / "table.csv");
  const Json manifest = Json::parse(read_file(folder / "manifest.json"));
  for (const char* key : {"date", "command_line", "seed", "limits", "build", "machine"}) {
    EXPECT_TRUE(manifest.contains(key)) << key;
  }
  EXPECT_TRUE(manifest["build"].contains("compiler"));

  const Outcome again = run(command + " --resume");
  EXPECT_EQ(again.code, 0);
  EXPECT_EQ(read_file(folder / "records.jsonl"), records);
  EXPECT_NE(again.out.find("0 cases run, 2 already there"), std::string::npos);

  EXPECT_EQ(
      run("run smoke --scenes sdof-stop --methods 'hat-lcp[samples=64]' --resume --out " + folder.string())
          .code,
      0);
  EXPECT_EQ(Json::parse(run("status --json " + folder.string()).out)[0]["planned"], 2);
  EXPECT_EQ(read_file(folder / "table.md"), table);

  EXPECT_EQ(run("report " + folder.string()).code, 0);
  EXPECT_EQ(read_file(folder / "table.md"), table);
  EXPECT_EQ(read_file(folder / "table.csv"), csv);
  const Outcome screen = run("report --format screen " + folder.string());
  EXPECT_EQ(screen.code, 0);
  const std::size_t groups = first.out.find("\nWhich method?");
  EXPECT_EQ(screen.out.substr(screen.out.find("\nWhich method?"), 600), first.out.substr(groups, 600));
}

TEST(CommandRun, PrintsEveryTableOnRequest) {
  const auto folder = test::fresh_folder("verbose");
  const Outcome outcome =
      run("run smoke --verbose --repetitions 1 --scenes sdof-stop --methods 'hat-lcp[samples=64]' --out " +
          folder.string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::size_t rows = outcome.out.find("| scene"), summary = outcome.out.find("## What is solved"),
                    screen = outcome.out.find("\nWhich method?");
  EXPECT_LT(rows, summary) << outcome.out;
  EXPECT_LT(summary, screen) << outcome.out;
  EXPECT_NE(screen, std::string::npos) << outcome.out;
}

TEST(SceneLines, AreFewWhereManyScenesGoIntoAPipe) {
  testing::internal::CaptureStdout();
  const std::size_t scenes = 3 * SceneLines::kMost - 1;
  {
    SceneLines lines(scenes);
    for (std::size_t i = 0; i < scenes; ++i)
      lines.add({test::good_record("s" + std::to_string(i), "m", "n=1", 1e-3, 1.0)});
  }
  const std::string out = testing::internal::GetCapturedStdout();
  EXPECT_EQ(static_cast<std::size_t>(std::count(out.begin(), out.end(), '\n')), SceneLines::kMost);
  EXPECT_TRUE(out.starts_with("s0 to s2: 3 cases, 3 certified\ns3 to s5: ")) << out;
  EXPECT_TRUE(out.ends_with("s207 to s208: 2 cases, 2 certified\n")) << out;
}

TEST(CommandRun, ExitsWithOneWhereSomethingFailedThatWasNotExpectedTo) {
  const auto folder = test::fresh_folder("failing");
  const std::string case_line =
      "run smoke --scenes sdof-stop --methods "
      "'fourier-lipschitz[harmonics=5,max_iterations=1,solver=newton]' --out ";
  EXPECT_EQ(run(case_line + folder.string()).code, 1);
  EXPECT_EQ(read_records(folder / "records.jsonl").size(), 1U);
}

TEST(CommandRun, RefusesASeedAShardAndDurationsThatMeanNothing) {
  for (const char* words : {"--seed -1", "--shard ''", "--durations nope"}) {
    const Outcome outcome = run(std::string("run smoke --dry-run ") + words);
    EXPECT_EQ(outcome.code, 2) << words;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST(CommandRun, StopsAtAnInterruptAndCompletesTheRunLater) {
  const auto folder = test::fresh_folder("interrupt");
  const std::string binary = SIGNORINI_BINARY, out = folder.string();
  const pid_t child = fork();
  if (child == 0) {
    if (freopen("/dev/null", "w", stdout) == nullptr || freopen("/dev/null", "w", stderr) == nullptr)
      _exit(99);
    execl(binary.c_str(), binary.c_str(), "run", "smoke", "--out", out.c_str(), nullptr);
    _exit(98);
  }
  // Not before a first record is there, so that the interrupt comes in the middle.
  std::error_code none;
  for (int i = 0; i < 6000; ++i) {
    const auto size = std::filesystem::file_size(folder / "records.jsonl", none);
    if (!none && size > 0) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(child, SIGINT);
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  const std::size_t before = read_records(folder / "records.jsonl").size();
  EXPECT_GE(before, 1U);
  const Outcome rest = run("run smoke --resume --out " + folder.string());
  EXPECT_NE(rest.code, 130);
  EXPECT_NE(rest.out.find(std::to_string(before) + " already there"), std::string::npos) << rest.out;
}

}  // namespace
}  // namespace signorini::run_test
