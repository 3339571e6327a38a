#include "methods/solvers/rank_one.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "methods/solvers/extended/symmetric_eigenpairs.hpp"

namespace signorini::rank_one_test {
namespace {

// Poles from 1 to 1e9, as the squares of a beam's frequencies, and a vector of both signs.
struct Graded {
  std::vector<long double> poles;
  Eigen::VectorXd z;
};

Graded graded(int n) {
  Graded made{.poles = {}, .z = Eigen::VectorXd(n)};
  for (int i = 0; i < n; ++i) {
    made.poles.push_back(std::pow(10.0L, 9.0L * i / (n - 1)));
    made.z[i] = std::cos(1.0 + 2.3 * i);
  }
  return made;
}

ExtendedMatrix sum_of(const Graded& of, double strength) {
  const Eigen::Index n = of.z.size();
  ExtendedMatrix A(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < n; ++i)
      A(i, j) = static_cast<long double>(strength) * of.z[i] * of.z[j] +
                (i == j ? of.poles[static_cast<std::size_t>(i)] : 0.0L);
  return A;
}

// Extended precision knows the least values to 1e-19 of the largest, 1e-10 of them.
TEST(RankOne, PairsAreThoseOfTheDenseMatrix) {
  for (const double strength : {1e-6, 1.0, 1e5}) {
    const Graded of = graded(24);
    const auto pairs = add_rank_one(of.poles, of.z, strength);
    const auto dense = extended::symmetric_eigenpairs(sum_of(of, strength));
    ASSERT_TRUE(pairs && dense);
    const Eigen::MatrixXd& V = pairs->vectors;
    EXPECT_LT((V.transpose() * V - Eigen::MatrixXd::Identity(24, 24)).norm(), 1e-14);
    for (std::size_t k = 0; k < 24; ++k) {
      EXPECT_NEAR(static_cast<double>(pairs->values[k] / dense->values[k]), 1.0, 1e-9);
      double along = 0.0;
      for (Eigen::Index i = 0; i < 24; ++i)
        along += V(i, static_cast<Eigen::Index>(k)) *
                 static_cast<double>(dense->vectors(i, static_cast<Eigen::Index>(k)));
      EXPECT_NEAR(std::abs(along), 1.0, 1e-9);
    }
  }
}

// The sum and the product of the values are those of the poles plus strength z^2, and times
// 1 + strength sum z_i^2 / p_i, to every digit though the values spread over nine decades.
TEST(RankOne, ValuesHaveAllDigitsHoweverFarTheySpread) {
  const Graded of = graded(40);
  const double strength = 3.0;
  const auto pairs = add_rank_one(of.poles, of.z, strength);
  ASSERT_TRUE(pairs);
  long double product = 1.0L, added = 1.0L;
  for (std::size_t k = 0; k < of.poles.size(); ++k) {
    const long double z = of.z[static_cast<Eigen::Index>(k)];
    product *= pairs->values[k] / of.poles[k];
    added += strength * z * z / of.poles[k];
  }
  EXPECT_NEAR(static_cast<double>(product / added), 1.0, 3e-16);
}

TEST(RankOne, LeavesPolesThatAreNotPushed) {
  const std::vector<long double> poles{1.0L, 4.0L, 4.0L, 9.0L};
  const auto pairs = add_rank_one(poles, Eigen::Vector4d(1.0, 0.0, 0.0, 1e-20), 10.0);
  ASSERT_TRUE(pairs);
  const std::vector<double> expected{4.0, 4.0, 9.0, 11.0};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_DOUBLE_EQ(static_cast<double>(pairs->values[k]), expected[k]);
  EXPECT_EQ(pairs->vectors.col(3).cwiseAbs(), Eigen::Vector4d(1.0, 0.0, 0.0, 0.0));
}

TEST(RankOne, IsNotFoundWherePolesCoincide) {
  EXPECT_FALSE(add_rank_one({1.0L, 4.0L, 4.0L}, Eigen::Vector3d(1.0, 1.0, 1.0), 1.0));
}

}  // namespace
}  // namespace signorini::rank_one_test
