#include "methods/harmonic_balance/continuation/series_point.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <vector>

#include "methods/discretisation/fourier_series.hpp"
#include "methods/linear_flow/linear_flow.hpp"
#include "methods/solvers/bracketed_zero.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

namespace {

/// The extremum of y near `t`, between the samples beside it, by Newton's method on y': the best of its
/// steps.
double polished_extremum(const Eigen::VectorXcd& y, double t, double spacing) {
  const Jet first = trigonometric_jet(y, t);
  const double side = first.curvature < 0.0 ? 1.0 : -1.0;
  double best = first.value;
  const auto slope = [&](double at) {
    const Jet jet = trigonometric_jet(y, at);
    if (side * jet.value > side * best) best = jet.value;
    return ValueAndSlope{jet.slope, jet.curvature};
  };
  // Shares of the period: y is flat there.
  newton_zero_near(slope, {.guess = t, .reach = spacing, .settled = 1e-12});
  return best;
}

int phases_of_contact(const SeriesCurve& curve) {
  std::size_t count = 0;
  for (const std::vector<ContactInterval>& pressing : curve.contacts())
    count += contact_phases(pressing, 1.0 / curve.harmonics()).size();
  return static_cast<int>(count);
}

/// Whether one contact presses at an instant, a share of the period.
bool presses(const std::vector<ContactInterval>& intervals, double t) {
  return std::any_of(intervals.begin(), intervals.end(), [&](const ContactInterval& interval) {
    return (t > interval.begin && t < interval.end) || (t + 1.0 > interval.begin && t + 1.0 < interval.end);
  });
}

/// Where any contact begins or ends to press, with 0 and 1, ascending.
std::vector<double> instants_of_change(const SeriesCurve& curve) {
  std::vector<double> instants{0.0, 1.0};
  for (const std::vector<ContactInterval>& pressing : curve.contacts()) {
    for (const ContactInterval& interval : pressing) {
      if (interval.end - interval.begin >= 1.0) continue;  // at all times
      instants.push_back(interval.begin - std::floor(interval.begin));
      instants.push_back(interval.end - std::floor(interval.end));
    }
  }
  std::sort(instants.begin(), instants.end());
  return instants;
}

/// The scene with the method's spring for its stops; without contacts at all where none presses. Empty where
/// the method's law is no spring.
std::optional<Problem> sprung_scene(const SeriesCurve& curve) {
  const bool pressed =
      std::any_of(curve.contacts().begin(), curve.contacts().end(), [](const auto& c) { return !c.empty(); });
  Problem sprung = curve.problem();
  const Eigen::ArrayXd softness = 1.0 - curve.law().multiplier_weight.array();
  if (pressed && !(softness > 0.0).all()) return std::nullopt;
  Penalty springs;
  for (Eigen::Index j = 0; j < softness.size(); ++j)
    springs.stiffness.push_back(pressed ? curve.law().constant[j] / softness[j] : 1.0);
  sprung.set_law(std::move(springs));
  return sprung;
}

/// dy(T) / dy(0) along the contacts of the series, 2 Nd x 2 Nd; empty where it is not known.
Eigen::MatrixXd monodromy(const SeriesCurve& curve) {
  const std::vector<bool> massive = contacts_with_mass(curve.problem());
  const bool all = std::all_of(massive.begin(), massive.end(), [](bool mass) { return mass; });
  if (curve.problem().size() > kMostForMultipliers || !all) return {};
  const std::optional<Problem> sprung = sprung_scene(curve);
  if (!sprung) return {};
  try {
    const ContactDynamics dynamics(*sprung);
    LinearFlows flows(dynamics);
    Eigen::MatrixXd M = Eigen::MatrixXd::Identity(2 * dynamics.size(), 2 * dynamics.size());
    const std::vector<double> instants = instants_of_change(curve);
    for (std::size_t i = 0; i + 1 < instants.size(); ++i) {
      if (instants[i + 1] == instants[i]) continue;
      std::vector<bool> closed;
      for (const auto& pressing : curve.contacts())
        closed.push_back(presses(pressing, 0.5 * (instants[i] + instants[i + 1])));
      M = product(flows.of(closed).transition((instants[i + 1] - instants[i]) * sprung->period()), M);
    }
    return M;
  } catch (const std::exception&) {
    return {};  // no flow of this structure
  }
}

OrbitStability stability_of(const SeriesCurve& curve, const Eigen::VectorXcd& multipliers) {
  if (multipliers.size() == 0) return OrbitStability::unknown;
  const Eigen::ArrayXd sizes = multipliers.cwiseAbs();
  if (curve.problem().damping().norm() == 0.0 && (sizes - 1.0).abs().maxCoeff() <= kOnCircle)
    return OrbitStability::elliptic;
  return sizes.maxCoeff() < 1.0 - kMultiplierRounding ? OrbitStability::stable : OrbitStability::unstable;
}

}  // namespace

std::pair<double, double> extremes_of(const Eigen::VectorXcd& y) {
  const int count = kResolvingSamples * std::max<int>(static_cast<int>(y.size()) - 1, 1);
  const Eigen::VectorXd values = sample_series(y, count);
  double least = values[0], largest = values[0];
  for (int i = 0; i < count; ++i) {
    const double before = values[(i + count - 1) % count], after = values[(i + 1) % count];
    const bool high = values[i] >= before && values[i] >= after;
    const bool low = values[i] <= before && values[i] <= after;
    if (!high && !low) continue;
    const double value = polished_extremum(y, static_cast<double>(i) / count, 1.0 / count);
    least = std::min(least, value);
    largest = std::max(largest, value);
  }
  return {least, largest};
}

SolutionPoint solution_point(const SeriesCurve& curve) {
  SolutionPoint point{.parameter = curve.frequency(),
                      .frequency = curve.frequency(),
                      .order = curve.order(),
                      .impacts = phases_of_contact(curve)};
  for (Eigen::Index c = 0; c < curve.motion().cols(); ++c) {
    const auto [least, largest] = extremes_of(curve.motion().col(c));
    point.x_max.push_back(largest);
    point.amplitude.push_back(0.5 * (largest - least));
  }
  const Eigen::MatrixXd M = monodromy(curve);
  if (M.size() > 0) point.multipliers = general_eigenvalues(M);
  point.stability = stability_of(curve, point.multipliers);
  return point;
}

}  // namespace signorini
