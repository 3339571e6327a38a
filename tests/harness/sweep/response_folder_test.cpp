// Responses that are kept as they come, and what a sweep that resumes makes of them.
#include "harness/sweep/response_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "tests/harness/program.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::response_folder_test {
namespace {

using Json = nlohmann::ordered_json;

const Json kQuestion{{"scene", "s"}, {"from", 1.0}};

Branch branch_to(const std::string& end) {
  Branch branch{.sequence = "order 1, no events", .began = "start", .ended = end};
  branch.points.assign(2, {.parameter = 2.0, .frequency = 2.0, .x_max = {0.1}, .amplitude = {0.1}});
  return branch;
}

MethodResponse two_branches() {
  MethodResponse response{.method = "m"};
  response.diagram = {.branches = {branch_to("here"), branch_to("there")}, .unfinished = "u", .notes = {"n"}};
  return response;
}

class ResponseFolders : public testing::Test {
 protected:
  void keep(const MethodResponse& response, const std::string& key, bool whole = true, bool resume = true) {
    ResponseFolder folder(path(), kQuestion, {"signorini"}, resume);
    for (const Branch& branch : response.diagram.branches) folder.add(response, branch);
    for (const SweepPoint& step : response.steps) folder.add(response, step);
    if (whole) folder.finish(response, key);
  }
  [[nodiscard]] std::optional<MethodResponse> kept(const std::string& method, const std::string& key) const {
    return ResponseFolder(path(), kQuestion, {}, true).complete(method, key);
  }
  [[nodiscard]] std::filesystem::path path() const { return folder_.path() / "out"; }
  [[nodiscard]] std::filesystem::path file() const { return path() / kBranchesFile; }

  test::TemporaryFolder folder_;
};

TEST_F(ResponseFolders, GiveBackWhatAMethodCompleted) {
  keep(two_branches(), "k");
  MethodResponse steps{.method = "n"};
  steps.steps.assign(3, {.frequency = 2.0, .status = Status::converged, .x_max = {0.5}});
  keep(steps, "l");
  const auto found = kept("m", "k");
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->diagram.branches.size(), 2U);
  EXPECT_EQ(found->diagram.branches[1].ended, "there");
  EXPECT_EQ(found->diagram.unfinished, "u");
  EXPECT_EQ(found->diagram.notes, std::vector<std::string>{"n"});
  EXPECT_EQ(kept("n", "l")->steps.size(), 3U);
  EXPECT_FALSE(kept("m", "of other code").has_value());
  EXPECT_FALSE(kept("o", "k").has_value());
}

TEST_F(ResponseFolders, DropWhatWasInterruptedAndATornLine) {
  keep(two_branches(), "k");
  const std::string whole = read_file(file());
  MethodResponse other = two_branches();
  other.method = "o";
  keep(other, "l", false);  // ended before its last line
  std::ofstream(file(), std::ios::app) << R"({"method":"o","sequ)";
  EXPECT_TRUE(kept("m", "k").has_value());
  EXPECT_FALSE(kept("o", "l").has_value());
  EXPECT_EQ(read_file(file()), whole);
  keep(other, "l");
  EXPECT_EQ(kept("o", "l")->diagram.branches.size(), 2U);  // not those of before too
}

TEST_F(ResponseFolders, AskAMethodAgainWhoseLineIsDamaged) {
  keep(two_branches(), "k");
  std::string text = read_file(file());
  text.replace(text.find("\"order\":1"), 9, "\"order\":0");
  std::ofstream(file()) << text;
  testing::internal::CaptureStderr();
  EXPECT_FALSE(kept("m", "k").has_value());
  EXPECT_NE(testing::internal::GetCapturedStderr().find("branches.jsonl:1: order = 0"), std::string::npos);
}

TEST_F(ResponseFolders, KeepTheFileOfASweepThatBeginsAnew) {
  keep(two_branches(), "k");
  keep(two_branches(), "k", true, false);
  EXPECT_TRUE(std::filesystem::exists(path() / "branches.previous.jsonl"));
  EXPECT_EQ(read_file(file()), read_file(path() / "branches.previous.jsonl"));
}

TEST_F(ResponseFolders, RefuseOtherQuestionsOtherFoldersAndASecondSweep) {
  keep(two_branches(), "k");
  Json other = kQuestion;
  other["from"] = 1.5;
  try {
    const ResponseFolder folder(path(), other, {}, true);
    ADD_FAILURE() << "accepted";
  } catch (const UsageError& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("from = 1.5 (must be 1.0 as in"), std::string::npos)
        << refusal.what();
  }
  EXPECT_THROW(ResponseFolder(path(), other, {}, false), UsageError);
  (void)folder_.write("foreign/letter.txt", "dear");
  EXPECT_THROW(ResponseFolder(folder_.path() / "foreign", kQuestion, {}, true), UsageError);
  (void)folder_.write("run/manifest.json", R"({"schema": 1, "suite": "quick"})");
  EXPECT_THROW(ResponseFolder(folder_.path() / "run", kQuestion, {}, true), UsageError);
  const ResponseFolder first(path(), kQuestion, {}, true);
  EXPECT_THROW(ResponseFolder(path(), kQuestion, {}, true), UsageError);
}

// The second method's lines are cut in the middle, as a kill leaves them.
TEST(CommandSweep, ResumesAnInterruptedSweep) {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::string command =
      "sweep sdof-stop --methods exact-orbit:hat-lcp --set samples=64 --from 2.3 --to 3 --max-order 2 ";
  for (const std::string format : {"json", "csv", "md"}) {
    std::filesystem::remove_all(out);
    const std::string asked = command + "--format " + format + " ";
    const test::Outcome alone = test::run_program(asked);
    const test::Outcome first = test::run_program(asked + "--out " + out);
    ASSERT_EQ(first.code, 0) << first.err;
    EXPECT_EQ(first.out, alone.out);
    const std::string file = out + "/" + kBranchesFile;
    const std::string whole = read_file(file);
    const std::size_t hats = whole.find(R"({"method":"hat-lcp)");
    ASSERT_NE(hats, std::string::npos);
    std::ofstream(file) << whole.substr(0, whole.find('\n', hats) + 100);  // torn in its second line
    const test::Outcome second = test::run_program(asked + "--resume --out " + out);
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_EQ(second.out, alone.out) << format;
    EXPECT_EQ(second.err, alone.err);
    EXPECT_EQ(read_file(file), whole);
  }
}

// A method that the folder has whole is not asked: what it has is printed even where it was changed by hand.
TEST(CommandSweep, DoesNotComputeAgainWhatTheFolderHas) {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  for (const std::string way : {"--methods exact-orbit", "--method exact-orbit --points 3",
                                "--methods exact-orbit --follow period-doubling --second law.restitution "
                                "--second-from 1 --second-to 0.95"}) {
    std::filesystem::remove_all(out);
    const std::string command = "sweep sdof-stop " + way + " --from 2.5 --to 3 --format jsonl --out " + out;
    ASSERT_EQ(test::run_program(command).code, 0);
    std::string text = read_file(out + "/" + kBranchesFile);
    const std::string field = R"("x_max":[)";
    const std::size_t at = text.find(field) + field.size();
    text.replace(at, text.find(']', at) - at, "77.5");
    std::ofstream(out + "/" + kBranchesFile) << text;
    EXPECT_NE(test::run_program(command + " --resume").out.find("77.5"), std::string::npos) << way;
    EXPECT_EQ(test::run_program(command).out.find("77.5"), std::string::npos) << way;
  }
}

TEST(CommandSweep, RefusesFoldersInOneLine) {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::string command = "sweep sdof-stop --methods exact-orbit --from 2.5 --to 3 --out " + out + " ";
  ASSERT_EQ(test::run_program(command).code, 0);
  (void)folder.write("foreign/letter.txt", "dear");
  (void)folder.write("busy/letter.txt", "dear");
  const Descriptor lock = lock_folder(folder.path() / "busy");
  const auto refused = [](const std::string& asked, const std::string& reason) {
    const test::Outcome outcome = test::run_program(asked);
    EXPECT_EQ(outcome.code, 2) << asked;
    EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  };
  refused(command + "--resume --max-order 1", "max-order = 1 (must be \"as it costs little\" as in");
  refused(command + "--resume --orders 3", "max-order = 3 (must be \"as it costs little\" as in");
  refused("sweep sdof-stop --methods exact-orbit --from 2.5 --to 3 --resume", "resume (must go with --out)");
  const std::string into =
      "sweep sdof-stop --methods exact-orbit --from 2.5 --to 3 --out " + folder.path().string();
  refused(into + "/busy", "must not be in use");
  refused(into + "/foreign --resume", "must be new, empty or a folder that sweep --out wrote");
}

}  // namespace
}  // namespace signorini::response_folder_test
