#include "harness/run_folder/manifest_check.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "harness/failure.hpp"
#include "harness/records/record_check.hpp"
#include "harness/run_folder/run_folder.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::manifest_check_test {
namespace {

using Json = nlohmann::ordered_json;

std::string complaint(const std::string& text) {
  try {
    parse_manifest(text, "m.json");
    return "";
  } catch (const UsageError& error) {
    return error.what();
  }
}

std::string complaint(const Json& manifest) { return complaint(manifest.dump()); }

/// A full manifest with one member changed.
std::string complaint(const char* place, const Json& value) {
  Json manifest = make_manifest({.name = "quick"}, {}, {}, {"signorini", "run"});
  manifest[Json::json_pointer(place)] = value;
  return complaint(manifest);
}

TEST(ManifestCheck, TakesWhatRunAndMergeWrite) {
  EXPECT_EQ(complaint(make_manifest({.name = "quick"}, {}, {}, {"signorini", "run"})), "");
  EXPECT_EQ(complaint("/plugins", {{"my-method", "0123"}}), "");
  EXPECT_EQ(complaint("/shard", "2/3"), "");
  EXPECT_EQ(complaint("/calibration", {{"version", 1}, {"seconds", 2e-3}, {"solves", 25}}), "");
  EXPECT_EQ(complaint("/shards", Json::array({{{"date", "a"}, {"shard", "1/2"}, {"load", nullptr}}})), "");
  EXPECT_EQ(complaint(std::string("{}")), "");
}

// The words that a shell gave may be anything, and the folder of a run is resumed and reported whatever its
// name.
TEST(ManifestCheck, TakesTheManifestOfARunInAnyFolder) {
  const std::string folder = "results/a\nb\x1b[2J\xff" + std::string(9000, 'x');
  const Json manifest = make_manifest({.name = "quick"}, {}, {}, {"signorini", "run", "--out", folder});
  EXPECT_EQ(complaint(manifest), "");
}

TEST(ManifestCheck, RefusesWhatIsNoObject) {
  for (const char* text : {"", "{ nonsense", "[1]", "3", "\"text\"", "{} {}"})
    EXPECT_EQ(complaint(std::string(text)), "m.json: manifest = unreadable (must be one JSON object)")
        << text;
}

TEST(ManifestCheck, RefusesControlCharactersAndEndlessTextsWhereverTheyStand) {
  EXPECT_EQ(complaint("/machine/cpu", "a\x1b[31m"),
            "m.json: text = a\\x1b[31m (must be at most 4000 bytes without control characters)");
  EXPECT_NE(complaint("/command_line/0", "a\nb"), "");
  EXPECT_NE(complaint("/unknown", {{"deep", "\x7f"}}), "");
  EXPECT_NE(complaint("/build/libraries", {{"a\tb", "1"}}), "");
  EXPECT_NE(complaint("/date", std::string(kLongestText + 1, 'x')), "");
}

TEST(ManifestCheck, RefusesWhatNestsWithoutEnd) {
  constexpr int kLevels = 100000;
  EXPECT_EQ(complaint("{\"a\":" + std::string(kLevels, '[') + std::string(kLevels, ']') + "}"),
            "m.json: value = nested (must be at most 32 levels deep)");
}

TEST(ManifestCheck, RefusesMembersOfAnotherTypeOrRange) {
  EXPECT_EQ(complaint("/limits/memory_mb", 1e300),
            "m.json: limits.memory_mb = 1e+300 (must be a whole number, 1..1e9)");
  EXPECT_EQ(complaint("/limits/timeout_s", -1.0), "m.json: limits.timeout_s = -1.0 (must be a number >= 0)");
  EXPECT_EQ(complaint("/jobs", 0), "m.json: jobs = 0 (must be a whole number, 1..1e9)");
  EXPECT_EQ(complaint("/shard", "4/3"), "m.json: shard = \"4/3\" (must be I/N with 1 <= I <= N)");
  EXPECT_EQ(complaint("/suite", "../x"), "m.json: suite = \"../x\" (must be the name of a suite)");
  EXPECT_EQ(complaint("/shards", Json::array({Json::object(), {{"load", "0"}}})),
            "m.json: shards[1].load = \"0\" (must be a list of numbers)");
  EXPECT_EQ(complaint("/schema", 2), "m.json: schema = 2 (must be 1)");
  EXPECT_EQ(complaint("/calibration/seconds", 0.0),
            "m.json: calibration.seconds = 0.0 (must be a number in 1e-6..1e6)");
  EXPECT_EQ(complaint("/runs", Json::array({{{"times_multiplied_by", -1.0}}})),
            "m.json: runs[0].times_multiplied_by = -1.0 (must be a number in 1e-6..1e6)");
  for (const char* place : {"/seed", "/times_comparable", "/limits", "/build", "/machine", "/build/sources",
                            "/machine/processors", "/machine/load", "/command_line", "/order", "/date",
                            "/limits/repetitions", "/plugins", "/shards", "/build/dirty"})
    EXPECT_NE(complaint(place, Json::array({Json::array()})), "") << place;
}

TEST(ManifestCheck, RefusesNamesOfMethodsThatLeadElsewhere) {
  EXPECT_EQ(complaint("/plugins", {{"../x", "1"}}),
            "m.json: plugins = {\"../x\":\"1\"} (must be an object of texts, by names of methods)");
}

TEST(ReadManifest, RefusesAFileOfMoreThan16MiB) {
  const auto folder = test::fresh_folder("large-manifest");
  std::ofstream(folder / "manifest.json") << "{\"a\": \"" + std::string(17U << 20U, 'x') + "\"}";
  EXPECT_THROW(read_manifest(folder / "manifest.json"), UsageError);
  EXPECT_THROW(read_manifest(folder / "none.json"), UsageError);
}

}  // namespace
}  // namespace signorini::manifest_check_test
