#include "methods/solvers/condition_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "problems/linear_algebra/lu.hpp"

namespace signorini::condition_estimate_test {
namespace {

double one_norm(const Eigen::MatrixXd& matrix) { return matrix.cwiseAbs().colwise().sum().maxCoeff(); }

double true_condition(const Eigen::MatrixXd& matrix) {
  return one_norm(matrix) * one_norm(LuFactors(matrix).inverse());
}

TEST(TriangularCondition, IsALowerBoundWithinAFactorOfThreeOnRandomMatrices) {
  std::srand(11);
  for (int size = 1; size <= 40; ++size) {
    Eigen::MatrixXd r = Eigen::MatrixXd::Random(size, size).triangularView<Eigen::Upper>();
    r.diagonal().array() += 2.0;
    const double exact = true_condition(r);
    const double estimate = triangular_condition(r);
    EXPECT_LE(estimate, exact * (1.0 + 1e-10)) << size;
    EXPECT_GE(estimate, exact / 3.0) << size;
  }
}

TEST(TriangularCondition, IsExactForDiagonals) {
  const Eigen::Vector3d diagonal(1e-8, -2.0, 5.0);
  EXPECT_NEAR(triangular_condition(diagonal.asDiagonal().toDenseMatrix()), 5e8, 1.0);
  EXPECT_EQ(triangular_condition(Eigen::MatrixXd::Identity(4, 4)), 1.0);
}

TEST(TriangularCondition, SeesWhatTheDiagonalHides) {
  // Unit diagonal, and an inverse that grows as 2^m.
  constexpr int kSize = 30;
  Eigen::MatrixXd r = Eigen::MatrixXd::Identity(kSize, kSize);
  r.triangularView<Eigen::StrictlyUpper>().setConstant(-1.0);
  EXPECT_GE(triangular_condition(r), std::pow(2.0, kSize - 2));
}

TEST(TriangularCondition, ReadsTheUpperTriangleOnly) {
  Eigen::MatrixXd r = Eigen::MatrixXd::Identity(3, 3);
  r(2, 0) = 1e6;
  EXPECT_EQ(triangular_condition(r), 1.0);
}

TEST(TriangularCondition, TellsASingularMatrixAndNone) {
  Eigen::MatrixXd r = Eigen::MatrixXd::Identity(3, 3);
  r(1, 1) = 0.0;
  EXPECT_EQ(triangular_condition(r), kSingular);
  Eigen::MatrixXd cancelling(2, 2);  // to a zero by zero, which a substitution would not see
  cancelling << 0.0, 1.0, 0.0, 1.0;
  EXPECT_EQ(triangular_condition(cancelling), kSingular);
  r(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(triangular_condition(r), kSingular);
  EXPECT_EQ(triangular_condition(Eigen::MatrixXd()), 1.0);
}

TEST(ConditionFrom, IsFiniteWhateverADecompositionSays) {
  EXPECT_EQ(condition_from(1e-3), 1e3);
  for (const double reciprocal : {0.0, std::numeric_limits<double>::quiet_NaN(), 1e-320})
    EXPECT_EQ(condition_from(reciprocal), kSingular);
}

}  // namespace
}  // namespace signorini::condition_estimate_test
