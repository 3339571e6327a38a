#include "methods/linear_flow/shared_modes.hpp"

#include <algorithm>
#include <utility>

namespace signorini {

std::shared_ptr<const ModalBasis> SharedModes::of(const ModeEquations& equations) {
  const FreeForm& form = equations.form;
  std::vector<Eigen::MatrixXd> matrices;  // no list in braces, which copies each one twice
  matrices.reserve(7);
  matrices.emplace_back(equations.structure().mass);
  for (const auto* matrix : {&form.damping, &form.stiffness, &form.basis, &equations.output_of_state})
    matrices.emplace_back(*matrix);
  matrices.emplace_back(form.relaxing.of_xi);
  matrices.emplace_back(form.relaxing.times);
  const auto equal = [](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return a.rows() == b.rows() && a.cols() == b.cols() && (a - b).norm() == 0.0;
  };
  Entry& entry = entries_[equations.mode.active];
  if (std::ranges::equal(entry.matrices, matrices, equal)) return entry.modes;
  ++found_;
  entry = {.matrices = std::move(matrices), .modes = modal_basis(equations)};
  return entry.modes;
}

}  // namespace signorini
