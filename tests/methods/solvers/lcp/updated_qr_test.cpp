#include "methods/solvers/lcp/updated_qr.hpp"

#include <gtest/gtest.h>

#include <random>

#include "problems/linear_algebra/lu.hpp"

namespace signorini::updated_qr_test {
namespace {

/// A matrix kept twice: by updates of its factors, and in full.
class Twin {
 public:
  explicit Twin(int size) : matrix_(Eigen::MatrixXd::Random(size, size)) { qr_.factorise(matrix_); }

  void grow() {
    const Eigen::Index size = matrix_.rows();
    Eigen::MatrixXd next(size + 1, size + 1);
    next.setRandom();
    next.topLeftCorner(size, size) = matrix_;
    qr_.append_column(next.col(size).head(size));
    qr_.append_row(next.row(size).transpose());
    matrix_ = next;
  }

  void shrink(int row, int column) {
    qr_.remove_column(column);
    qr_.remove_row(row);
    matrix_ = without(without(matrix_, column).transpose(), row).transpose();
  }

  void replace_column(int column) {
    const Eigen::VectorXd fresh = Eigen::VectorXd::Random(matrix_.rows());
    qr_.remove_column(column);
    qr_.append_column(fresh);
    Eigen::MatrixXd next(matrix_.rows(), matrix_.cols());
    next << without(matrix_, column), fresh;
    matrix_ = next;
  }

  void replace_row(int row) {
    const Eigen::VectorXd fresh = Eigen::VectorXd::Random(matrix_.cols());
    qr_.append_row(fresh);
    qr_.remove_row(row);
    Eigen::MatrixXd next(matrix_.rows(), matrix_.cols());
    next << without(matrix_.transpose(), row).transpose(), fresh.transpose();
    matrix_ = next;
  }

  [[nodiscard]] int size() const { return static_cast<int>(matrix_.rows()); }

  void expect_solves() const {
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(matrix_.rows(), 1.0, 2.0);
    Eigen::VectorXd x = b;
    qr_.solve(x);
    // Backward stable: the residual is small whatever the conditioning.
    const double scale = matrix_.norm() * x.norm() + b.norm();
    EXPECT_LE((matrix_ * x - b).norm(), 1e-13 * scale) << "size " << matrix_.rows();
    // Of R, which has the condition of the matrix to a factor of its size.
    const double condition = qr_.condition(), rows = static_cast<double>(matrix_.rows());
    const double exact = 1.0 / LuFactors(matrix_).reciprocal_condition();
    EXPECT_GE(condition, exact / (4.0 * rows));
    EXPECT_LE(condition, exact * (4.0 * rows));
  }

 private:
  static Eigen::MatrixXd without(const Eigen::MatrixXd& matrix, int column) {
    Eigen::MatrixXd rest(matrix.rows(), matrix.cols() - 1);
    rest << matrix.leftCols(column), matrix.rightCols(matrix.cols() - 1 - column);
    return rest;
  }

  Eigen::MatrixXd matrix_;
  UpdatedQr qr_;
};

TEST(UpdatedQr, SolvesAfterEachOfManyRandomUpdates) {
  std::srand(3);
  std::mt19937 random(5);
  Twin twin(4);
  for (int step = 0; step < 2000; ++step) {
    const int size = twin.size();
    std::uniform_int_distribution<int> any(0, size - 1);
    switch (std::uniform_int_distribution<int>(0, 3)(random)) {
      case 0:
        if (size < 40) twin.grow();
        break;
      case 1:
        if (size > 1) twin.shrink(any(random), any(random));
        break;
      case 2:
        twin.replace_column(any(random));
        break;
      default:
        twin.replace_row(any(random));
    }
    twin.expect_solves();
  }
}

TEST(UpdatedQr, GrowsFromOneByOne) {
  std::srand(4);
  Twin twin(1);
  for (int k = 0; k < 30; ++k) twin.grow();
  EXPECT_EQ(twin.size(), 31);
  twin.expect_solves();
}

}  // namespace
}  // namespace signorini::updated_qr_test
