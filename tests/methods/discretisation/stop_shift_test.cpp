#include "methods/discretisation/stop_shift.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini {
namespace {

TEST(StopShift, CountsTimeFromItsMiddleTheShortWayRound) {
  const StopShift shift{.time = 0.9, .distance = 1.0, .speed = 10.0};
  EXPECT_NEAR(shift.since(0.95), 0.05, 1e-15);
  EXPECT_NEAR(shift.since(0.1), 0.2, 1e-15);  // across the end of the period
  EXPECT_NEAR(shift.since(0.5), -0.4, 1e-15);
  EXPECT_NEAR(shift.at(0.1), 3.0, 1e-14);
  for (int k = 0; k < 200; ++k) {
    EXPECT_LE(std::abs(shift.since(0.01 * k)), 0.5);
    if (k % 100 == 40) continue;  // half a period away, where both signs are right
    EXPECT_NEAR(shift.since(0.01 * k), shift.since(0.01 * k + 3.0), 1e-13);
  }
}

TEST(ShiftAt, IsThatOfTheContactWhoseIntervalIsNearest) {
  // The second contact lasts, from 0.4 to 0.8.
  const std::vector<StopShift> shifts{{.time = 0.1, .width = 0.0, .distance = 1.0},
                                      {.time = 0.6, .width = 0.4, .distance = 2.0}};
  EXPECT_EQ(shift_at(shifts, 0.12).distance, 1.0);
  EXPECT_EQ(shift_at(shifts, 0.45).distance, 2.0);
  EXPECT_EQ(shift_at(shifts, 0.24).distance, 1.0);  // 0.14 from the first, 0.16 from the second
  EXPECT_EQ(shift_at(shifts, 0.26).distance, 2.0);
  EXPECT_EQ(shift_at(shifts, 0.97).distance,
            1.0);  // 0.13 from the first, across the end; 0.17 from the second
}

TEST(ShiftAt, IsNoneWhereThereAreNoShifts) { EXPECT_EQ(shift_at({}, 0.3).at(0.3), 0.0); }

}  // namespace
}  // namespace signorini
