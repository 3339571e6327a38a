#include "problems/linear_algebra/lu.hpp"

namespace signorini {

LuFactors::LuFactors(const Eigen::MatrixXd& A) : lu_(A) {}

void LuFactors::compute(const Eigen::MatrixXd& A) { lu_.compute(A); }

Eigen::VectorXd LuFactors::solve(const Eigen::VectorXd& b) const { return lu_.solve(b); }

Eigen::MatrixXd LuFactors::solve(const Eigen::MatrixXd& B) const { return lu_.solve(B); }

Eigen::MatrixXd LuFactors::inverse() const { return lu_.inverse(); }

double LuFactors::reciprocal_condition() const { return lu_.rcond(); }

double LuFactors::determinant() const { return lu_.determinant(); }

Eigen::VectorXd LuFactors::pivots() const { return lu_.matrixLU().diagonal(); }

double LuFactors::permutation_sign() const { return static_cast<double>(lu_.permutationP().determinant()); }

LuFactorsInPlace::LuFactorsInPlace(Eigen::MatrixXd& A) : lu_(A) {}

Eigen::VectorXd LuFactorsInPlace::solve(const Eigen::VectorXd& b) const { return lu_.solve(b); }

double LuFactorsInPlace::reciprocal_condition() const { return lu_.rcond(); }

CompleteLuFactors::CompleteLuFactors(const Eigen::MatrixXd& A) : lu_(A) {}

Eigen::VectorXd CompleteLuFactors::solve(const Eigen::VectorXd& b) const { return lu_.solve(b); }

bool CompleteLuFactors::regular() const { return lu_.isInvertible(); }

double CompleteLuFactors::reciprocal_condition() const { return lu_.rcond(); }

double CompleteLuFactors::least_pivot() const { return lu_.matrixLU().diagonal().cwiseAbs().minCoeff(); }

Eigen::VectorXd lu_solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) { return LuFactors(A).solve(b); }

Eigen::MatrixXd lu_solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) { return LuFactors(A).solve(B); }

double determinant(const Eigen::MatrixXd& A) { return A.rows() == 0 ? 1.0 : LuFactors(A).determinant(); }

Eigen::MatrixXd lower_solve(const Eigen::MatrixXd& L, const Eigen::MatrixXd& B) {
  return L.triangularView<Eigen::Lower>().solve(B);
}

}  // namespace signorini
