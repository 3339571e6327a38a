#pragma once
// The linear complementarity problem, and those of a few unknowns that are solved at an instant.

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "methods/deadline.hpp"
#include "methods/options.hpp"

namespace signorini {

/// Bounds on combinations of the columns of a matrix A, over segments of its rows.
class ColumnBounds {
 public:
  /// \param starts  as `starts` gives it
  explicit ColumnBounds(std::vector<int> starts) : starts_(std::move(starts)) {}
  virtual ~ColumnBounds() = default;

  /// The first row of each segment, from 0 on, and the number of rows at the end.
  [[nodiscard]] const std::vector<int>& starts() const { return starts_; }

  /// out[s] += b_s, where b_s >= |sum_k weights[k] A(i, columns[k])| for every row i of segment s, but for
  /// rounding.
  virtual void add(std::span<const int> columns, const double* weights, Eigen::VectorXd& out) const = 0;

 private:
  std::vector<int> starts_;
};

/// A square matrix A that need not exist as an array. Each call handles whole columns or blocks, so
/// that its cost is that of the arithmetic. Indices are below size(), without repetition.
class LcpMatrix {
 public:
  virtual ~LcpMatrix() = default;

  /// Rows and columns of A.
  [[nodiscard]] virtual int size() const = 0;

  /// out += sum_k weights[k] * A(first + (0, 1, ...), columns[k]), added in the order of `columns`: of as
  /// many rows as out has.
  virtual void add_columns(std::span<const int> columns, const double* weights, int first,
                           Eigen::Ref<Eigen::VectorXd> out) const = 0;

  /// Segments of rows short beside all of A, and how large sums of its columns are there. Null where all rows
  /// are as soon evaluated as bounded.
  [[nodiscard]] virtual std::unique_ptr<const ColumnBounds> column_bounds() const = 0;

  /// A(rows, columns), dense.
  [[nodiscard]] virtual Eigen::MatrixXd submatrix(std::span<const int> rows,
                                                  std::span<const int> columns) const = 0;

  /// A z; z and the result have size().
  [[nodiscard]] virtual Eigen::VectorXd operator*(const Eigen::VectorXd& z) const = 0;

  /// A^{-1} b; not finite where A is singular.
  [[nodiscard]] virtual Eigen::VectorXd solve(const Eigen::VectorXd& b) const = 0;
};

/// Finds z >= 0 with w = q + A z >= 0 and z^T w = 0. Entries of A are of order one on the diagonal (the
/// assembly scales them), q may have any size.
struct Lcp {
  std::shared_ptr<const LcpMatrix> matrix;  ///< A, never null
  Eigen::VectorXd offset;                   ///< q
  /// N, a divisor of the size of q: the unknowns of a contact at N instants follow one another. 1 where the
  /// problem is that of a single instant [-]
  int samples = 1;

  /// m, unknowns of any sign behind those of the contacts, each as two that are not negative
  /// (bordered_lcp.hpp)
  /// [-]
  int free = 0;

  /// N Nc.
  [[nodiscard]] Eigen::Index contact_unknowns() const { return offset.size() - 2 * free; }
  /// Nc, the runs of N unknowns.
  [[nodiscard]] int contacts() const { return static_cast<int>(contact_unknowns()) / samples; }
};

/// How a complementarity problem is solved.
enum class ComplementaritySolver {
  automatic,  ///< pivoting, restarted with other covering vectors where the path fails
  pivoting,   ///< pivoting, one path
  newton,     ///< semi-smooth Newton with a line search, the source paper's solver
};

/// The values of the option `solver`.
template <>
struct EnumNames<ComplementaritySolver> {
  /// In the order of the enumerators.
  static constexpr std::array<std::string_view, 3> values{"auto", "pivoting", "newton"};
};

/// What a solve may do, and when it must end.
struct SolverSettings {
  ComplementaritySolver solver = ComplementaritySolver::automatic;  ///< which of them `solve_lcp` takes
  double tolerance = 1e-10;                                         ///< on LcpResult::residual [-]
  int max_iterations = 0;  ///< pivots or Newton iterations; 0: the solver's own limit
  int most_positive = 0;   ///< components of z that a path of pivots holds positive at most; 0: any number
  /// The end of the time budget.
  Deadline deadline = {};
  double cover_amplitude =
      0.0;                   ///< of the wave of a cold path's covering vector (smooth_cover), in [0, 1) [-]
  double cover_phase = 0.0;  ///< [rad]
};

/// How a solve ended.
enum class LcpStatus {
  solved,       ///< residual below tolerance
  ray,          ///< the path of the pivoting solver ends in an unbounded direction
  stalled,      ///< the line search of the Newton solver found no descent
  limit,        ///< pivots or iterations used up
  breakdown,    ///< the active block is singular to working precision
  interrupted,  ///< the time budget ran out
};

/// The answer of a solver, or its best iterate.
struct LcpResult {
  LcpStatus status = LcpStatus::breakdown;  ///< how it ended
  Eigen::VectorXd z = {};                   ///< of the size of q
  double residual = 0.0;                 ///< max |min(z, w)| / max(max |q|, max |z|), NaN-safe (infinity) [-]
  long pivots = 0;                       ///< pivoting solver
  long iterations = 0;                   ///< Newton solver
  long factorisations = 0;               ///< dense factorisations from scratch
  std::optional<double> condition = {};  ///< estimate for the block of A on which z > 0; empty: none [-]
};

/// max_i |min(z_i, w_i)| / max(max |q|, max |z|) with w recomputed from z; infinity if anything is not
/// finite. The scale is the larger of the load on the constraint and the answer.
double natural_residual(const Lcp& lcp, const Eigen::VectorXd& z);

/// One sentence on how a solve ended.
std::string describe(LcpStatus status);

/// The problem w = q + A z of a single instant, for the solvers of any complementarity problem.
/// \param matrix  A as an array, m x m
/// \param offset  q, m
Lcp dense_lcp(Eigen::MatrixXd matrix, Eigen::VectorXd offset);

/// Finds z with w = A z + q, z_i w_i = 0, z_i >= 0, w_i >= 0, except that indices in `held` are
/// equalities: w_i = 0, z_i of any sign.
///
/// \param A     m x m, symmetric positive semi-definite with a positive diagonal (a Delassus matrix)
/// \param q     m
/// \param held  one flag per index
/// \return m; unique when A is positive definite. For a singular A, where w is unique but z is not, z is
///         the one of least norm on its support. Empty if there is none, or if rounding decides.
/// Block principal pivoting, by the least index where that stagnates [judice1994]; then, for a singular A,
/// Lemke's method. A dense solve of the active set per pivot.
std::optional<Eigen::VectorXd> solve_small_lcp(const Eigen::MatrixXd& A, const Eigen::VectorXd& q,
                                               const std::vector<bool>& held);

}  // namespace signorini
