// `signorini verify`.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/files.hpp"
#include "harness/orbits/orbit_file.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/program.hpp"

namespace signorini::verify_test {
namespace {

using Json = nlohmann::ordered_json;
using test::Outcome;

Outcome run(const std::string& arguments) { return test::run_program(arguments); }

/// Kept orbits of one scene, for a test to spoil.
std::filesystem::path kept_orbits(const char* name) {
  const auto folder = test::fresh_folder(name);
  const Outcome update =
      run("verify --update --scenes sdof-two-sided-e08 --starts 8 --subharmonics 1 " + folder.string());
  EXPECT_EQ(update.code, 0) << update.err << update.out;
  return folder;
}

Outcome verify(const std::filesystem::path& folder) {
  return run("verify " + folder.string() + " --scenes sdof-two-sided-e08");
}

TEST(Verify, PassesWhatIsUnchangedAndKeepsNothingOfTheMachine) {
  const auto folder = kept_orbits("verify-same");
  const std::string text = read_file(folder / "sdof-two-sided-e08.json");
  EXPECT_EQ(text.find("tmp"), std::string::npos);
  EXPECT_EQ(text.find("seconds"), std::string::npos);
  const Outcome outcome = verify(folder);
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("1 scenes, 0 differences"), std::string::npos) << outcome.out;
}

// A search of less than before misses orbits that are still there.
TEST(Verify, UpdateForgetsNoOrbitThatIsStillCertified) {
  const auto folder = test::fresh_folder("verify-less");
  const auto file = folder / "sdof-preload-bounce.json";
  std::filesystem::copy_file(references_folder() / "sdof-preload-bounce.json", file);
  const auto names = [&] {
    const Json kept = Json::parse(read_file(file));
    std::vector<std::string> found;
    for (const Json& orbit : kept["orbits"]) found.push_back(orbit["orbit"]);
    return found;
  };
  const std::vector<std::string> before = names();
  ASSERT_EQ(before.size(), 3U);
  const Outcome less =
      run("verify --update --scenes sdof-preload-bounce --starts 0 --subharmonics 1 " + folder.string());
  EXPECT_EQ(less.code, 0) << less.out << less.err;
  EXPECT_NE(less.out.find("certified again from its events"), std::string::npos) << less.out;
  EXPECT_EQ(names(), before);
}

TEST(Verify, FindsTamperedOrbits) {
  const auto folder = kept_orbits("verify-tampered");
  const auto file = folder / "sdof-two-sided-e08.json";
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
  EXPECT_NE(outcome.out.find("sdof-two-sided-e08: no orbits are kept"), std::string::npos) << outcome.out;
  std::ofstream(folder / "sdof-two-sided-e08.json")
      << R"({"schema": 1, "scene": "sdof-two-sided-e08", "scene_sha256": "other", "law": {"restitution": 0.8},
            "search": {"starts": 8, "subharmonics": 2, "seed": 1}, "orbits": []})";
  outcome = verify(folder);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.out.find("sdof-two-sided-e08: the scene file has changed"), std::string::npos);
  std::ofstream(folder / "sdof-two-sided-e08.json") << "{ nonsense";
  outcome = verify(folder);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("sdof-two-sided-e08.json: "), std::string::npos) << outcome.err;
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

}  // namespace
}  // namespace signorini::verify_test
