#include "harness/judge/reference.hpp"

#include <nlohmann/json.hpp>

#include "harness/judge/motion.hpp"
#include "harness/judge/orbit.hpp"
#include "harness/records/record.hpp"
#include "harness/records/record_json.hpp"
#include "harness/records/trajectory_json.hpp"

namespace signorini {

namespace {

/// Two computations of a scene's reference must agree to this, relative.
constexpr double kReferenceErrorBar = 1e-9;

struct LawSetter {
  Law scene;
  Law operator()(Undetermined) const { return scene; }
  Law operator()(const auto& law) const { return law; }
};

/// Polishing at most sheds the error of the integration: a motion farther away is another one.
bool stays(const Problem& problem, const Trajectory& marched, const Trajectory& polished) {
  constexpr double kDrift = 1e-6;
  const Motion from = sample_motion(problem, marched);
  return distance(from, sample_motion(problem, polished)).x_l2.value_or(0.0) <= kDrift;
}

}  // namespace

Reference compute_reference(const Problem& problem, const OrbitTools& tools, Deadline deadline) {
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
  if (!orbit.motion) return {.reason = orbit.reason};
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
  nlohmann::ordered_json json;
  if (!reference.orbit) {
    json["reason"] = reference.reason;
    return json;
  }
  // As a record, so that one reader and writer of trajectories does.
  Record carrier;
  carrier.period = reference.orbit->period();
  carrier.trajectory =
      samples_of(*reference.orbit, static_cast<int>(reference.orbit->data().samples.x.rows()));
  if (!reference.confirmed.empty()) carrier.certificate = reference.confirmed.front();
  json["carrier"] = to_json(carrier);
  json["error_bar"] = reference.error_bar;
  if (reference.residual) json["residual"] = *reference.residual;
  json["fingerprint"] = reference.fingerprint;
  return json;
}

Reference reference_from_json(const nlohmann::ordered_json& json) {
  Reference reference;
  try {
    if (json.contains("reason")) {
      reference.reason = json["reason"].get<std::string>();
      return reference;
    }
    const Record carrier = record_from_json(json.at("carrier"));
    reference.orbit = trajectory_of(carrier.period.value(), carrier.trajectory.value());
    reference.error_bar = json.at("error_bar");
    if (json.contains("residual")) reference.residual = json["residual"].get<double>();
    reference.fingerprint = json.at("fingerprint");
    if (carrier.certificate.return_distance) reference.confirmed.push_back(carrier.certificate);
    return reference;
  } catch (const nlohmann::json::exception& error) {
    throw BadRecord(error.what());
  } catch (const std::bad_optional_access&) {
    throw BadRecord("reference = incomplete (must hold a trajectory with its period)");
  }
}

Problem under_law(const Problem& problem, const RepresentedLaw& law) {
  Problem changed = problem;
  changed.law = std::visit(LawSetter{problem.law}, law);
  return changed;
}

}  // namespace signorini
