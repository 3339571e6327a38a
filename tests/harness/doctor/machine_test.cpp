#include "harness/doctor/machine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/harness/fake_method.hpp"

namespace signorini::machine_test {
namespace {

/// A system told by a folder of files.
class Machines : public testing::Test {
 protected:
  void put(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text << "\n";
  }

  [[nodiscard]] MachineProperty find(const std::string& name) const {
    const std::vector<MachineProperty> properties = examine_system(root_);
    const auto found = std::find_if(properties.begin(), properties.end(),
                                    [&](const MachineProperty& one) { return one.name == name; });
    if (found == properties.end()) return {.value = "not looked at"};
    return *found;
  }

  std::filesystem::path root_ = test::fresh_folder("machine");
};

TEST_F(Machines, AreFoundGoodWhereTheyAreQuiet) {
  put("sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "performance");
  put("sys/devices/system/cpu/intel_pstate/no_turbo", "1");
  put("sys/devices/system/cpu/smt/active", "0");
  put("sys/devices/system/clocksource/clocksource0/current_clocksource", "tsc");
  put("proc/cpuinfo", "flags\t\t: fpu vme de pse tsc");
  put("proc/stat", "cpu 1000 0 1000 98000 0 0 0 0 0 0");
  put("proc/loadavg", "0.05 0.10 0.10 1/100 1234");
  for (const MachineProperty& one : examine_system(root_)) {
    EXPECT_TRUE(one.good) << one.name << " = " << one.value;
    EXPECT_TRUE(one.advice.empty()) << one.name;
    EXPECT_NE(one.value, "unknown") << one.name;
  }
}

TEST_F(Machines, AreFoundUnreliableForEachReason) {
  put("sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "powersave");
  put("sys/devices/system/cpu/cpufreq/boost", "1");
  put("sys/devices/system/cpu/smt/active", "1");
  put("sys/devices/system/clocksource/clocksource0/current_clocksource", "hpet");
  put("proc/cpuinfo", "flags\t\t: fpu tsc hypervisor");
  put("proc/stat", "cpu 1000 0 1000 88000 0 0 0 10000 0 0");
  put("proc/loadavg", "1.97 0.10 0.10 1/100 1234");
  for (const MachineProperty& one : examine_system(root_)) {
    EXPECT_FALSE(one.good) << one.name << " = " << one.value;
    EXPECT_FALSE(one.advice.empty()) << one.name;
  }
  EXPECT_EQ(find("stolen time").value, "10.0 %");
  EXPECT_EQ(find("governor").value, "powersave");
  EXPECT_EQ(find("turbo").value, "on");
}

TEST_F(Machines, SayWhatTheSystemDoesNotTell) {
  EXPECT_EQ(find("governor").value, "unknown");
  EXPECT_TRUE(find("governor").good);
}

TEST(ExamineRunning, LooksAtEverythingThatMoves) {
  std::vector<std::string> names;
  for (const MachineProperty& one : examine_running()) {
    names.push_back(one.name);
    EXPECT_FALSE(one.value.empty()) << one.name;
    EXPECT_EQ(one.good, one.advice.empty()) << one.name;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"build", "processors", "clock resolution", "repeatability",
                                             "other processes"}));
}

}  // namespace
}  // namespace signorini::machine_test
