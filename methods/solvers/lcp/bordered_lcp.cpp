#include "methods/solvers/lcp/bordered_lcp.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "problems/linear_algebra/lu.hpp"

namespace signorini {

namespace {

/// The bounds of A on its rows, and those of the border: its columns on each segment, its rows one by one.
class BorderedBounds final : public ColumnBounds {
 public:
  BorderedBounds(std::unique_ptr<const ColumnBounds> inner, const Eigen::MatrixXd& border)
      : ColumnBounds(all_starts(*inner, border)), inner_(std::move(inner)), border_(border) {
    const auto segments = std::ssize(inner_->starts()) - 1;
    largest_.resize(segments, border.cols());
    for (Eigen::Index s = 0; s < segments; ++s) {
      const int first = inner_->starts()[static_cast<std::size_t>(s)];
      const int end = inner_->starts()[static_cast<std::size_t>(s) + 1];
      largest_.row(s) = border.middleRows(first, end - first).cwiseAbs().colwise().maxCoeff();
    }
  }

  void add(std::span<const int> columns, const double* weights, Eigen::VectorXd& out) const override {
    const Eigen::Index segments = largest_.rows();
    std::vector<int> own;
    std::vector<double> weight;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns[k] < border_.rows()) {
        own.push_back(columns[k]);
        weight.push_back(weights[k]);
      } else {
        out.head(segments) += std::abs(weights[k]) * largest_.col(columns[k] - border_.rows());
      }
    }
    Eigen::VectorXd inside = out.head(segments);
    inner_->add(own, weight.data(), inside);
    out.head(segments) = inside;
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(border_.cols());
    for (std::size_t k = 0; k < own.size(); ++k) sums += weight[k] * border_.row(own[k]).transpose();
    out.tail(border_.cols()) += sums.cwiseAbs();
  }

 private:
  static std::vector<int> all_starts(const ColumnBounds& inner, const Eigen::MatrixXd& border) {
    std::vector<int> starts = inner.starts();
    for (Eigen::Index j = 0; j < border.cols(); ++j) starts.push_back(starts.back() + 1);
    return starts;
  }

  std::unique_ptr<const ColumnBounds> inner_;
  const Eigen::MatrixXd& border_;
  Eigen::MatrixXd largest_;  // |E| on each segment
};

}  // namespace

BorderedLcpMatrix::BorderedLcpMatrix(std::shared_ptr<const LcpMatrix> inner, Eigen::MatrixXd border)
    : inner_(std::move(inner)), n_(inner_->size()), border_(n_, 2 * border.cols()) {
  border_ << border, -border;
}

int BorderedLcpMatrix::size() const { return n_ + static_cast<int>(border_.cols()); }

void BorderedLcpMatrix::add_columns(std::span<const int> columns, const double* weights, int first,
                                    Eigen::Ref<Eigen::VectorXd> out) const {
  const int inside = std::clamp(n_ - first, 0, static_cast<int>(out.size()));
  // In the order of the columns: runs of those of A, and those of the border between them.
  for (std::size_t k = 0; k < columns.size();) {
    std::size_t end = k;
    while (end < columns.size() && columns[end] < n_) ++end;
    if (end > k) {
      if (inside > 0) inner_->add_columns(columns.subspan(k, end - k), weights + k, first, out.head(inside));
      for (int i = inside; i < out.size(); ++i)
        for (std::size_t j = k; j < end; ++j) out[i] += weights[j] * border_(columns[j], first + i - n_);
      k = end;
    } else {
      if (inside > 0) out.head(inside) -= weights[k] * border_.col(columns[k] - n_).segment(first, inside);
      ++k;
    }
  }
}

std::unique_ptr<const ColumnBounds> BorderedLcpMatrix::column_bounds() const {
  std::unique_ptr<const ColumnBounds> inner = inner_->column_bounds();
  if (!inner) return nullptr;
  return std::make_unique<BorderedBounds>(std::move(inner), border_);
}

Eigen::MatrixXd BorderedLcpMatrix::submatrix(std::span<const int> rows, std::span<const int> columns) const {
  const auto entry = [&](Eigen::Index i, Eigen::Index j) {
    const int row = rows[static_cast<std::size_t>(i)], column = columns[static_cast<std::size_t>(j)];
    if (row >= n_) return column < n_ ? border_(column, row - n_) : 0.0;
    return column < n_ ? inner_->submatrix({&row, 1}, {&column, 1})(0, 0) : -border_(row, column - n_);
  };
  return Eigen::MatrixXd::NullaryExpr(std::ssize(rows), std::ssize(columns), entry);
}

Eigen::VectorXd BorderedLcpMatrix::operator*(const Eigen::VectorXd& z) const {
  Eigen::VectorXd result(size());
  const Eigen::VectorXd inside = z.head(n_);
  result << *inner_ * inside - border_ * z.tail(border_.cols()), border_.transpose() * inside;
  return result;
}

Eigen::VectorXd BorderedLcpMatrix::solve(const Eigen::VectorXd& b) const {
  // z = A^-1 (r + E a), E^T A^-1 E a = s - E^T A^-1 r.
  const Eigen::Index m = border_.cols() / 2;
  const auto E = border_.leftCols(m);
  const Eigen::VectorXd z = inner_->solve(b.head(n_));
  Eigen::MatrixXd answers(n_, m);
  for (Eigen::Index j = 0; j < m; ++j) answers.col(j) = inner_->solve(E.col(j));
  const Eigen::VectorXd a = lu_solve(Eigen::MatrixXd(E.transpose() * answers),
                                     Eigen::VectorXd(b.segment(n_, m) - E.transpose() * z));
  Eigen::VectorXd result(size());
  result << z + answers * a, a.cwiseMax(0.0), (-a).cwiseMax(0.0);
  return result;
}

Lcp bordered_lcp(const Lcp& lcp, Eigen::MatrixXd border, const Eigen::VectorXd& balance) {
  Lcp result{.matrix = std::make_shared<BorderedLcpMatrix>(lcp.matrix, std::move(border)),
             .offset = {},
             .samples = lcp.samples,
             .free = static_cast<int>(balance.size())};
  result.offset.resize(result.matrix->size());
  result.offset << lcp.offset, -balance, balance;
  return result;
}

Eigen::VectorXd free_unknowns(const Lcp& lcp, const Eigen::VectorXd& z) {
  return z.segment(lcp.contact_unknowns(), lcp.free) - z.tail(lcp.free);
}

Eigen::VectorXd with_free_unknowns(const Lcp& lcp, const Eigen::VectorXd& z) {
  const Eigen::Index n = lcp.contact_unknowns(), m = lcp.free;
  if (m == 0 || z.size() != n) return z;
  Eigen::VectorXd all = Eigen::VectorXd::Zero(lcp.offset.size());
  all.head(n) = z;
  const Eigen::VectorXd w = lcp.offset + *lcp.matrix * all;
  Eigen::MatrixXd border(n, m);  // E where z presses, 0 elsewhere
  for (Eigen::Index j = 0; j < m; ++j) {
    Eigen::VectorXd one = Eigen::VectorXd::Zero(lcp.offset.size());
    one[n + j] = -1.0;
    border.col(j) = (*lcp.matrix * one).head(n);
  }
  border = (z.array() > 0.0).cast<double>().matrix().asDiagonal() * border;
  const Eigen::VectorXd a =
      CompleteLuFactors(border.transpose() * border).solve(Eigen::VectorXd(border.transpose() * w.head(n)));
  if (!a.allFinite()) return all;
  all.segment(n, m) = a.cwiseMax(0.0);
  all.tail(m) = (-a).cwiseMax(0.0);
  return all;
}

}  // namespace signorini
