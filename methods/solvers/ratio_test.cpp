#include "methods/solvers/ratio_test.hpp"

#include <algorithm>

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
