#include "methods/flow/cvode_session.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace signorini::cvode_session_test {
namespace {

using Vector = Eigen::VectorXd;

CvodeSession oscillator(double tolerance) {
  return {tolerance, Vector::Constant(2, tolerance),
          [](double, const Eigen::Ref<const Vector>& y, Eigen::Ref<Vector> rate) {
            rate[0] = y[1];
            rate[1] = -y[0];
          }};
}

// CVODE bounds the error of a step; over some periods up to a thousand such errors add up.
constexpr double kTolerance = 1e-11, kGlobal = 1e3 * kTolerance;

TEST(CvodeSession, FollowsAnOscillatorAndInterpolatesItsStepsToTolerance) {
  CvodeSession session = oscillator(kTolerance);
  session.start(0.0, Eigen::Vector2d(1.0, 0.0), 10.0, 1.0);
  Vector y;
  double worst = 0.0, begin = 0.0, end = 0.0;
  for (; end < 10.0; begin = end) {
    end = session.step();
    for (int i = 0; i <= 4; ++i) {
      const double time = begin + (end - begin) * i / 4;
      session.interpolate(time, y);
      worst = std::max(worst, std::abs(y[0] - std::cos(time)));
    }
  }
  EXPECT_DOUBLE_EQ(end, 10.0);
  EXPECT_LT(worst, kGlobal);
  EXPECT_GT(session.rhs_evaluations(), 10);
}

TEST(CvodeSession, RestartsFromAnyState) {
  CvodeSession session = oscillator(kTolerance);
  Vector y;
  for (int round = 0; round < 3; ++round) {
    session.start(2.0, Eigen::Vector2d(0.0, 1.0), 3.0, 1.0);
    while (session.step() < 3.0) continue;
    session.interpolate(3.0, y);
    EXPECT_NEAR(y[0], std::sin(1.0), kGlobal);
  }
}

// y' = -r (y - cos t) - sin t, y(0) = 1: y = cos t, whatever r. Explicit steps are bounded by 1 / r.
CvodeSession relaxation(double rate, Multistep multistep) {
  return {1e-9, Vector::Constant(1, 1e-9),
          [rate](double t, const Eigen::Ref<const Vector>& y, Eigen::Ref<Vector> slope) {
            slope[0] = -rate * (y[0] - std::cos(t)) - std::sin(t);
          },
          multistep};
}

TEST(CvodeSession, NeedsNoShortStepsOfBackwardDifferentiationWhereAFastMotionIsGone) {
  long adams = 0, bdf = 0;
  for (const auto& [multistep, evaluations] : {std::pair{Multistep::adams, &adams}, {Multistep::bdf, &bdf}}) {
    CvodeSession session = relaxation(1e5, multistep);
    session.start(0.0, Vector::Ones(1), 3.0, 1.0);
    while (session.step() < 3.0) continue;
    Vector y;
    session.interpolate(3.0, y);
    EXPECT_NEAR(y[0], std::cos(3.0), 1e-7);
    *evaluations = session.rhs_evaluations();
  }
  EXPECT_GT(adams, 100000);
  EXPECT_LT(bdf, 2000);
}

TEST(CvodeSession, CarriesAnExceptionOfTheRightHandSideThroughC) {
  CvodeSession session(1e-8, Vector::Constant(1, 1e-8),
                       [](double, const auto&, auto) { throw std::domain_error("rhs"); });
  session.start(0.0, Vector::Ones(1), 1.0, 1.0);
  EXPECT_THROW(session.step(), std::domain_error);
}

TEST(CvodeSession, ReportsAFailureWithTheCallAndItsMessage) {
  CvodeSession session(1e-8, Vector::Constant(1, 1e-8), [](double, const auto&, Eigen::Ref<Vector> rate) {
    rate[0] = std::numeric_limits<double>::quiet_NaN();
  });
  session.start(0.0, Vector::Ones(1), 1.0, 1.0);
  try {
    for (int i = 0; i < 100; ++i) session.step();
    FAIL() << "no failure";
  } catch (const IntegrationError& error) {
    EXPECT_NE(std::string(error.what()).find("CVode failed"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace signorini::cvode_session_test
