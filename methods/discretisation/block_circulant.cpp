#include "methods/discretisation/block_circulant.hpp"

#include <algorithm>
#include <utility>

#include "methods/discretisation/lag_bounds.hpp"

namespace signorini {

BlockCirculant::BlockCirculant(int samples, const std::vector<Eigen::MatrixXcd>& symbol, double tail)
    : samples_(samples),
      contacts_(static_cast<int>(symbol.front().rows())),
      lags_(2 * samples, contacts_ * contacts_),
      symbol_(symbol),
      tail_(tail),
      fft_(samples) {
  // Relative to the tail on every harmonic, the rest is a band-limited convolution.
  for (Eigen::MatrixXcd& block : symbol_) block.diagonal().array() -= tail;
  Eigen::VectorXcd spectrum(static_cast<Eigen::Index>(symbol_.size()));
  Eigen::VectorXd values(samples);
  for (int row = 0; row < contacts_; ++row) {
    for (int col = 0; col < contacts_; ++col) {
      for (std::size_t n = 0; n < symbol_.size(); ++n) {
        spectrum[static_cast<Eigen::Index>(n)] = symbol_[n](row, col);
      }
      fft_.inverse(spectrum, values);
      // z_j has Fourier coefficients (1/N) sum_j ..., hence the kernel of the convolution is the inverse over
      // N.
      values /= samples;
      if (row == col) values[0] += tail;
      lags_.col(row * contacts_ + col) << values, values;
    }
  }
}

void BlockCirculant::add_columns(std::span<const int> columns, const double* weights, int first,
                                 Eigen::Ref<Eigen::VectorXd> out) const {
  for (int done = 0; done < out.size();) {
    const int row = (first + done) / samples_;
    const int instant = (first + done) % samples_;
    const int count = std::min(samples_ - instant, static_cast<int>(out.size()) - done);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const int col_contact = columns[k] / samples_;
      const int shift = samples_ - columns[k] % samples_ + instant;
      out.segment(done, count) += weights[k] * lags_.col(row * contacts_ + col_contact).segment(shift, count);
    }
    done += count;
  }
}

std::unique_ptr<const ColumnBounds> BlockCirculant::column_bounds() const {
  constexpr int kFewRows = 512;
  if (size() <= kFewRows) return nullptr;
  return std::make_unique<LagBounds>(samples_, contacts_, lags_);
}

Eigen::MatrixXd BlockCirculant::submatrix(std::span<const int> rows, std::span<const int> columns) const {
  const auto entry = [&](Eigen::Index i, Eigen::Index j) {
    return (*this)(rows[static_cast<std::size_t>(i)], columns[static_cast<std::size_t>(j)]);
  };
  return Eigen::MatrixXd::NullaryExpr(std::ssize(rows), std::ssize(columns), entry);
}

Eigen::VectorXd BlockCirculant::operator*(const Eigen::VectorXd& z) const {
  const auto kept = static_cast<Eigen::Index>(symbol_.size());
  Eigen::MatrixXcd input(fft_.coefficients(), contacts_);
  for (int c = 0; c < contacts_; ++c) fft_.forward(z.segment(c * samples_, samples_), input.col(c));
  Eigen::MatrixXcd output(kept, contacts_);
  for (Eigen::Index n = 0; n < kept; ++n) {
    output.row(n) = (symbol_[static_cast<std::size_t>(n)] * input.row(n).transpose()).transpose();
  }
  Eigen::VectorXd result(size());
  for (int c = 0; c < contacts_; ++c) fft_.inverse(output.col(c), result.segment(c * samples_, samples_));
  return result + tail_ * z;
}

Eigen::VectorXd BlockCirculant::solve(const Eigen::VectorXd& b) const {
  Eigen::MatrixXcd spectrum(fft_.coefficients(), contacts_);
  for (int c = 0; c < contacts_; ++c) fft_.forward(b.segment(c * samples_, samples_), spectrum.col(c));
  const auto kept = static_cast<Eigen::Index>(symbol_.size());
  for (Eigen::Index n = 0; n < kept; ++n) {
    const auto place = static_cast<std::size_t>(n);
    if (contacts_ == 1) {  // a division, where factors would be an allocation for each harmonic
      spectrum(n, 0) /= symbol_[place](0, 0) + tail_;
    } else {
      spectrum.row(n) = factors()[place].solve(Eigen::VectorXcd(spectrum.row(n).transpose())).transpose();
    }
  }
  spectrum.bottomRows(spectrum.rows() - kept) /= tail_;
  Eigen::VectorXd result(size());
  for (int c = 0; c < contacts_; ++c) fft_.inverse(spectrum.col(c), result.segment(c * samples_, samples_));
  return result;
}

/// Of A_n, made when they are first asked for: Krylov methods ask at every step.
const BlockCirculant::Factors& BlockCirculant::factors() const {
  if (factors_.empty()) {
    const Eigen::MatrixXcd tail = tail_ * Eigen::MatrixXcd::Identity(contacts_, contacts_);
    factors_.reserve(symbol_.size());
    for (const Eigen::MatrixXcd& block : symbol_) factors_.emplace_back(block + tail);
  }
  return factors_;
}

Lcp periodic_lcp(BlockCirculant matrix, Eigen::VectorXd offset) {
  const int samples = matrix.samples();
  return {std::make_shared<BlockCirculant>(std::move(matrix)), std::move(offset), samples};
}

}  // namespace signorini
