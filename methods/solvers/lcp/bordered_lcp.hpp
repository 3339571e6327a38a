#pragma once
// Complementarity problems with some unknowns of any sign, each tied to an equation.

#include <Eigen/Core>
#include <memory>
#include <span>

#include "methods/solvers/lcp/lcp.hpp"

namespace signorini {

/// The matrix of
///
///     w = q + A z - E a >= 0,   z >= 0,   z^T w = 0,   E^T z = b,
///
/// a of any sign, m of them, as a complementarity problem of z, a+ and a-, a = a+ - a-: rows E^T z - b >= 0
/// and b - E^T z >= 0 beside them. The border is skew, so that the matrix is semidefinite or copositive where
/// A is.
class BorderedLcpMatrix final : public LcpMatrix {
 public:
  /// \param inner   A, n x n, regular  \param border  E, n x m of rank m
  BorderedLcpMatrix(std::shared_ptr<const LcpMatrix> inner, Eigen::MatrixXd border);

  /// n + 2 m: z, a+, a-.
  [[nodiscard]] int size() const override;
  void add_columns(std::span<const int> columns, const double* weights, int first,
                   Eigen::Ref<Eigen::VectorXd> out) const override;
  /// Those of A, and of the border's rows one by one.
  [[nodiscard]] std::unique_ptr<const ColumnBounds> column_bounds() const override;
  [[nodiscard]] Eigen::MatrixXd submatrix(std::span<const int> rows,
                                          std::span<const int> columns) const override;
  [[nodiscard]] Eigen::VectorXd operator*(const Eigen::VectorXd& z) const override;
  /// The z, a+ and a-, one of each pair 0, of right-hand sides whose last m are the m before with the
  /// opposite sign.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const override;

 private:
  std::shared_ptr<const LcpMatrix> inner_;
  int n_;
  Eigen::MatrixXd border_;  // (E, -E), n x 2 m
};

/// w = q + A z - E a with E^T z = b. \param lcp  A and q, without free unknowns \param balance  b, m
Lcp bordered_lcp(const Lcp& lcp, Eigen::MatrixXd border, const Eigen::VectorXd& balance);

/// a of an answer, m; empty where none is free.
Eigen::VectorXd free_unknowns(const Lcp& lcp, const Eigen::VectorXd& z);

/// z of the contacts with the a, as a+ and a-, that bring w nearest to zero where z is positive; z itself
/// where none is free or z has them.
Eigen::VectorXd with_free_unknowns(const Lcp& lcp, const Eigen::VectorXd& z);

}  // namespace signorini
