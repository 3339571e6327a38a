// Runs the built program: exit codes and messages are part of its contract.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "harness/files.hpp"
#include "harness/records/record_store.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"

namespace signorini {
namespace {

using Json = nlohmann::ordered_json;

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
        BadUse{"frobnicate", 2, "command = frobnicate (must be one of list, show, solve, run, "},
        BadUse{"", 2, "subcommand is required"}, BadUse{"list animals", 2, "animals"},
        BadUse{"show nothing-of-that-name", 2, "name = nothing-of-that-name"},
        BadUse{"solve no-such-scene --method hat-lcp", 2, "scene = no-such-scene"},
        BadUse{"solve sdof-stop --method no-such", 2, "method = no-such"},
        BadUse{"solve sdof-stop", 2, "--method"},
        BadUse{"solve sdof-stop --method hat-lcp --set colour=red", 2, "colour = red (unknown option"},
        BadUse{"solve sdof-stop --method hat-lcp --set samples=few", 2, "samples = few"},
        BadUse{"solve sdof-stop --method hat-lcp --set samples", 2, "set = samples"},
        BadUse{"solve sdof-stop --method hat-lcp --samples 0", 2, "--samples"},
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
       {"",        "list",   "show",         "solve",           "run",        "status", "merge",
        "compare", "doctor", "submit slurm", "submit parallel", "completion", "man",    "report",
        "orbits",  "verify", "check",        "new method",      "new scene",  "sweep"}) {
    const Outcome outcome = run(std::string(command) + " --help");
    EXPECT_EQ(outcome.code, 0) << command;
    EXPECT_NE(outcome.out.find("Usage: signorini"), std::string::npos) << command;
    EXPECT_EQ(outcome.err, "") << command;
  }
}

TEST(CommandLine, TellsItsVersion) {
  const Outcome outcome = run("--version");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out.rfind("signorini ", 0), 0U);
}

TEST(CommandLine, ListsMethodsScenesAndSuites) {
  EXPECT_NE(run("list methods").out.find("fourier-lipschitz"), std::string::npos);
  EXPECT_NE(run("list scenes").out.find("sdof-stop"), std::string::npos);
  EXPECT_NE(run("list suites").out.find("quick"), std::string::npos);
  const Outcome all = run("list");
  EXPECT_EQ(all.code, 0);
  for (const char* name : {"hat-lcp", "sdof-stop", "smoke"}) EXPECT_NE(all.out.find(name), std::string::npos);
}

TEST(CommandLine, ShowsScenesAndMethods) {
  EXPECT_NE(run("show sdof-stop").out.find("eigenfrequencies"), std::string::npos);
  const std::string method = run("show fourier-lipschitz").out;
  EXPECT_NE(method.find("harmonics"), std::string::npos);
  EXPECT_NE(method.find("order             1, of the error of x"), std::string::npos) << method;
}

TEST(CommandLine, RefusesABadSceneFileWithFileLineAndField) {
  const auto folder = test::fresh_folder("bad-scene");
  std::ofstream(folder / "bad.toml") << "schema = 1\nname = 3\n";
  const Outcome outcome = run("solve " + (folder / "bad.toml").string() + " --method hat-lcp");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("bad.toml:2: name = 3"), std::string::npos) << outcome.err;
}

TEST(CommandLine, SolvesAndPrintsOneRecordThatStartsAnotherSolve) {
  const Outcome first =
      run("solve sdof-stop --method fourier-lipschitz --set harmonics=10 --json --samples 64");
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(std::count(first.out.begin(), first.out.end(), '\n'), 1);
  const Json json = Json::parse(first.out);
  EXPECT_EQ(json["status"], "converged");
  EXPECT_EQ(json["options"]["harmonics"], 10);
  EXPECT_EQ(json["trajectory"]["t"].size(), 64U);
  EXPECT_EQ(json["trajectory"]["x"][0].size(), 64U);
  EXPECT_EQ(json["certificate"]["status"], "certified");
  EXPECT_LT(json["errors"]["x_l2"].get<double>(), 0.5);
  const auto file = test::fresh_folder("start") / "first.json";
  std::ofstream(file) << first.out;
  const Outcome second =
      run("solve sdof-stop --method event-driven --set steady=shooting --json --start " + file.string());
  ASSERT_EQ(second.code, 0) << second.err << second.out;
  EXPECT_LT(Json::parse(second.out)["errors"]["x_l2"].get<double>(), 1e-6);
}

TEST(CommandLine, ReportsASolveInWords) {
  const Outcome outcome = run("solve sdof-stop --method hat-lcp");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("sdof-stop/hat-lcp: converged", 0), 0U) << outcome.out;
  EXPECT_NE(outcome.out.find("error of x"), std::string::npos);
}

TEST(CommandLine, PrintsThePlanWithoutRunningIt) {
  const Outcome outcome =
      run("run quick --scenes sdof-stop --methods 'penalty-hbm[harmonics=31,penalty=1e4|1e6]' --dry-run");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(
      outcome.out,
      "sdof-stop/penalty-hbm[harmonics=31,penalty=1e4]\nsdof-stop/penalty-hbm[harmonics=31,penalty=1e6]\n");
}

TEST(CommandLine, RunsASceneFileInPlaceOfTheSuites) {
  const std::filesystem::path folder = test::fresh_folder("own-scene");
  std::string text = read_file(problems_folder() / "catalogue" / "sdof-stop.toml");
  text.replace(text.find("\"sdof-stop\""), 11, "\"my-stop\"");
  std::ofstream(folder / "own.toml") << text;
  const Outcome outcome = run("run quick --methods 'hat-lcp[samples=64]' --scenes " +
                              (folder / "own.toml").string() + " --dry-run");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "my-stop/hat-lcp[samples=64]\n");
}

TEST(CommandLine, RunsASuiteReportsAndResumesIt) {
  const auto folder = test::fresh_folder("run");
  const std::string command =
      "run smoke --scenes sdof-stop --methods 'hat-lcp[samples=64]:fourier-lipschitz[harmonics=5]' --out " +
      folder.string();
  const Outcome first = run(command);
  ASSERT_EQ(first.code, 0) << first.err << first.out;
  EXPECT_NE(first.out.find("| scene"), std::string::npos);
  EXPECT_NE(first.out.find(folder.string()), std::string::npos);
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
       {std::pair{"status " + jobs, "manifest.json: jobs = \"many\" (must be a number)\n"},
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

TEST(CommandLine, RefusesAFileWhereAFolderIsToBe) {
  const auto file = test::fresh_folder("file-for-folder") / "file";
  std::ofstream(file) << "mine";
  const Outcome outcome = run("verify --update --scenes sdof-stop " + file.string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err, fmt::format("path = {} (must be usable: Not a directory)\n", file.string()));
}

TEST(CommandLine, ExitsWithOneWhereSomethingFailedThatWasNotExpectedTo) {
  const auto folder = test::fresh_folder("failing");
  const std::string case_line =
      "run smoke --scenes sdof-stop --methods "
      "'fourier-lipschitz[harmonics=5,max_iterations=1,solver=newton]' --out ";
  EXPECT_EQ(run(case_line + folder.string()).code, 1);
  EXPECT_EQ(read_records(folder / "records.jsonl").size(), 1U);
}

TEST(CommandLine, ListsTheOrbitsOfAScene) {
  const Outcome table = run("orbits sdof-subharmonic --starts 8 --subharmonics 2");
  EXPECT_EQ(table.code, 0) << table.err;
  EXPECT_NE(table.out.find("| orbit"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("unstable"), std::string::npos) << table.out;
  const Outcome outcome = run("orbits sdof-subharmonic --starts 8 --subharmonics 2 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json orbits = Json::parse(outcome.out);
  ASSERT_GE(orbits.size(), 2U);
  for (const char* key : {"orbit", "order", "period", "amplitude", "impacts", "error_bar", "floquet",
                          "stable", "events", "found_by", "starts", "from_rest"}) {
    EXPECT_TRUE(orbits[0].contains(key)) << key;
  }
  EXPECT_EQ(orbits[0]["order"], 1);
}

TEST(CommandLine, ExitsWithOneWhereNoOrbitIsFound) {
  const Outcome outcome = run("orbits sdof-stop --starts 0 --timeout 1e-9");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("no certified orbit"), std::string::npos) << outcome.err;
}

/// Kept orbits of one scene, for a test to spoil.
std::filesystem::path kept_orbits(const char* name) {
  const auto folder = test::fresh_folder(name);
  const Outcome update = run("verify --update --scenes sdof-subharmonic --starts 8 " + folder.string());
  EXPECT_EQ(update.code, 0) << update.err << update.out;
  return folder;
}

Outcome verify(const std::filesystem::path& folder) {
  return run("verify " + folder.string() + " --scenes sdof-subharmonic");
}

TEST(Verify, PassesWhatIsUnchangedAndKeepsNothingOfTheMachine) {
  const auto folder = kept_orbits("verify-same");
  const std::string text = read_file(folder / "sdof-subharmonic.json");
  EXPECT_EQ(text.find("tmp"), std::string::npos);
  EXPECT_EQ(text.find("seconds"), std::string::npos);
  const Outcome outcome = verify(folder);
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("1 scenes, 0 differences"), std::string::npos) << outcome.out;
}

TEST(Verify, FindsTamperedOrbits) {
  const auto folder = kept_orbits("verify-tampered");
  const auto file = folder / "sdof-subharmonic.json";
  const Json kept = Json::parse(read_file(file));
  Json changed = kept;
  changed["orbits"][0]["events"][0]["time"] = kept["orbits"][0]["events"][0]["time"].get<double>() + 1e-5;
  std::ofstream(file) << changed.dump();
  Outcome outcome = verify(folder);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.out.find("time"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("1 scenes, 1 differences"), std::string::npos) << outcome.out;
  changed = kept;
  changed["orbits"][0]["stable"] = !kept["orbits"][0]["stable"].get<bool>();
  std::ofstream(file) << changed.dump();
  outcome = verify(folder);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.out.find("stable became"), std::string::npos) << outcome.out;
  changed = kept;
  changed["orbits"].erase(0);
  std::ofstream(file) << changed.dump();
  outcome = verify(folder);
  EXPECT_EQ(outcome.code, 0) << outcome.out;  // what is new is told, and is no difference
  EXPECT_NE(outcome.out.find(": new, amplitude"), std::string::npos) << outcome.out;
}

TEST(Verify, RefusesAFolderThatKeepsNothing) {
  const auto folder = test::fresh_folder("verify-empty");
  const Outcome outcome = run("verify " + folder.string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.rfind("dir = " + folder.string() + " (must be a folder of references", 0), 0U)
      << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST(Verify, FindsAMissingFileAndAChangedScene) {
  const auto folder = test::fresh_folder("verify-missing");
  Outcome outcome = verify(folder);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.out.find("sdof-subharmonic: no orbits are kept"), std::string::npos) << outcome.out;
  std::ofstream(folder / "sdof-subharmonic.json")
      << R"({"schema": 1, "scene": "sdof-subharmonic", "scene_sha256": "other", "law": {"restitution": 0.8},
            "search": {"starts": 8, "subharmonics": 2, "seed": 1}, "orbits": []})";
  outcome = verify(folder);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.out.find("sdof-subharmonic: the scene file has changed"), std::string::npos);
  std::ofstream(folder / "sdof-subharmonic.json") << "{ nonsense";
  outcome = verify(folder);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("sdof-subharmonic.json: "), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST(Verify, AsksForScenesThatTakeLongOnlyByName) {
  const auto problems = test::fresh_folder("verify-large");
  std::filesystem::create_directories(problems / "catalogue");
  for (const auto& [name, tag] : {std::pair{"huge", "large"}, {"hard", "long-search"}, {"small", "easy"}}) {
    std::ofstream(problems / "catalogue" / (std::string(name) + ".toml"))
        << fmt::format("schema = 1\nname = \"{}\"\ntags = [\"{}\"]\n", name, tag);
  }
  ASSERT_EQ(::setenv("SIGNORINI_PROBLEMS", problems.c_str(), 1), 0);
  const auto references = test::fresh_folder("verify-large-references");
  std::ofstream(references / "hard.json") << "{}";  // kept orbits do not make the search any shorter
  const Outcome all = run("verify " + references.string());
  const Outcome named = run("verify --scenes huge " + references.string());
  ASSERT_EQ(::unsetenv("SIGNORINI_PROBLEMS"), 0);

  EXPECT_EQ(all.code, 1);
  EXPECT_NE(all.out.find("small: no orbits are kept"), std::string::npos) << all.out;
  EXPECT_EQ(all.out.find("huge"), std::string::npos) << all.out;
  EXPECT_EQ(all.out.find("hard"), std::string::npos) << all.out;
  EXPECT_NE(named.out.find("huge: no orbits are kept"), std::string::npos) << named.out;
}

TEST(Verify, TakesALevelOfAFamilyByName) {
  const auto folder = test::fresh_folder("verify-family");
  const Outcome outcome = run("verify --scenes 'grazing@0.1' " + folder.string());
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("grazing@0.1: no orbits are kept"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("1 scenes, 1 differences"), std::string::npos) << outcome.out;
}

TEST(Verify, RerunsTheRecordsOfARun) {
  const auto folder = test::fresh_folder("verify-run");
  ASSERT_EQ(run("run smoke --scenes sdof-stop --methods 'hat-lcp[samples=64]' --out " + folder.string()).code,
            0);
  Outcome outcome = run("verify " + folder.string());
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("1 cases, 0 differences"), std::string::npos) << outcome.out;
  Json record = Json::parse(read_file(folder / "records.jsonl"));
  record["errors"]["x_l2"] = 0.5 * record["errors"]["x_l2"].get<double>();
  std::ofstream(folder / "records.jsonl") << record.dump() << "\n";
  outcome = run("verify " + folder.string());
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.out.find("error of x"), std::string::npos) << outcome.out;
  EXPECT_EQ(run("verify " + folder.string() + " --cases 'zzz*'").code, 3);
}

TEST(CommandLine, RunsShardsThatMergeToTheWholeRun) {
  const auto folder = test::fresh_folder("shards");
  const std::string out = folder.string();
  const std::string command =
      "run quick --scenes sdof-stop:sdof-far-stop --methods 'hat-lcp[samples=64]' --repetitions 1 ";
  ASSERT_EQ(run(command + "--out " + out + "/whole").code, 0);
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const Outcome part =
        run(command + fmt::format("--shard {} --out {}/shards/shard-{}", shard, out, shard[0]));
    EXPECT_EQ(part.code, 0) << part.err;
  }
  const std::string merge =
      fmt::format("merge {0}/shards/shard-1 {0}/shards/shard-2 {0}/shards/shard-3 --out {0}/all", out);
  const Outcome merged = run(merge);
  ASSERT_EQ(merged.code, 0) << merged.err;
  EXPECT_EQ(run(merge).code, 0) << "a merge may be repeated";
  const auto whole = read_records(folder / "whole" / "records.jsonl");
  const auto all = read_records(folder / "all" / "records.jsonl");
  ASSERT_EQ(all.size(), 2U);
  for (const Record& record : whole) {
    const auto same =
        std::find_if(all.begin(), all.end(), [&](const Record& r) { return r.key == record.key; });
    ASSERT_NE(same, all.end()) << record.case_id;
    EXPECT_EQ(same->errors.x_l2, record.errors.x_l2);
  }
  EXPECT_EQ(run(fmt::format("merge {0}/shards/shard-1 {0}/shards/shard-2 --out {0}/part", out)).code, 2);
  EXPECT_EQ(run(merge.substr(0, merge.rfind(' ')) + " " + out + "/shards/merged").code, 0)
      << "beside the shards, as submit does";
  EXPECT_EQ(run(merge.substr(0, merge.rfind(' ')) + " " + out + "/whole").code, 2)
      << "a run is not written over";

  const Outcome status = run("status --json " + out + "/shards");
  ASSERT_EQ(status.code, 0) << status.err;
  const Json list = Json::parse(status.out);
  ASSERT_EQ(list.size(), 4U);
  EXPECT_EQ(list[3]["name"], "all");
  EXPECT_EQ(list[3]["converged"], 2);
  EXPECT_EQ(list[3]["pending"], 0);
  EXPECT_NE(run("status " + out + "/all").out.find("done"), std::string::npos);

  const Outcome compared = run(fmt::format("compare {0}/all {0}/all", out));
  EXPECT_EQ(compared.code, 0) << compared.out;
  EXPECT_NE(compared.out.find("2 cases compared, "), std::string::npos) << compared.out;
  Json record = Json::parse(read_file(folder / "whole" / "records.jsonl")
                                .substr(0, read_file(folder / "whole" / "records.jsonl").find('\n')));
  record["status"] = "crashed";
  std::ofstream(folder / "whole" / "records.jsonl") << record.dump() << "\n";
  const Outcome worse = run(fmt::format("compare {0}/all {0}/whole", out));
  EXPECT_EQ(worse.code, 4) << worse.out;
  EXPECT_NE(worse.out.find("broken: "), std::string::npos) << worse.out;
}

/// Long options that --help shows.
std::set<std::string> options_in_help(const std::string& command) {
  std::set<std::string> options;
  const std::string help = run(command + " --help").out;
  for (std::size_t at = help.find("--"); at != std::string::npos; at = help.find("--", at + 2)) {
    const std::size_t end = help.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", at);
    if (at > 0 && (help[at - 1] == ' ' || help[at - 1] == ',') && help.rfind('\n', at) + 8 > at)
      options.insert(help.substr(at, end - at));
  }
  return options;
}

TEST(CommandLine, DescribesEveryOptionToShellsAndToMan) {
  const std::string bash = run("completion bash").out, zsh = run("completion zsh").out, man = run("man").out;
  for (const char* command : {"run", "status", "merge", "compare", "submit slurm", "solve", "verify"}) {
    EXPECT_NE(bash.find(fmt::format("'{} '*)", command)), std::string::npos) << command;
    EXPECT_NE(zsh.find(fmt::format("'{} '*)", command)), std::string::npos) << command;
    EXPECT_NE(man.find(fmt::format(".SS {}\n", command)), std::string::npos) << command;
    const std::set<std::string> options = options_in_help(command);
    EXPECT_GE(options.size(), 1U) << command;
    for (const std::string& option : options) {
      EXPECT_NE(bash.find(option), std::string::npos) << option;
      EXPECT_NE(zsh.find("'" + option + ":"), std::string::npos) << option;
      std::string escaped;
      for (const char c : option) escaped += c == '-' ? "\\-" : std::string(1, c);
      EXPECT_NE(man.find(escaped), std::string::npos) << option;
    }
  }
}

TEST(CommandLine, PointsToTheHelpOfTheCommandThatWasMisused) {
  EXPECT_TRUE(run("run quick --no-such").err.ends_with("(see `signorini run --help`)\n"));
  EXPECT_TRUE(run("submit slurm out").err.ends_with("(see `signorini submit slurm --help`)\n"));
}

TEST(CommandLine, OrdersTheManualAsOneReadsIt) {
  const std::string man = run("man").out;
  EXPECT_LT(man.find(".SS submit\n"), man.find(".SS submit slurm\n"));
  EXPECT_NE(man.find("\nAll other words are those of `signorini run`"), std::string::npos);
}

TEST(CommandLine, CompletesInBash) {
  const auto folder = test::fresh_folder("completion");
  std::ofstream(folder / "signorini.bash") << run("completion bash").out;
  std::ofstream(folder / "try.bash") << "source " << (folder / "signorini.bash").string() << R"(
try() { COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _signorini; echo "${COMPREPLY[@]}"; }
try signorini comp
try signorini run --sh
try signorini submit slurm --sh
)";
  const auto answer = folder / "answer";
  ASSERT_EQ(std::system(fmt::format("bash {0}/try.bash >{0}/answer 2>&1", folder.string()).c_str()), 0);
  EXPECT_EQ(read_file(answer), "compare completion\n--shard\n--shards\n");
}

TEST(CommandLine, ExaminesTheMachine) {
  const Outcome outcome = run("doctor --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const Json& finding : Json::parse(outcome.out)) {
    EXPECT_TRUE(finding.contains("name") && finding.contains("value") && finding.contains("good")) << finding;
    EXPECT_EQ(finding["good"].get<bool>(), !finding.contains("advice")) << finding;
  }
}

TEST(CommandLine, PrintsTheScriptsOfASubmissionAndWritesNone) {
  const auto folder = test::fresh_folder("submit");
  const std::string out = (folder / "not-made").string();
  const Outcome outcome = run("submit slurm " + out + " --shards 3 --dry-run quick --scenes 'sdof*'");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("--array=1-3"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("--scenes 'sdof*'"), std::string::npos) << outcome.out;
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(CommandLine, RefusesASubmissionWhoseShardsCouldNotStart) {
  const std::string out = (test::fresh_folder("refused") / "not-made").string();
  for (const char* words : {"--out elsewhere", "--shard 1/2", "--timeout never"}) {
    const Outcome outcome = run("submit slurm " + out + " --shards 2 --dry-run smoke " + words);
    EXPECT_EQ(outcome.code, 2) << words;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  EXPECT_EQ(run("submit parallel " + out + " --shards 2 --dry-run smoke --beside 2").code, 2);
}

TEST(CommandLine, RefusesASeedAShardAndDurationsThatMeanNothing) {
  for (const char* words : {"--seed -1", "--shard ''", "--durations nope"}) {
    const Outcome outcome = run(std::string("run smoke --dry-run ") + words);
    EXPECT_EQ(outcome.code, 2) << words;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST(CommandLine, CallsASubmissionThatTheLauncherRefusesBadUsage) {
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

TEST(CommandLine, RunsShardsByGnuParallel) {
  if (std::system("command -v parallel >/dev/null") != 0) GTEST_SKIP() << "GNU parallel is not installed";
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

TEST(CommandLine, StopsAtAnInterruptAndCompletesTheRunLater) {
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
}  // namespace signorini
