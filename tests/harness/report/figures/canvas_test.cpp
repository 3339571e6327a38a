#include "harness/report/figures/canvas.hpp"

#include <gtest/gtest.h>

namespace signorini::canvas_test {
namespace {

TEST(Canvas, NumbersBlocksOverAllPanels) {
  Canvas canvas;
  EXPECT_TRUE(canvas.empty());
  const auto first = canvas.add("0 1\n", "a method");
  canvas.plot(first, "using 1:2 with lines");
  canvas.draw("2 3\n", "with points");
  EXPECT_EQ(canvas.panel(), "plot data index 0 using 1:2 with lines, \\\n  data index 1 with points\n");
  canvas.plot(first, "with steps");
  canvas.plot("0.5 with lines");
  EXPECT_EQ(canvas.panel(), "plot data index 0 with steps, \\\n  0.5 with lines\n");
  EXPECT_EQ(canvas.data(), "# a method\n0 1\n\n\n2 3\n\n\n");
}

TEST(Canvas, LeavesOutWhatHasNoLines) {
  Canvas canvas;
  EXPECT_EQ(canvas.add("", "a method"), std::nullopt);
  canvas.draw("", "with lines");
  EXPECT_TRUE(canvas.empty());
  EXPECT_EQ(canvas.data(), "");
  EXPECT_NE(canvas.panel().find("plot 2 notitle"), std::string::npos);  // a frame without curves
}

}  // namespace
}  // namespace signorini::canvas_test
