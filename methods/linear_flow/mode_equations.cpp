#include "methods/linear_flow/mode_equations.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <complex>
#include <utility>

namespace signorini {

MassForm::MassForm(const ExtendedMatrix& M, const ExtendedMatrix& D, const ExtendedMatrix& K) {
  const Eigen::LLT<ExtendedMatrix> mass(M);
  definite = mass.info() == Eigen::Success;
  L = mass.matrixL();
  q_of_z = mass.matrixU().solve(ExtendedMatrix::Identity(M.rows(), M.rows()));
  const auto transformed = [&](const ExtendedMatrix& A) {
    const ExtendedMatrix half = mass.matrixL().solve(A);
    return ExtendedMatrix(mass.matrixL().solve(ExtendedMatrix(half.transpose())).transpose());
  };
  damping = transformed(D);
  stiffness = transformed(K);
}

EnergyForm::EnergyForm(const MassForm& mass, double rate) {
  const Eigen::Index n = mass.size();
  const long double s = rate;
  const ExtendedMatrix identity = ExtendedMatrix::Identity(n, n);
  const ExtendedMatrix& stiffness = mass.stiffness;
  // The shift s^2 keeps E regular where K is not, at a rigid-body motion, and costs nothing elsewhere: s is a
  // rate of motions that matter, so that e and z' stay of one size in them.
  constexpr long double kRounding = 1e-12L;  // of a symmetric K on the way here
  const ExtendedMatrix skew = 0.5L * (stiffness - stiffness.transpose());
  const bool circulates = skew.norm() > kRounding * stiffness.norm();
  ExtendedMatrix elastic = stiffness + s * s * identity;
  if (circulates) elastic -= skew;
  const Eigen::LLT<ExtendedMatrix> energy(elastic);
  definite = mass.definite && energy.info() == Eigen::Success;
  E = definite ? ExtendedMatrix(energy.matrixL()) : ExtendedMatrix(s * identity);
  z_of_e = E.transpose().triangularView<Eigen::Upper>().solve(identity);
  B = ExtendedMatrix::Zero(2 * n, 2 * n);
  B.topRightCorner(n, n) = E.transpose();
  B.bottomLeftCorner(n, n) =
      definite ? ExtendedMatrix(s * s * z_of_e - E) : ExtendedMatrix(-stiffness * z_of_e);
  if (definite && circulates) B.bottomLeftCorner(n, n) -= skew * z_of_e;
  B.bottomRightCorner(n, n) = -mass.damping;
}

ModeEquations::ModeEquations(const ContactDynamics& of, ContactMode contacts)
    : dynamics(&of), mode(std::move(contacts)), form(of.stops().free_form(mode)) {
  const FlowStructure& s = structure();
  const int contact_count = s.contact_count();
  const auto active = static_cast<Eigen::Index>(mode.active.size());
  output_of_state = Eigen::MatrixXd::Zero(contact_count + active, states());
  output_of_state.topLeftCorner(contact_count, size()) = s.directions.transpose();
  output_of_load.resize(contact_count + active, static_cast<Eigen::Index>(s.rates.size()));
  if (s.relaxing() > 0) {  // x = W^T u + xi
    output_of_state.block(0, size(), contact_count, contact_count).setIdentity();
    output_of_load.topRows(contact_count).setZero();
  } else {
    output_of_load.topRows(contact_count) = s.shift;
  }
  if (active == 0) return;
  output_of_state.bottomRows(active) = form.force_of_state;
  output_of_load.bottomRows(active) = form.force_of_load;
  if (s.relaxing() > 0) return;
  // x = W^T u + s + C_0 lambda
  const Eigen::MatrixXd give = s.massless_compliance(Eigen::all, mode.active);
  output_of_state.topRows(contact_count) += give * form.force_of_state;
  output_of_load.topRows(contact_count) += give * form.force_of_load;
}

Eigen::VectorXcd ModeEquations::reduced_load(Eigen::Index h) const {
  Eigen::VectorXcd load = form.load.col(h);
  if (h == 0) load -= (structure().stiffness * form.offset).cast<std::complex<double>>();
  return form.basis.transpose() * load;
}

MassForm ModeEquations::mass_form() const {
  const ExtendedMatrix Q = form.basis.cast<long double>();
  const auto reduced = [&](const Eigen::MatrixXd& A) -> ExtendedMatrix {
    if (Q.cols() == size()) return A.cast<long double>();  // nothing is held: Q is the identity
    return Q.transpose() * (A.cast<long double>() * Q);
  };
  const FlowStructure& s = structure();
  return {reduced(s.mass), reduced(form.damping), reduced(form.stiffness)};
}

Eigen::Index ModeEquations::force_row(int contact) const {
  const auto found = std::lower_bound(mode.active.begin(), mode.active.end(), contact);
  if (found == mode.active.end() || *found != contact) return -1;
  return structure().contact_count() + (found - mode.active.begin());
}

}  // namespace signorini
