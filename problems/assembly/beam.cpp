#include "problems/assembly/beam.hpp"

#include <map>

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

double element_length(const Beam& beam) { return beam.length / beam.elements; }

// Adds weight * (deflection of `from` + integral of the rotation from there to `to`).
void integrate(int from, int to, double h, double weight, std::map<int, double>& leaders) {
  leaders[2 * from] += weight;
  const int step = to > from ? 1 : -1;
  for (int node = from; node != to; node += step) {
    leaders[2 * node + 1] += weight * step * h / 2.0;
    leaders[2 * (node + step) + 1] += weight * step * h / 2.0;
  }
}

std::vector<Follower> followers(const Beam& beam) {
  std::vector<bool> contact(static_cast<std::size_t>(beam.elements) + 1, false);
  for (const int dof : beam.contacts) {
    if (dof % 2 != 0) {
      throw InvalidProblem(
          "system.contact_mass", "massless",
          "needs contacts on deflections only, the even coordinates: rotations keep their mass");
    }
    contact[static_cast<std::size_t>(dof / 2) + 1] = true;
  }
  std::vector<Follower> result;
  for (int node = 1; node <= beam.elements; ++node) {
    if (!contact[static_cast<std::size_t>(node)]) continue;
    const auto [left, other] = nearest_free_nodes(contact, node);  // node 0 is free: there is a left one
    const bool between = other > node;
    const double share = between ? static_cast<double>(other - node) / (other - left) : 1.0;
    std::map<int, double> leaders;
    integrate(left, node, element_length(beam), share, leaders);
    if (between) integrate(other, node, element_length(beam), 1.0 - share, leaders);
    result.push_back({.dof = 2 * node, .leaders = {leaders.begin(), leaders.end()}});
  }
  return result;
}

// A of one plane in both: coordinate 2 n + r of the plane p becomes 4 n + 2 p + r.
SparseMatrix in_two_planes(const SparseMatrix& A) {
  Entries entries;
  const auto place = [](int i, int plane) { return 4 * (i / 2) + 2 * plane + i % 2; };
  for_each_entry(A, [&](int row, int column, double value) {
    for (int plane = 0; plane < 2; ++plane)
      entries.emplace_back(place(row, plane), place(column, plane), value);
  });
  return from_entries(entries, 2 * A.rows());
}

// The matrix of one plane with `value` at these coordinates, deflections 2 n and rotations 2 n + 1 of nodes.
SparseMatrix on_coordinates(const std::vector<int>& coordinates, double value, Eigen::Index size) {
  Entries entries;
  for (const int i : coordinates) entries.emplace_back(i, i, value);
  return from_entries(entries, size);
}

}  // namespace

SparseMatrix gyroscopic_matrix(const Shaft& shaft) {
  const int size = 4 * (shaft.beam.elements + 1), theta = 4 * shaft.disc_node + 1, phi = theta + 2;
  const double momentum = shaft.polar_inertia * shaft.spin;
  SparseMatrix G(size, size);
  if (momentum == 0.0) return G;
  G.insert(theta, phi) = momentum;
  G.insert(phi, theta) = -momentum;
  return G;
}

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

SparseMatrix unclamped_mass(const Beam& beam) {
  const double h = element_length(beam);
  const double mass = beam.density * beam.area * h;
  if (beam.contact_mass == ContactMass::lumped) {
    const Eigen::Vector4d halves(mass / 2, mass * h * h / 78, mass / 2, mass * h * h / 78);
    return sum_of_elements(beam.elements, halves.asDiagonal());
  }
  Eigen::Matrix4d element;
  element << 156, 22 * h, 54, -13 * h,        //
      22 * h, 4 * h * h, 13 * h, -3 * h * h,  //
      54, 13 * h, 156, -22 * h,               //
      -13 * h, -3 * h * h, -22 * h, 4 * h * h;
  const SparseMatrix consistent = sum_of_elements(beam.elements, mass / 420 * element);
  return beam.contact_mass == ContactMass::massless ? redistributed(consistent, followers(beam)) : consistent;
}

SparseMatrix unclamped_stiffness(const Beam& beam) {
  const double h = element_length(beam);
  Eigen::Matrix4d element;
  element << 12, 6 * h, -12, 6 * h,         //
      6 * h, 4 * h * h, -6 * h, 2 * h * h,  //
      -12, -6 * h, 12, -6 * h,              //
      6 * h, 2 * h * h, -6 * h, 4 * h * h;
  return sum_of_elements(beam.elements, beam.young * beam.inertia / (h * h * h) * element);
}

Structure assemble(const Beam& beam) {
  const int size = 2 * beam.elements;
  std::vector<SparseMatrix> masses;
  for (int b = 0; b < beam.count; ++b) {
    Beam single = beam;
    single.contacts.clear();
    for (const int dof : beam.contacts) {
      if (dof / size == b) single.contacts.push_back(dof % size);
    }
    masses.push_back(clamped(unclamped_mass(single), 2));
  }
  const std::vector<SparseMatrix> springs(masses.size(), clamped(unclamped_stiffness(beam), 2));
  return {.mass = block_diagonal(masses),
          .damping = SparseMatrix(size * beam.count, size * beam.count),
          .stiffness = block_diagonal(springs)};
}

Structure assemble(const Shaft& shaft) {
  const SparseMatrix mass = unclamped_mass(shaft.beam);
  const std::vector<int> ends = {0, 2 * shaft.beam.elements};
  const SparseMatrix disc = on_coordinates({2 * shaft.disc_node}, shaft.disc_mass, mass.rows()) +
                            on_coordinates({2 * shaft.disc_node + 1}, shaft.disc_inertia, mass.rows());
  return {.mass = in_two_planes(mass + disc),
          .damping = in_two_planes(on_coordinates(ends, shaft.bearing_damping, mass.rows())) +
                     gyroscopic_matrix(shaft),
          .stiffness = in_two_planes(unclamped_stiffness(shaft.beam) +
                                     on_coordinates(ends, shaft.bearing_stiffness, mass.rows()))};
}

}  // namespace signorini
