#pragma once
// A block-circulant matrix known by its Fourier symbol: every periodic method's operator.

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "methods/discretisation/real_fft.hpp"
#include "methods/solvers/lcp/lcp.hpp"
#include "problems/linear_algebra/complex_lu.hpp"

namespace signorini {

/// Real matrix of size N Nc acting on N samples of Nc contacts by periodic convolution,
///
///     (A z)_{c,i} = sum_{d,j} a_{cd}[(i - j) mod N] z_{d,j},
///     a_{cd}[k] = (1/N) sum_{|n| <= N/2} (A_n)_{cd} e^{2 pi i n k / N},
///
/// A_n the Nc x Nc symbol. Unknown (c, i) has index c N + i. Stored: one lag table per pair of contacts
/// (2 N Nc^2 numbers); the N Nc x N Nc array never exists. Products with many columns go through FFTs.
class BlockCirculant final : public LcpMatrix {
 public:
  /// \param symbol A_n for n = 0..H, H <= N/2; harmonics above H have the symbol `tail` * identity.
  ///        The identity part `tail` sits on the diagonal exactly, without a round trip through a transform.
  BlockCirculant(int samples, const std::vector<Eigen::MatrixXcd>& symbol, double tail = 0.0);

  /// N.
  [[nodiscard]] int samples() const { return samples_; }
  /// Nc.
  [[nodiscard]] int contacts() const { return contacts_; }
  /// N Nc.
  [[nodiscard]] int size() const override { return samples_ * contacts_; }

  /// A(row, col).
  [[nodiscard]] double operator()(int row, int col) const {
    return lag(row / samples_, col / samples_, row % samples_ - col % samples_);
  }

  /// O(1) per row and column: each is a shifted piece of the lag table.
  void add_columns(std::span<const int> columns, const double* weights, int first,
                   Eigen::Ref<Eigen::VectorXd> out) const override;
  /// Some sqrt(N) segments a contact, of one length but for its last (LagBounds).
  [[nodiscard]] std::unique_ptr<const ColumnBounds> column_bounds() const override;
  [[nodiscard]] Eigen::MatrixXd submatrix(std::span<const int> rows,
                                          std::span<const int> columns) const override;
  /// By FFTs, O(N log N Nc + N Nc^2).
  [[nodiscard]] Eigen::VectorXd operator*(const Eigen::VectorXd& z) const override;
  /// By one Nc x Nc solve per harmonic, whose factors are kept from the first call on; not finite where some
  /// A_n is singular.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const override;

 private:
  [[nodiscard]] double lag(int row_contact, int col_contact, int difference) const {
    return lags_(difference + samples_, row_contact * contacts_ + col_contact);
  }

  using Factors = std::vector<ComplexLuFactors>;
  [[nodiscard]] const Factors& factors() const;

  int samples_;
  int contacts_;
  Eigen::MatrixXd lags_;  // 2N x Nc^2: row k holds lag k - N, so that a column of A is contiguous
  std::vector<Eigen::MatrixXcd> symbol_;
  double tail_;
  mutable Factors factors_;  // empty until a solve needs them
  mutable RealFft fft_;      // owns its work space: one transform at a time, as everything in a thread
};

/// The problem w = q + A z of Nc contacts at N instants, q N Nc.
Lcp periodic_lcp(BlockCirculant matrix, Eigen::VectorXd offset);

}  // namespace signorini
