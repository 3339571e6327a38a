#include "methods/harmonic_balance/harmonic_continuation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/complementarity/exact_quadrature.hpp"
#include "methods/harmonic_balance/harmonic_options.hpp"
#include "methods/solvers/constants.hpp"
#include "methods/solvers/homotopy.hpp"

namespace signorini {

namespace {

constexpr int kStartUnknowns = 800;  // harmonics times contacts: pivots grow with both
// Of the way to twice the harmonics at the full constant, which each point found is tried from at once.
constexpr PathSteps kHarmonicSteps{.growth = kInfinity, .trials = 20};

/// lambda with zeros for the harmonics that it lacks.
Eigen::MatrixXcd padded(Eigen::MatrixXcd lambda, int harmonics) {
  lambda.conservativeResizeLike(Eigen::MatrixXcd::Zero(harmonics + 1, lambda.cols()));
  return lambda;
}

}  // namespace

ContactReceptance truncated(const ContactReceptance& receptance, int harmonics) {
  const auto count = std::min(harmonics, receptance.harmonics()) + 1;
  return {receptance.period,
          {receptance.receptance.begin(), receptance.receptance.begin() + count},
          receptance.free_response.topRows(count),
          receptance.rigid,
          receptance.rigid_load};
}

ContinuationPoint continuation_start(const ContactReceptance& receptance) {
  int loaded = 0;
  for (int n = 0; n <= receptance.harmonics(); ++n) {
    if (receptance.free_response.row(n).cwiseAbs().maxCoeff() > 0.0) loaded = n;
  }
  const int affordable =
      std::clamp(kStartUnknowns / std::max(1, receptance.contacts()), 5, kDefaultHarmonics);
  const int harmonics = std::max(affordable, 2 * loaded);
  if (harmonics >= receptance.harmonics()) return {};
  return {.harmonics = harmonics, .stiffness_factor = 1.0 / 16.0};
}

ExactProjection continue_in_harmonics(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                                      const LawAt& law_at, const ContinuationPoint& start,
                                      Eigen::MatrixXcd lambda, double tolerance, const Start& budget) {
  const int all = receptance.harmonics();
  ContinuationPoint here = start;
  ContinuationPoint next = start;
  ExactProjection end;
  int iterations = 0;
  // Halfway back in log H and log c.
  const auto halfway = [&]() -> ContinuationPoint {
    return {static_cast<int>(std::sqrt(static_cast<double>(here.harmonics) * next.harmonics)),
            std::sqrt(here.stiffness_factor * next.stiffness_factor)};
  };
  // A step that adds no harmonic and stiffens by less than 5 % is the end.
  const auto stalls = [&] {
    const ContinuationPoint back = halfway();
    const bool failed = next.harmonics > here.harmonics || next.stiffness_factor > here.stiffness_factor;
    return failed && back.harmonics == here.harmonics && back.stiffness_factor < 1.05 * here.stiffness_factor;
  };
  const auto advance = [&](double step) {
    next = step < 1.0 ? halfway() : ContinuationPoint{std::min(all, 2 * here.harmonics), 1.0};
    const ContactReceptance level = truncated(receptance, next.harmonics);
    const ProjectedLaw law = with_stiffness_factor(law_at(level), next.stiffness_factor);
    ExactProjection exact = project_exactly(
        {level, gap, law}, padded(lambda, next.harmonics),
        {.samples = kResolvingSamples * next.harmonics, .tolerance = tolerance, .deadline = budget.deadline});
    iterations += exact.iterations;
    if (!exact.converged) return false;
    here = next;
    lambda = exact.lambda;
    end = std::move(exact);
    return true;
  };
  const bool reached = follow_path(
      kHarmonicSteps, advance, [&] { return here.harmonics == all && here.stiffness_factor == 1.0; },
      [&] { return budget.expired() || stalls(); });
  if (!reached) end = {.lambda = {}};
  end.iterations = iterations;
  return end;
}

}  // namespace signorini
