#include "methods/solvers/rank_one.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

constexpr long double kRounding = std::numeric_limits<long double>::epsilon();

// A root as its distance from a pole.
struct Root {
  std::size_t base = 0;
  long double distance = 0.0L;
};

// 1 + sum_i w_i / (p_i - x), w_i > 0, which rises from one pole to the next.
class SecularFunction {
 public:
  SecularFunction(std::vector<long double> poles, std::vector<long double> weights)
      : poles_(std::move(poles)), weights_(std::move(weights)) {}

  // p_i - x.
  [[nodiscard]] long double from(std::size_t i, const Root& x) const {
    return (poles_[i] - poles_[x.base]) - x.distance;
  }
  [[nodiscard]] long double value(const Root& x) const { return poles_[x.base] + x.distance; }

  // The root above pole j: between low and high, from the nearer of the two poles beside it.
  [[nodiscard]] std::optional<Root> root(std::size_t j) const {
    constexpr int kMost = 100;
    const bool last = j + 1 == poles_.size();
    long double low = 0.0L, high = std::accumulate(weights_.begin(), weights_.end(), 0.0L);
    if (!last) high = 0.5L * (poles_[j + 1] - poles_[j]);
    Root x{.base = j, .distance = last ? 0.5L * high : high};
    if (!last && sums(j, x).total() < 0.0L) {
      low = -high;
      high = 0.0L;
      x = {.base = j + 1, .distance = low};
    }
    for (int step = 0; step < kMost; ++step) {
      const Sums f = sums(j, x);
      const long double total = f.total();
      if (!std::isfinite(total)) return std::nullopt;
      if (std::abs(total) <= kRounding * (1.0L + f.above - f.below)) return x;
      (total < 0.0L ? low : high) = x.distance;
      long double next = x.distance + step_from(j, x, f);
      if (!(next > low && next < high)) next = 0.5L * (low + high);
      const bool still = std::abs(next - x.distance) <= kRounding * std::abs(next);
      x.distance = next;
      if (still) return x;
    }
    return std::nullopt;
  }

 private:
  // Of the terms up to pole j and of those above it, with their derivatives.
  struct Sums {
    long double below = 0.0L, below_slope = 0.0L, above = 0.0L, above_slope = 0.0L;
    [[nodiscard]] long double total() const { return 1.0L + below + above; }
  };

  [[nodiscard]] Sums sums(std::size_t j, const Root& x) const {
    Sums f;
    for (std::size_t i = 0; i < poles_.size(); ++i) {
      const long double inverse = 1.0L / from(i, x), term = weights_[i] * inverse;
      (i <= j ? f.below : f.above) += term;
      (i <= j ? f.below_slope : f.above_slope) += term * inverse;
    }
    return f;
  }

  // To the root of what has the values and slopes of both sums, each a constant and the pole next to it.
  [[nodiscard]] long double step_from(std::size_t j, const Root& x, const Sums& f) const {
    const long double left = from(j, x), left_weight = f.below_slope * left * left;
    const long double below = 1.0L + f.below - f.below_slope * left;
    if (j + 1 == poles_.size()) return left + left_weight / below;
    const long double right = from(j + 1, x), right_weight = f.above_slope * right * right;
    const long double constant = below + f.above - f.above_slope * right;
    const long double a = constant * (left + right) + left_weight + right_weight,
                      b = f.total() * left * right;
    const long double root = std::sqrt(std::max(0.0L, a * a - 4.0L * b * constant));
    return a <= 0.0L ? (a - root) / (2.0L * constant) : 2.0L * b / (a + root);
  }

  std::vector<long double> poles_, weights_;
};

// A value: of a pole that stays, or of a root.
struct Found {
  long double value = 0.0L;
  Eigen::Index pole = -1;
  Root root = {};
};

}  // namespace

std::optional<RankOneEigenpairs> add_rank_one(const std::vector<long double>& poles, const Eigen::VectorXd& z,
                                              double strength) {
  constexpr long double kNear = 1e-12L;  // of two poles
  const double least = kEpsilon * z.lpNorm<Eigen::Infinity>();
  std::vector<Found> found;
  std::vector<Eigen::Index> pushed;
  std::vector<long double> pushed_poles, weights;
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    const long double pole = poles[static_cast<std::size_t>(i)], share = z[i];
    if (std::abs(z[i]) <= least) {
      found.push_back({.value = pole, .pole = i});
      continue;
    }
    if (!pushed.empty() && !(pole - pushed_poles.back() > kNear * pole)) return std::nullopt;
    pushed.push_back(i);
    pushed_poles.push_back(pole);
    weights.push_back(strength * share * share);
  }
  const SecularFunction secular(std::move(pushed_poles), std::move(weights));
  for (std::size_t j = 0; j < pushed.size(); ++j) {
    const std::optional<Root> root = secular.root(j);
    if (!root) return std::nullopt;
    found.push_back({.value = secular.value(*root), .root = *root});
  }
  std::ranges::sort(found, {}, &Found::value);
  RankOneEigenpairs pairs{.values = {}, .vectors = Eigen::MatrixXd::Zero(z.size(), z.size())};
  std::vector<long double> vector(pushed.size());
  for (const Found& one : found) {
    auto column = pairs.vectors.col(std::ssize(pairs.values));
    pairs.values.push_back(one.value);
    if (one.pole >= 0) {
      column[one.pole] = 1.0;
      continue;
    }
    long double square = 0.0L;
    for (std::size_t i = 0; i < pushed.size(); ++i) {
      vector[i] = z[pushed[i]] / secular.from(i, one.root);
      square += vector[i] * vector[i];
    }
    const long double factor = 1.0L / std::sqrt(square);
    if (!(factor > 0.0L)) return std::nullopt;
    for (std::size_t i = 0; i < pushed.size(); ++i)
      column[pushed[i]] = static_cast<double>(factor * vector[i]);
  }
  return pairs;
}

}  // namespace signorini
