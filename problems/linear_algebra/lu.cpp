#include "problems/linear_algebra/lu.hpp"

#include "problems/linear_algebra/lapack.hpp"

namespace signorini {

namespace {

/// Eigen's factors with those of LAPACK in their place: of large matrices these are several times faster.
class LapackLu : public Eigen::PartialPivLU<Eigen::MatrixXd> {
 public:
  explicit LapackLu(const Eigen::MatrixXd& A) {
    m_l1_norm = A.cwiseAbs().colwise().sum().maxCoeff();
    m_lu = A;
    const auto n = static_cast<int>(A.rows());
    Eigen::VectorXi pivots(n);
    int info = 0;  // of a singular matrix the pivot is 0, as Eigen leaves it
    dgetrf_(&n, &n, m_lu.data(), &n, pivots.data(), &info);
    m_rowsTranspositions.resize(n);
    signed char sign = 1;
    for (int i = 0; i < n; ++i) {
      m_rowsTranspositions.coeffRef(i) = pivots[i] - 1;
      if (pivots[i] != i + 1) sign = static_cast<signed char>(-sign);
    }
    m_det_p = sign;
    m_p = m_rowsTranspositions;
    m_isInitialized = true;
  }
};

}  // namespace

LuFactors::LuFactors(const Eigen::MatrixXd& A) { compute(A); }

void LuFactors::compute(const Eigen::MatrixXd& A) {
  if (is_for_lapack(A))
    lu_ = LapackLu(A);
  else
    lu_.compute(A);
}

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
