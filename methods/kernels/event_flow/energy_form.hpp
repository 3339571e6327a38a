#pragma once

#include <Eigen/Cholesky>

namespace signorini {

/// The free motion of M q'' + D q' + K q = 0 (Nr coordinates, M definite) in the coordinates of its energy,
///
///     (e, z')' = B (e, z'),   e = E^T z,   z = L^T q,   M = L L^T,
///     B = [0, E^T; -K~ E^-T, -D~],   (K~, D~) = L^-1 (K, D) L^-T.
///
/// With E E^T = K~ + s^2 the lower left block is s^2 E^-T - E: B is nearly skew, no motion grows on its way
/// however stiff the structure. Where M or K~ + s^2 is not definite, `definite` is false and E = s.
template <class Real>
struct EnergyForm {
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

  /// \param s  a rate of the motion that matters [rad/s], > 0
  EnergyForm(const Eigen::MatrixXd& M, const Eigen::MatrixXd& D, const Eigen::MatrixXd& K, Real s) {
    const Eigen::Index n = M.rows();
    const Matrix identity = Matrix::Identity(n, n);
    const Eigen::LLT<Matrix> mass(M.cast<Real>());
    L = mass.matrixL();
    const auto symmetric = [&](const Eigen::MatrixXd& A) {
      const Matrix half = mass.matrixL().solve(A.cast<Real>());
      return Matrix(mass.matrixL().solve(Matrix(half.transpose())).transpose());
    };
    const Matrix stiffness = symmetric(K);
    const Eigen::LLT<Matrix> energy(stiffness + s * s * identity);
    definite = mass.info() == Eigen::Success && energy.info() == Eigen::Success;
    E = definite ? Matrix(energy.matrixL()) : Matrix(s * identity);
    z_of_e = E.transpose().template triangularView<Eigen::Upper>().solve(identity);
    q_of_z = mass.matrixU().solve(identity);
    B = Matrix::Zero(2 * n, 2 * n);
    B.topRightCorner(n, n) = E.transpose();
    B.bottomLeftCorner(n, n) = definite ? Matrix(s * s * z_of_e - E) : Matrix(-stiffness * z_of_e);
    B.bottomRightCorner(n, n) = -symmetric(D);
  }

  bool definite = false;
  Matrix L, E;            ///< Nr x Nr, lower triangular
  Matrix z_of_e, q_of_z;  ///< E^-T and L^-T
  Matrix B;               ///< 2 Nr x 2 Nr
};

}  // namespace signorini
