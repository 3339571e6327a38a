#include "methods/flow/impact.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace signorini {
namespace {

// Rows that differ by rounding alone share the force, whatever the solution of a nearly singular system is.
TEST(NewtonImpulses, OfTheSameStopTwiceGiveTheVelocityOfTheStopOnce) {
  for (const double apart : {0.0, 1e-16, 1e-13, 1e-10}) {
    Eigen::Matrix2d G = Eigen::Matrix2d::Constant(0.5);
    G(0, 1) = G(1, 0) = 0.5 * (1.0 - apart);
    const auto p = newton_impulses(
        {.delassus = G, .approach = Eigen::Vector2d(2.0, 2.0), .restitution = Eigen::Vector2d(0.5, 0.5)});
    ASSERT_TRUE(p) << apart;
    EXPECT_LE(p->maxCoeff(), 0.0);
    const Eigen::Vector2d after = Eigen::Vector2d(2.0, 2.0) + G * *p;
    EXPECT_NEAR(after[0], -1.0, 1e-9);
    EXPECT_NEAR(after[1], -1.0, 1e-9);
    EXPECT_NEAR(p->sum(), -6.0, 1e-8);
  }
}

TEST(NewtonImpulses, ReproduceTheSingleContact) {
  const auto p = newton_impulses({.delassus = Eigen::MatrixXd::Constant(1, 1, 0.5),
                                  .approach = Eigen::VectorXd::Constant(1, 3.0),
                                  .restitution = Eigen::VectorXd::Constant(1, 0.8)});
  ASSERT_TRUE(p);
  EXPECT_NEAR((*p)[0], -1.8 * 3.0 / 0.5, 1e-14 * 10.8);
}

TEST(NewtonImpulses, PassAnImpulseOnToARestingContactThatItPushes) {
  // Off-diagonal < 0: an impulse at contact 0 drives contact 1 into its stop.
  const Eigen::MatrixXd G = (Eigen::Matrix2d() << 2.0, -1.0, -1.0, 2.0).finished();
  const auto p = newton_impulses(
      {.delassus = G, .approach = Eigen::Vector2d(1.0, 0.0), .restitution = Eigen::Vector2d(0.5, 0.5)});
  ASSERT_TRUE(p);
  const Eigen::Vector2d after = Eigen::Vector2d(1.0, 0.0) + G * *p;
  EXPECT_NEAR(after[0], -0.5, 1e-14);
  EXPECT_NEAR(after[1], 0.0, 1e-14);
  EXPECT_LT((*p)[1], 0.0);
}

TEST(NewtonImpulses, LeaveARestingContactAloneThatTheImpactLiftsOff) {
  const Eigen::MatrixXd G = (Eigen::Matrix2d() << 2.0, 1.0, 1.0, 2.0).finished();
  const auto p = newton_impulses(
      {.delassus = G, .approach = Eigen::Vector2d(1.0, 0.0), .restitution = Eigen::Vector2d(0.5, 0.5)});
  ASSERT_TRUE(p);
  EXPECT_DOUBLE_EQ((*p)[1], 0.0);
  EXPECT_LT(G(1, 0) * (*p)[0], 0.0);
}

TEST(NewtonImpulses, NeverGainEnergyAndNeverPull) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Index size = 2 + trial % 4;
    const Eigen::MatrixXd B = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return normal(random); });
    const Eigen::MatrixXd G = B * B.transpose() + 0.2 * Eigen::MatrixXd::Identity(size, size);
    const Eigen::VectorXd v = Eigen::VectorXd::NullaryExpr(size, [&] { return std::abs(normal(random)); });
    const Eigen::VectorXd e = Eigen::VectorXd::Constant(size, unit(random));
    const auto p = newton_impulses({.delassus = G, .approach = v, .restitution = e});
    ASSERT_TRUE(p);
    EXPECT_LE(p->maxCoeff(), 0.0);
    const Eigen::VectorXd after = v + G * *p;
    // Work of the impulses: p . (v_- + v_+) / 2.
    EXPECT_LE(p->dot(v + after), 1e-12 * v.squaredNorm() / G.diagonal().minCoeff());
    EXPECT_LE((after + e.cwiseProduct(v)).maxCoeff(), 1e-10 * v.maxCoeff());
  }
}

}  // namespace
}  // namespace signorini
