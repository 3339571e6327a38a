#include "harness/plots/drawn_stops.hpp"

#include <gtest/gtest.h>

namespace signorini::drawn_stops_test {
namespace {

Problem between_walls() {
  Problem problem;
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = 0.5},
                      {.normal = {{1, 1.0}}, .gap = 0.25},
                      {.normal = {{0, -1.0}}, .gap = 0.75},
                      {.normal = {{0, -2.0}}, .gap = 0.75}};
  return problem;
}

TEST(DrawnStops, AreThoseOfTheSameDisplacementEitherWay) {
  const std::vector<DrawnStop> stops = stops_of(between_walls(), 0);
  ASSERT_EQ(stops.size(), 2U);
  EXPECT_EQ(stops[0].contact, 0);
  EXPECT_EQ(stops[0].place, 0.5);
  EXPECT_EQ(stops[1].contact, 2);
  EXPECT_EQ(stops[1].place, -0.75);
  EXPECT_EQ(stops_of(between_walls(), 1).size(), 1U);
}

TEST(DrawnStops, StandAsWallsInARangeThatHoldsThem) {
  const std::vector<DrawnStop> stops = stops_of(between_walls(), 0);
  const std::vector<double> inside{-0.25, 0.25}, beyond{-2.0, 2.0};
  const std::string commands = abscissa_commands(inside, stops, 5);
  EXPECT_TRUE(commands.starts_with("set xtics 0.5\n")) << commands;  // over 1.25
  EXPECT_TRUE(abscissa_commands(beyond, stops, 5).starts_with("set xtics 1\n"));
  // As many tics as the range holds, and one fewer: 1.25 / 0.1 and 4 / 0.1.
  EXPECT_TRUE(abscissa_commands(inside, stops, 13).starts_with("set xtics 0.1\n"));
  EXPECT_TRUE(abscissa_commands(inside, stops, 12).starts_with("set xtics 0.2\n"));
  EXPECT_TRUE(abscissa_commands(beyond, stops, 40).starts_with("set xtics 0.1\n"));
  EXPECT_TRUE(abscissa_commands(beyond, stops, 39).starts_with("set xtics 0.2\n"));
  EXPECT_NE(commands.find("set arrow from -0.75, graph 0 to -0.75, graph 1"), std::string::npos) << commands;
  Canvas canvas;
  draw_stops(stops, canvas);
  EXPECT_NE(canvas.panel().find("-0.75 with lines"), std::string::npos);
}

}  // namespace
}  // namespace signorini::drawn_stops_test
