#include "problems/assembly/bar.hpp"

#include "problems/validation.hpp"

namespace signorini {

namespace {

// Contact nodes on the line through two nodes without contact.
std::vector<Follower> followers(const Bar& bar) {
  std::vector<bool> contact(static_cast<std::size_t>(bar.elements) + 1, false);
  for (const int dof : bar.contacts) contact[static_cast<std::size_t>(dof) + 1] = true;
  std::vector<Follower> result;
  for (int node = 1; node <= bar.elements; ++node) {
    if (!contact[static_cast<std::size_t>(node)]) continue;
    const auto [near, far] = nearest_free_nodes(contact, node);
    if (far < 0) {
      throw InvalidProblem("system.contact_mass", "massless",
                           "must leave some node besides the clamped one without contact, to carry the mass");
    }
    const double along = static_cast<double>(node - near) / (far - near);
    result.push_back({.dof = node, .leaders = {{near, 1.0 - along}, {far, along}}});
  }
  return result;
}

}  // namespace

SparseMatrix unclamped_mass(const Bar& bar) {
  const double mass = bar.density * bar.area * bar.length / bar.elements;
  Eigen::Matrix2d element;
  if (bar.contact_mass == ContactMass::lumped) {
    element << mass / 2, 0.0, 0.0, mass / 2;
    return sum_of_elements(bar.elements, element);
  }
  element << mass / 3, mass / 6, mass / 6, mass / 3;
  const SparseMatrix consistent = sum_of_elements(bar.elements, element);
  return bar.contact_mass == ContactMass::massless ? redistributed(consistent, followers(bar)) : consistent;
}

Structure assemble(const Bar& bar) {
  const double stiffness = bar.young * bar.area * bar.elements / bar.length;
  Eigen::Matrix2d element;
  element << stiffness, -stiffness, -stiffness, stiffness;
  return {.mass = clamped(unclamped_mass(bar), 1),
          .damping = SparseMatrix(bar.elements, bar.elements),
          .stiffness = clamped(sum_of_elements(bar.elements, element), 1)};
}

}  // namespace signorini
