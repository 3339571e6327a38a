#include "harness/run_folder/machine_load.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "harness/files.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::machine_load_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

TEST(LoadAverage, IsThatOfTheLastMinuteAndWhatRunsBesideUs) {
  const fs::path root = test::fresh_folder("loadavg");
  EXPECT_FALSE(load_average(root).has_value());
  fs::create_directories(root / "proc");
  std::ofstream(root / "proc/loadavg") << "3.36 2.54 2.12 4/213 4711\n";
  const LoadAverage load = load_average(root).value();
  EXPECT_EQ(load.minute, 3.36);
  EXPECT_EQ(load.running, 3);
}

TEST(LoadShare, IsThatOfOthersOverTheProcessorsLeftToThem) {
  EXPECT_DOUBLE_EQ(load_share(3.0, 1, 1, 3), 1.0);
  EXPECT_DOUBLE_EQ(load_share(3.0, 0, 1, 2), 3.0);
  EXPECT_EQ(load_share(0.5, 1, 1, 2), 0.0);
  EXPECT_LT(load_share(1.1, 1, 1, 1), 1.0) << "a machine of one processor is never quite idle";
  EXPECT_GT(load_share(2.0, 1, 1, 1), 1.0);
}

TEST(TimesFactor, IsTheRatioOfTheCalibrationsWhereBothAreOfOneVersion) {
  const auto with = [](double seconds, int version) {
    return Json{{"calibration", {{"version", version}, {"seconds", seconds}}}};
  };
  EXPECT_DOUBLE_EQ(times_factor(with(2e-3, 1), with(5e-3, 1)).value(), 0.4);
  EXPECT_FALSE(times_factor(with(2e-3, 1), with(5e-3, 2)));
  EXPECT_FALSE(times_factor(with(2e-3, 1), Json::object()));
  EXPECT_FALSE(times_factor(Json::object(), with(2e-3, 1)));
  EXPECT_FALSE(times_factor(with(1e6, 1), with(1e-6, 1)));
}

Json manifest(const Json& machine, int jobs = 1) {
  return {
      {"jobs", jobs}, {"times_comparable", true}, {"build", {{"timings_count", true}}}, {"machine", machine}};
}

// The committed results of one such run: load 3.1 on two processors.
TEST(Times, AreNotComparableOfABusyMachine) {
  const auto why = [](const Json& machine, int jobs = 1) {
    return why_not_comparable(manifest(machine, jobs));
  };
  EXPECT_EQ(why({{"processors", 2}, {"load", {0.9, 3.0, 3.0}}}), "");
  EXPECT_EQ(why({{"processors", 2}, {"load", {3.134, 2.98, 2.58}}}),
            "the load average was 3.1 at the start, on 2 processors with 1 case at a time");
  EXPECT_EQ(why({{"processors", 2}, {"load", {3.134, 2.98, 2.58}}, {"running", 0}}), "")
      << "a build has just ended";
  EXPECT_EQ(why({{"processors", 2}, {"load", {0.1}}, {"load_end", {1.9}}}), "") << "1 of them is ours";
  EXPECT_EQ(why({{"processors", 2}, {"load", {0.1}}, {"load_end", {2.4}}}),
            "the load average was 2.4 at the end, on 2 processors with 1 case at a time");
  EXPECT_EQ(why({{"processors", 8}, {"load", {0.0}}}, 4), "4 cases ran at the same time");
  EXPECT_EQ(why_not_comparable({{"times_comparable", false}}), "its manifest says so");
  EXPECT_EQ(why_not_comparable(Json()), "");
  Json merged = manifest({{"processors", 2}});
  merged["shards"] = {{{"load", {0.1}}}, {{"load", nullptr}}, {{"load", {9.0}}}};
  EXPECT_NE(why_not_comparable(merged), "");
}

TEST(Manifest, KeepsWhyTimesAreNotComparable) {
  Json idle = manifest({{"processors", 2}, {"load", {0.0}}});
  note_times(idle);
  EXPECT_EQ(idle["times_comparable"], true);
  EXPECT_FALSE(idle.contains("times_not_comparable"));
  note_times(idle, "an earlier part of the run was disturbed");
  EXPECT_EQ(idle["times_comparable"], false);
  EXPECT_EQ(why_not_comparable(idle), "an earlier part of the run was disturbed");
}

TEST(Manifest, IsClosedWithTheLoadAtTheEnd) {
  const fs::path folder = test::fresh_folder("closed-manifest");
  std::ofstream(folder / "manifest.json") << manifest({{"processors", 100000}, {"load", {0.0}}}).dump();
  close_manifest(folder);
  const Json closed = Json::parse(read_file(folder / "manifest.json"));
  EXPECT_EQ(closed["machine"]["load_end"].size(), 3U);
  EXPECT_EQ(closed["times_comparable"], true);
  close_manifest(folder, "it began under load");
  EXPECT_EQ(why_not_comparable(Json::parse(read_file(folder / "manifest.json"))), "it began under load");
}

}  // namespace
}  // namespace signorini::machine_load_test
