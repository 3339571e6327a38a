#include "methods/solvers/lemke_basis.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace signorini {

void LemkeBasis::begin_with_tau(int row) {
  factors_.factorise(Eigen::MatrixXd::Constant(1, 1, cover_[row]));
  rows_ = {row};
  columns_ = {kTau};
}

void LemkeBasis::begin_with(std::vector<int> active) {
  factors_.factorise(matrix_.submatrix(active, active));
  rows_ = active;
  columns_ = std::move(active);
}

void LemkeBasis::append_z(int index) {
  matrix_.gather_column(rows_, index, work_);
  factors_.append_column(work_);
  columns_.push_back(index);
}

void LemkeBasis::append_tau() {
  gather(cover_, work_);
  factors_.append_column(work_);
  columns_.push_back(kTau);
}

int LemkeBasis::remove_column(int position) {
  const int index = columns_[static_cast<std::size_t>(position)];
  factors_.remove_column(position);
  columns_.erase(columns_.begin() + position);
  return index;
}

void LemkeBasis::append_row(int index) {
  work_.resize(static_cast<Eigen::Index>(columns_.size()));
  const std::span<const int> columns = columns_;
  const auto tau =
      static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), kTau) - columns_.begin());
  matrix_.gather_row(index, columns.first(tau), work_.data());
  if (tau < columns.size()) {
    work_[static_cast<Eigen::Index>(tau)] = cover_[index];
    matrix_.gather_row(index, columns.subspan(tau + 1), work_.data() + tau + 1);
  }
  factors_.append_row(work_);
  rows_.push_back(index);
}

void LemkeBasis::remove_row(int index) {
  const int position = position_of_row(index);
  factors_.remove_row(position);
  rows_.erase(rows_.begin() + position);
}

int LemkeBasis::position_of_row(int index) const {
  return static_cast<int>(std::find(rows_.begin(), rows_.end(), index) - rows_.begin());
}

int LemkeBasis::position_of_tau() const {
  const auto place = std::find(columns_.begin(), columns_.end(), kTau);
  return place == columns_.end() ? -1 : static_cast<int>(place - columns_.begin());
}

void LemkeBasis::gather(const Eigen::VectorXd& full, Eigen::VectorXd& part) const {
  part.resize(static_cast<Eigen::Index>(rows_.size()));
  for (std::size_t k = 0; k < rows_.size(); ++k) part[static_cast<Eigen::Index>(k)] = full[rows_[k]];
}

Eigen::VectorXd LemkeBasis::gathered(const Eigen::VectorXd& full) const {
  Eigen::VectorXd part;
  gather(full, part);
  return part;
}

void LemkeBasis::gather_column(int index, Eigen::VectorXd& part) const {
  matrix_.gather_column(rows_, index, part);
}

void LemkeBasis::accumulate(const Eigen::VectorXd& basic, Eigen::VectorXd& out) const {
  const std::span<const int> columns = columns_;
  const int tau = position_of_tau();
  if (tau < 0) {
    matrix_.add_columns(columns, basic.data(), out);
    return;
  }
  const auto before = static_cast<std::size_t>(tau);
  matrix_.add_columns(columns.first(before), basic.data(), out);
  out += basic[tau] * cover_;
  matrix_.add_columns(columns.subspan(before + 1), basic.data() + tau + 1, out);
}

}  // namespace signorini
