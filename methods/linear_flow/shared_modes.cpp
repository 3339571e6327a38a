#include "methods/linear_flow/shared_modes.hpp"

#include <algorithm>
#include <array>

namespace signorini {

namespace {

template <class Matrix>
bool equal_matrices(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && (a - b).norm() == 0.0;
}

}  // namespace

std::shared_ptr<const ModalBasis> SharedModes::of(const ModeEquations& equations) {
  Entry& entry = entries_[equations.mode.active];
  if (entry.factors == equations.structure().factors) return entry.modes;  // nothing needs to be compared
  const FreeForm& form = equations.form;
  const SparseMatrix& mass = equations.structure().mass;
  const Eigen::MatrixXd times = form.relaxing.times;
  const std::array<const Eigen::MatrixXd*, 6> others{
      &form.damping, &form.stiffness, &form.basis, &equations.output_of_state, &form.relaxing.of_xi, &times};
  const auto equal = [](const Eigen::MatrixXd& kept, const Eigen::MatrixXd* now) {
    return equal_matrices(kept, *now);
  };
  if (!std::ranges::equal(entry.others, others, equal) || !equal_matrices(entry.mass, mass)) {
    ++found_;
    entry.modes = modal_basis(equations);
    entry.mass = mass;
    entry.others.clear();
    for (const Eigen::MatrixXd* matrix : others) entry.others.push_back(*matrix);
  }
  entry.factors = equations.structure().factors;
  return entry.modes;
}

}  // namespace signorini
