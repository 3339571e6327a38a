#include "problems/matrix_properties.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/linear_algebra/sparse/sparse_factors.hpp"
#include "problems/sparse_cholesky.hpp"

namespace signorini {

namespace {

constexpr double kCurvature = 1e-10;  // of the unit diagonal
constexpr int kLarge = 2000;          // coordinates from which nested dissection and supernodes pay
constexpr int kFull = 200000;         // entries from which they do as well: a dense matrix of 450 rows

// The lower triangle of E A E + shift I, E = diag(a_ii)^{-1/2}. Coordinates without diagonal are left out:
// their diagonal is 1 + shift.
SparseMatrix lower_triangle_scaled(const SparseMatrix& A, const Eigen::VectorXd& diagonal, double shift) {
  SparseMatrix scaled(A.rows(), A.cols());
  scaled.reserve((A.nonZeros() + A.rows()) / 2 + A.rows());
  for (int column = 0; column < A.outerSize(); ++column) {
    scaled.startVec(column);
    scaled.insertBackByOuterInner(column, column) = 1.0 + shift;
    if (diagonal(column) <= 0.0) continue;
    for (SparseMatrix::InnerIterator entry(A, column); entry; ++entry) {
      const auto row = static_cast<int>(entry.row());
      if (row <= column || diagonal(row) <= 0.0) continue;
      scaled.insertBackByOuterInner(column, row) =
          entry.value() / (std::sqrt(diagonal(row)) * std::sqrt(diagonal(column)));
    }
  }
  scaled.finalize();
  return scaled;
}

// Smallest pivot of E A E + shift I, E = diag(a_ii)^{-1/2}. Coordinates without diagonal are left out (their
// pivot is 1 + shift); -1 if they are coupled to anything or if the factorisation breaks down.
double smallest_pivot(const SparseMatrix& A, double shift) {
  const double rounding = kEntryRounding * largest_entry(A);
  const Eigen::VectorXd diagonal = A.diagonal();
  if ((diagonal.array() < -rounding).any()) return -1.0;
  bool coupled_to_nothing = true;
  for_each_entry(A, [&](int row, int column, double value) {
    if (row == column || (diagonal(row) > 0.0 && diagonal(column) > 0.0)) return;
    if (std::abs(value) > rounding) coupled_to_nothing = false;
  });
  if (!coupled_to_nothing) return -1.0;
  const SparseMatrix scaled = lower_triangle_scaled(A, diagonal, shift);
  if (A.rows() > kLarge || A.nonZeros() > kFull) {
    return (1.0 + shift) * SparseCholesky(scaled).smallest_pivot();
  }
  const SparseLdlt factors(scaled);
  return factors.regular() ? factors.least_pivot() : -1.0;
}

// Gershgorin: enough for A to be positive semi-definite, without a factorisation.
bool is_dominated_by_diagonal(const SparseMatrix& A) {
  Eigen::VectorXd surplus = A.diagonal();
  for_each_entry(A, [&](int row, int column, double value) {
    if (row != column) surplus(column) -= std::abs(value);
  });
  return (surplus.array() >= 0.0).all();
}

/// M, K and D over powers of two near their largest entries, which rounds nothing, and what sums over all
/// places say.
class ScaledTriple {
 public:
  ScaledTriple(const SparseMatrix& M, const SparseMatrix& K, const SparseMatrix& D)
      : matrices_{&M, &K, &D}, scales_{scale_of(M), scale_of(K), scale_of(D)} {}

  /// Calls visit(m, k, d) at every place where one of the matrices has an entry: no sum of matrices is made.
  template <class Visit>
  void for_each_place(Visit visit) const {
    for (int column = 0; column < matrices_[0]->outerSize(); ++column) {
      std::array<SparseMatrix::InnerIterator, 3> entries{SparseMatrix::InnerIterator(*matrices_[0], column),
                                                         SparseMatrix::InnerIterator(*matrices_[1], column),
                                                         SparseMatrix::InnerIterator(*matrices_[2], column)};
      const auto row_of = [](const auto& entry) {
        return entry ? entry.row() : std::numeric_limits<Eigen::Index>::max();
      };
      while (entries[0] || entries[1] || entries[2]) {
        const Eigen::Index row = std::min({row_of(entries[0]), row_of(entries[1]), row_of(entries[2])});
        std::array<double, 3> values{};
        for (std::size_t i = 0; i < 3; ++i) {
          if (row_of(entries[i]) != row) continue;
          values[i] = entries[i].value() / scales_[i];
          ++entries[i];
        }
        visit(values[0], values[1], values[2]);
      }
    }
  }

  /// alpha, beta that make alpha M + beta K nearest to D, entry by entry, and the largest entry that is left;
  /// all in the scaled matrices. Least squares; the second pass takes what rounding of the first has left.
  [[nodiscard]] std::pair<Eigen::Vector2d, double> nearest_combination() const {
    Eigen::Matrix2d gram = Eigen::Matrix2d::Zero();
    for_each_place([&](double m, double k, double) {
      gram += Eigen::Matrix2d{{m * m, m * k}, {m * k, k * k}};
    });
    const Eigen::Vector2d norms =
        gram.diagonal().cwiseSqrt().unaryExpr([](double x) { return x > 0.0 ? x : 1.0; });
    const Eigen::Matrix2d angles =
        norms.cwiseInverse().asDiagonal() * gram * norms.cwiseInverse().asDiagonal();
    Eigen::Vector2d fit = Eigen::Vector2d::Zero();
    double largest = 0.0;
    for (int pass = 0; pass < 3; ++pass) {
      Eigen::Vector2d share = Eigen::Vector2d::Zero();
      largest = 0.0;
      for_each_place([&](double m, double k, double d) {
        const double rest = d - fit[0] * m - fit[1] * k;
        share += rest * Eigen::Vector2d(m, k);
        if (std::isnan(rest) || std::abs(rest) > largest) largest = std::abs(rest);  // NaN, once met, stays
      });
      if (pass < 2)
        fit += norms.cwiseInverse().cwiseProduct(
            least_norm_solve(angles, Eigen::VectorXd(share.cwiseQuotient(norms))));
    }
    return {fit, largest};
  }

  [[nodiscard]] double scale(std::size_t matrix) const { return scales_[matrix]; }

 private:
  static double scale_of(const SparseMatrix& A) {
    const double largest = largest_entry(A);
    return largest > 0.0 && std::isfinite(largest) ? std::exp2(std::ilogb(largest)) : 1.0;
  }

  std::array<const SparseMatrix*, 3> matrices_;
  std::array<double, 3> scales_;
};

// What is rounding of the other part is none: a time in which contacts relax is not 1e-22 s.
ProportionalDamping without_rounding(ProportionalDamping factors, const SparseMatrix& M,
                                     const SparseMatrix& K, double dampers) {
  constexpr double kRounding = 1e-13;
  if (std::abs(factors.alpha) * largest_entry(M) <= kRounding * dampers) factors.alpha = 0.0;
  if (std::abs(factors.beta) * largest_entry(K) <= kRounding * dampers) factors.beta = 0.0;
  return factors;
}

}  // namespace

double largest_entry(const SparseMatrix& A) {
  double largest = 0.0;
  for_each_entry(A, [&](int, int, double value) {
    if (std::isnan(value) || std::abs(value) > largest) largest = std::abs(value);  // NaN, once met, stays
  });
  return largest;
}

// As columns are gone through, the entries above the diagonal of each are met in order by their partners
// below it: one place per column tells how far. A transpose would take as much memory as the matrix.
bool is_symmetric(const SparseMatrix& A) {
  const auto* rows = A.innerIndexPtr();
  const auto* values = A.valuePtr();
  const auto* begin = A.outerIndexPtr();
  const auto end = [&](int column) {
    return A.isCompressed() ? begin[column + 1] : begin[column] + A.innerNonZeroPtr()[column];
  };
  const double rounding = kEntryRounding * largest_entry(A);
  bool symmetric = !std::isnan(rounding);
  const auto compare = [&](double a, double b) { symmetric = symmetric && std::abs(a - b) <= rounding; };
  std::vector<int> next(begin, begin + A.cols());  // the first entry of each column without partner yet
  const auto pass_to = [&](int column, int row) {
    int& place = next[static_cast<std::size_t>(column)];
    for (; place < end(column) && rows[place] < row; ++place) compare(values[place], 0.0);
    return place < end(column) && rows[place] == row ? values[place++] : 0.0;
  };
  for (int column = 0; column < A.cols(); ++column) {
    for (int k = begin[column]; k < end(column); ++k) {
      if (rows[k] > column) compare(values[k], pass_to(rows[k], column));
    }
  }
  for (int column = 0; column < A.cols(); ++column) pass_to(column, column);
  return symmetric;
}

bool is_semidefinite(const SparseMatrix& A) {
  return is_dominated_by_diagonal(A) || smallest_pivot(A, kCurvature) > 0.0;
}

bool is_definite(const SparseMatrix& A) {
  return (A.diagonal().array() > 0.0).all() && smallest_pivot(A, 0.0) > kDefinitePivot;
}

SparseMatrix combination(const ProportionalDamping& factors, const SparseMatrix& M, const SparseMatrix& K) {
  SparseMatrix sum(M.rows(), M.cols());
  sum.reserve(M.nonZeros() + K.nonZeros());
  for (int column = 0; column < M.outerSize(); ++column) {
    sum.startVec(column);
    SparseMatrix::InnerIterator m(M, column);
    SparseMatrix::InnerIterator k(K, column);
    while (m || k) {
      const bool of_m = m && (!k || m.row() <= k.row());
      const bool of_k = k && (!m || k.row() <= m.row());
      const int row = static_cast<int>(of_m ? m.row() : k.row());
      sum.insertBackByOuterInner(column, row) =
          (of_m ? factors.alpha * m.value() : 0.0) + (of_k ? factors.beta * k.value() : 0.0);
      if (of_m) ++m;
      if (of_k) ++k;
    }
  }
  sum.finalize();
  return sum;
}

std::optional<ProportionalDamping> proportional_damping(const SparseMatrix& M, const SparseMatrix& K,
                                                        const SparseMatrix& D) {
  const ScaledTriple scaled(M, K, D);
  const auto [share, rest] = scaled.nearest_combination();
  const double dampers = largest_entry(D);
  if (!share.allFinite() || !(rest * scaled.scale(2) <= kEntryRounding * dampers) || !is_symmetric(K))
    return std::nullopt;
  return without_rounding({.alpha = share[0] * (scaled.scale(2) / scaled.scale(0)),
                           .beta = share[1] * (scaled.scale(2) / scaled.scale(1))},
                          M, K, dampers);
}

std::optional<ProportionalDamping> proportional_damping(const Structure& structure) {
  if (!structure.proportional)
    return proportional_damping(structure.mass, structure.stiffness, structure.damping);
  return without_rounding(*structure.proportional, structure.mass, structure.stiffness,
                          largest_entry(structure.damping));
}

}  // namespace signorini
