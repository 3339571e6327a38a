#include "methods/harmonic_balance/harmonic_continuation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/complementarity/exact_quadrature.hpp"

namespace signorini {

namespace {

constexpr int kStartHarmonics = 20;
constexpr int kFewestHarmonics = 5;
constexpr int kStartUnknowns = 800;  // harmonics times contacts: pivots grow with both
constexpr double kStartFactor = 1.0 / 16.0;
constexpr double kGrowth = 2.0;  // of the harmonics where Newton follows
constexpr int kContinuationSteps = 20;

/// lambda with zeros for the harmonics that it lacks.
Eigen::MatrixXcd extended(const Eigen::MatrixXcd& lambda, int harmonics) {
  Eigen::MatrixXcd longer = Eigen::MatrixXcd::Zero(harmonics + 1, lambda.cols());
  const Eigen::Index common = std::min(longer.rows(), lambda.rows());
  longer.topRows(common) = lambda.topRows(common);
  return longer;
}

}  // namespace

ContactReceptance truncated(const ContactReceptance& receptance, int harmonics) {
  const auto count = std::min(harmonics, receptance.harmonics()) + 1;
  return {receptance.period,
          {receptance.receptance.begin(), receptance.receptance.begin() + count},
          receptance.free_response.topRows(count)};
}

ContinuationPoint continuation_start(const ContactReceptance& receptance) {
  int loaded = 0;
  for (int n = 0; n <= receptance.harmonics(); ++n) {
    if (receptance.free_response.row(n).cwiseAbs().maxCoeff() > 0.0) loaded = n;
  }
  const int affordable =
      std::clamp(kStartUnknowns / std::max(1, receptance.contacts()), kFewestHarmonics, kStartHarmonics);
  const int harmonics = std::max(affordable, 2 * loaded);
  if (harmonics >= receptance.harmonics()) return {};
  return {harmonics, kStartFactor};
}

ExactProjection continue_in_harmonics(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                                      const LawAt& law_at, const ContinuationPoint& start,
                                      Eigen::MatrixXcd lambda, double tolerance, const Start& budget) {
  const int all = receptance.harmonics();
  const auto grown = [all](int harmonics) {
    return std::min(all, static_cast<int>(std::ceil(kGrowth * harmonics)));
  };
  int iterations = 0;
  ContinuationPoint here = start;
  ContinuationPoint next{grown(here.harmonics), 1.0};
  for (int trial = 0; trial < kContinuationSteps && !budget.expired(); ++trial) {
    const ContactReceptance level = truncated(receptance, next.harmonics);
    const ProjectedLaw law = with_stiffness_factor(law_at(level), next.stiffness_factor);
    ExactProjection exact = project_exactly(
        {level, gap, law}, extended(lambda, next.harmonics),
        {.samples = kResolvingSamples * next.harmonics, .tolerance = tolerance, .deadline = budget.deadline});
    iterations += exact.iterations;
    if (exact.converged) {
      here = next;
      if (here.harmonics == all && here.stiffness_factor == 1.0) {
        exact.iterations = iterations;
        return exact;
      }
      lambda = std::move(exact.lambda);
      next = {grown(here.harmonics), 1.0};
    } else {
      // Halfway back in log H and log c. A step that adds no harmonic and stiffens by less than 5 % is the
      // end.
      const int halfway = static_cast<int>(std::sqrt(static_cast<double>(here.harmonics) * next.harmonics));
      const double softer = std::sqrt(here.stiffness_factor * next.stiffness_factor);
      if (halfway == here.harmonics && softer < 1.05 * here.stiffness_factor) break;
      next = {halfway, softer};
    }
  }
  return {.iterations = iterations, .lambda = {}};
}

}  // namespace signorini
