#include "methods/solvers/lcp/lcp.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace signorini::lcp_test {
namespace {

TEST(NaturalResidual, IsTheLargestOfTheSmallerPartnersRelativeToLoadAndAnswer) {
  const Eigen::MatrixXd a = (Eigen::Matrix2d() << 2.0, 1.0, 0.0, 4.0).finished();
  const Lcp lcp = dense_lcp(a, Eigen::Vector2d(-3.0, 1.0));
  // z = (1, 0.5): w = (-0.5, 3); min(z, w) = (-0.5, 0.5); scale 3.
  EXPECT_NEAR(natural_residual(lcp, Eigen::Vector2d(1.0, 0.5)), 0.5 / 3.0, 1e-15);
  // z = (8, 0): w = (13, 1); min = (8, 0); scale 8.
  EXPECT_NEAR(natural_residual(lcp, Eigen::Vector2d(8.0, 0.0)), 1.0, 1e-15);
  // The solution.
  EXPECT_NEAR(natural_residual(lcp, Eigen::Vector2d(1.5, 0.0)), 0.0, 1e-16);
}

TEST(NaturalResidual, DoesNotDependOnTheUnits) {
  const Eigen::MatrixXd a = Eigen::MatrixXd::Identity(3, 3);
  const Eigen::Vector3d q(-1.0, 2.0, -3.0), z(0.5, 0.1, 3.5);
  const double residual = natural_residual(dense_lcp(a, q), z);
  EXPECT_NEAR(natural_residual(dense_lcp(a, 1e-9 * q), 1e-9 * z), residual, 1e-12 * residual);
}

TEST(NaturalResidual, IsInfiniteWhereANumberIsNotFinite) {
  const Lcp lcp = dense_lcp(Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(-1.0, 1.0));
  EXPECT_TRUE(std::isinf(natural_residual(lcp, Eigen::Vector2d(std::nan(""), 0.0))));
  EXPECT_TRUE(
      std::isinf(natural_residual(lcp, Eigen::Vector2d(std::numeric_limits<double>::infinity(), 0.0))));
}

TEST(NaturalResidual, OfNoLoadAndNoAnswerIsZero) {
  const Lcp lcp = dense_lcp(Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d::Zero());
  EXPECT_EQ(natural_residual(lcp, Eigen::Vector2d::Zero()), 0.0);
}

TEST(Describe, TellsTheEndsOfASolveApart) {
  std::set<std::string> sentences;
  for (const LcpStatus status : {LcpStatus::solved, LcpStatus::ray, LcpStatus::stalled, LcpStatus::limit,
                                 LcpStatus::breakdown, LcpStatus::interrupted}) {
    sentences.insert(describe(status));
  }
  EXPECT_EQ(sentences.size(), 6U);
  EXPECT_EQ(sentences.count(""), 0U);
}

}  // namespace
}  // namespace signorini::lcp_test
