#include "methods/solvers/lcp/active_set_lcp.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <random>

#include "problems/linear_algebra/lu.hpp"

namespace signorini::active_set_lcp_test {
namespace {

/// z by trying all sets; G positive definite, so that exactly one is right.
Eigen::VectorXd enumerated(const Eigen::MatrixXd& G, const Eigen::VectorXd& q) {
  const auto m = static_cast<int>(q.size());
  for (int mask = 0; mask < 1 << m; ++mask) {
    std::vector<int> set;
    for (int i = 0; i < m; ++i) {
      if ((mask >> i & 1) != 0) set.push_back(i);
    }
    Eigen::VectorXd z = Eigen::VectorXd::Zero(m);
    if (!set.empty()) {
      const Eigen::MatrixXd block = G(set, set);
      const Eigen::VectorXd part = lu_solve(block, Eigen::VectorXd(-q(set)));
      for (std::size_t k = 0; k < set.size(); ++k) z[set[k]] = part[static_cast<Eigen::Index>(k)];
    }
    Eigen::VectorXd w = q + G * z;
    for (const int i : set) w[i] = 0.0;
    if (z.minCoeff() >= 0.0 && w.minCoeff() >= 0.0) return z;
  }
  return {};
}

class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : random_(seed) {}
  /// In [-1, 1).
  double operator()() { return 2.0 * static_cast<double>(random_()) / 4294967296.0 - 1.0; }
  Eigen::MatrixXd matrix(int rows, int columns) {
    Eigen::MatrixXd A(rows, columns);
    for (double& value : A.reshaped()) value = (*this)();
    return A;
  }

 private:
  std::mt19937 random_;
};

// Gram matrices of few random columns are badly conditioned: sets change many times, and some cycle.
TEST(ActiveSetLcp, MatchesExhaustiveEnumeration) {
  RandomNumbers random(1);
  long fallbacks = 0;
  for (int problem = 0; problem < 300; ++problem) {
    const int m = 3 + problem % 5;
    const Eigen::MatrixXd root = random.matrix(m, m);
    const Eigen::MatrixXd G = root * root.transpose() + 1e-6 * Eigen::MatrixXd::Identity(m, m);
    ActiveSetLcp lcp(G);
    for (int step = 0; step < 4; ++step) {
      const Eigen::VectorXd q = random.matrix(m, 1);
      const Eigen::VectorXd exact = enumerated(G, q);
      ASSERT_EQ(exact.size(), m);
      ASSERT_TRUE(lcp.solve(q)) << "problem " << problem;
      EXPECT_LE((lcp.z() - exact).norm(), 1e-6 * (1.0 + exact.norm())) << "problem " << problem;
      EXPECT_LE((lcp.w() - q - G * lcp.z()).norm(), 1e-9 * (1.0 + exact.norm()));
      EXPECT_GE(lcp.z().minCoeff(), 0.0);
      EXPECT_GE(lcp.w().minCoeff(), -1e-9 * (1.0 + exact.norm()));
      EXPECT_EQ(lcp.z().dot(lcp.w()), 0.0);
    }
    fallbacks += lcp.fallbacks();
  }
  EXPECT_GT(fallbacks, 0);  // else the other way out is not tested
  EXPECT_LT(fallbacks, 60);
}

// Along a path on which the set changes three times, four inverses are made, and one set is tried per step.
TEST(ActiveSetLcp, RemembersSetsAndTheirInverses) {
  Eigen::MatrixXd G(3, 3);
  G << 2.0, 0.5, 0.1, 0.5, 2.0, 0.5, 0.1, 0.5, 2.0;
  ActiveSetLcp lcp(G);
  constexpr int kSteps = 400;
  for (int round = 0; round < 2; ++round) {
    for (int step = 0; step < kSteps; ++step) {
      const double t = 2.0 * step / kSteps - 1.0;
      ASSERT_TRUE(lcp.solve(Eigen::Vector3d(0.8 + t, 0.3 + t, -0.2 + t)));
    }
    EXPECT_EQ(lcp.factorisations(), 3);  // {0 1 2}, {1 2}, {2}
  }
  EXPECT_EQ(lcp.fallbacks(), 0);
  EXPECT_TRUE(lcp.set().empty());
  EXPECT_LE(lcp.changes(), 2 * kSteps + 10);
  lcp.restart();
  ASSERT_TRUE(lcp.solve(Eigen::Vector3d(-1.0, 1.0, 1.0)));
  EXPECT_EQ(lcp.set(), (std::vector<int>{0}));
}

TEST(ActiveSetLcp, SolvesOnAGivenSet) {
  RandomNumbers random(2);
  const Eigen::MatrixXd root = random.matrix(4, 4);
  const Eigen::MatrixXd G = root * root.transpose() + Eigen::MatrixXd::Identity(4, 4);
  ActiveSetLcp lcp(G);
  const std::vector<int> set{0, 3};
  const Eigen::VectorXd q = random.matrix(2, 1);
  const Eigen::MatrixXd block = G(set, set);
  EXPECT_LE((block * lcp.on_set(set, q) + q).norm(), 1e-13);
}

// Two contacts at one place: their forces are not determined, but half each is the least; w is.
TEST(ActiveSetLcp, SharesWhatIsNotDetermined) {
  Eigen::MatrixXd G(3, 3);
  G << 1.0, 1.0, 0.2, 1.0, 1.0, 0.2, 0.2, 0.2, 1.0;
  ActiveSetLcp lcp(G);
  ASSERT_TRUE(lcp.solve(Eigen::Vector3d(-1.0, -1.0, 1.0)));
  EXPECT_NEAR(lcp.z()[0], 0.5, 1e-12);
  EXPECT_NEAR(lcp.z()[1], 0.5, 1e-12);
  EXPECT_NEAR(lcp.w()[2], 1.2, 1e-12);
}

TEST(ActiveSetLcp, RefusesWhatIsNoNumber) {
  ActiveSetLcp lcp(Eigen::MatrixXd::Identity(2, 2));
  EXPECT_FALSE(lcp.solve(Eigen::Vector2d(std::numeric_limits<double>::quiet_NaN(), 1.0)));
  EXPECT_TRUE(lcp.solve(Eigen::Vector2d(-1.0, 1.0)));
}

}  // namespace
}  // namespace signorini::active_set_lcp_test
