// With the stops out of reach every method must find the linear response.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/conformance/answers.hpp"
#include "harness/conformance/checks.hpp"
#include "harness/conformance/fall.hpp"
#include "methods/structure/periodic_response.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

namespace {

constexpr int kInstants = 1024;  // of a period of the load
/// Relative to the response: what solves by iteration may stop here.
constexpr double kExact = 1e-8;
/// Of a force that must not be there, relative to the load.
constexpr double kNoForce = 1e-9;
/// Stops stand at this many times the largest displacement.
constexpr double kOutOfReach = 10.0;

/// x at the contacts without contact over a period of the load, kInstants x Nc [m]. \throws SingularStiffness
Eigen::MatrixXd linear_response(const Problem& problem) {
  Problem linear = problem;
  linear.subharmonic = 1;
  const ContactReceptance receptance = contact_receptance(
      linear, highest_load_harmonic(linear), [&](int n) { return exact_weights(n * linear.frequency); });
  return sample_series(receptance.free_response, kInstants);
}

/// Periods of the load in that of the answer, at least 1.
int load_periods(const Problem& problem, const Trajectory& answer) {
  return std::max(
      1, static_cast<int>(std::lround(answer.period() * problem.frequency / (2.0 * std::numbers::pi))));
}

/// The relative error of one resolution, or what is wrong with its answer.
struct Reached {
  std::optional<double> error = {};
  std::string defect = {};
};

Reached reached(const Subject& subject, const Problem& open, const Eigen::MatrixXd& response) {
  const Solution solution = subject.solve(open);
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

CheckResult check_contact_free(const Subject& subject) {
  if (auto refusal = why_not(subject)) return *refusal;
  if (subject.problem().contacts.empty()) return not_applicable("there is no contact to look at");
  Eigen::MatrixXd response;
  try {
    response = linear_response(subject.problem());
  } catch (const SingularStiffness&) {
    return not_applicable("without its stops the structure has no periodic response");
  }
  const double largest = response.cwiseAbs().maxCoeff();
  if (!(largest > 0.0)) return not_applicable("without contact nothing moves");
  const Problem open = with_stops_at(subject.problem(), kOutOfReach * largest);
  const std::vector<Settings> ladder = usable_ladder(subject.entry());
  for (const LadderBranch& branch : branches_of(ladder)) {
    std::vector<LadderStep> steps;
    for (std::size_t i = 0; i < branch.places.size(); ++i) {
      const Settings& settings = ladder[branch.places[i]];
      const Subject resolved = subject.with(settings);
      if (!resolved.support().ok) continue;
      const Reached one = reached(resolved, open, response);
      const std::string label = MethodChoice{&subject.entry(), settings}.label();
      if (!one.error) return failed(label + ": " + one.defect);
      steps.push_back({.size = branch.sizes[i], .error = *one.error});
    }
    CheckResult result = judge_fall(steps, subject.entry().order, kExact);
    if (result.outcome == CheckOutcome::failed) result.why = "with the stops out of reach, " + result.why;
    if (result.outcome != CheckOutcome::passed) return result;
  }
  return passed();
}

}  // namespace signorini
