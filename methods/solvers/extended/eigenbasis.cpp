#include "methods/solvers/extended/eigenbasis.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <utility>

namespace signorini::extended {

std::optional<Eigenbasis> eigenbasis(const ExtendedMatrix& A) {
  using Complex = std::complex<long double>;
  const Eigen::Index n = A.rows();
  if (n == 0) return Eigenbasis{};
  if (!all_finite(A)) return std::nullopt;
  const Eigen::EigenSolver<ExtendedMatrix> solver(A);
  if (solver.info() != Eigen::Success) return std::nullopt;
  Eigenbasis basis{.real = {}, .imaginary = {}, .vectors = ExtendedMatrix(n, n), .inverse = {}};
  for (const Complex& value : solver.eigenvalues()) {
    // A pair that rounding has left without an imaginary part is defective, and its columns are no vectors.
    if (value.imag() == 0.0L && std::signbit(value.imag())) return std::nullopt;
    basis.real.push_back(value.real());
    basis.imaginary.push_back(value.imag());
  }
  // Columns are not yet of norm 1; of a pair the first holds the real parts, the second the imaginary ones.
  const ExtendedMatrix& columns = solver.pseudoEigenvectors();
  for (Eigen::Index k = 0, size = 1; k < n; k += size) {
    size = basis.imaginary[static_cast<std::size_t>(k)] == 0.0L ? 1 : 2;
    const auto vector = columns.middleCols(k, size);
    basis.vectors.middleCols(k, size) = vector / vector.norm();
  }
  auto inverted = inverse(basis.vectors);
  if (!inverted) return std::nullopt;
  basis.inverse = std::move(*inverted);
  return basis;
}

}  // namespace signorini::extended
