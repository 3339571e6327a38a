// Methods that are commands: what they read, and what becomes of those that misbehave.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "harness/files.hpp"
#include "tests/plugin/installed_program.hpp"

namespace signorini::test::command_method_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A description of a command `sh script.sh`, with further lines at its end.
void describe(const TemporaryFolder& folder, const std::string& script, const std::string& more = "") {
  static_cast<void>(folder.write("script.sh", script));
  const std::string text =
      "schema = 1\nname = \"shell\"\ntitle = \"A command for tests\"\nladder = \"level=1|2\"\n"
      "command = [\"sh\", \"script.sh\"]\n[represents]\nrestitution = \"scene\"\n"
      "[[option]]\nname = \"level\"\ndefault = 1\nleast = 1\nmost = 3\nunit = \"[-]\"\nmeaning = \"1..3\"\n" +
      more;
  static_cast<void>(folder.write("method.toml", text));
}

Json solve(const TemporaryFolder& folder, const std::string& arguments = "") {
  const Outcome outcome =
      run_installed(folder, "solve sdof-stop --method shell --plugin method.toml --json " + arguments);
  EXPECT_TRUE(outcome.code == 0 || outcome.code == 1) << outcome.err;
  return Json::parse(outcome.out, nullptr, false);
}

/// An answer of a motion at rest, whose parts a test may spoil.
std::string answer(const std::string& x, const std::string& t = "[0.0, 1.4279966607226333]") {
  return fmt::format(
      R"({{"verdict": "converged", "trajectory": {{"t": {}, "x": {}, "velocity": {}, "force": {}}}}})", t, x,
      x, x);
}

struct BadAnswer {
  const char* name;
  std::string script;
  const char* status;
  std::string message;
};

void PrintTo(const BadAnswer& bad, std::ostream* stream) { *stream << bad.name; }

void expect_outcome(const Json& record, const BadAnswer& bad) {
  EXPECT_EQ(record.at("status"), bad.status) << record.dump();
  EXPECT_NE(record.at("message").get<std::string>().find(bad.message), std::string::npos) << record.dump();
}

class BadAnswers : public testing::TestWithParam<BadAnswer> {};

TEST_P(BadAnswers, HaveTheStatusOfWhatHappened) {
  const TemporaryFolder folder;
  describe(folder, GetParam().script);
  expect_outcome(solve(folder), GetParam());
}

std::string print(const std::string& text) { return "cat <<'END'\n" + text + "\nEND\n"; }

INSTANTIATE_TEST_SUITE_P(
    Each, BadAnswers,
    testing::Values(
        BadAnswer{"abort", "kill -ABRT $$\n", "crashed", "signal 6"},
        BadAnswer{"exit code", "echo first >&2; echo no licence >&2; exit 3\n", "crashed",
                  "exit code 3: no licence"},
        BadAnswer{"nothing", "exit 0\n", "invalid-output", "parse error"},
        BadAnswer{"rubbish", "echo hello\n", "invalid-output", "parse error"},
        BadAnswer{"a list", "echo '[1, 2]'\n", "invalid-output", "no JSON object"},
        BadAnswer{"no verdict", "echo '{}'\n", "invalid-output", "verdict"},
        BadAnswer{"a strange verdict", "echo '{\"verdict\": \"perhaps\"}'\n", "invalid-output",
                  "verdict = perhaps"},
        BadAnswer{"a strange key", "echo '{\"verdict\": \"converged\", \"colour\": 1}'\n", "invalid-output",
                  "colour = unknown"},
        BadAnswer{"no trajectory", "echo '{\"verdict\": \"converged\"}'\n", "invalid-output",
                  "without a trajectory"},
        BadAnswer{"two contacts", print(answer("[[0, 0], [0, 0]]")), "invalid-output",
                  "2 contacts, the scene 1"},
        BadAnswer{"uneven lists", print(answer("[[0, 0, 0]]")), "invalid-output", "uneven"},
        BadAnswer{"other instants", print(answer("[[0, 0]]", "[0.0, 0.5]")), "invalid-output",
                  "trajectory.t[1]"},
        BadAnswer{"not a number", print(answer("[[0, NaN]]")), "invalid-output", "parse error"},
        BadAnswer{"words", print(answer("[[0, \"one\"]]")), "invalid-output", "must be number"},
        BadAnswer{"half an answer", "echo '{\"verdict\": \"conv'\n", "invalid-output", "parse error"},
        BadAnswer{"gave up", "echo '{\"verdict\": \"not-converged\", \"message\": \"it was hard\"}'\n",
                  "not-converged", "it was hard"},
        BadAnswer{"rest", print(answer("[[0, 0]]")), "inaccurate", ""}));

TEST(CommandMethods, ReadTheProblemWithItsOptionsAndTheTimeLeft) {
  const TemporaryFolder folder;
  describe(folder, "cat >request.json\necho '{\"verdict\": \"not-converged\"}'\n");
  solve(folder, "--set level=3");
  const Json request = Json::parse(read_file(folder.path() / "request.json"));
  EXPECT_EQ(request.at("schema"), 1);
  EXPECT_EQ(request.at("options"), (Json{{"level", 3}}));
  EXPECT_GT(request.at("seconds").get<double>(), 1.0);
  EXPECT_FALSE(request.contains("start"));
  const Json& problem = request.at("problem");
  EXPECT_EQ(problem.at("size"), 1);
  EXPECT_EQ(problem.at("mass"), (Json{{"row", {0}}, {"column", {0}}, {"value", {1.0}}}));
  EXPECT_EQ(problem.at("damping").at("value"), Json({0.1}));
  EXPECT_EQ(problem.at("frequency"), 2.2);
  EXPECT_EQ(problem.at("subharmonic"), 1);
  EXPECT_NEAR(problem.at("period").get<double>(), 2.8559933214452666, 1e-12);
  EXPECT_EQ(problem.at("force"), (Json{{{"dof", 0}, {"harmonic", 1}, {"cos", 1.0}, {"sin", 0.0}}}));
  EXPECT_EQ(problem.at("contacts"),
            Json::parse(R"([{"normal": [[0, 1.0]], "gap": 0.2, "law": {"restitution": 1.0}}])"));
  EXPECT_EQ(problem.at("law"), (Json{{"restitution", 1.0}}));
}

TEST(CommandMethods, MayStartFromAMotion) {
  const TemporaryFolder folder;
  describe(folder, "cat >request.json\necho '{\"verdict\": \"not-converged\"}'\n");
  const Outcome start = run_installed(folder, "solve sdof-stop --method exact-orbit --json --samples 512");
  ASSERT_EQ(start.code, 0) << start.err;
  static_cast<void>(folder.write("start.json", start.out));
  solve(folder, "--start start.json");
  const Json motion = Json::parse(read_file(folder.path() / "request.json")).at("start");
  EXPECT_EQ(motion.at("trajectory").at("x").at(0).size(), 1024U);
  EXPECT_EQ(motion.at("trajectory").at("x").at(0).at(2), Json::parse(start.out)["trajectory"]["x"][0][1]);
}

/// Processes with this word among their arguments.
int processes_with(const std::string& word) {
  int count = 0;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc", none)) {
    std::ifstream stream(entry.path() / "cmdline", std::ios::binary);
    const std::string line{std::istreambuf_iterator<char>(stream), {}};
    if (line.find(word) != std::string::npos) ++count;
  }
  return count;
}

TEST(CommandMethods, ThatNeverAnswerAreEndedAtTheTimeLimitWithAllTheyStarted) {
  const TemporaryFolder folder;
  describe(folder, "setsid sleep 98765.25 &\nsleep 98765.5 &\nwait\n");
  const Outcome run = run_installed(
      folder,
      "run catalogue --scenes sdof-stop --methods 'shell[level=1]:hat-lcp[samples=64]' --timeout 1 "
      "--out run --plugin method.toml");
  EXPECT_EQ(run.code, 1) << run.err;
  const std::map<std::string, Record> records = records_in(folder.path() / "run");
  EXPECT_EQ(records.at("sdof-stop/shell[level=1]").status, Status::timeout);
  EXPECT_EQ(records.at("sdof-stop/shell[level=1]").message, "the command was stopped at the time limit");
  EXPECT_EQ(records.at("sdof-stop/hat-lcp[samples=64]").status, Status::converged);
  EXPECT_EQ(processes_with("98765.5"), 0);
  EXPECT_EQ(processes_with("98765.25"), 0);
}

/// A command that stays, answers at rest, and says that it took so long [s].
void describe_persistent(const TemporaryFolder& folder, const std::string& seconds) {
  const std::string rest = answer("[[0, 0]]");
  const std::string told = rest.substr(0, rest.size() - 1) + ", \"seconds\": " + seconds + "}";
  describe(folder, "while read -r line; do sleep 0.01; echo \"$line\" >request.json; cat <<'END'\n" + told +
                       "\nEND\ndone\n");
  const std::string text = read_file(folder.path() / "method.toml");
  static_cast<void>(folder.write("method.toml", "persistent = true\n" + text));
}

TEST(CommandMethods, ThatStayAreTimedByTheirOwnClock) {
  const TemporaryFolder folder;
  describe_persistent(folder, "0.004");
  const Json record = solve(folder);
  EXPECT_GE(record.at("seconds").at("solve").get<double>(), 0.004) << record.dump();
  EXPECT_GT(record.at("seconds").at("exchange").get<double>(), 0.005);
  EXPECT_EQ(Json::parse(read_file(folder.path() / "request.json")).at("persistent"), true);
}

TEST(CommandMethods, CannotTellMoreTimeThanPassedNorNearlyNone) {
  const TemporaryFolder folder;
  describe_persistent(folder, "1e6");
  EXPECT_EQ(solve(folder).at("status"), "invalid-output");
  describe_persistent(folder, "0.0");
  EXPECT_GE(solve(folder).at("seconds").at("solve").get<double>(), 1e-4);
}

/// A command that stays and, for every line read, runs `then`; $n counts the lines.
void describe_reader(const TemporaryFolder& folder, const std::string& then) {
  const std::string rest = answer("[[0, 0]]");
  describe(folder, "n=0\nanswer() { echo '" + rest.substr(0, rest.size() - 1) +
                       ", \"seconds\": 1e-4}'; }\nwhile read -r line; do n=$((n + 1)); " + then + "\ndone\n");
  static_cast<void>(
      folder.write("method.toml", "persistent = true\n" + read_file(folder.path() / "method.toml")));
}

// One that needs 0.3 s for a scene that it does not know, keeps every answer on disc, and tells no time.
TEST(CommandMethods, AreTimedOnScenesThatTheyDoNotKnow) {
  const TemporaryFolder folder;
  const std::string rest = answer("[[0, 0]]");
  describe(
      folder,
      "while read -r line; do\nkey=$(echo \"$line\" | sed 's/\"seconds\":[^,}]*//' | md5sum | cut -c1-32)\n"
      "[ -e \"$key\" ] || { sleep 0.3; : >\"$key\"; }\necho '" +
          rest.substr(0, rest.size() - 1) + ", \"seconds\": 0}'\ndone\n");
  static_cast<void>(
      folder.write("method.toml", "persistent = true\n" + read_file(folder.path() / "method.toml")));
  for (int again = 0; again < 2; ++again)
    EXPECT_GT(solve(folder).at("seconds").at("solve").get<double>(), 0.1);
}

TEST(CommandMethods, AreNotToldTheNameOfTheScene) {
  const TemporaryFolder folder;
  describe(folder, "cat >request.json\necho '{\"verdict\": \"not-converged\"}'\n");
  solve(folder);
  EXPECT_EQ(Json::parse(read_file(folder.path() / "request.json")).at("problem").at("name"), "scene");
}

class LaterAnswers : public testing::TestWithParam<BadAnswer> {};

TEST_P(LaterAnswers, HaveTheStatusOfWhatHappened) {
  const TemporaryFolder folder;
  describe_reader(folder, GetParam().script);
  const Json record = solve(folder);
  expect_outcome(record, GetParam());
  EXPECT_FALSE(record.contains("seconds")) << record.dump();
}

INSTANTIATE_TEST_SUITE_P(
    Each, LaterAnswers,
    testing::Values(
        BadAnswer{"ends after its answer", "answer; exit 0", "crashed",
                  "in a repeated solve: the command ended before its answer"},
        BadAnswer{"fails after its answer", "answer; echo no licence >&2; exit 3", "crashed",
                  "in a repeated solve: the command ended with exit code 3: no licence"},
        BadAnswer{"aborts when asked again", "[ $n = 1 ] || kill -ABRT $$; answer", "crashed", "signal 6"},
        BadAnswer{"talks nonsense when asked again", "[ $n = 1 ] && answer || echo hello", "invalid-output",
                  "parse error"},
        BadAnswer{"answers twice at once", "both=$(answer; answer); echo \"$both\"", "invalid-output",
                  "more than one line"},
        BadAnswer{"answers twice", "answer; sleep 0.005; answer", "invalid-output", "more than one line"}));

TEST(CommandMethods, ThatHangWhenAskedAgainAreEndedAndDisturbNoOtherCase) {
  const TemporaryFolder folder;
  describe_reader(folder, "[ $n = 1 ] || sleep 98765.75; answer");
  const Outcome run = run_installed(
      folder,
      "run catalogue --scenes sdof-stop --methods 'shell[level=1]:hat-lcp[samples=64]' --timeout 1 "
      "--out run --plugin method.toml");
  EXPECT_EQ(run.code, 1) << run.err;
  const std::map<std::string, Record> records = records_in(folder.path() / "run");
  const Record& hangs = records.at("sdof-stop/shell[level=1]");
  EXPECT_NE(hangs.status, Status::converged);
  EXPECT_EQ(records.at("sdof-stop/hat-lcp[samples=64]").status, Status::converged);
  EXPECT_EQ(processes_with("98765.75"), 0);
}

// Sent and received at once: neither side may wait for the other with a full pipe.
TEST(CommandMethods, MayTalkBeforeTheyHaveReadAndLeaveWithoutReading) {
  const TemporaryFolder folder;
  const std::string talk = "head -c 3000000 /dev/zero | tr '\\0' 'x' >&2\n";
  describe(folder, talk + "echo '{\"verdict\": \"not-converged\", \"message\": \"enough\"}'\n");
  EXPECT_EQ(solve(folder).at("message"), "enough");
}

TEST(CommandMethods, DoNotApplyWhereTheirDescriptionNamesNoLaw) {
  const TemporaryFolder folder;
  describe(folder, "exit 1\n");
  const Outcome outcome =
      run_installed(folder, "solve sdof-penalty-soft --method shell --plugin method.toml --json");
  const Json record = Json::parse(outcome.out);
  EXPECT_EQ(record.at("status"), "not-applicable");
}

TEST(CommandMethods, ChangedInTheirScriptHaveStaleRecords) {
  const TemporaryFolder folder;
  describe(folder, "echo '{\"verdict\": \"not-converged\"}'\n");
  const std::string run =
      "run catalogue --scenes sdof-stop --methods 'shell[level=1]' --out run --resume --plugin method.toml";
  EXPECT_NE(run_installed(folder, run).out.find("1 cases run, 0 already there"), std::string::npos);
  EXPECT_NE(run_installed(folder, run).out.find("0 cases run, 1 already there"), std::string::npos);
  static_cast<void>(
      folder.write("script.sh", "echo '{\"verdict\": \"not-converged\", \"message\": \"new\"}'\n"));
  EXPECT_NE(run_installed(folder, run).out.find("1 cases run, 0 already there"), std::string::npos);
}

TEST(CommandMethods, RefuseBadOptions) {
  const TemporaryFolder folder;
  describe(
      folder, "exit 1\n",
      "[[option]]\nname = \"law\"\ndefault = \"dlft\"\nchoices = [\"dlft\", \"penalty\"]\nunit = \"[-]\"\n"
      "meaning = \"words\"\n[[option]]\nname = \"plain\"\ndefault = false\nunit = \"[-]\"\nmeaning = \"yes "
      "or no\"\n");
  const std::string command = "solve sdof-stop --method shell --plugin method.toml --set ";
  expect_refusal(run_installed(folder, command + "level=4"), {"level = 4 (must be at most 3)"});
  expect_refusal(run_installed(folder, command + "level=nan"), {"level = nan (must be a finite number)"});
  expect_refusal(run_installed(folder, command + "level=1.5"), {"level = 1.5 (must be a whole number)"});
  expect_refusal(run_installed(folder, command + "law=other"),
                 {"law = other (must be one of dlft, penalty)"});
  expect_refusal(run_installed(folder, command + "plain=perhaps"),
                 {"plain = perhaps (must be true or false)"});
  expect_refusal(run_installed(folder, command + "colour=1"), {"unknown option; known: level, law, plain"});
}

struct BadDescription {
  const char* from;
  const char* to;
  const char* complaint;
};

void PrintTo(const BadDescription& bad, std::ostream* stream) { *stream << bad.complaint; }

class BadDescriptions : public testing::TestWithParam<BadDescription> {};

TEST_P(BadDescriptions, AreRefusedInOneLineThatNamesTheirPlace) {
  const TemporaryFolder folder;
  describe(folder, "exit 0\n");
  std::string text = read_file(folder.path() / "method.toml");
  const auto& [from, to, complaint] = GetParam();
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string(from).size(), to);
  static_cast<void>(folder.write("method.toml", text));
  expect_refusal(run_installed(folder, "list --plugin method.toml"), {"method.toml:", complaint});
}

INSTANTIATE_TEST_SUITE_P(
    Each, BadDescriptions,
    testing::Values(
        BadDescription{"schema = 1", "schema = 2", "schema = 2 (must be 1)"},
        BadDescription{"schema = 1", "schema = ", "method.toml:1"}, BadDescription{"title", "titel", "titel"},
        BadDescription{"name = \"shell\"", "name = \"A Shell\"", "method = A Shell (must be a name"},
        BadDescription{"name = \"shell\"", "name = \"hat-lcp\"", "method = hat-lcp (must be new"},
        BadDescription{"[\"sh\", \"script.sh\"]", "[]", "command = "},
        BadDescription{"[\"sh\", ", "[\"no-such-program-anywhere\", ", "must be a program on the PATH"},
        BadDescription{"[\"sh\", ", "[\"./script.sh\", ", "must be a program on the PATH"},
        BadDescription{"\"level=1|2\"", "\"level\"", "ladder = level ("},
        BadDescription{"\"level=1|2\"", "\"level=1|9\"", "level = 9 (must be at most 3)"},
        BadDescription{"\"level=1|2\"", "\"size=1\"", "size = 1 (unknown option"},
        BadDescription{"restitution = \"scene\"", "restitution = 1.5", "restitution = 1.5"},
        BadDescription{"restitution = \"scene\"", "penalty = 1.0", "penalty = 1"},
        BadDescription{"default = 1", "default = 7", "level = 7 (must be at most 3)"},
        BadDescription{"default = 1", "default = nan", "default = nan"},
        BadDescription{"schema = 1", "schema = 1\npersistent = 1", "persistent = 1 (must be true or false)"},
        BadDescription{"unit = \"[-]\"", "unit = \"metres\"", "unit in brackets"},
        BadDescription{"meaning = \"1..3\"", "meaning = \"1..3\"\nchoices = [\"a\"]", "choices"}));

}  // namespace
}  // namespace signorini::test::command_method_test
