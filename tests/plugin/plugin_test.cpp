// Plugins that are shared objects: equal to the methods of the program, or refused in one line.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "harness/files.hpp"
#include "methods/plugin/sanitizer.hpp"
#include "tests/plugin/installed_program.hpp"

namespace signorini::test::plugin_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string plugin(const std::string& name) { return " --plugin " + plugin_path(name); }

struct BadPlugin {
  const char* file;
  std::vector<std::string> complaint;
};

void PrintTo(const BadPlugin& bad, std::ostream* stream) { *stream << bad.file; }

class BadPlugins : public testing::TestWithParam<BadPlugin> {};

TEST_P(BadPlugins, AreRefusedInOneLineThatSaysWhy) {
  const TemporaryFolder folder;
  const auto& [file, complaint] = GetParam();
  if (!fs::exists(plugin_path(file))) GTEST_SKIP() << "not built by this compiler for this architecture";
  if (kAddressSanitizer && std::string(file) == "sanitised.so") GTEST_SKIP() << "built as the program is";
  std::vector<std::string> parts = complaint;
  parts.push_back(plugin_path(file));
  expect_refusal(run_installed(folder, "list methods" + plugin(file)), parts);
}

INSTANTIATE_TEST_SUITE_P(
    Each, BadPlugins,
    testing::Values(BadPlugin{"aligned.so", {"EIGEN_MAX_ALIGN_BYTES is 64 there, "}},
                    BadPlugin{"vectorised.so", {"EIGEN_MAX_ALIGN_BYTES is 32 there, 16 here"}},
                    BadPlugin{"checked.so",
                              {"checks of the standard library is assertions there, none here"}},
                    BadPlugin{"sanitised.so", {"plugin = "}},
                    BadPlugin{"rounding.so", {"must leave floating-point numbers as they are"}},
                    BadPlugin{"old_headers.so", {"headers is 0123 there, "}},
                    BadPlugin{"old_api.so", {"must be built for plugin API 2, not 1"}},
                    BadPlugin{"text.so", {"must be a shared object that can be loaded: "}},
                    BadPlugin{"no_entry.so", {"must be a plugin: it has no function signorini_plugin"}},
                    BadPlugin{"unresolved.so", {"undefined symbol"}},
                    BadPlugin{"abort_on_load.so", {"signal 6", "this cannot go well"}},
                    BadPlugin{"unmakeable.so", {"tiny-unmakeable", "tiny::Refusal"}},
                    BadPlugin{"clash.so", {"method = hat-lcp (must be new"}},
                    BadPlugin{"misnamed.so", {"method = Tiny One (must be a name in lower-kebab-case)"}}));

TEST(Plugins, ThatAreMissingOrFoldersAreRefused) {
  const TemporaryFolder folder;
  expect_refusal(run_installed(folder, "list --plugin /no/such.so"),
                 {"plugin = /no/such.so (must be a file"});
  expect_refusal(run_installed(folder, "list --plugin ."), {"plugin = . (must be a file"});
  expect_refusal(run_installed(folder, "list --plugin ''"), {"plugin =  (must be a file"});
}

TEST(Plugins, AreListedAndShownAfterTheMethodsOfTheProgram) {
  const TemporaryFolder folder;
  const std::string both = plugin("throwing.so") + plugin("tiny.so");
  const Outcome list = run_installed(folder, "list methods" + both);
  EXPECT_EQ(list.code, 0) << list.err;
  const std::size_t last = list.out.find("exact-orbit"), tiny = list.out.find("tiny "),
                    quiet = list.out.find("tiny-quiet"), throwing = list.out.find("tiny-throwing");
  ASSERT_NE(throwing, std::string::npos) << list.out;
  EXPECT_TRUE(last < tiny && tiny < quiet && quiet < throwing) << list.out;
  EXPECT_EQ(run_installed(folder, "list methods" + plugin("tiny.so") + plugin("throwing.so")).out, list.out);
  const Outcome show = run_installed(folder, "show tiny" + both);
  EXPECT_NE(show.out.find("level"), std::string::npos) << show.out;
}

TEST(Plugins, OfTheSearchPathAreThereForEveryCommand) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "first");
  fs::create_directories(folder.path() / "second");
  fs::copy(plugin_path("tiny.so"), folder.path() / "second" / "tiny.so");
  static_cast<void>(folder.write("first/notes.txt", "no plugin, and no reason to complain"));
  static_cast<void>(folder.write("first/command.toml",
                                 "schema = 1\nname = \"command\"\ntitle = \"A command\"\nladder = \"a=1\"\n"
                                 "command = [\"true\"]\n[represents]\nrestitution = 1\n[[option]]\nname = "
                                 "\"a\"\ndefault = 1\nunit = \"[-]\"\nmeaning = \"nothing\"\n"));
  const std::string path = "SIGNORINI_PLUGIN_PATH=first::second";
  const Outcome list = run_installed(folder, "list methods", path);
  EXPECT_EQ(list.code, 0) << list.err;
  EXPECT_NE(list.out.find("\ntiny "), std::string::npos) << list.out;
  EXPECT_NE(list.out.find("\ncommand "), std::string::npos) << list.out;
  EXPECT_EQ(run_installed(folder, "list methods --plugin second/../second/tiny.so", path).out, list.out);
  // Another file of the same contents is another plugin, whose method has a name that is taken.
  expect_refusal(run_installed(folder, "list" + plugin("tiny.so"), path), {"method = tiny (must be new"});
}

TEST(Plugins, OnASearchPathThatCannotBeReadAreRefused) {
  const TemporaryFolder folder;
  expect_refusal(run_installed(folder, "list", "SIGNORINI_PLUGIN_PATH=/no/such/folder"),
                 {"SIGNORINI_PLUGIN_PATH = /no/such/folder (must name folders that can be read"});
}

TEST(Plugins, RefuseBadOptionsAsMethodsOfTheProgramDo) {
  const TemporaryFolder folder;
  const std::string solve = "solve sdof-stop --method tiny" + plugin("tiny.so");
  expect_refusal(run_installed(folder, solve + " --set level=9"), {"level = 9 (must be in 1..3)"});
  expect_refusal(run_installed(folder, solve + " --set colour=1"),
                 {"colour = 1 (unknown option; known: level)"});
}

TEST(Plugins, ThatThrowTheirOwnTypeGetARecordAndLeaveOthersUntouched) {
  const TemporaryFolder folder;
  const Outcome run = run_installed(
      folder, "run catalogue --scenes sdof-stop --methods 'tiny*[level=1]:hat-lcp[samples=64]' --out run" +
                  plugin("throwing.so"));
  EXPECT_EQ(run.code, 1) << run.err;
  const std::map<std::string, Record> records = records_in(folder.path() / "run");
  ASSERT_EQ(records.size(), 3U);
  const Record& thrown = records.at("sdof-stop/tiny-throwing[level=1]");
  EXPECT_EQ(thrown.status, Status::exception);
  EXPECT_EQ(thrown.message, "an object of type tiny::Misfortune, which is no std::exception");
  EXPECT_EQ(records.at("sdof-stop/hat-lcp[samples=64]").status, Status::converged);
  // It stands still and says so: an answer that is judged like any other.
  EXPECT_EQ(records.at("sdof-stop/tiny-quiet[level=1]").status, Status::inaccurate);
  EXPECT_NE(run.out.find("tiny-throwing"), std::string::npos);
}

TEST(Plugins, ThatThrowTheirOwnTypeAreToldBySolve) {
  const TemporaryFolder folder;
  const Outcome solve =
      run_installed(folder, "solve sdof-stop --method tiny-throwing --json" + plugin("throwing.so"));
  EXPECT_EQ(solve.code, 1) << solve.err;
  EXPECT_EQ(Json::parse(solve.out).at("status"), "exception");
}

TEST(Plugins, WithoutOptimisationHaveNoTimes) {
  const TemporaryFolder folder;
  const Outcome solve =
      run_installed(folder, "solve sdof-stop --method tiny-debug --json" + plugin("debug.so"));
  const Json record = Json::parse(solve.out);
  EXPECT_FALSE(record.contains("seconds"));
  EXPECT_EQ(record.at("not_timed"), "the plugin is built without optimisation or with assertions");
}

// The key of a record holds the plugin's bytes: another build of it is another method.
TEST(Plugins, RebuiltMakeTheirRecordsStaleAndNoOthers) {
  const TemporaryFolder folder;
  const fs::path copy = folder.path() / "tiny.so";
  fs::copy(plugin_path("tiny.so"), copy);
  const std::string run =
      "run catalogue --scenes sdof-stop --methods 'tiny[level=1]:hat-lcp[samples=64]' --out run "
      "--repetitions 1 --resume --plugin tiny.so";
  const Outcome first = run_installed(folder, run);
  EXPECT_NE(first.out.find("2 cases run, 0 already there"), std::string::npos) << first.out << first.err;
  EXPECT_NE(run_installed(folder, run).out.find("0 cases run, 2 already there"), std::string::npos);
  const Record before = records_in(folder.path() / "run").at("sdof-stop/tiny[level=1]");
  EXPECT_EQ(before.plugin, sha256_of_file(copy));
  std::ofstream(copy, std::ios::app) << "what follows the sections changes nothing but the hash";
  EXPECT_NE(run_installed(folder, run).out.find("1 cases run, 1 already there"), std::string::npos);
  const Json manifest = Json::parse(read_file(folder.path() / "run" / "manifest.json"));
  EXPECT_EQ(manifest.at("plugins").at("tiny"), sha256_of_file(copy));
  EXPECT_FALSE(manifest.at("plugins").contains("hat-lcp"));
}

TEST(Plugins, AreHandedOnToTheShardsOfASubmission) {
  const TemporaryFolder folder;
  fs::copy(plugin_path("tiny.so"), folder.path() / "tiny.so");
  const Outcome submit =
      run_installed(folder, "submit slurm out --shards 2 --dry-run quick --methods tiny --plugin tiny.so");
  EXPECT_EQ(submit.code, 0) << submit.err;
  EXPECT_NE(submit.out.find("--plugin " + (folder.path() / "tiny.so").string()), std::string::npos)
      << submit.out;
}

// A copy of the tree in another place, with a scene that is nowhere else.
TEST(InstalledProgram, ReadsTheScenesThatWereInstalledWithIt) {
  const TemporaryFolder folder;
  const fs::path program = fs::path("bin") / "signorini",
                 scenes = fs::path("share") / "signorini" / "problems";
  for (const fs::path& part : {program, scenes}) {
    fs::create_directories((folder.path() / part).parent_path());
    fs::copy(installed_tree() / "prefix" / part, folder.path() / part, fs::copy_options::recursive);
  }
  const fs::path catalogue = folder.path() / scenes / "catalogue";
  fs::copy(catalogue / "sdof-stop.toml", catalogue / "only-here.toml");
  EXPECT_EQ(run_program(folder, folder.path() / program, "show only-here").code, 0);
  EXPECT_NE(run_program(folder, folder.path() / program, "list suites").out.find("catalogue"),
            std::string::npos);
  expect_refusal(run_installed(folder, "show only-here"), {"name = only-here"});
}

}  // namespace
}  // namespace signorini::test::plugin_test
