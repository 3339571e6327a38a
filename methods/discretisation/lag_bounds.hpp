#pragma once
// Bounds of combinations of the columns of a block-circulant matrix.

#include <Eigen/Core>
#include <span>

#include "methods/solvers/lcp/lcp.hpp"

namespace signorini {

/// Bounds over some sqrt(N) segments of the N rows of each contact, all of one length L but for a contact's
/// last.
///
/// The rows of a segment meet L lags of a column in turn: the largest entry among them bounds it. Columns of
/// one contact at neighbouring instants c_1 < c_2 < ... are summed by parts,
///
///     sum_k v_k A_{c_k} = V_1 A_{c_1} + sum_{k > 1} V_k (A_{c_k} - A_{c_{k-1}}),   V_k = sum_{j >= k} v_j,
///
/// where a difference is at most (c_k - c_{k-1}) times the largest step between two lags: where a contact
/// moves from one node to the next, the forces of both change fast and their effect elsewhere hardly at all.
class LagBounds final : public ColumnBounds {
 public:
  /// \param lags  lag k - N of each pair of contacts (row contact * Nc + column contact) in row k, 2N x Nc^2
  LagBounds(int samples, int contacts, const Eigen::MatrixXd& lags);

  void add(std::span<const int> columns, const double* weights, Eigen::VectorXd& out) const override;

 private:
  [[nodiscard]] int first_piece(int column) const { return (samples_ - column % samples_) / length_; }
  void add_column(int column, double weight, Eigen::VectorXd& out) const;
  void add_difference(int column, int before, double weight, Eigen::VectorXd& out) const;

  int samples_;
  int contacts_;
  int length_;                // L
  int segments_;              // of a contact
  Eigen::MatrixXd largest_;   // of two pieces of L lags, from each piece on: entries
  Eigen::MatrixXd steepest_;  // of three pieces: steps from a lag to the next
};

}  // namespace signorini
