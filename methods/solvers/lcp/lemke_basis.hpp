#pragma once
// The basis of Lemke's method: which variables move along the path, the linear system that ties them, and the
// ratio test that tells which of them reaches its bound first.

#include <Eigen/Core>
#include <limits>
#include <utility>
#include <vector>

#include "methods/solvers/lcp/lcp.hpp"
#include "methods/solvers/lcp/open_rows.hpp"
#include "methods/solvers/lcp/updated_qr.hpp"

namespace signorini {

/// The bordered active block G = [A_RB, d_R] of w = q + tau d + A z: R the rows whose w is held at zero (or
/// drives the path), B the basic z; d_R is there while tau is basic. A full tableau would have the size of q;
/// this has that of the positive z. Its factors are updated, O(|R|^2) per change, by Givens rotations, which
/// unlike an updated inverse or LU without exchanges do not lose stability however long the path is.
class LemkeBasis {
 public:
  /// An empty basis.
  /// \param matrix  A, which must outlive the basis
  explicit LemkeBasis(const LcpMatrix& matrix) : matrix_(matrix) {}

  /// The covering vector d, size of q; to be set before tau becomes basic.
  void set_cover(Eigen::VectorXd cover) { cover_ = std::move(cover); }
  /// d.
  [[nodiscard]] const Eigen::VectorXd& cover() const { return cover_; }

  /// Starts with tau alone in the given row, G = d_row.
  void begin_with_tau(int row);
  /// Starts with the z of `active` in their own rows, without tau: G = A_SS.
  void begin_with(std::vector<int> active);

  /// Appends the column A_R,index: z of that index becomes basic.
  void append_z(int index);
  /// Appends the column d_R: tau becomes basic.
  void append_tau();
  /// Removes the column at a position; returns the index of its z, meaningless for tau.
  int remove_column(int position);
  /// Appends the row of an index, whose w is then held.
  void append_row(int index);
  /// Removes the row of an index, whose w then moves.
  void remove_row(int index);

  /// R, in the order of rows.
  [[nodiscard]] const std::vector<int>& rows() const { return rows_; }
  /// Position of an index among the rows; it must be there.
  [[nodiscard]] int position_of_row(int index) const;
  /// Position of tau among the columns; -1 where it is not basic.
  [[nodiscard]] int position_of_tau() const;
  /// Indices of the basic z in the order of columns; tau must not be among them.
  [[nodiscard]] const std::vector<int>& basic_z() const { return columns_; }

  /// G^{-1} b for a square G, in place; not finite where G is singular to working precision.
  void solve(Eigen::VectorXd& b) const { factors_.solve(b); }
  /// What the basic variables, in the order of columns, add to w.
  /// \param result  as far as its memory reaches, nothing is allocated
  void combine(const Eigen::VectorXd& basic, Combination& result) const;
  /// Estimated condition number of a square G (triangular_condition) [-].
  [[nodiscard]] double condition() const { return factors_.condition(); }

 private:
  static constexpr int kTau = -1;  // tau among the columns

  const LcpMatrix& matrix_;
  Eigen::VectorXd cover_;
  UpdatedQr factors_;
  std::vector<int> rows_;     // R
  std::vector<int> columns_;  // B, and kTau
};

/// The variables that move along the path: their values, or their rates along the driving variable.
struct PathVariables {
  Eigen::VectorXd basic;  ///< basic z and tau, in the order of the basis's columns
  Eigen::VectorXd w;      ///< of open rows, in any order
};

/// What stops the path at the end of one linear piece.
struct Blocking {
  /// Which variable stops it.
  enum class Kind {
    none,  ///< nothing: the piece is a ray
    tau,   ///< the homotopy parameter reaches zero: the problem is solved
    z,     ///< a basic z reaches zero: that sample opens
    w,     ///< a positive w reaches zero: that sample closes
  };
  Kind kind = Kind::none;  ///< of the variable that stops it
  int position = 0;        ///< of z and tau: place in the order of columns; of w: place in PathVariables
  double step = std::numeric_limits<double>::infinity();  ///< of the driving variable up to there
};

/// How far a basic variable at its bound gives way, and how slowly one falls that does not fall: rounding.
/// \param value  basic z and tau
/// \return the step at which the first of them is below zero by its slack, the first pass of `find_blocking`
double longest_step_of_basic(const Eigen::VectorXd& value, const Eigen::VectorXd& rate, double scale);

/// The first variable to reach its bound at value + step rate, step >= 0.
///
/// In exact arithmetic that is the smallest ratio value / -rate over falling variables. With rounding, ties
/// and near-ties would often pick a variable of tiny rate, whose exchange makes the basis ill-conditioned. So
/// the test has two passes [harris1973]: the longest step that violates no bound by more than a tolerance of
/// rounding size, and among the variables met up to there the one that falls fastest, the largest pivot.
/// tau has precedence, since it ends the path.
/// \param tau  position of tau among value.basic; -1 if it is not basic
/// \param scale  max |q|, the size of w against which rounding is measured
Blocking find_blocking(const PathVariables& value, const PathVariables& rate, int tau, double scale);

}  // namespace signorini
