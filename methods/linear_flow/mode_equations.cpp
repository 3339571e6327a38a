#include "methods/linear_flow/mode_equations.hpp"

#include <algorithm>
#include <complex>
#include <utility>

#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/sparse/sparse_products.hpp"

namespace signorini {

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
  Eigen::MatrixXd give(contact_count, active);
  for (Eigen::Index k = 0; k < active; ++k)
    give.col(k) = s.massless_compliance.col(mode.active[static_cast<std::size_t>(k)]);
  output_of_state.topRows(contact_count) += product(give, form.force_of_state);
  output_of_load.topRows(contact_count) += product_of_complex(give, form.force_of_load);
}

Eigen::VectorXcd ModeEquations::reduced_load(Eigen::Index h) const {
  Eigen::VectorXcd load = form.load.col(h);
  if (h == 0) load -= sparse_image(structure().stiffness, form.offset).cast<std::complex<double>>();
  return free() == size() ? load : image_of_complex_by_transposed(form.basis, load);
}

MassForm ModeEquations::mass_form() const {
  const ExtendedMatrix Q = extended::widened(form.basis);
  const auto reduced = [&](const Eigen::MatrixXd& A) {
    ExtendedMatrix wide = extended::widened(A);
    if (Q.cols() == size()) return wide;  // nothing is held: Q is the identity
    return extended::transposed_product(Q, extended::product(wide, Q));
  };
  const FlowStructure& s = structure();
  return {reduced(s.mass), reduced(dynamics->stops().damping(mode)),
          reduced(dynamics->stops().stiffness(mode))};
}

Eigen::Index ModeEquations::force_row(int contact) const {
  const auto found = std::lower_bound(mode.active.begin(), mode.active.end(), contact);
  if (found == mode.active.end() || *found != contact) return -1;
  return structure().contact_count() + (found - mode.active.begin());
}

}  // namespace signorini
