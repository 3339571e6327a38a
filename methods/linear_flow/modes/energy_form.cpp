#include "methods/linear_flow/modes/energy_form.hpp"

#include <utility>

namespace signorini {

namespace {

bool is_identity(const ExtendedMatrix& A) {
  for (Eigen::Index j = 0; j < A.cols(); ++j) {
    for (Eigen::Index i = 0; i < A.rows(); ++i)
      if (A(i, j) != (i == j ? 1.0L : 0.0L)) return false;
  }
  return true;
}

}  // namespace

MassForm::MassForm(const ExtendedMatrix& M, const ExtendedMatrix& D, const ExtendedMatrix& K)
    : unit(is_identity(M)) {
  if (unit) {
    definite = true;
    L = q_of_z = M;
    damping = D;
    stiffness = K;
    return;
  }
  extended::Cholesky mass = extended::cholesky(M);
  definite = mass.definite;
  L = std::move(mass.L);
  q_of_z = extended::transposed(extended::solve_lower(L, extended::identity(L.rows())));
  const auto transformed = [this](const ExtendedMatrix& A) {
    return extended::transposed(extended::solve_lower(L, extended::transposed(extended::solve_lower(L, A))));
  };
  damping = transformed(D);
  stiffness = transformed(K);
}

EnergyForm::EnergyForm(const MassForm& mass, double rate) {
  const Eigen::Index n = mass.size();
  const long double s = rate, square = s * s;
  const ExtendedMatrix& stiffness = mass.stiffness;
  // The shift s^2 keeps E regular where K is not, at a rigid-body motion, and costs nothing elsewhere: s is a
  // rate of motions that matter, so that e and z' stay of one size in them.
  constexpr long double kRounding = 1e-12L;  // of a symmetric K on the way here
  ExtendedMatrix skew(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = 0; i < n; ++i) skew(i, j) = 0.5L * (stiffness(i, j) - stiffness(j, i));
  }
  const bool circulates = extended::norm(skew) > kRounding * extended::norm(stiffness);
  ExtendedMatrix elastic = stiffness;
  for (Eigen::Index i = 0; i < n; ++i) elastic(i, i) += square;
  for (Eigen::Index i = 0; circulates && i < n * n; ++i) elastic.data()[i] -= skew.data()[i];
  extended::Cholesky energy = extended::cholesky(elastic);
  definite = mass.definite && energy.definite;
  E = definite ? std::move(energy.L) : extended::identity(n);
  for (Eigen::Index i = 0; !definite && i < n; ++i) E(i, i) = s;
  z_of_e = extended::transposed(extended::solve_lower(E, extended::identity(n)));
  // What the symmetric part leaves out, or without an energy all.
  ExtendedMatrix rest;
  if (!definite || circulates) rest = extended::product(definite ? skew : stiffness, z_of_e);
  B = ExtendedMatrix(2 * n, 2 * n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = 0; i < n; ++i) {
      B(i, j) = 0.0L;
      B(i, n + j) = E(j, i);
      B(n + i, j) = definite ? square * z_of_e(i, j) - E(i, j) : 0.0L;
      if (rest.size() > 0) B(n + i, j) -= rest(i, j);
      B(n + i, n + j) = -mass.damping(i, j);
    }
  }
}

}  // namespace signorini
