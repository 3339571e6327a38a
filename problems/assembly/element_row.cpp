#include "problems/assembly/element_row.hpp"

namespace signorini {

SparseMatrix sum_of_elements(int elements, const Eigen::MatrixXd& element) {
  const int width = static_cast<int>(element.rows());
  const int size = width / 2 * (elements + 1);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(elements) * static_cast<std::size_t>(element.size()));
  for (int e = 0; e < elements; ++e) {
    const int first = width / 2 * e;
    for (int i = 0; i < width; ++i) {
      for (int j = 0; j < width; ++j) {
        if (element(i, j) != 0.0) entries.emplace_back(first + i, first + j, element(i, j));
      }
    }
  }
  SparseMatrix A(size, size);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

SparseMatrix block_diagonal(const std::vector<SparseMatrix>& parts) {
  std::vector<Eigen::Triplet<double>> entries;
  int size = 0;
  for (const SparseMatrix& part : parts) {
    for (int column = 0; column < part.outerSize(); ++column) {
      for (SparseMatrix::InnerIterator entry(part, column); entry; ++entry) {
        entries.emplace_back(size + static_cast<int>(entry.row()), size + column, entry.value());
      }
    }
    size += static_cast<int>(part.rows());
  }
  SparseMatrix A(size, size);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

SparseMatrix clamped(const SparseMatrix& A, int coordinates) {
  const Eigen::Index left = A.rows() - coordinates;
  return A.bottomRightCorner(left, left);
}

}  // namespace signorini
