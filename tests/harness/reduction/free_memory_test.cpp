#include "harness/reduction/free_memory.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace signorini::free_memory_test {
namespace {

namespace fs = std::filesystem;

/// A folder with files of /proc and /sys, for one test.
class FreeMemory : public testing::Test {
 protected:
  FreeMemory()
      : root_(fs::temp_directory_path() / ("signorini-memory-" + std::to_string(getpid()) + "-" +
                                           testing::UnitTest::GetInstance()->current_test_info()->name())) {}
  ~FreeMemory() override { fs::remove_all(root_); }

  void has(const fs::path& file, const std::string& text) const {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }

  fs::path root_;
};

TEST_F(FreeMemory, IsSomeOfWhatTheMachineHas) {
  const double all =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  EXPECT_GT(free_memory(), 1e6);
  EXPECT_LE(free_memory(), all);
}

TEST_F(FreeMemory, IsWithoutBoundWhereNothingTells) { EXPECT_TRUE(std::isinf(free_memory(root_))); }

TEST_F(FreeMemory, IsWhatTheMachineHasAvailable) {
  has("proc/meminfo", "MemTotal: 4000 kB\nMemFree: 1000 kB\nMemAvailable: 3000 kB\n");
  has("proc/self/cgroup", "0::/user\n");
  has("sys/fs/cgroup/user/memory.max", "max\n");
  has("sys/fs/cgroup/user/memory.current", "500\n");
  EXPECT_EQ(free_memory(root_), 3000.0 * 1024.0);
}

TEST_F(FreeMemory, IsWhatTheTightestGroupLeaves) {
  has("proc/meminfo", "MemAvailable: 3000 kB\n");
  has("proc/self/cgroup", "0::/job/step\n");
  has("sys/fs/cgroup/job/step/memory.max", "90000\n");
  has("sys/fs/cgroup/job/step/memory.current", "10000\n");
  EXPECT_EQ(free_memory(root_), 80000.0);
  has("sys/fs/cgroup/job/memory.max", "70000\n");
  has("sys/fs/cgroup/job/memory.current", "30000\n");
  has("sys/fs/cgroup/job/memory.stat", "anon 20000\ninactive_file 5000\nactive_file 5000\n");
  EXPECT_EQ(free_memory(root_), 45000.0);
  has("sys/fs/cgroup/job/memory.max", "20000\n");
  EXPECT_EQ(free_memory(root_), 0.0);
}

TEST_F(FreeMemory, IsWhatAGroupOfTheFirstVersionLeaves) {
  has("proc/self/cgroup", "5:cpu,cpuacct:/\n4:hugetlb,memory:/job\nnonsense\n0::/\n");
  has("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "50000\n");
  has("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "20000\n");
  has("sys/fs/cgroup/memory/job/memory.stat", "inactive_file 1\ntotal_inactive_file 8000\n");
  EXPECT_EQ(free_memory(root_), 38000.0);
}

TEST_F(FreeMemory, IsThatOfTheGroupAContainerShows) {
  has("proc/self/cgroup", "0::/outside/name\n");
  has("sys/fs/cgroup/memory.max", "1000\n");
  has("sys/fs/cgroup/memory.current", "400\n");
  EXPECT_EQ(free_memory(root_), 600.0);
}

}  // namespace
}  // namespace signorini::free_memory_test
