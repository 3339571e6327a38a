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
constexpr double kStiffest = 10.0;  // behind which the stops' own law is tried, first
constexpr double kNoSpring = 1e6;
constexpr PathSteps kStiffnessSteps{
    .first = 1.0, .largest = 4.0, .smallest = 0.07, .growth = 1.5};  // in log2 r

/// The solves of one continuation.
class Springs {
 public:
  Springs(const ProjectedEquations& equations, Eigen::MatrixXcd lambda,
          const ExactProjectionSettings& settings)
      : equations_(equations), settings_(settings), lambda_(std::move(lambda)) {}

  [[nodiscard]] int iterations() const { return iterations_; }

  /// The solution with springs of r c, from the last one; none where Newton's method does not find it.
  std::optional<ExactProjection> solve(double ratio) {
    const bool own = ratio == kInfinity;
    const ProjectedLaw law = own ? equations_.law : on_springs(equations_.law, ratio);
    ExactProjectionSettings settings = settings_;
    settings.most = 15;
    if (!own) settings.tolerance = std::max(1e-6, settings_.tolerance);
    ExactProjection solved = project_exactly({equations_.receptance, equations_.gap, law}, lambda_, settings);
    iterations_ += solved.iterations;
    if (!solved.converged) return std::nullopt;
    lambda_ = solved.lambda;
    return solved;
  }

  [[nodiscard]] bool expired() const { return settings_.deadline.passed(); }

 private:
  const ProjectedEquations& equations_;
  ExactProjectionSettings settings_;
  Eigen::MatrixXcd lambda_;
  int iterations_ = 0;
};

/// r of the first solution; 0 where there is none.
double soften(Springs& springs) {
  for (double ratio = kFirst; ratio >= kSoftest && !springs.expired(); ratio *= kFirst) {
    if (springs.solve(ratio)) return ratio;
  }
  return 0.0;
}

}  // namespace

ExactProjection continue_in_stiffness(const ProjectedEquations& equations, Eigen::MatrixXcd lambda,
                                      const ExactProjectionSettings& settings) {
  Springs springs(equations, std::move(lambda), settings);
  double solved = soften(springs);
  double stiffest = kStiffest;
  std::optional<ExactProjection> rigid;
  const auto advance = [&](double step) {
    const double next = solved * std::exp2(step);
    if (next > stiffest) {
      rigid = springs.solve(kInfinity);
      if (rigid || stiffest >= kNoSpring) return rigid.has_value();
      stiffest /= kFirst;
    }
    if (!springs.solve(next)) return false;
    solved = next;
    return true;
  };
  if (solved > 0.0)
    follow_path(
        kStiffnessSteps, advance, [&] { return rigid.has_value(); }, [&] { return springs.expired(); });
  if (!rigid) rigid = ExactProjection{.residual = kInfinity, .lambda = {}};
  rigid->iterations = springs.iterations();
  return *std::move(rigid);
}

}  // namespace signorini
