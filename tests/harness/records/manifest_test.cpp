#include "harness/records/manifest.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "harness/build_info.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini {
namespace {

TEST(Manifest, SaysWhatTheRecordsComeFrom) {
  const Limits limits{.timeout = 2.5, .memory_mb = 64, .repetitions = 7};
  const auto manifest = make_manifest({.name = "quick"}, limits, {.seed = 42}, {"signorini", "run"});
  EXPECT_EQ(manifest.at("schema"), 1);
  EXPECT_EQ(manifest.at("suite"), "quick");
  EXPECT_EQ(manifest.at("seed"), 42);
  EXPECT_EQ(manifest.at("command_line"), (std::vector<std::string>{"signorini", "run"}));
  EXPECT_EQ(manifest.at("limits").at("timeout_s"), 2.5);
  EXPECT_EQ(manifest.at("limits").at("memory_mb"), 64);
  EXPECT_EQ(manifest.at("limits").at("repetitions"), 7);
  EXPECT_EQ(manifest.at("build").at("version"), build_info().version);
  EXPECT_EQ(manifest.at("build").at("sources").size(), build_info().sources.size());
  EXPECT_TRUE(manifest.at("build").at("sources").contains("common"));
  EXPECT_GE(manifest.at("machine").at("processors").get<int>(), 1);
  // "2026-11-22T15:00:00Z"
  const auto date = manifest.at("date").get<std::string>();
  EXPECT_EQ(date.size(), 20U);
  EXPECT_EQ(date.back(), 'Z');
}

TEST(Manifest, ComparesNoTimesOfCasesThatRanSideBySide) {
  const auto comparable = [](const Schedule& schedule) {
    return make_manifest({}, {}, schedule, {}).at("times_comparable").get<bool>();
  };
  EXPECT_EQ(comparable({}), build_may_be_timed());
  EXPECT_FALSE(comparable({.parallel = 2}));
  EXPECT_FALSE(comparable({.beside = 2}));
  EXPECT_EQ(make_manifest({}, {}, {.parallel = 3, .beside = 2}, {}).at("jobs"), 6);
}

TEST(ClockGovernor, IsThatOfTheFirstProcessorOrEmpty) {
  const auto root = test::fresh_folder("governor");
  EXPECT_EQ(clock_governor(root), "");
  const auto folder = root / "sys/devices/system/cpu/cpu0/cpufreq";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "scaling_governor") << "powersave\n";
  EXPECT_EQ(clock_governor(root), "powersave");
}

}  // namespace
}  // namespace signorini
