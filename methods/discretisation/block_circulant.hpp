#pragma once
// A block-circulant matrix known by its Fourier symbol: every periodic method's operator.

#include <Eigen/Core>
#include <complex>
#include <span>
#include <vector>

#include "methods/discretisation/real_fft.hpp"

namespace signorini {

/// Real matrix of size N Nc acting on N samples of Nc contacts by periodic convolution,
///
///     (A z)_{c,i} = sum_{d,j} a_{cd}[(i - j) mod N] z_{d,j},
///     a_{cd}[k] = (1/N) sum_{|n| <= N/2} (A_n)_{cd} e^{2 pi i n k / N},
///
/// A_n the Nc x Nc symbol. Unknown (c, i) has index c N + i. Stored: one lag table per pair of contacts
/// (2 N Nc^2 numbers); the N Nc x N Nc array never exists. Products with many columns go through FFTs.
class BlockCirculant {
 public:
  /// \param symbol A_n for n = 0..H, H <= N/2; harmonics above H have the symbol `tail` * identity.
  ///        The identity part `tail` sits on the diagonal exactly, without a round trip through a transform.
  BlockCirculant(int samples, const std::vector<Eigen::MatrixXcd>& symbol, double tail = 0.0);

  /// N.
  [[nodiscard]] int samples() const { return samples_; }
  /// Nc.
  [[nodiscard]] int contacts() const { return contacts_; }
  /// N Nc.
  [[nodiscard]] int size() const { return samples_ * contacts_; }

  /// A(row, col).
  [[nodiscard]] double operator()(int row, int col) const {
    return lag(row / samples_, col / samples_, row % samples_ - col % samples_);
  }

  /// out += sum_k weights[k] * A(:, columns[k]); out has size().
  void add_columns(std::span<const int> columns, const double* weights, Eigen::VectorXd& out) const;

  /// A(rows, col), written into out.
  void gather(std::span<const int> rows, int col, Eigen::VectorXd& out) const;

  /// A(rows, columns), dense.
  [[nodiscard]] Eigen::MatrixXd submatrix(std::span<const int> rows, std::span<const int> columns) const;

  /// A z by FFTs, O(N log N Nc + N Nc^2).
  [[nodiscard]] Eigen::VectorXd operator*(const Eigen::VectorXd& z);

  /// A^{-1} b, one Nc x Nc solve per harmonic; not finite where some A_n is singular.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b);

 private:
  [[nodiscard]] double lag(int row_contact, int col_contact, int difference) const {
    return lags_(difference + samples_, row_contact * contacts_ + col_contact);
  }

  int samples_;
  int contacts_;
  Eigen::MatrixXd lags_;  // 2N x Nc^2: row k holds lag k - N, so that a column of A is contiguous
  std::vector<Eigen::MatrixXcd> symbol_;
  double tail_;
  RealFft fft_;
};

}  // namespace signorini
