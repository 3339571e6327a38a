#include "methods/linear_flow/energy_form.hpp"

#include <Eigen/Cholesky>

namespace signorini {

EnergyForm::EnergyForm(const ExtendedMatrix& M, const ExtendedMatrix& D, const ExtendedMatrix& K,
                       double rate) {
  const Eigen::Index n = M.rows();
  const long double s = rate;
  const ExtendedMatrix identity = ExtendedMatrix::Identity(n, n);
  const Eigen::LLT<ExtendedMatrix> mass(M);
  L = mass.matrixL();
  const auto transformed = [&](const ExtendedMatrix& A) {
    const ExtendedMatrix half = mass.matrixL().solve(A);
    return ExtendedMatrix(mass.matrixL().solve(ExtendedMatrix(half.transpose())).transpose());
  };
  const ExtendedMatrix stiffness = transformed(K);
  // The shift s^2 keeps E regular where K is not, at a rigid-body motion, and costs nothing elsewhere: s is a
  // rate of motions that matter, so that e and z' stay of one size in them.
  const Eigen::LLT<ExtendedMatrix> energy(stiffness + s * s * identity);
  definite = mass.info() == Eigen::Success && energy.info() == Eigen::Success;
  E = definite ? ExtendedMatrix(energy.matrixL()) : ExtendedMatrix(s * identity);
  z_of_e = E.transpose().triangularView<Eigen::Upper>().solve(identity);
  q_of_z = mass.matrixU().solve(identity);
  B = ExtendedMatrix::Zero(2 * n, 2 * n);
  B.topRightCorner(n, n) = E.transpose();
  B.bottomLeftCorner(n, n) =
      definite ? ExtendedMatrix(s * s * z_of_e - E) : ExtendedMatrix(-stiffness * z_of_e);
  B.bottomRightCorner(n, n) = -transformed(D);
}

}  // namespace signorini
