#include "problems/linear_algebra/sparse_factors.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

namespace signorini {

struct SparseLlt::Factors {
  explicit Factors(const Eigen::SparseMatrix<double>& A) : llt(A) {}
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> llt;
};

SparseLlt::SparseLlt(const Eigen::SparseMatrix<double>& A) : factors_(std::make_shared<const Factors>(A)) {}

bool SparseLlt::definite() const { return factors_->llt.info() == Eigen::Success; }

Eigen::VectorXd SparseLlt::solve(const Eigen::VectorXd& b) const { return factors_->llt.solve(b); }

Eigen::MatrixXd SparseLlt::solve(const Eigen::MatrixXd& B) const { return factors_->llt.solve(B); }

struct SparseLdlt::Factors {
  explicit Factors(const Eigen::SparseMatrix<double>& A) : ldlt(A) {}
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt;
};

SparseLdlt::SparseLdlt(const Eigen::SparseMatrix<double>& A) : factors_(std::make_shared<const Factors>(A)) {}

bool SparseLdlt::regular() const { return factors_->ldlt.info() == Eigen::Success; }

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
