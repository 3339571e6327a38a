#include "problems/linear_algebra/sparse/sparse_factors.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

namespace signorini {

struct SparseLlt::Factors {
  explicit Factors(const Eigen::SparseMatrix<double>& A) : llt(A) {}
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> llt;
};

SparseLlt::SparseLlt(const Eigen::SparseMatrix<double>& A) : factors_(std::make_shared<const Factors>(A)) {}

bool SparseLlt::definite() const {
  if (factors_->llt.info() != Eigen::Success) return false;
  // NaN passes Eigen's test of the pivots; the diagonal is the first entry of each column.
  const auto& L = factors_->llt.matrixL().nestedExpression();
  for (Eigen::Index j = 0; j < L.cols(); ++j) {
    if (!std::isfinite(L.valuePtr()[L.outerIndexPtr()[j]])) return false;
  }
  return true;
}

Eigen::VectorXd SparseLlt::solve(const Eigen::VectorXd& b) const { return factors_->llt.solve(b); }

Eigen::MatrixXd SparseLlt::solve(const Eigen::MatrixXd& B) const { return factors_->llt.solve(B); }

struct SparseLdlt::Factors {
  explicit Factors(const Eigen::SparseMatrix<double>& A) : ldlt(A) {}
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt;
};

SparseLdlt::SparseLdlt(const Eigen::SparseMatrix<double>& A) : factors_(std::make_shared<const Factors>(A)) {}

bool SparseLdlt::regular() const {
  if (factors_->ldlt.info() != Eigen::Success) return false;
  const Eigen::VectorXd pivots = factors_->ldlt.vectorD();
  return std::all_of(pivots.begin(), pivots.end(), [](double pivot) { return std::isfinite(pivot); });
}

double SparseLdlt::least_pivot() const { return factors_->ldlt.vectorD().minCoeff(); }

Eigen::MatrixXd SparseLdlt::solve(const Eigen::MatrixXd& B) const { return factors_->ldlt.solve(B); }

Eigen::SparseMatrix<double> SparseLdlt::solve(const Eigen::SparseMatrix<double>& B) const {
  return factors_->ldlt.solve(B);
}

struct SparseLu::Factors {
  explicit Factors(const Eigen::SparseMatrix<double>& A) : lu(A) {}
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu;
};

SparseLu::SparseLu(const Eigen::SparseMatrix<double>& A) : factors_(std::make_shared<const Factors>(A)) {}

bool SparseLu::regular() const { return factors_ && factors_->lu.info() == Eigen::Success; }

Eigen::VectorXd SparseLu::solve(const Eigen::VectorXd& b) const { return factors_->lu.solve(b); }

Eigen::MatrixXd SparseLu::solve(const Eigen::MatrixXd& B) const { return factors_->lu.solve(B); }

}  // namespace signorini
