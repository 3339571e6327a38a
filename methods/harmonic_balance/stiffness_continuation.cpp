#include "methods/harmonic_balance/stiffness_continuation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "methods/solvers/constants.hpp"
#include "methods/solvers/homotopy.hpp"

namespace signorini {

namespace {

constexpr double kFirst = 1.0 / 16.0;  // r: contacts last for about four times as long as in the end
constexpr double kSoftest = 1e-8;
constexpr PathSteps kStiffnessSteps{
    .first = 1.0, .largest = 4.0, .smallest = 0.07, .growth = 1.5};  // in log2 r

}  // namespace

ExactProjection continue_in_stiffness(const ProjectedEquations& equations, Eigen::MatrixXcd lambda,
                                      const ExactProjectionSettings& settings) {
  int iterations = 0;
  // The solution with springs of r c, from the last one; none where Newton's method does not find it.
  const auto solve = [&](double ratio) -> std::optional<ExactProjection> {
    const bool own = ratio == kInfinity;
    const ProjectedLaw law = own ? equations.law : on_springs(equations.law, ratio);
    ExactProjectionSettings limits = settings;
    limits.most = 15;
    if (!own) limits.tolerance = std::max(1e-6, settings.tolerance);
    ExactProjection found = project_exactly({equations.receptance, equations.gap, law}, lambda, limits);
    iterations += found.iterations;
    if (!found.converged) return std::nullopt;
    lambda = found.lambda;
    return found;
  };
  const auto expired = [&] { return settings.deadline.passed(); };
  double solved = 0.0;  // r of the last solution; 0: none yet
  for (double ratio = kFirst; solved == 0.0 && ratio >= kSoftest && !expired(); ratio *= kFirst)
    if (solve(ratio)) solved = ratio;
  double stiffest = 10.0;  // behind which the stops' own law is tried; at 1e6 there is no spring any more
  std::optional<ExactProjection> rigid;
  const auto advance = [&](double step) {
    const double next = solved * std::exp2(step);
    if (next > stiffest) {
      rigid = solve(kInfinity);
      if (rigid || stiffest >= 1e6) return rigid.has_value();
      stiffest /= kFirst;
    }
    if (!solve(next)) return false;
    solved = next;
    return true;
  };
  if (solved > 0.0)
    follow_path(
        kStiffnessSteps, advance, [&] { return rigid.has_value(); }, expired);
  if (!rigid) rigid = ExactProjection{.residual = kInfinity, .lambda = {}};
  rigid->iterations = iterations;
  return *std::move(rigid);
}

}  // namespace signorini
