#include "methods/linear_flow/shared_modes.hpp"

namespace signorini {

namespace {

template <class Matrix>
bool equal_matrices(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && (a - b).norm() == 0.0;
}

}  // namespace

bool SharedModes::Entry::fits(const ModeEquations& equations) const {
  const FlowStructure& structure = equations.structure();
  return equal_matrices(mass, structure.mass) && equal_matrices(damping, equations.form.damping) &&
         equal_matrices(stiffness, equations.form.stiffness) && equal_matrices(basis, equations.form.basis) &&
         equal_matrices(output_of_state, equations.output_of_state) &&
         equal_matrices(relaxing, equations.form.relaxing.of_xi) &&
         equal_matrices(times, equations.form.relaxing.times);
}

std::shared_ptr<const ModalBasis> SharedModes::of(const ModeEquations& equations) {
  const auto known = entries_.find(equations.mode.active);
  if (known != entries_.end() && known->second.fits(equations)) return known->second.modes;
  ++found_;
  const FlowStructure& structure = equations.structure();
  Entry& entry = entries_[equations.mode.active];
  entry = {.mass = structure.mass,
           .damping = equations.form.damping,
           .stiffness = equations.form.stiffness,
           .basis = equations.form.basis,
           .output_of_state = equations.output_of_state,
           .relaxing = equations.form.relaxing.of_xi,
           .times = equations.form.relaxing.times,
           .modes = modal_basis(equations)};
  return entry.modes;
}

}  // namespace signorini
