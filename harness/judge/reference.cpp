#include "harness/judge/reference.hpp"

#include <nlohmann/json.hpp>

#include "harness/judge/measures/motion.hpp"
#include "harness/judge/orbit.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/records/record.hpp"
#include "harness/records/record_json.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "methods/orbit/reduced/reduced_orbit.hpp"

namespace signorini {

namespace {

struct LawSetter {
  Law scene;
  Law operator()(Undetermined) const { return scene; }
  Law operator()(const auto& law) const { return law; }
};

/// Polishing at most sheds the error of the integration: a motion farther away is another one.
bool stays(const Problem& problem, const Trajectory& marched, const Trajectory& polished) {
  const Motion from = sample_motion(problem, marched);
  return distance(from, sample_motion(problem, polished)).x_l2.value_or(0.0) <= kSameOrbit;
}

}  // namespace

/// All but the motion of its orbit.
void visit_fields(Either<Reference> auto& reference, auto&& field) {
  field(Field{"reason"}, reference.reason);
  field(required("error_bar"), reference.error_bar);
  field(Field{"residual"}, reference.residual);
  field(Field{"fingerprint"}, reference.fingerprint);
  field(Field{"confirmed"}, reference.confirmed);
}

Reference compute_reference(const Problem& problem, const OrbitTools& tools, Deadline deadline) {
  std::string of_large;  // why there is no orbit by its own way, where that was tried
  if (tools.large && prefers_reduction(problem)) {
    CertifiedOrbit found = tools.large(problem, deadline);
    if (found.motion && found.error_bar <= kLargeReferenceErrorBar)
      return as_reference(problem, std::move(found));
    of_large = (found.motion ? "an orbit that is known too badly" : found.reason) + "; ";
  }
  const Start from_rest{.guess = {}, .deadline = deadline};
  const Solution marched = tools.solver(problem, marching_options(), from_rest);
  CertifiedOrbit orbit;
  if (tools.polish && marched.verdict == Verdict::converged && marched.trajectory) {
    const int order = sample_motion(problem, *marched.trajectory).order;
    orbit = tools.polish(with_subharmonic(problem, order), *marched.trajectory, {}, deadline);
    if (orbit.motion && !stays(problem, *marched.trajectory, *orbit.motion)) {
      return {.reason =
                  "marching from rest has not settled: the exact orbit nearest to where it ended is farther "
                  "away than its error bar allows"};
    }
  }
  if (!orbit.motion || orbit.error_bar > kReferenceErrorBar) {
    orbit = confirm_orbit(problem, tools.solver, marching_options(), from_rest, marched, kReferenceErrorBar);
  }
  if (!orbit.motion) return {.reason = of_large + orbit.reason};
  return as_reference(problem, std::move(orbit));
}

Reference as_reference(const Problem& problem, CertifiedOrbit orbit) {
  const Motion motion = sample_motion(problem, *orbit.motion);
  Reference reference{.orbit = std::make_shared<SampledTrajectory>(*orbit.motion, motion.count()),
                      .reason = {},
                      .error_bar = orbit.error_bar,
                      .residual = orbit.residual,
                      .fingerprint = fingerprint(motion)};
  if (orbit.return_distance) {
    reference.confirmed.push_back({.error_bar = orbit.error_bar,
                                   .events = std::move(orbit.events),
                                   .return_distance = orbit.return_distance});
  }
  return reference;
}

nlohmann::ordered_json to_json(const Reference& reference) {
  nlohmann::ordered_json json = write_fields(reference);
  if (!reference.orbit) return json;
  const auto count = static_cast<int>(reference.orbit->data().samples.x.rows());
  json["period"] = reference.orbit->period();
  json["trajectory"] = write_fields(samples_of(*reference.orbit, count));
  return json;
}

Reference reference_from_json(const nlohmann::ordered_json& json) try {
  Reference reference;
  read_fields(json, reference);
  if (reference.reason.empty()) {  // then there is an orbit
    TrajectorySamples samples;
    read_fields(json.at("trajectory"), samples);
    reference.orbit = trajectory_of(json.at("period").get<double>(), samples);
  }
  return reference;
} catch (const nlohmann::json::exception& error) {
  throw BadRecord(error.what());
}

Problem under_law(const Problem& problem, const RepresentedLaw& law) {
  Problem changed = problem;
  changed.set_law(std::visit(LawSetter{problem.law()}, law));
  return changed;
}

}  // namespace signorini
