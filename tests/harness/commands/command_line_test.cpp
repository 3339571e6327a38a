// What all commands have in common: exit codes, one line on stderr, help and version.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>

#include "harness/files.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"

namespace signorini::command_line_test {
namespace {

using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

struct BadUse {
  const char* arguments;
  int code;
  const char* complaint;
};

void PrintTo(const BadUse& use, std::ostream* stream) { *stream << use.arguments; }

class BadUses : public testing::TestWithParam<BadUse> {};

TEST_P(BadUses, GetOneLineOnStderrAndTheirExitCode) {
  const Outcome outcome = run(GetParam().arguments);
  EXPECT_EQ(outcome.code, GetParam().code) << outcome.err;
  EXPECT_NE(outcome.err.find(GetParam().complaint), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

INSTANTIATE_TEST_SUITE_P(
    Each, BadUses,
    testing::Values(
        BadUse{"frobnicate", 2, "command = frobnicate (must be one of list, show, solve, orbits, "},
        BadUse{"slove sdof-stop", 2, "; did you mean solve?)"},
        BadUse{"--plugin x slove sdof-stop", 2, "; did you mean solve?)"},
        BadUse{"solve sdof-stop --method hatlcp", 2, "; did you mean hat-lcp?)"},
        BadUse{"solve sdof-stop --method hat-lcp --set sample=3", 2, "; did you mean samples?)"},
        BadUse{"solve sdof-stop --mehtod hat-lcp", 2, "; --mehtod: did you mean --method?"},
        BadUse{"run quik --dry-run", 2, "; did you mean quick?)"},
        BadUse{"run quick --methods hatlcp --dry-run", 3, "did you mean hat-lcp?"},
        BadUse{"run quick --scenes sdof-stp --dry-run", 3, "did you mean sdof-stop"},
        BadUse{"solve nofile.toml --method hat-lcp", 2, "nofile.toml (must exist: there is no such file)"},
        BadUse{"run no/suite.toml --dry-run", 2, "suite = no/suite.toml (must exist: there is no such file)"},
        BadUse{"run quick --scenes a.toml b.toml --dry-run", 2, "--scenes A.toml:B.toml"},
        BadUse{"", 2, "subcommand is required"}, BadUse{"list animals", 2, "animals"},
        BadUse{"show nothing-of-that-name", 2, "name = nothing-of-that-name"},
        BadUse{"solve no-such-scene --method hat-lcp", 2, "scene = no-such-scene"},
        BadUse{"solve sdof-stop --method no-such", 2, "method = no-such"},
        BadUse{"solve sdof-stop", 2, "--method"},
        BadUse{"solve sdof-stop --method hat-lcp --set colour=red", 2, "colour = red (unknown option"},
        BadUse{"solve sdof-stop --method hat-lcp --set samples=few", 2, "samples = few"},
        BadUse{"solve sdof-stop --method hat-lcp --set samples", 2, "set = samples"},
        BadUse{"solve sdof-stop --method hat-lcp --samples 0", 2, "--samples"},
        BadUse{"solve sdof-stop --method hat-lcp --samples 4194304", 2, "not in range 1 to 65536"},
        BadUse{"solve sdof-stop --method hat-lcp --start /no/such/file", 2, "/no/such/file"},
        BadUse{"run no-such-suite", 2, "suite = no-such-suite"},
        BadUse{"run quick --methods zzz* --dry-run", 3, "methods = zzz*"},
        BadUse{"run quick --scenes zzz* --dry-run", 3, "scenes = zzz*"},
        BadUse{"run quick --methods hat-lcp[samples] --dry-run", 2, "methods = samples"},
        BadUse{"run quick --timeout -1", 2, "timeout = -1"},
        BadUse{"run quick --repetitions 0", 2, "--repetitions"},
        BadUse{"run quick --no-such-flag", 2, "--no-such-flag"},
        BadUse{"run quick --shard 3/2 --dry-run", 2, "shard = 3/2 (must be I/N"},
        BadUse{"run quick --shard 1/2 --durations /no/such --dry-run", 2, "dir = /no/such"},
        BadUse{"run quick --jobs 0", 2, "--jobs"},
        BadUse{"run quick --scenes /no/such.toml --dry-run", 2, "/no/such.toml"},
        BadUse{"merge /no/such/folder --out /tmp/out", 2, "dir = /no/such/folder"},
        BadUse{"merge /no/such/folder", 2, "--out"}, BadUse{"status /no/such/folder", 2, "dir = /no/such"},
        BadUse{"compare /no/such /no/such", 2, "dir = /no/such"}, BadUse{"submit slurm", 2, "dir"},
        BadUse{"submit slurm out", 2, "--shards"},
        BadUse{"submit slurm out --shards 2 --dry-run quick --scenes zzz*", 3, "scenes = zzz*"},
        BadUse{"submit slurm out --shards 2 --dry-run quick --no-such", 2, "--no-such"},
        BadUse{"submit teams out", 2, "subcommand is required"}, BadUse{"completion fish", 2, "fish"},
        BadUse{"report /no/such/folder", 2, "dir = /no/such/folder"},
        BadUse{"check", 2, "method = missing (must be a method, or --all"},
        BadUse{"check hat-lcp --all", 2, "method = hat-lcp"}, BadUse{"check no-such", 2, "method = no-such"},
        BadUse{"check hat-lcp --scenes zzz*", 3, "scenes = zzz*"},
        BadUse{"check hat-lcp --checks zzz*", 3, "checks = zzz*"},
        BadUse{"check hat-lcp --suite no-such", 2, "suite = no-such"},
        BadUse{"check hat-lcp --timeout 0", 2, "timeout = 0"}, BadUse{"new", 2, "subcommand is required"},
        BadUse{"new method", 2, "name"},
        BadUse{"new method My_Method --out-of-tree", 2, "name = My_Method (must be lower-kebab"},
        BadUse{"new method my-method --tree /no/such", 2, "tree = /no/such"},
        BadUse{"new method my-method --tree . --out-of-tree", 2, "--tree"},
        BadUse{"sweep no-such-scene --method hat-lcp --from 1 --to 2", 2, "scene = no-such-scene"},
        BadUse{"sweep sdof-stop --method no-such --from 1 --to 2", 2, "method = no-such"},
        BadUse{"sweep sdof-stop --method hat-lcp --from 1", 2, "--to"},
        BadUse{"sweep sdof-stop --method hat-lcp --from 0 --to 2", 2, "from = 0 (must be a positive"},
        BadUse{"sweep sdof-stop --method hat-lcp --from 1 --to nan", 2, "to = nan"},
        BadUse{"sweep sdof-stop --method hat-lcp --from 1 --to 1", 2, "to = 1 (must differ"},
        BadUse{"sweep sdof-stop --method hat-lcp --from 1 --to 2 --points 1", 2, "--points"},
        BadUse{"sweep sdof-stop --method hat-lcp --from 1 --to 2 --set colour=red", 2, "colour = red"},
        BadUse{"sweep sdof-stop --method hat-lcp --from 1 --to 2 --format pdf", 2, "pdf"},
        BadUse{"orbits no-such-scene", 2, "scene = no-such-scene"},
        BadUse{"orbits sdof-stop --subharmonics 0", 2, "--subharmonics"},
        BadUse{"orbits sdof-stop --starts -1", 2, "--starts"},
        BadUse{"orbits sdof-stop --timeout 0", 2, "timeout = 0"}, BadUse{"orbits", 2, "scene"},
        BadUse{"verify /no/such/folder", 2, "dir = /no/such/folder"},
        BadUse{"verify . --scenes zzz*", 3, "scenes = zzz*"}, BadUse{"report . --format pdf", 2, "pdf"}));

TEST(CommandLine, HelpsWithEveryCommand) {
  for (const char* command :
       {"",        "list",   "show",         "solve",           "run",        "status",    "merge",
        "compare", "doctor", "submit slurm", "submit parallel", "completion", "man",       "report",
        "orbits",  "motion", "verify",       "check",           "new method", "new scene", "sweep"}) {
    const Outcome outcome = run(std::string(command) + " --help");
    EXPECT_EQ(outcome.code, 0) << command;
    EXPECT_NE(outcome.out.find("Usage: signorini"), std::string::npos) << command;
    EXPECT_EQ(outcome.err, "") << command;
  }
}

/// The program with redirections of its own; its exit code.
int code_of(const std::string& arguments_and_redirections) {
  return run(arguments_and_redirections + "; (exit $?)").code;
}

TEST(CommandLine, SaysThatWhatItPrintsFindsNoRoom) {
  const std::string complaint = (test::fresh_folder("full-output") / "complaint").string();
  for (const char* command : {"list", "show sdof-stop", "--help", "--version"}) {
    SCOPED_TRACE(command);
    EXPECT_EQ(code_of(std::string(command) + " >/dev/full 2>" + complaint), 2);
    const std::string said = read_file(complaint);
    EXPECT_TRUE(said.starts_with("stdout = full (must take what is printed: ")) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  }
}

TEST(CommandLine, HasItsExitCodeWhereNothingCanBeSaid) {
  EXPECT_EQ(code_of("show no-such-scene 2>/dev/full"), 2);
  EXPECT_EQ(code_of("show no-such-scene >&- 2>&-"), 2);
  EXPECT_EQ(code_of("list >&- 2>&-"), 0);
}

TEST(CommandLine, PrintsIntoNoFileOfARunWhereStdoutIsClosed) {
  const std::filesystem::path folder = test::fresh_folder("closed-output");
  EXPECT_EQ(
      code_of("run quick --scenes sdof-far-stop --methods 'hat-lcp[samples=64]' --repetitions 1 --out " +
              (folder / "run").string() + " <&- >&- 2>&-"),
      0);
  const std::string records = read_file(folder / "run" / "records.jsonl");
  EXPECT_EQ(std::count(records.begin(), records.end(), '\n'), 1);
  EXPECT_EQ(records.front(), '{');
}

TEST(CommandLine, TellsItsVersion) {
  const Outcome outcome = run("--version");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out.rfind("signorini ", 0), 0U);
}

TEST(CommandLine, RefusesABadSceneFileWithFileLineAndField) {
  const auto folder = test::fresh_folder("bad-scene");
  std::ofstream(folder / "bad.toml") << "schema = 1\nname = 3\n";
  const Outcome outcome = run("solve " + (folder / "bad.toml").string() + " --method hat-lcp");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("bad.toml:2: name = 3"), std::string::npos) << outcome.err;
}

/// A run's folder whose manifest the user wrote.
std::filesystem::path run_with_manifest(const char* name, const std::string& manifest) {
  const auto folder = test::fresh_folder(name);
  std::ofstream(folder / "manifest.json") << manifest;
  std::ofstream(folder / "records.jsonl");
  return folder;
}

TEST(CommandLine, RefusesAManifestWhoseMembersHaveTheWrongType) {
  const std::string jobs = run_with_manifest("manifest-jobs", R"({"jobs": "many"})").string();
  const std::string times = run_with_manifest("manifest-times", R"({"times_comparable": 3})").string();
  const std::string machine = run_with_manifest("manifest-machine", R"({"machine": "mine"})").string();
  for (const auto& [command, complaint] :
       {std::pair{"status " + jobs, "manifest.json: jobs = \"many\" (must be a whole number, 1..1e9)\n"},
        std::pair{fmt::format("compare {0} {0}", times),
                  "manifest.json: times_comparable = 3 (must be true or false)\n"},
        std::pair{fmt::format("merge {0} --out {0}/merged", machine),
                  "manifest.json: machine = \"mine\" (must be an object)\n"}}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_TRUE(outcome.err.ends_with(complaint)) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST(CommandLine, SaysWhyASceneWithoutALoadIsNotFollowed) {
  const auto folder = test::fresh_folder("no-load");
  std::ofstream(folder / "rest.toml")
      << "schema = 1\nname = \"rest\"\n"
         "system = { kind = \"sdof\", mass = 1.0, damping = 0.1, stiffness = 1.0 }\n"
         "forcing = { frequency = 1.0 }\ncontact = [{ dof = 0, gap = 1.0 }]\nlaw = { penalty = 10.0 }\n";
  const std::string scene = (folder / "rest.toml").string();
  for (const char* options : {"", " --from 0.5 --to 3", " --from 0.5 --to 3 --methods aft-hbm"}) {
    const Outcome outcome = run("sweep " + scene + options);
    EXPECT_EQ(outcome.code, 2) << options;
    EXPECT_NE(outcome.err.find("without a periodic load"), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST(CommandLine, RefusesAFileWhereAFolderIsToBe) {
  const auto file = test::fresh_folder("file-for-folder") / "file";
  std::ofstream(file) << "mine";
  const Outcome outcome = run("verify --update --scenes sdof-stop " + file.string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err, fmt::format("path = {} (must be usable: Not a directory)\n", file.string()));
}

TEST(CommandLine, PointsToTheHelpOfTheCommandThatWasMisused) {
  EXPECT_TRUE(run("run quick --no-such").err.ends_with("(see `signorini run --help`)\n"));
  EXPECT_TRUE(run("submit slurm out").err.ends_with("(see `signorini submit slurm --help`)\n"));
}

}  // namespace
}  // namespace signorini::command_line_test
