#include "methods/linear_flow/shared_modes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "methods/linear_flow/modes/spring_modes.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

namespace {

template <class Matrix>
bool equal_matrices(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && (a - b).norm() == 0.0;
}

// The closed stops of a mode where each is a spring by itself, of a structure whose modes are worth finding
// from those without.
std::optional<GroundedSprings> springs_of(const ModeEquations& equations) {
  const std::vector<int>& closed = equations.mode.active;
  const FlowStructure& s = equations.structure();
  const Eigen::MatrixXd& response = equations.mode.response;
  if (closed.empty() || equations.size() <= kLongDouble || equations.dynamics->rigid()) return std::nullopt;
  if (!response.isDiagonal(0.0)) return std::nullopt;
  GroundedSprings springs{.directions = columns_of(s.directions, closed),
                          .stiffness = response.diagonal(),
                          .damping = response.diagonal()};
  for (Eigen::Index k = 0; k < springs.damping.size(); ++k) {
    const int contact = closed[static_cast<std::size_t>(k)];
    springs.damping[k] *= s.relaxes(contact) ? s.relaxation[contact] : 0.0;
  }
  return springs;
}

}  // namespace

std::shared_ptr<const ModalBasis> SharedModes::of(const ModeEquations& equations) {
  const std::vector<int>& active = equations.mode.active;
  const std::shared_ptr<const SparseLlt>& factors = equations.structure().factors;
  auto known = entries_.find(active);
  if (known != entries_.end() && known->second.factors == factors)
    return known->second.modes;  // nothing needs to be compared
  const FreeForm& form = equations.form;
  const Eigen::MatrixXd times = form.relaxing.times;
  std::vector<const Eigen::MatrixXd*> others{&equations.output_of_state, &form.relaxing.of_xi, &times};
  // Those by springs from modes that are known are others only where the springs are, or those modes.
  const std::optional<GroundedSprings> springs = springs_of(equations);
  std::shared_ptr<const ModalBasis> open;
  SparseMatrix mass;
  Eigen::MatrixXd damping, stiffness;
  if (springs) {
    const std::vector<bool> none(static_cast<std::size_t>(equations.structure().contact_count()), false);
    open = of(ModeEquations(*equations.dynamics, equations.dynamics->mode(none)));
    known = entries_.find(active);  // other modes of the open structure leave none of these
  }
  if (open) {
    others.push_back(&equations.mode.response);
  } else {
    damping = equations.dynamics->stops().damping(equations.mode);
    stiffness = equations.dynamics->stops().stiffness(equations.mode);
    others.insert(others.end(), {&damping, &stiffness, &form.basis});
    mass = equations.structure().mass;
  }
  const auto equal = [](const Eigen::MatrixXd& kept, const Eigen::MatrixXd* now) {
    return equal_matrices(kept, *now);
  };
  if (known != entries_.end() && std::ranges::equal(known->second.others, others, equal) &&
      equal_matrices(known->second.mass, mass)) {
    known->second.factors = factors;
    return known->second.modes;
  }
  if (active.empty()) entries_.clear();
  ++found_;
  std::optional<ComplexModes> modes;
  if (open)
    modes = modes_with_springs(open->reduced, equations.structure().mass, *springs,
                               equations.structure().frequency);
  Entry& entry = entries_[active];
  entry.factors = factors;
  entry.mass = mass;
  entry.others.clear();
  for (const Eigen::MatrixXd* matrix : others) entry.others.push_back(*matrix);
  entry.modes =
      modes ? std::make_shared<const ModalBasis>(equations, *std::move(modes)) : modal_basis(equations);
  return entry.modes;
}

}  // namespace signorini
