#include "methods/solvers/lemke_basis.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSlack = 64 * kEpsilon;  // rounding of a few dozen operations, relative

// Rates above which (they are negative) a variable counts as not falling.
struct Pivots {
  double z, w;
};

// Second pass: the fastest of the variables that reach their bound within the longest step.
Blocking choose_within(const PathVariables& value, const PathVariables& rate, int tau, double longest,
                       const Pivots& least) {
  Blocking best;
  double largest = 0.0;
  for (Eigen::Index k = 0; k < value.basic.size(); ++k) {
    if (rate.basic[k] >= -least.z) continue;
    const double step = std::max(value.basic[k], 0.0) / -rate.basic[k];
    if (step > longest) continue;
    const auto position = static_cast<int>(k);
    if (position == tau) return {Blocking::Kind::tau, position, step};
    if (-rate.basic[k] > largest) {
      largest = -rate.basic[k];
      best = {Blocking::Kind::z, position, step};
    }
  }
  for (Eigen::Index i = 0; i < value.w.size(); ++i) {
    // Rows held have rate 0, so that nothing but a basic w passes here.
    if (rate.w[i] >= -least.w || value.w[i] > -longest * rate.w[i]) continue;
    if (-rate.w[i] > largest) {
      largest = -rate.w[i];
      best = {Blocking::Kind::w, static_cast<int>(i), std::max(value.w[i], 0.0) / -rate.w[i]};
    }
  }
  return best;
}

}  // namespace

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
  work_ = cover_(rows_);
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
  const int tau = position_of_tau();
  const auto before = tau < 0 ? columns.size() : static_cast<std::size_t>(tau);
  matrix_.gather_row(index, columns.first(before), work_.data());
  if (tau >= 0) {
    work_[tau] = cover_[index];
    matrix_.gather_row(index, columns.subspan(before + 1), work_.data() + before + 1);
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

Blocking find_blocking(const PathVariables& value, const PathVariables& rate, int tau, double scale) {
  const double z_slack = kSlack * std::max(value.basic.lpNorm<Eigen::Infinity>(), scale);
  const double w_slack = kSlack * scale;
  const Pivots least{kSlack * std::max(1.0, rate.basic.lpNorm<Eigen::Infinity>()),
                     kSlack * std::max(1.0, -rate.w.minCoeff())};
  // First pass: values that rounding has pushed below zero count as zero, and every bound gives way by the
  // slack.
  double longest = kInfinity;
  for (Eigen::Index k = 0; k < value.basic.size(); ++k) {
    if (rate.basic[k] >= -least.z) continue;
    longest = std::min(longest, (std::max(value.basic[k], 0.0) + z_slack) / -rate.basic[k]);
  }
  const auto reach = (value.w.array().max(0.0) + w_slack) / -rate.w.array();
  longest = std::min(longest, (rate.w.array() < -least.w).select(reach, kInfinity).minCoeff());
  return longest < kInfinity ? choose_within(value, rate, tau, longest, least) : Blocking{};
}

}  // namespace signorini
