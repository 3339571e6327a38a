#include "harness/schematic/boundary.hpp"

#include <gtest/gtest.h>

namespace signorini::boundary_test {
namespace {

TEST(NumberText, IsAsPeopleWriteIt) {
  EXPECT_EQ(number_text(0.2), "0.2");
  EXPECT_EQ(number_text(-0.3), "−0.3");
  EXPECT_EQ(number_text(1e10), "10¹⁰");
  EXPECT_EQ(number_text(2.5e-7), "2.5·10⁻⁷");
  EXPECT_EQ(number_text(-1e-9), "−10⁻⁹");
  EXPECT_EQ(range_text(0.99999999, 0.99999999, "m"), "0.99999999 m");
  EXPECT_EQ(range_text(0.1, 0.3, "m"), "0.1 … 0.3 m");
}

Problem four_contacts() {
  Problem problem;
  problem.contacts = {{.normal = {{1, 1.0}}, .gap = 0.3},
                      {.normal = {{1, -2.0}}, .gap = 0.1},
                      {.normal = {{1, 1.0}, {0, 0.0}}, .gap = 0.5},
                      {.normal = {{0, -1.0}, {2, 1.0}}, .gap = 0.7},
                      {.normal = {{0, 1.0}, {2, 1.0}}, .gap = 0.9}};
  return problem;
}

TEST(SingleStops, GroupContactsBySideOfTheirCoordinate) {
  const auto stops = single_stops(four_contacts());
  ASSERT_EQ(stops.size(), 2U);
  EXPECT_TRUE(stops[0].forward);
  EXPECT_EQ(stops[0].contacts, 2);
  EXPECT_EQ(gap_text(stops[0]), "2 stops, g = 0.3 … 0.5 m");
  EXPECT_FALSE(stops[1].forward);
  EXPECT_EQ(gap_text(stops[1]), "g = 0.1 m");
}

TEST(PairStops, CloseWithTheCoordinateOfPositiveFactor) {
  const auto pairs = pair_stops(four_contacts());
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].closing, 2);
  EXPECT_EQ(pairs[0].other, 0);
  EXPECT_EQ(other_stops(four_contacts()), 1);  // the last one, closed by both
}

/// One contact of this gap.
Problem with_gap(double gap) {
  Problem problem;
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = gap}};
  return problem;
}

TEST(DrawnGap, TellsOpenFromClosedAndKeepsTheOrder) {
  const Problem problem = with_gap(1.0);
  EXPECT_EQ(drawn_gap(0.0, problem), 0.0);
  EXPECT_EQ(drawn_gap(-0.5, problem), 0.0);
  EXPECT_GT(drawn_gap(1e-9, problem), 0.1);
  EXPECT_GT(drawn_gap(1.0, problem), drawn_gap(0.5, problem) + 0.1);
  EXPECT_EQ(drawn_gap(1e-6, with_gap(1e-6)), drawn_gap(1.0, problem));  // of the scale of the scene
}

TEST(LoadText, HasTheTermsOfOneCoordinate) {
  Problem problem;
  problem.force = {{.dof = 0, .harmonic = 0, .cos = -0.5},
                   {.dof = 0, .harmonic = 3, .sin = 2.0},
                   {.dof = 1, .harmonic = 1, .cos = 1.0},
                   {.dof = 2, .harmonic = 1}};
  EXPECT_EQ(loaded_coordinates(problem), (std::vector{0, 1}));
  EXPECT_EQ(load_text(problem, 0), "−0.5 + 2 sin 3ωt N");
  EXPECT_EQ(load_text(problem, 1), "1 cos ωt N");
  problem.force.push_back({.dof = 1, .harmonic = 1, .sin = -0.25});
  EXPECT_EQ(load_text(problem, 1), "1 cos ωt − 0.25 sin ωt N");
  problem.force.push_back({.dof = 0, .harmonic = 1, .cos = 1.0});
  EXPECT_EQ(load_text(problem, 0), "f(t)");
}

TEST(LoadText, IsTheForceAtTheFrequencyOfTheScene) {
  Problem problem;
  problem.frequency = 2.0;
  problem.force = {{.dof = 0, .cos = 0.5, .omega_power = 2}, {.dof = 0, .cos = 1.0}};
  EXPECT_EQ(load_text(problem, 0), "3 cos ωt N");
}

TEST(MotionNote, TellsFrequencyOrderAndLaw) {
  Problem problem;
  problem.frequency = 2.2;
  problem.subharmonic = 3;
  problem.contacts.resize(2);
  problem.set_law(Restitution{0.8});
  EXPECT_EQ(motion_note(problem), "ω = 2.2 rad/s, order 3, e = 0.8");
  problem.set_law(Penalty{{100.0, 1e5}});
  EXPECT_EQ(motion_note(problem), "ω = 2.2 rad/s, order 3, stop of 100 … 100000 N/m");
  problem.frame = {{.dof = 0, .cos = 0.1}};
  EXPECT_EQ(motion_note(problem), "ω = 2.2 rad/s, order 3, stop of 100 … 100000 N/m, moving stops");
}

TEST(MeshLines, AreAllInnerNodesOfCoarseMeshesAndNeverMoreThanForty) {
  EXPECT_EQ(mesh_lines(4), (std::vector{0.25, 0.5, 0.75}));
  EXPECT_TRUE(mesh_lines(1).empty());
  for (const int elements : {41, 200, 10000, 99999}) {
    const auto lines = mesh_lines(elements);
    EXPECT_LE(lines.size(), 40U) << elements;
    EXPECT_GE(lines.size(), 19U) << elements;
    EXPECT_LT(lines.back(), 1.0);
  }
}

TEST(ElementsText, TellsWhatIsLeftOut) {
  EXPECT_EQ(elements_text(1), "1 element");
  EXPECT_EQ(elements_text(40), "40 elements");
  EXPECT_EQ(elements_text(10000), "10000 elements (a line every 250)");
}

}  // namespace
}  // namespace signorini::boundary_test
