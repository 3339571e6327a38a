#include "methods/discretisation/gauss_rule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace signorini {

namespace {

/// Legendre's polynomial and its derivative.
struct LegendreValue {
  double value = 1.0;
  double slope = 0.0;
};

LegendreValue legendre(int degree, double x) {
  double before = 0.0;
  double value = 1.0;
  for (int k = 1; k <= degree; ++k) {
    const double next = ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k;
    before = value;
    value = next;
  }
  return {value, degree * (x * value - before) / (x * x - 1.0)};
}

GaussRule computed_rule(int count) {
  constexpr int kSteps = 10;  // from this guess three or four suffice
  GaussRule rule{Eigen::VectorXd(count), Eigen::VectorXd(count)};
  for (int i = 0; 2 * i < count; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
    if (2 * i + 1 == count) x = 0.0;
    LegendreValue p = legendre(count, x);
    double way = x;
    for (int step = 0; step < kSteps && std::abs(way) > 2.0 * std::numeric_limits<double>::epsilon();
         ++step) {
      way = p.value / p.slope;
      x -= way;
      p = legendre(count, x);
    }
    rule.nodes[i] = x;
    rule.nodes[count - 1 - i] = -x;
    rule.weights[i] = rule.weights[count - 1 - i] = 2.0 / ((1.0 - x * x) * p.slope * p.slope);
  }
  return rule;
}

}  // namespace

const GaussRule& gauss_rule(int count) {
  thread_local std::map<int, GaussRule> rules;
  const auto place = rules.find(count);
  if (place != rules.end()) return place->second;
  return rules.emplace(count, computed_rule(count)).first->second;
}

int gauss_nodes_for(double z) {
  constexpr double kMost = 1e6;
  const double bounded = z > 0.0 ? std::min(z, kMost) : 0.0;  // 0, too, where z is no number
  const double needed = bounded + 5.0 * (1.0 + std::cbrt(bounded));
  // In steps of a sixteenth or less, so that few rules are computed.
  const double step = std::max(1.0, std::exp2(std::floor(std::log2(needed)) - 4.0));
  return static_cast<int>(step * std::ceil(needed / step));
}

}  // namespace signorini
