// The check that with all stops out of reach a method finds the linear response.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/conformance/checks.hpp"
#include "harness/conformance/resolution_series.hpp"
#include "harness/conformance/transformations.hpp"
#include "methods/structure/periodic_response.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

namespace {

constexpr int kInstants = 1024;  // of a period of the load
/// Relative error of x at which no decay is asked for: the residual of an iterative solve [-].
constexpr double kExact = 1e-8;
/// Largest contact force without contact, relative to the load [-].
constexpr double kNoForce = 1e-9;
/// Distance of the stops in units of the largest displacement [-].
constexpr double kOutOfReach = 10.0;

/// Linear response x at the contacts over a period of the load, kInstants x Nc [m]. \throws SingularStiffness
Eigen::MatrixXd linear_response(const Problem& problem) {
  Problem linear = problem;
  linear.subharmonic = 1;
  const ContactReceptance receptance = contact_receptance(
      linear, highest_load_harmonic(linear), [&](int n) { return exact_weights(n * linear.frequency); });
  return sample_series(receptance.free_response, kInstants);
}

/// Number of periods of the load in the period of the answer, at least 1.
int load_periods(const Problem& problem, const Trajectory& answer) {
  return std::max(
      1, static_cast<int>(std::lround(answer.period() * problem.frequency / (2.0 * std::numbers::pi))));
}

/// The relative error of x at one resolution, or what is wrong with the answer.
struct LinearAnswer {
  std::optional<double> error = {};
  std::string defect = {};
};

LinearAnswer linear_answer(const CheckedMethod& checked, const Problem& open,
                           const Eigen::MatrixXd& response) {
  const Solution solution = checked.solve(open);
  if (solution.verdict != Verdict::converged || !solution.trajectory)
    return {.defect = "with the stops out of reach it does not converge: " + solution.message};
  const int periods = load_periods(open, *solution.trajectory);
  const Samples samples = solution.trajectory->sample(periods * kInstants);
  if (samples.x.cols() != response.cols())
    return {.defect = "its trajectory has the wrong number of contacts"};
  if (!solution.trajectory->impulses().empty())
    return {.defect = "it finds impulses where no stop is in reach"};
  if (samples.force.cwiseAbs().maxCoeff() > kNoForce * load_scale(open))
    return {.defect = "it finds contact forces where no stop is in reach"};
  const Eigen::MatrixXd expected = response.replicate(periods, 1);
  return {.error = (samples.x - expected).norm() / expected.norm()};
}

}  // namespace

CheckResult check_contact_free(const CheckedMethod& checked) {
  if (auto refusal = unless_supported(checked)) return *refusal;
  if (checked.problem().contacts.empty()) return not_applicable("there is no contact to look at");
  Eigen::MatrixXd response;
  try {
    response = linear_response(checked.problem());
  } catch (const SingularStiffness&) {
    return not_applicable("without its stops the structure has no periodic response");
  }
  const double largest = response.cwiseAbs().maxCoeff();
  if (!(largest > 0.0)) return not_applicable("without contact nothing moves");
  const Problem open = with_stops_at(checked.problem(), kOutOfReach * largest);
  const std::vector<Settings> ladder = usable_ladder(checked.entry());
  for (const ResolutionSeries& series : resolution_series(ladder)) {
    std::vector<ResolutionStep> steps;
    for (std::size_t i = 0; i < series.places.size(); ++i) {
      const Settings& settings = ladder[series.places[i]];
      const CheckedMethod resolved = checked.with(settings);
      if (!resolved.support().ok) continue;
      const LinearAnswer one = linear_answer(resolved, open, response);
      const std::string label = MethodChoice{&checked.entry(), settings}.label();
      if (!one.error) return failed(label + ": " + one.defect);
      steps.push_back({.size = series.sizes[i], .error = *one.error});
    }
    CheckResult result = check_error_decay(steps, checked.entry().order, kExact);
    if (result.outcome == CheckOutcome::failed) result.why = "with the stops out of reach, " + result.why;
    if (result.outcome != CheckOutcome::passed) return result;
  }
  return passed();
}

}  // namespace signorini
