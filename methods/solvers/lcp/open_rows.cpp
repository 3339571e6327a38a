#include "methods/solvers/lcp/open_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace signorini {

OpenRows::OpenRows(const Lcp& lcp, Eigen::VectorXd cover)
    : lcp_(lcp),
      bounds_(lcp.matrix->column_bounds()),
      starts_(bounds_ ? bounds_->starts() : std::vector<int>{0, static_cast<int>(lcp.offset.size())}),
      open_(Eigen::VectorXd::Ones(lcp.offset.size())),
      slack_(row_slack(lcp.offset.lpNorm<Eigen::Infinity>())),
      cover_(std::move(cover)),
      w_(lcp.offset.size()),
      rate_(lcp.offset.size()),
      largest_cover_(std::ssize(starts_) - 1),
      least_(Eigen::VectorXd::Constant(largest_cover_.size(), -kInfinity)),
      fastest_(largest_cover_.size()),
      soonest_(largest_cover_.size()),
      known_(starts_.size() - 1, 0) {
  for (int s = 0; s < static_cast<int>(largest_cover_.size()); ++s)
    largest_cover_[s] = cover_.segment(first_row(s), row_count(s)).lpNorm<Eigen::Infinity>();
}

int OpenRows::segment_of(int row) const {
  return static_cast<int>(std::upper_bound(starts_.begin(), starts_.end(), row) - starts_.begin()) - 1;
}

void OpenRows::hold(int row) {
  open_[row] = 0.0;
  w_[row] = 0.0;
}

void OpenRows::release(int row, double w) {
  open_[row] = 1.0;
  w_[row] = w;
  double& least = least_[segment_of(row)];
  least = std::min(least, w);
}

void OpenRows::forget_values() {
  ++vertex_;
  least_.setConstant(-kInfinity);
}

void OpenRows::correct_values(const Combination& change) {
  ++vertex_;
  if (!bounds_) return;
  bound_sum(change, fastest_);
  least_ -= fastest_;
}

void OpenRows::bound_sum(const Combination& terms, Eigen::VectorXd& bound) const {
  bound = std::abs(terms.cover) * largest_cover_;
  bounds_->add(terms.columns, terms.weights.data(), bound);
}

void OpenRows::find_falling(const Combination& value, const Combination& rate, int rising, double longest) {
  evaluated_.clear();
  falling_.clear();
  fastest_fall_ = 0.0;
  if (!bounds_) {
    evaluate(0, value, rate, rising);
    longest = scan(0, longest, least_pivot(fastest_fall_));
  } else {
    bound_sum(rate, fastest_);
    // As below, by a bound: a row left out here alone makes the search longer, no more.
    const double falls = least_pivot(fastest_.maxCoeff());
    // A bound of zero is of rows that do not move.
    soonest_ = (fastest_.array() > 0.0).select(least_.array().max(0.0) / fastest_.array(), kInfinity);
    while (true) {
      int segment = 0;
      if (!(soonest_.minCoeff(&segment) <= longest) || soonest_[segment] == kInfinity) break;
      soonest_[segment] = kInfinity;
      evaluate(segment, value, rate, rising);
      longest = scan(segment, longest, falls);
    }
  }
  // What hardly falls beside the fastest row falls by rounding.
  const double least = least_pivot(fastest_fall_);
  std::erase_if(falling_, [&](int row) {
    return rate_[row] >= -least || std::max(w_[row], 0.0) > longest * -rate_[row];
  });
  falling_value_ = w_(falling_);
  falling_rate_ = rate_(falling_);
}

/// Values, where they are not known from the vertex before, and rates.
void OpenRows::evaluate(int segment, const Combination& value, const Combination& rate, int rising) {
  const int first = first_row(segment);
  const int count = row_count(segment);
  const auto add = [&](const Combination& terms, Eigen::Ref<Eigen::VectorXd> out) {
    lcp_.matrix->add_columns(terms.columns, terms.weights.data(), first, out);
  };
  long& known = known_[static_cast<std::size_t>(segment)];
  if (known != vertex_) {
    w_.segment(first, count) = lcp_.offset.segment(first, count) + value.cover * cover_.segment(first, count);
    add(value, w_.segment(first, count));
    known = vertex_;
  }
  rate_.segment(first, count) = rate.cover * cover_.segment(first, count);
  add(rate, rate_.segment(first, count));
  // Held rows stay where they are exactly; only the driving w moves. What rounding leaves there would be
  // taken for the rate of a blocking variable.
  rate_.segment(first, count).array() *= open_.segment(first, count).array();
  if (rising >= first && rising < first + count) rate_[rising] = 1.0;
  fastest_fall_ = std::max(fastest_fall_, -rate_.segment(first, count).minCoeff());
  evaluated_.push_back(segment);
}

/// The step at which something is below zero by the slack, no longer than `longest`; the rows of an evaluated
/// segment at zero by then are added to the falling ones.
double OpenRows::scan(int segment, double longest, double falls) {
  constexpr int kTogether = 16;
  const int end = first_row(segment + 1);
  for (int first = first_row(segment); first < end; first += kTogether) {
    const int count = std::min(kTogether, end - first);
    const auto w = w_.segment(first, count).array();
    const auto rate = rate_.segment(first, count).array();
    if (longest < kInfinity && (w.max(0.0) + longest * rate).minCoeff() > 0.0) continue;
    for (int row = first; row < first + count; ++row) {
      const double value = std::max(w_[row], 0.0);
      if (!(rate_[row] < 0.0) || value > longest * -rate_[row]) continue;
      falling_.push_back(row);
      if (rate_[row] < -falls) longest = std::min(longest, (value + slack_) / -rate_[row]);
    }
  }
  return longest;
}

double OpenRows::least_of(int segment) const {
  const int first = first_row(segment);
  const int count = row_count(segment);
  // Of a segment that is held altogether a number still, from which a rate can be taken.
  constexpr double kLargest = std::numeric_limits<double>::max();
  return (open_.segment(first, count).array() > 0.0).select(w_.segment(first, count), kLargest).minCoeff();
}

void OpenRows::advance(double step) {
  ++vertex_;
  // A little more than the bounds, by what the rounding of so many differences adds up to.
  constexpr double kMore = 8 * kEpsilon;
  if (bounds_) least_.array() -= (1.0 + kMore) * step * fastest_.array() + kMore * least_.array().abs();
  for (const int segment : evaluated_) {
    w_.segment(first_row(segment), row_count(segment)) +=
        step * rate_.segment(first_row(segment), row_count(segment));
    if (bounds_) least_[segment] = least_of(segment);
    known_[static_cast<std::size_t>(segment)] = vertex_;
  }
}

}  // namespace signorini
