#include "problems/assembly/shaft.hpp"

namespace signorini {

namespace {

// A of one plane in both: coordinate 2 n + r of the plane p becomes 4 n + 2 p + r.
SparseMatrix in_two_planes(const SparseMatrix& A) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto place = [](int i, int plane) { return 4 * (i / 2) + 2 * plane + i % 2; };
  for (int column = 0; column < A.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(A, column); entry; ++entry) {
      for (int plane = 0; plane < 2; ++plane) {
        entries.emplace_back(place(static_cast<int>(entry.row()), plane), place(column, plane),
                             entry.value());
      }
    }
  }
  SparseMatrix both(2 * A.rows(), 2 * A.cols());
  both.setFromTriplets(entries.begin(), entries.end());
  return both;
}

// The matrix of one plane with `value` at the deflections of these nodes.
SparseMatrix on_nodes(const std::vector<int>& nodes, double value, Eigen::Index size) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const int node : nodes) entries.emplace_back(2 * node, 2 * node, value);
  SparseMatrix A(size, size);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

}  // namespace

Structure assemble(const Shaft& shaft) {
  const SparseMatrix mass = unclamped_mass(shaft.beam);
  const std::vector<int> ends = {0, shaft.beam.elements};
  return {.mass = in_two_planes(mass + on_nodes({shaft.disc_node}, shaft.disc_mass, mass.rows())),
          .damping = in_two_planes(on_nodes(ends, shaft.bearing_damping, mass.rows())),
          .stiffness = in_two_planes(unclamped_stiffness(shaft.beam) +
                                     on_nodes(ends, shaft.bearing_stiffness, mass.rows()))};
}

}  // namespace signorini
