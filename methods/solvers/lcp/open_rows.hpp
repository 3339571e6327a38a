#pragma once
// The rows of a complementarity problem that are open along Lemke's path, and which of them may close first.

#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <vector>

#include "methods/solvers/constants.hpp"
#include "methods/solvers/lcp/lcp.hpp"

namespace signorini {

/// What a row may fall below zero by; `scale` is max |q|.
inline double row_slack(double scale) { return kSumRounding * scale; }

/// The rate below which a variable counts as not falling, where the largest is `fastest`.
inline double least_pivot(double fastest) { return kSumRounding * std::max(1.0, fastest); }

/// A_columns weights + cover d over all rows of a problem: what the basic variables, or their rates, add to
/// w.
struct Combination {
  std::vector<int> columns = {};     ///< of A
  std::vector<double> weights = {};  ///< one per column
  double cover = 0.0;                ///< factor of the covering vector d
};

/// w = q + A z + tau d of the rows that no basis holds at zero, at a vertex of Lemke's path.
///
/// Most open rows are far from closing. Per segment of rows a lower bound of w is kept, which falls along a
/// piece of the path no faster than a bound of the rates (ColumnBounds). Only segments that might close a row
/// before the piece ends are evaluated. A pivot costs O(number of segments + rows in those evaluated) times
/// the columns in the basis, in place of all rows; which row closes is not touched by it. Of a matrix without
/// bounds all rows are evaluated.
class OpenRows {
 public:
  /// No row is held, and no value is known.
  /// \param lcp    must outlive the rows
  /// \param cover  the covering vector d, size of q
  OpenRows(const Lcp& lcp, Eigen::VectorXd cover);

  /// The row is held at zero by the basis from now on.
  void hold(int row);
  /// The row is open from now on, its w as given.
  void release(int row, double w);

  /// No value is known any more, nor a bound of one.
  void forget_values();
  /// The basic variables were corrected: values are to be evaluated from them, and bounds hold for them.
  /// \param change  of the basic variables
  void correct_values(const Combination& change);

  /// The open rows that fall to zero before any other, within `longest` and the slack: all of them that do so
  /// first, and few others.
  /// \param value    of the basic variables, at this vertex
  /// \param rate     of the basic variables and the driving one
  /// \param rising   a held row whose w drives: its rate is one; -1: none
  /// \param longest  step of the driving variable within which something else ends the piece; may be infinite
  void find_falling(const Combination& value, const Combination& rate, int rising, double longest);

  /// The rows found.
  [[nodiscard]] const std::vector<int>& falling() const { return falling_; }
  /// Their w, in the same order.
  [[nodiscard]] const Eigen::VectorXd& value() const { return falling_value_; }
  /// Their rates, all negative.
  [[nodiscard]] const Eigen::VectorXd& rate() const { return falling_rate_; }

  /// To the next vertex, `step` of the driving variable further.
  void advance(double step);

 private:
  [[nodiscard]] int first_row(int segment) const { return starts_[static_cast<std::size_t>(segment)]; }
  [[nodiscard]] int row_count(int segment) const { return first_row(segment + 1) - first_row(segment); }
  [[nodiscard]] int segment_of(int row) const;
  void bound_sum(const Combination& terms, Eigen::VectorXd& bound) const;
  void evaluate(int segment, const Combination& value, const Combination& rate, int rising);
  double scan(int segment, double longest, double falls);
  [[nodiscard]] double least_of(int segment) const;

  const Lcp& lcp_;
  std::unique_ptr<const ColumnBounds> bounds_;
  std::vector<int> starts_;
  Eigen::VectorXd open_;  // 1 of an open row, 0 of a held one
  double slack_;          // what a row may fall below zero by
  Eigen::VectorXd cover_, w_, rate_;
  Eigen::VectorXd largest_cover_;  // of |d|, and below segment by segment:
  Eigen::VectorXd least_;          // a lower bound of w over the open rows
  Eigen::VectorXd fastest_;        // an upper bound of |rate|
  Eigen::VectorXd soonest_;        // a lower bound of the step at which a row closes
  double fastest_fall_ = 0.0;      // of the rows evaluated at this vertex
  std::vector<long> known_;        // the vertex at which w_ was right
  std::vector<int> evaluated_;     // segments, at this vertex
  long vertex_ = 1;
  std::vector<int> falling_;
  Eigen::VectorXd falling_value_, falling_rate_;
};

}  // namespace signorini
