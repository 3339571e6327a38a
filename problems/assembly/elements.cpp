#include "problems/assembly/elements.hpp"

namespace signorini {

namespace {

// First node without contact from `node` on, in steps of +-1; -1 if there is none.
int next_free(const std::vector<bool>& contact, int node, int step) {
  const int count = static_cast<int>(contact.size());
  for (node += step; node >= 0 && node < count; node += step) {
    if (!contact[static_cast<std::size_t>(node)]) return node;
  }
  return -1;
}

}  // namespace

SparseMatrix from_entries(const Entries& entries, Eigen::Index size) {
  SparseMatrix A(size, size);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

SparseMatrix sum_of_elements(int elements, const Eigen::MatrixXd& element) {
  const int width = static_cast<int>(element.rows());
  const int size = width / 2 * (elements + 1);
  Entries entries;
  entries.reserve(static_cast<std::size_t>(elements) * static_cast<std::size_t>(element.size()));
  for (int e = 0; e < elements; ++e) {
    const int first = width / 2 * e;
    for (int i = 0; i < width; ++i) {
      for (int j = 0; j < width; ++j) {
        if (element(i, j) != 0.0) entries.emplace_back(first + i, first + j, element(i, j));
      }
    }
  }
  return from_entries(entries, size);
}

SparseMatrix block_diagonal(const std::vector<SparseMatrix>& parts) {
  Entries entries;
  int size = 0;
  for (const SparseMatrix& part : parts) {
    for_each_entry(part, [&](int row, int column, double value) {
      entries.emplace_back(size + row, size + column, value);
    });
    size += static_cast<int>(part.rows());
  }
  return from_entries(entries, size);
}

SparseMatrix clamped(const SparseMatrix& A, int coordinates) {
  const Eigen::Index left = A.rows() - coordinates;
  SparseMatrix corner(left, left);
  corner.reserve(A.nonZeros());
  for (int column = 0; column < left; ++column) {
    corner.startVec(column);
    for (SparseMatrix::InnerIterator entry(A, column + coordinates); entry; ++entry) {
      const int row = static_cast<int>(entry.row()) - coordinates;
      if (row >= 0) corner.insertBackByOuterInner(column, row) = entry.value();
    }
  }
  corner.finalize();
  return corner;
}

SparseMatrix redistributed(const SparseMatrix& mass, const std::vector<Follower>& followers) {
  std::vector<bool> follows(static_cast<std::size_t>(mass.rows()), false);
  Entries entries;
  for (const Follower& follower : followers) {
    follows[static_cast<std::size_t>(follower.dof)] = true;
    for (const auto& [leader, weight] : follower.leaders) entries.emplace_back(follower.dof, leader, weight);
  }
  for (int i = 0; i < mass.rows(); ++i) {
    if (!follows[static_cast<std::size_t>(i)]) entries.emplace_back(i, i, 1.0);
  }
  const SparseMatrix P = from_entries(entries, mass.rows());
  const SparseMatrix moved = P.transpose() * mass * P;
  return 0.5 * (moved + SparseMatrix(moved.transpose()));  // symmetric to the last bit
}

std::pair<int, int> nearest_free_nodes(const std::vector<bool>& contact, int node) {
  const int left = next_free(contact, node, -1);
  const int right = next_free(contact, node, +1);
  if (left >= 0 && right >= 0) return {left, right};
  if (left >= 0) return {left, next_free(contact, left, -1)};
  if (right >= 0) return {right, next_free(contact, right, +1)};
  return {-1, -1};
}

}  // namespace signorini
