#include "problems/admissible_set.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "problems/assembly/rotor.hpp"

namespace signorini::admissible_set_test {
namespace {

/// The contact and what is required of it; empty where stops leave room.
std::string complaint(const std::vector<Contact>& stops) {
  const auto conflict = stop_conflict(stops);
  return conflict ? std::to_string(conflict->contact) + ": " + conflict->requirement : "";
}

bool leaves_room(const std::vector<Contact>& stops) { return complaint(stops).empty(); }

/// x <= gap along a direction of the plane of coordinates 3 and 8.
Contact stop_at(double angle, double gap, double scale = 1.0) {
  return {.normal = {{8, scale * std::sin(angle)}, {3, scale * std::cos(angle)}}, .gap = scale * gap};
}

/// A triangle of stops at `gap` from the origin.
std::vector<Contact> triangle(double gap) {
  const double third = 2.0 * std::numbers::pi / 3.0;
  return {stop_at(0.1, gap), stop_at(0.1 + third, gap), stop_at(0.1 - third, gap)};
}

TEST(RoomBetweenStops, EndsWhereATriangleOfThemCrossesOrMeets) {
  EXPECT_EQ(complaint(triangle(-0.1)), "2: must leave room: contacts 0, 1 and 2 exclude each other");
  EXPECT_TRUE(leaves_room(triangle(0.1)));
  EXPECT_TRUE(leaves_room(triangle(1e-9)));
  EXPECT_FALSE(leaves_room(triangle(0.0))) << "nothing can move between stops that meet";
  std::vector<Contact> far = triangle(-0.1);
  far[0].gap = 0.21;  // the heights of such a triangle: one stop far enough outside makes room
  EXPECT_TRUE(leaves_room(far));
  far[0].gap = 0.19;
  EXPECT_FALSE(leaves_room(far));
}

TEST(RoomBetweenStops, IsNamedByTheStopsThatExcludeEachOtherAlone) {
  std::vector<Contact> stops = {{.normal = {{0, 1.0}}, .gap = -1.0}, {.normal = {{1, -2.0}}, .gap = 3.0}};
  for (const Contact& stop : triangle(-0.1)) stops.push_back(stop);
  stops.insert(stops.begin() + 3, stop_at(1.0, 5.0));
  EXPECT_EQ(complaint(stops), "5: must leave room: contacts 2, 4 and 5 exclude each other");
}

/// Masses in a circle, each held against the next: their gaps must add up to room.
std::vector<Contact> circle(int size, double gap) {
  std::vector<Contact> stops;
  for (int i = 0; i < size; ++i)
    stops.push_back({.normal = {{i, 1.0}, {(i + 1) % size, -1.0}}, .gap = i == 0 ? gap : 0.25});
  return stops;
}

TEST(RoomBetweenStops, IsTheSumOfTheGapsAroundACircle) {
  for (const int size : {3, 5, 9, 40, 150}) {
    const double rest = 0.25 * (size - 1);
    EXPECT_TRUE(leaves_room(circle(size, -rest + 1e-3))) << size;
    EXPECT_FALSE(leaves_room(circle(size, -rest))) << size;
    EXPECT_FALSE(leaves_room(circle(size, -rest - 1e-3))) << size;
  }
  EXPECT_NE(complaint(circle(40, -100.0)).find("contacts 0, 1, 2, 3, 4, 5, 6, 7 and 32 more exclude"),
            std::string::npos);
}

/// By Helly's theorem half planes have no common interior exactly where three of them, or two, have none;
/// three where a positive combination of their normals vanishes and the same one of their gaps is not
/// positive.
bool half_planes_meet(const std::vector<Contact>& stops) {
  const auto w = [&](std::size_t j, std::size_t i) { return stops[j].normal[i].second; };
  const auto cross = [&](std::size_t a, std::size_t b) { return w(a, 0) * w(b, 1) - w(a, 1) * w(b, 0); };
  for (std::size_t a = 0; a < stops.size(); ++a) {
    for (std::size_t b = a + 1; b < stops.size(); ++b) {
      for (std::size_t c = b + 1; c < stops.size(); ++c) {
        const std::array y{cross(b, c), cross(c, a), cross(a, b)};
        const double sign = y[0] > 0.0 ? 1.0 : -1.0;
        if (sign * y[1] < 0.0 || sign * y[2] < 0.0) continue;
        if (sign * (y[0] * stops[a].gap + y[1] * stops[b].gap + y[2] * stops[c].gap) <= 0.0) return false;
      }
    }
  }
  return true;
}

TEST(RoomBetweenStops, IsThatOfHalfPlanesWhereverTheOriginAndWhateverTheUnits) {
  std::mt19937 random(20261123);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int crossed = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<Contact> stops;
    for (int j = 0; j < 3 + trial % 6; ++j)
      stops.push_back(
          stop_at(std::numbers::pi * unit(random), unit(random) + 0.3, std::exp(5.0 * unit(random))));
    const bool meet = half_planes_meet(stops);
    crossed += meet ? 0 : 1;
    EXPECT_EQ(leaves_room(stops), meet) << trial;
    const double step = 100.0 * unit(random);
    for (Contact& stop : stops) stop.gap += stop.normal[0].second * step - stop.normal[1].second * step;
    EXPECT_EQ(leaves_room(stops), meet) << trial << ", moved by " << step;
    for (Contact& stop : stops) {
      stop.normal[0].second *= 1e-7;  // another unit of coordinate 8
      stop.gap *= 1e5;
      stop.normal[0].second *= 1e5;
      stop.normal[1].second *= 1e5;
    }
    EXPECT_EQ(leaves_room(stops), meet) << trial << ", in other units";
  }
  EXPECT_GT(crossed, 50);
  EXPECT_LT(crossed, 350);
}

// Preloads alone exclude nothing where every stop can be retreated from.
TEST(RoomBetweenStops, IsLeftByThousandsOfPreloadedStopsThatCanBeRetreatedFrom) {
  std::vector<Contact> row;
  for (int i = 0; i + 1 < 20000; ++i) row.push_back({.normal = {{i, 1.0}, {i + 1, -1.0}}, .gap = -0.1});
  EXPECT_TRUE(leaves_room(row));
  std::vector<Contact> star;
  for (int i = 1; i < 20000; ++i) star.push_back({.normal = {{0, -1.0}, {i, 1.0}}, .gap = -0.1});
  EXPECT_TRUE(leaves_room(star));
  std::vector<Contact> both_sides;
  for (int i = 0; i < 10000; ++i) {
    both_sides.push_back({.normal = {{i, 1.0}}, .gap = 0.2});
    both_sides.push_back({.normal = {{i, -1.0}}, .gap = -0.1});
  }
  EXPECT_TRUE(leaves_room(both_sides));
}

TEST(RoomBetweenStops, IsThatOfARingOfThousandsOfFacets) {
  for (const int facets : {3, 7, 999}) {
    EXPECT_TRUE(leaves_room(ring_of_contacts(0, 1, facets, 0.01))) << facets;
    EXPECT_FALSE(leaves_room(ring_of_contacts(0, 1, facets, 0.0))) << facets;
    EXPECT_FALSE(leaves_room(ring_of_contacts(0, 1, facets, -0.01))) << facets;
    // About another centre: the same ring.
    std::vector<Contact> moved = ring_of_contacts(4, 2, facets, 0.01);
    for (Contact& facet : moved) facet.gap += 50.0 * facet.normal[0].second;
    EXPECT_TRUE(leaves_room(moved)) << facets;
    for (Contact& facet : moved) facet.gap -= 0.02;
    EXPECT_FALSE(leaves_room(moved)) << facets;
  }
}

/// The contact that is refused beside others of its place, -1 where none is.
int rival(const std::vector<Contact>& stops) {
  const auto conflict = restitution_conflict(stops);
  return conflict ? conflict->contact : -1;
}

/// x <= gap along `coefficient` times coordinate 2.
Contact rigid(double coefficient, double gap, double e) {
  return {.normal = {{2, coefficient}, {5, 0.0}}, .gap = gap, .law = Restitution{e}};
}

TEST(RestitutionsOfOnePlace, AreOneWhateverTheLengthOfTheNormals) {
  EXPECT_EQ(rival({rigid(1.0, 0.2, 0.5), rigid(1.0, 0.2, 0.8)}), 1);
  EXPECT_EQ(rival({rigid(1.0, 0.3, 0.5), rigid(3.0, 0.9, 0.8)}), 1) << "0.9 / 3 is not 0.3 to the last digit";
  EXPECT_EQ(rival({rigid(-2.0, -0.4, 0.5), rigid(-1.0, -0.2, 0.8)}), 1) << "a preload";
  EXPECT_EQ(rival({rigid(1.0, 0.0, 0.5), rigid(2.0, 0.0, 0.5), rigid(1.0, 0.0, 0.0)}), 2);
  EXPECT_EQ(rival({rigid(1.0, 0.2, 0.5), rigid(2.0, 0.4, 0.5)}), -1) << "equal ones are one stop";
  EXPECT_EQ(rival({rigid(1.0, 0.2, 0.5), rigid(-1.0, 0.2, 0.8)}), -1) << "on either side";
  EXPECT_EQ(rival({rigid(1.0, 0.2, 0.5), rigid(1.0, 0.2 + 1e-9, 0.8)}), -1) << "one behind the other";
}

TEST(RestitutionsOfOnePlace, DoNotMatterBehindANearerStop) {
  EXPECT_EQ(rival({rigid(1.0, 0.2, 0.5), rigid(1.0, 0.2, 0.8), rigid(1.0, 0.1, 1.0)}), -1);
  EXPECT_EQ(rival({rigid(1.0, 0.1, 1.0), rigid(1.0, 0.2, 0.5), rigid(1.0, 0.2, 0.8)}), -1);
  EXPECT_EQ(rival({rigid(1.0, 0.2, 0.5), rigid(1.0, 0.1, 1.0), rigid(1.0, 0.1, 0.8)}), 2);
}

TEST(RestitutionsOfOnePlace, AreAskedOfRigidStopsAlone) {
  const Contact spring{.normal = {{2, 1.0}}, .gap = 0.2, .law = Spring{5.0}};
  EXPECT_EQ(rival({rigid(1.0, 0.2, 0.5), spring, rigid(1.0, 0.3, 0.8)}), -1);
  EXPECT_EQ(rival({spring, rigid(1.0, 0.2, 0.5), rigid(2.0, 0.4, 0.8)}), 2);
}

}  // namespace
}  // namespace signorini::admissible_set_test
