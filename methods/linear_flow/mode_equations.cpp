#include "methods/linear_flow/mode_equations.hpp"

#include <algorithm>
#include <complex>
#include <utility>

namespace signorini {

ModeEquations::ModeEquations(const ContactDynamics& of, ContactMode contacts)
    : dynamics(&of), mode(std::move(contacts)), form(of.stops().free_form(mode)) {
  const FlowStructure& s = structure();
  const int contact_count = s.contact_count();
  const auto active = static_cast<Eigen::Index>(mode.active.size());
  output_of_state = Eigen::MatrixXd::Zero(contact_count + active, 2 * size());
  output_of_state.topLeftCorner(contact_count, size()) = s.directions.transpose();
  output_of_load.resize(contact_count + active, static_cast<Eigen::Index>(s.rates.size()));
  output_of_load.topRows(contact_count) = s.shift;
  if (active == 0) return;
  const ForceRows force = of.stops().force_rows(mode);
  // x = W^T u + s + C_0 lambda
  const Eigen::MatrixXd give = s.massless_compliance(Eigen::all, mode.active);
  output_of_state.topRows(contact_count) += give * force.of_state;
  output_of_state.bottomRows(active) = force.of_state;
  output_of_load.topRows(contact_count) += give * force.of_load;
  output_of_load.bottomRows(active) = force.of_load;
}

Eigen::VectorXcd ModeEquations::reduced_load(Eigen::Index h) const {
  Eigen::VectorXcd load = form.load.col(h);
  if (h == 0) load -= (structure().stiffness * form.offset).cast<std::complex<double>>();
  return form.basis.transpose() * load;
}

EnergyForm ModeEquations::energy() const {
  const ExtendedMatrix Q = form.basis.cast<long double>();
  const auto reduced = [&](const Eigen::MatrixXd& A) -> ExtendedMatrix {
    if (Q.cols() == size()) return A.cast<long double>();  // nothing is held: Q is the identity
    return Q.transpose() * (A.cast<long double>() * Q);
  };
  const FlowStructure& s = structure();
  return EnergyForm(reduced(s.mass), reduced(s.damping), reduced(form.stiffness), s.frequency);
}

Eigen::Index ModeEquations::force_row(int contact) const {
  const auto found = std::lower_bound(mode.active.begin(), mode.active.end(), contact);
  if (found == mode.active.end() || *found != contact) return -1;
  return structure().contact_count() + (found - mode.active.begin());
}

}  // namespace signorini
