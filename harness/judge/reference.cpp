#include "harness/judge/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "harness/judge/orbit.hpp"
#include "harness/records/record.hpp"
#include "harness/records/trajectory_json.hpp"
#include "methods/event_driven/event_driven.hpp"

namespace signorini {

namespace {

/// Two computations of a scene's reference must agree to this, relative.
constexpr double kReferenceErrorBar = 1e-9;
constexpr int kShootingSteps = 50;
constexpr int kMarchedPeriods = 20000;

struct LawSetter {
  Law scene;
  Law operator()(Undetermined) const { return scene; }
  Law operator()(const auto& law) const { return law; }
};

bool found(const Solution& solution) {
  return solution.verdict == Verdict::converged && solution.trajectory != nullptr;
}

std::string reason_of(const Solution& solution) {
  return solution.message.empty() ? "no orbit was found" : solution.message;
}

/// Polishing at most sheds the error of the integration: a motion farther away is another one.
bool stays(const Problem& problem, const Trajectory& marched, const Trajectory& polished) {
  constexpr double kDrift = 1e-6;
  const Motion from = sample_motion(problem, marched);
  return distance(from, sample_motion(problem, polished)).x_l2.value_or(0.0) <= kDrift;
}

Solution event_driven(const Problem& problem, const OrbitRequest& request) {
  EventDriven::Options options;
  options.tolerance = request.tolerance;
  options.steady = request.shooting ? EventDriven::Steady::shooting : EventDriven::Steady::marching;
  options.max_iterations = request.shooting ? kShootingSteps : kMarchedPeriods;
  const EventDriven method(options);
  const Support support = method.supports(problem);
  if (!support.ok) return Solution{.message = support.reason};
  return method.prepare(problem)->solve({.guess = request.guess, .deadline = request.deadline});
}

/// What `solver` found at kOrbitTolerance, found again at the tighter one (see find_orbit).
CheckedOrbit confirm_orbit(const Problem& problem, const OrbitSolver& solver, const OrbitRequest& request,
                           const Solution& first, double largest_error_bar) {
  if (!found(first)) return {.reason = reason_of(first)};
  // Continued at the order that was found, which marching may find to be several forcing periods.
  const Motion motion = sample_motion(problem, *first.trajectory);
  const Problem continued = with_subharmonic(problem, motion.order);
  OrbitRequest again = request;
  again.tolerance = kTightOrbitTolerance;
  again.shooting = true;
  again.guess = first.trajectory;
  Solution second = solver(continued, again);
  if (!found(second) && !request.shooting) {
    again.shooting = false;
    again.guess = request.guess;
    second = solver(problem, again);
  }
  if (!found(second)) {
    return {.reason = fmt::format("found at tolerance {:g} but not at {:g}: {}", kOrbitTolerance,
                                  kTightOrbitTolerance, second.message)};
  }
  const Motion tight = sample_motion(problem, *second.trajectory);
  // Two searches from one guess may stay at it alike: no orbit is known better than they integrate.
  const double error_bar =
      std::max(kOrbitTolerance, distance(motion, tight, best_shift(motion, tight)).x_l2.value_or(0.0));
  if (error_bar > largest_error_bar) {
    return {.reason = fmt::format("two tolerances give orbits that differ by {:.1e}", error_bar)};
  }
  return {.orbit = second.trajectory,
          .error_bar = error_bar,
          .residual = second.residual,
          .source = request.shooting ? "shooting from the answer" : "marching"};
}

}  // namespace

OrbitSolver event_driven_orbits() { return event_driven; }

CheckedOrbit find_orbit(const Problem& problem, const OrbitSolver& solver, OrbitRequest request,
                        double largest_error_bar) {
  request.tolerance = kOrbitTolerance;
  return confirm_orbit(problem, solver, request, solver(problem, request), largest_error_bar);
}

Reference compute_reference(const Problem& problem, const OrbitTools& tools,
                            std::chrono::steady_clock::time_point deadline) {
  const OrbitRequest request{
      .tolerance = kOrbitTolerance, .shooting = false, .guess = {}, .deadline = deadline};
  const Solution marched = tools.solver(problem, request);
  if (!found(marched)) return {.reason = reason_of(marched)};
  CheckedOrbit checked;
  if (tools.polish) {
    const Problem same_order = with_subharmonic(problem, sample_motion(problem, *marched.trajectory).order);
    checked = tools.polish({.problem = same_order, .answer = *marched.trajectory, .deadline = deadline});
    if (checked.orbit && !stays(problem, *marched.trajectory, *checked.orbit)) {
      return {.reason =
                  "marching from rest has not settled: the exact orbit nearest to where it ended is farther "
                  "away than its error bar allows"};
    }
  }
  if (!checked.orbit || checked.error_bar > kReferenceErrorBar)
    checked = confirm_orbit(problem, tools.solver, request, marched, kReferenceErrorBar);
  if (!checked.orbit) return {.reason = checked.reason};
  const Motion motion = sample_motion(problem, *checked.orbit);
  Reference reference{.orbit = std::make_shared<SampledTrajectory>(*checked.orbit, motion.count()),
                      .reason = {},
                      .error_bar = checked.error_bar,
                      .residual = checked.residual,
                      .fingerprint = fingerprint(motion)};
  if (checked.return_distance) {
    reference.confirmed.push_back({.error_bar = checked.error_bar,
                                   .events = std::move(checked.events),
                                   .return_distance = checked.return_distance});
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
