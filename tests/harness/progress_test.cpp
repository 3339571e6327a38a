#include "harness/progress.hpp"

#include <gtest/gtest.h>

namespace signorini {
namespace {

TEST(ProgressLine, EstimatesTheRestFromWhatIsDone) {
  EXPECT_EQ(progress_line(0.0, 4, 0.0, "x"), "[0/4] 0 % x");
  EXPECT_EQ(progress_line(1.0, 4, 30.0, "x"), "[1/4] 25 % ETA 1:30 x");
  EXPECT_EQ(progress_line(0.5, 4, 10.0, "x"), "[0/4] 12 % ETA 1:10 x");
  EXPECT_EQ(progress_line(4.0 - 1e-12, 4, 10.0, "x"), "[4/4] 100 % ETA 0:00 x");
}

}  // namespace
}  // namespace signorini
