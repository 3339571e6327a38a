#include "harness/reduction/free_memory.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

namespace signorini::free_memory_test {
namespace {

TEST(FreeMemory, IsSomeOfWhatTheMachineHas) {
  const double all =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  EXPECT_GT(free_memory(), 1e6);
  EXPECT_LE(free_memory(), all);
}

}  // namespace
}  // namespace signorini::free_memory_test
