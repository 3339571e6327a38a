#include "methods/solvers/lcp/lemke_basis.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

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
  factors_.append_column(matrix_.submatrix(rows_, {&index, 1}));
  columns_.push_back(index);
}

void LemkeBasis::append_tau() {
  factors_.append_column(cover_(rows_));
  columns_.push_back(kTau);
}

int LemkeBasis::remove_column(int position) {
  const int index = columns_[static_cast<std::size_t>(position)];
  factors_.remove_column(position);
  columns_.erase(columns_.begin() + position);
  return index;
}

void LemkeBasis::append_row(int index) {
  const std::span<const int> columns = columns_;
  const int tau = position_of_tau();
  const auto before = tau < 0 ? columns.size() : static_cast<std::size_t>(tau);
  Eigen::RowVectorXd row(std::ssize(columns));
  row.head(static_cast<Eigen::Index>(before)) = matrix_.submatrix({&index, 1}, columns.first(before));
  if (tau >= 0) {
    row[tau] = cover_[index];
    const std::span<const int> behind = columns.subspan(before + 1);
    row.tail(std::ssize(behind)) = matrix_.submatrix({&index, 1}, behind);
  }
  factors_.append_row(row.transpose());
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

void LemkeBasis::combine(const Eigen::VectorXd& basic, Combination& result) const {
  result.columns = columns_;
  result.weights.assign(basic.begin(), basic.end());
  const int tau = position_of_tau();
  result.cover = tau < 0 ? 0.0 : basic[tau];
  if (tau < 0) return;
  result.columns.erase(result.columns.begin() + tau);
  result.weights.erase(result.weights.begin() + tau);
}

double longest_step_of_basic(const Eigen::VectorXd& value, const Eigen::VectorXd& rate, double scale) {
  const double slack = kSumRounding * std::max(value.lpNorm<Eigen::Infinity>(), scale);
  const double least = least_pivot(rate.lpNorm<Eigen::Infinity>());
  double longest = kInfinity;
  for (Eigen::Index k = 0; k < value.size(); ++k) {
    if (rate[k] < -least) longest = std::min(longest, (std::max(value[k], 0.0) + slack) / -rate[k]);
  }
  return longest;
}

Blocking find_blocking(const PathVariables& value, const PathVariables& rate, int tau, double scale) {
  const double fastest_w = rate.w.size() > 0 ? -rate.w.minCoeff() : 0.0;
  const Pivots least{least_pivot(rate.basic.lpNorm<Eigen::Infinity>()), least_pivot(fastest_w)};
  double longest = longest_step_of_basic(value.basic, rate.basic, scale);
  const auto reach = (value.w.array().max(0.0) + row_slack(scale)) / -rate.w.array();
  if (rate.w.size() > 0)
    longest = std::min(longest, (rate.w.array() < -least.w).select(reach, kInfinity).minCoeff());
  return longest < kInfinity ? choose_within(value, rate, tau, longest, least) : Blocking{};
}

}  // namespace signorini
