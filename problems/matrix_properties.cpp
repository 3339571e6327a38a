#include "problems/matrix_properties.hpp"

#include <Eigen/QR>
#include <Eigen/SparseCholesky>
#include <cmath>

#include "problems/sparse_cholesky.hpp"

namespace signorini {

namespace {

constexpr double kAsymmetry = 1e-12;  // of the largest entry
constexpr double kCurvature = 1e-10;  // of the unit diagonal
constexpr double kMargin = 1e-13;     // of the unit diagonal
constexpr int kLarge = 2000;          // coordinates from which nested dissection and supernodes pay

template <class Visit>
void for_each_entry(const SparseMatrix& A, Visit visit) {
  for (int column = 0; column < A.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(A, column); entry; ++entry) {
      visit(static_cast<int>(entry.row()), column, entry.value());
    }
  }
}

// Smallest pivot of E A E + shift I, E = diag(a_ii)^{-1/2}. Coordinates without diagonal are left out (their
// pivot is 1 + shift); -1 if they are coupled to anything or if the factorisation breaks down.
double smallest_pivot(const SparseMatrix& A, double shift) {
  const double rounding = kAsymmetry * largest_entry(A);
  const Eigen::VectorXd diagonal = A.diagonal();
  if ((diagonal.array() < -rounding).any()) return -1.0;
  std::vector<Eigen::Triplet<double>> entries;
  bool coupled_to_nothing = true;
  for_each_entry(A, [&](int row, int column, double value) {
    if (row == column) return;
    if (diagonal(row) > 0.0 && diagonal(column) > 0.0) {
      entries.emplace_back(row, column, value / (std::sqrt(diagonal(row)) * std::sqrt(diagonal(column))));
    } else if (std::abs(value) > rounding) {
      coupled_to_nothing = false;
    }
  });
  if (!coupled_to_nothing) return -1.0;
  for (int i = 0; i < A.rows(); ++i) entries.emplace_back(i, i, 1.0 + shift);
  SparseMatrix scaled(A.rows(), A.cols());
  scaled.setFromTriplets(entries.begin(), entries.end());
  if (A.rows() > kLarge) return (1.0 + shift) * SparseCholesky(scaled).smallest_pivot();
  const Eigen::SimplicialLDLT<SparseMatrix> factors(scaled);
  return factors.info() == Eigen::Success ? factors.vectorD().minCoeff() : -1.0;
}

// Gershgorin: enough for A to be positive semi-definite, without a factorisation.
bool is_dominated_by_diagonal(const SparseMatrix& A) {
  Eigen::VectorXd surplus = A.diagonal();
  for_each_entry(A, [&](int row, int column, double value) {
    if (row != column) surplus(column) -= std::abs(value);
  });
  return (surplus.array() >= 0.0).all();
}

// Entries of D - alpha M - beta K, relative to the largest of D, that count as rounding.
constexpr double kProportional = 1e-12;

/// alpha, beta that make alpha M + beta K nearest to D, entry by entry.
ProportionalDamping nearest_combination(const SparseMatrix& M, const SparseMatrix& K, const SparseMatrix& D) {
  const auto product = [](const SparseMatrix& A, const SparseMatrix& B) { return A.cwiseProduct(B).sum(); };
  const double inertia = M.norm();
  const double springs = K.norm();
  if (springs == 0.0) return {.alpha = product(M, D) / (inertia * inertia)};
  const double angle = product(M, K) / (inertia * springs);
  const Eigen::Matrix2d gram{{1.0, angle}, {angle, 1.0}};
  const Eigen::Vector2d share = gram.completeOrthogonalDecomposition().solve(
      Eigen::Vector2d(product(M, D) / inertia, product(K, D) / springs));
  return {share[0] / inertia, share[1] / springs};
}

}  // namespace

double largest_entry(const SparseMatrix& A) {
  double largest = 0.0;
  for_each_entry(A, [&](int, int, double value) {
    if (std::isnan(value) || std::abs(value) > largest) largest = std::abs(value);  // NaN, once met, stays
  });
  return largest;
}

bool is_symmetric(const SparseMatrix& A) {
  const SparseMatrix difference = A - SparseMatrix(A.transpose());
  return largest_entry(difference) <= kAsymmetry * largest_entry(A);
}

bool is_semidefinite(const SparseMatrix& A) {
  return is_dominated_by_diagonal(A) || smallest_pivot(A, kCurvature) > 0.0;
}

bool is_definite(const SparseMatrix& A) {
  return (A.diagonal().array() > 0.0).all() && smallest_pivot(A, 0.0) > kMargin;
}

std::optional<ProportionalDamping> proportional_damping(const SparseMatrix& M, const SparseMatrix& K,
                                                        const SparseMatrix& D) {
  const double dampers = largest_entry(D);
  ProportionalDamping fit;
  SparseMatrix rest = D;
  // Least squares over all entries; the second pass takes what rounding of the first has left.
  for (int pass = 0; pass < 2 && largest_entry(rest) > 0.0; ++pass) {
    const ProportionalDamping part = nearest_combination(M, K, rest);
    fit.alpha += part.alpha;
    fit.beta += part.beta;
    rest = D - fit.alpha * M - fit.beta * K;
  }
  if (!(largest_entry(rest) <= kProportional * dampers)) return std::nullopt;
  return fit;
}

}  // namespace signorini
