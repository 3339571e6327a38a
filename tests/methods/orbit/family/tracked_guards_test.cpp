// The bound of a guard between two points, on functions that are known.

#include "methods/orbit/family/tracked_guards.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace signorini::tracked_guards_test {
namespace {

// a + b z + .. of degree four, as a guard between 0 and 1.
struct Quartic {
  std::array<double, 5> a;
  [[nodiscard]] double value(double z) const {
    return a[0] + z * (a[1] + z * (a[2] + z * (a[3] + z * a[4])));
  }
  [[nodiscard]] double slope(double z) const {
    return a[1] + z * (2.0 * a[2] + z * (3.0 * a[3] + z * 4.0 * a[4]));
  }
  [[nodiscard]] GuardCubic cubic() const {
    return {.value = value(0.0), .last = value(1.0), .slope = slope(0.0), .last_slope = slope(1.0)};
  }
};

TEST(GuardCubic, HasTheLeastValueOfACubicAndItsPlace) {
  // (z - .03)^2 (1 + k z) - 1e-6: narrower than any sample, and not symmetric.
  for (const double k : {0.0, 0.3, -0.3}) {
    const Quartic f{{9e-4 - 1e-6, -0.06 + 9e-4 * k, 1.0 - 0.06 * k, k, 0.0}};
    const GuardCubic::Lowest lowest = f.cubic().lowest();
    EXPECT_LT(f.value(lowest.at), -1e-7) << k;
    EXPECT_LE(lowest.bound, f.value(lowest.at));
    EXPECT_GE(lowest.bound, f.value(lowest.at) - 0.1);
  }
}

TEST(GuardCubic, BoundsDipsWhoseFourthCoefficientIsNoLargerThanTheirThird) {
  constexpr double kSampled = 1e-2;  // of coefficients of size 1, between samples a sixteenth apart
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  int dips = 0;
  for (int k = 0; k < 5000; ++k) {
    Quartic f{{share(random), share(random), share(random), share(random), 0.0}};
    f.a[4] = std::abs(f.a[3]) / 3.0 * share(random);  // of the cubic it leaves a_3 + 2 a_4
    double least = 1e300;
    for (int i = 1; i < 200; ++i) least = std::min(least, f.value(i / 200.0));
    if (least >= std::min(f.value(0.0), f.value(1.0))) continue;
    ++dips;
    EXPECT_LE(f.cubic().lowest().bound, least + kSampled) << k;
  }
  EXPECT_GT(dips, 500);
}

TEST(GuardCubic, DoubtsNeitherAStraightLineNorABeginningWithoutSlope) {
  EXPECT_GT((GuardCubic{.value = 0.0, .last = 1.0, .slope = 1.0, .last_slope = 1.0}).lowest().bound, 0.0);
  EXPECT_GT((GuardCubic{.value = 0.0, .last = 1.0, .slope = 0.0, .last_slope = 2.0}).lowest().bound, 0.0);
}

}  // namespace
}  // namespace signorini::tracked_guards_test
