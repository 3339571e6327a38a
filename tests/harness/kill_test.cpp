// Kills the built program without warning and resumes its run.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include "harness/files.hpp"
#include "harness/run_folder/record_store.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/stored_records.hpp"

namespace signorini::kill_test {
namespace {

constexpr const char* kScenes = "sdof-stop:sdof-far-stop";
constexpr const char* kMethods = "hat-lcp[samples=64|128|256]";

pid_t start_run(const std::filesystem::path& folder) {
  const std::string binary = SIGNORINI_BINARY, out = folder.string();
  const pid_t child = fork();
  if (child != 0) return child;
  if (freopen("/dev/null", "w", stdout) == nullptr || freopen("/dev/null", "w", stderr) == nullptr) _exit(99);
  execl(binary.c_str(), binary.c_str(), "run", "catalogue", "--scenes", kScenes, "--methods", kMethods,
        "--resume", "--out", out.c_str(), nullptr);
  _exit(98);
}

std::string contents(const std::filesystem::path& file) {
  return std::filesystem::exists(file) ? read_file(file) : std::string();
}

std::string whole_lines(const std::string& text) { return text.substr(0, text.rfind('\n') + 1); }

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// What the folder holds: finished records, and lines of rounds that are not.
struct Progress {
  std::string records;
  std::size_t rounds = 0;
};

Progress progress_of(const std::filesystem::path& folder) {
  return {whole_lines(contents(folder / "records.jsonl")),
          lines_of(whole_lines(contents(folder / "unfinished.jsonl")))};
}

/// Waits until the run has written one more line than there was, or is over; true if it is over.
bool wait_for_news(pid_t run, const std::filesystem::path& folder, const Progress& before, int& status) {
  for (int i = 0; i < 6000; ++i) {
    if (waitpid(run, &status, WNOHANG) == run) return true;
    const Progress now = progress_of(folder);
    if (now.records.size() > before.records.size() || now.rounds > before.rounds) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

TEST(KilledRuns, LoseNothingThatWasWrittenAndDuplicateNothing) {
  const auto folder = test::fresh_folder("killed");
  int kills = 0, status = 0;
  constexpr int kKills = 10;
  for (bool over = false; !over; ++kills) {
    const Progress before = progress_of(folder);
    const pid_t run = start_run(folder);
    if (kills == kKills) {  // enough: this one may end
      waitpid(run, &status, 0);
      break;
    }
    over = wait_for_news(run, folder, before, status);
    if (over) break;
    // A different moment of the work each time, from at once to some rounds later.
    std::this_thread::sleep_for(std::chrono::milliseconds(37 * (kills % 8)));
    kill(run, SIGKILL);
    waitpid(run, &status, 0);
    over = WIFEXITED(status);
    EXPECT_EQ(progress_of(folder).records.rfind(before.records, 0), 0U) << "records were lost or changed";
  }
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_GE(kills, 3);
  const std::vector<Record> records = read_records(folder / "records.jsonl");
  EXPECT_EQ(records.size(), 6U);
  EXPECT_EQ(lines_of(read_file(folder / "records.jsonl")), records.size()) << "a key is there twice";
  std::set<std::string> cases;
  for (const Record& record : records) {
    cases.insert(record.case_id);
    EXPECT_GE(record.seconds ? record.seconds->rounds.size() : 3U, 3U) << record.case_id;
  }
  EXPECT_EQ(cases.size(), 6U);
  EXPECT_FALSE(std::filesystem::exists(folder / "unfinished.jsonl"));
}

}  // namespace
}  // namespace signorini::kill_test
