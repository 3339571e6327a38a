#include "problems/assembly/contact_mass.hpp"

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

SparseMatrix redistributed(const SparseMatrix& mass, const std::vector<Follower>& followers) {
  std::vector<bool> follows(static_cast<std::size_t>(mass.rows()), false);
  std::vector<Eigen::Triplet<double>> entries;
  for (const Follower& follower : followers) {
    follows[static_cast<std::size_t>(follower.dof)] = true;
    for (const auto& [leader, weight] : follower.leaders) entries.emplace_back(follower.dof, leader, weight);
  }
  for (int i = 0; i < mass.rows(); ++i) {
    if (!follows[static_cast<std::size_t>(i)]) entries.emplace_back(i, i, 1.0);
  }
  SparseMatrix P(mass.rows(), mass.cols());
  P.setFromTriplets(entries.begin(), entries.end());
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
