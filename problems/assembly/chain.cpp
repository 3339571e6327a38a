#include "problems/assembly/chain.hpp"

namespace signorini {

namespace {

SparseMatrix elements_in_a_row(const std::vector<double>& elements) {
  const int size = static_cast<int>(elements.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < size; ++i) {
    const double a = elements[static_cast<std::size_t>(i)];
    entries.emplace_back(i, i, a);
    if (i == 0) continue;  // the wall does not move
    entries.emplace_back(i - 1, i - 1, a);
    entries.emplace_back(i - 1, i, -a);
    entries.emplace_back(i, i - 1, -a);
  }
  SparseMatrix A(size, size);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

SparseMatrix diagonal(const std::vector<double>& values) {
  const int size = static_cast<int>(values.size());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(values.size());
  for (int i = 0; i < size; ++i) entries.emplace_back(i, i, values[static_cast<std::size_t>(i)]);
  SparseMatrix A(size, size);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

}  // namespace

Structure assemble(const Chain& chain) {
  if (chain.dampers.size() != chain.masses.size() || chain.springs.size() != chain.masses.size()) {
    throw std::invalid_argument("chain: masses, dampers and springs must have one entry per mass");
  }
  return {.mass = diagonal(chain.masses),
          .damping = elements_in_a_row(chain.dampers),
          .stiffness = elements_in_a_row(chain.springs)};
}

}  // namespace signorini
