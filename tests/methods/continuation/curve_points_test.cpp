#include "methods/continuation/curve_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace signorini::curve_points_test {
namespace {

/// Points of the unit circle at these angles.
CurvePoints circle(const std::vector<double>& angles) {
  CurvePoints curve;
  for (const double angle : angles) {
    curve.x.emplace_back(Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    curve.tangents.emplace_back(Eigen::Vector2d(-std::sin(angle), std::cos(angle)));
  }
  return curve;
}

Eigen::VectorXd at(double angle, double radius = 1.0) {
  return radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

TEST(CurvePoints, PassByWhatIsBetweenThem) {
  const CurvePoints curve = circle({0.0, 0.3, 0.6});
  EXPECT_TRUE(curve.pass_by(at(0.45), 0.0));
  EXPECT_FALSE(curve.pass_by(at(0.45, 1.002), 0.0)) << "beyond 4/1000 of a cubic's length";
  EXPECT_TRUE(curve.pass_by(at(0.45, 1.002), 0.003));
  EXPECT_FALSE(curve.pass_by(at(0.7), 0.0)) << "beyond the end";
}

TEST(CurvePoints, OfAnotherKindDoNotCount) {
  CurvePoints curve = circle({0.0, 0.3, 0.6, 0.9});
  curve.labels = {1, 1, 2, 2};
  EXPECT_TRUE(curve.pass_by(at(0.15), 0.0, 1));
  EXPECT_FALSE(curve.pass_by(at(0.15), 0.0, 2));
  EXPECT_TRUE(curve.pass_by(at(0.45), 0.0, 2)) << "one end is of that kind";
}

TEST(CurvePoints, WereAtTheirEndBeforeWhereTheyHaveComeBack) {
  std::vector<double> angles;
  for (double angle = 0.0; angle < 2.0 * std::numbers::pi + 0.1; angle += 0.2) {
    angles.push_back(angle);
    const CurvePoints curve = circle(angles);
    EXPECT_EQ(curve.passed_before(curve.x.back(), 0.0), angle > 2.0 * std::numbers::pi) << angle;
  }
  EXPECT_FALSE(CurvePoints{}.passed_before(at(0.0), 1.0));
}

// Many short steps after a long one end within 4/1000 of its length.
TEST(CurvePoints, WereNotAtTheirEndBeforeForTheirStepsBeingShort) {
  std::vector<double> angles{0.0, 0.3, 0.6};
  for (int i = 1; i <= 30; ++i) angles.push_back(0.6 + 1e-6 * i);
  const CurvePoints curve = circle(angles);
  EXPECT_TRUE(curve.pass_by(curve.x.back(), 0.0));
  EXPECT_FALSE(curve.passed_before(curve.x.back(), 0.0));
}

}  // namespace
}  // namespace signorini::curve_points_test
