#include "harness/judge/exact_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <exception>
#include <functional>
#include <map>
#include <new>
#include <stdexcept>
#include <utility>

#include "harness/judge/orbit.hpp"
#include "methods/discretisation/periodic_time.hpp"
#include "methods/orbit/exact_orbit.hpp"
#include "methods/orbit/reduced/reduced_orbit.hpp"
#include "methods/orbit/return_check.hpp"
#include "problems/linear_algebra/general_eigen.hpp"

namespace signorini {

namespace {

constexpr int kNormInstants = 4096;

/// Those of every contact that changes or strikes; what a resting one passes on is none of its own.
std::vector<OrbitEvent> events_of(const ExactTrajectory& orbit) {
  std::vector<OrbitEvent> events;
  std::map<int, bool> closed;  // of the contacts that act
  const std::vector<int> acting = orbit.acting_contacts();
  for (std::size_t j = 0; j < acting.size(); ++j) closed[acting[j]] = orbit.orbit().start.closed[j];
  const double start = orbit.orbit().start.time, period = orbit.period();
  std::vector<ContactEvent> listed = orbit.events().value_or(std::vector<ContactEvent>{});
  std::ranges::stable_sort(
      listed, {}, [&](const ContactEvent& event) { return wrapped_time(event.time - start, period); });
  for (const ContactEvent& event : listed) {
    const bool passes_on = event.kind == ContactEvent::Kind::impact && closed[event.contact];
    if (event.kind != ContactEvent::Kind::impact)
      closed[event.contact] = event.kind == ContactEvent::Kind::close;
    if (passes_on) continue;
    events.push_back({.time = event.time, .contact = event.contact, .kind = event.kind});
    if (event.impulse != 0.0) events.back().value = event.impulse;
  }
  std::ranges::stable_sort(events, {}, &OrbitEvent::time);
  return events;
}

/// The error bar of the motion, relative to X, as one of x in the mean square; of contacts at rest, whose x
/// is rounding about its mean wherever the origin is, relative to X.
double relative_error_bar(const ExactOrbit& orbit, const Trajectory& motion, double displacement_scale) {
  const Samples samples = motion.sample(kNormInstants);
  if (samples.x.size() == 0) return orbit.error_bar;
  constexpr double kAtRest = 1e-12;  // of X
  const double norm = std::sqrt((samples.x.rowwise() - samples.x.colwise().mean()).array().square().mean());
  return norm > kAtRest * displacement_scale ? orbit.error_bar * displacement_scale / norm : orbit.error_bar;
}

/// True if small disturbances decay; empty where no multiplier is defined or round-off would decide.
std::optional<bool> stability(const ExactOrbit& orbit) {
  constexpr double kUndecided = 1e-9;
  if (orbit.multipliers.values.size() == 0) return std::nullopt;
  const double largest = largest_magnitude(orbit.multipliers.values);
  if (std::abs(largest - 1.0) <= std::max(kUndecided, orbit.error_bar)) return std::nullopt;
  return largest < 1.0;
}

void take_multipliers(const ExactOrbit& found, CertifiedOrbit& orbit) {
  const auto& [values, undefined, orders] = found.multipliers;
  if (!undefined.empty()) orbit.undefined = describe_orders(found.multipliers);
  for (const ImpactOrder& order : orders) orbit.orders.push_back({order.contacts, order.largest});
  if (values.size() > 0) orbit.floquet.emplace();
  for (const std::complex<double>& multiplier : values)
    orbit.floquet->emplace_back(multiplier.real(), multiplier.imag());
  orbit.stable = stability(found);
  orbit.stability = stability_word(orbit.stable, orbit.undefined);
}

/// True if two orbits have the same events, each within the error bars of both: times in periods, impulses
/// against the largest. The instants of weak events are known some hundred times less well than the motion.
bool same_events(const CertifiedOrbit& orbit, const Certificate& other, double period) {
  constexpr double kErrorBars = 100.0;
  const double allowed = kErrorBars * (orbit.error_bar + other.error_bar.value_or(0.0));
  const double largest = largest_impulse(orbit.events);
  const auto same = [&](const OrbitEvent& a, const OrbitEvent& b) {
    return a.contact == b.contact && a.kind == b.kind &&
           std::abs(std::remainder(a.time - b.time, period)) <= allowed * period &&
           std::abs(a.value.value_or(0.0) - b.value.value_or(0.0)) <= allowed * largest;
  };
  return std::equal(orbit.events.begin(), orbit.events.end(), other.events.begin(), other.events.end(), same);
}

/// How far away CVODE returned on an orbit confirmed before. Between its events a motion is linear, so that
/// two orbits with the same events are one; without events, nothing names it.
std::optional<double> known_return(const CertifiedOrbit& orbit, std::span<const Certificate> confirmed,
                                   double period) {
  if (orbit.events.empty()) return std::nullopt;
  for (const Certificate& other : confirmed) {
    if (same_events(orbit, other, period)) return other.return_distance;
  }
  return std::nullopt;
}

/// Whether what is no orbit fails by so little that one may be there: an impact grazes, or a stop is passed
/// by less than the least approach that an impact has.
bool almost_an_orbit(const ExactOrbit& found) {
  constexpr double kHardly = 1e-6;  // of the motion
  return found.outcome == OrbitOutcome::grazing ||
         (found.outcome == OrbitOutcome::not_admissible && found.admissibility.violation <= kHardly);
}

CertifiedOrbit polish(const Problem& problem, const Trajectory& answer,
                      std::span<const Certificate> confirmed, Deadline deadline) {
  const auto expired = [deadline] { return deadline.passed(); };
  OrbitFinder finder(problem);
  SearchOptions options;
  options.polish.second_evaluation = true;
  options.free_families = FreeFamilies::first;  // it claims that nothing touches
  options.expired = expired;
  const OrbitSearch search = finder.find(answer, options);
  const ExactOrbit& found = search.orbit;
  if (!found.certified()) {
    return {.reason = found.reason.empty() ? describe(found.outcome)
                                           : describe(found.outcome) + ": " + found.reason,
            .unconfirmed = almost_an_orbit(found) ? found.trajectory : nullptr};
  }
  const ContactDynamics& dynamics = finder.model()->dynamics;
  CertifiedOrbit orbit{.motion = found.trajectory, .residual = found.residual};
  orbit.error_bar = relative_error_bar(found, *found.trajectory, dynamics.scales().displacement);
  orbit.source =
      found.outcome == OrbitOutcome::chatter ? "exact orbit with a complete chatter" : "exact orbit";
  orbit.events = events_of(*found.trajectory);
  orbit.return_distance = known_return(orbit, confirmed, problem.period());
  if (!orbit.return_distance) {
    try {
      const ReturnCheck check = cvode_return(dynamics, *found.trajectory, expired);
      if (!check.returned) {
        return {.reason = fmt::format(
                    "an exact orbit, but CVODE returns {:.1e} away from it where {:.1e} is allowed",
                    check.distance, check.allowed),
                .unconfirmed = found.trajectory};
      }
      orbit.return_distance = check.distance;
    } catch (const std::runtime_error& error) {  // the flow fails, or the time is up
      return {.reason = fmt::format("an exact orbit, but CVODE does not follow it: {}", error.what()),
              .unconfirmed = found.trajectory};
    }
  }
  take_multipliers(found, orbit);
  return orbit;
}

/// From rest, or behind an answer.
CertifiedOrbit corrected_orbit(const Problem& problem, const Trajectory* answer, KeptSpace& spaces,
                               Deadline deadline) {
  const std::shared_ptr<const ContactSpace> kept = spaces.of(problem);
  const ContactSpace& space = *kept;
  if (!space.obstacle().empty()) return {.reason = space.obstacle()};
  OrbitCorrectionSettings settings;
  settings.search.expired = [deadline] { return deadline.passed(); };
  const CorrectedOrbit found = (answer == nullptr ? find_reduced_orbit(problem, space, settings)
                                                  : polish_reduced_orbit(problem, space, *answer, settings))
                                   .corrected;
  if (!found.bar) {
    return {.reason = found.refusal.empty() ? describe(found.orbit.outcome) + ": " + found.orbit.reason
                                            : "an orbit of the reduced structure, but " + found.refusal};
  }
  CertifiedOrbit orbit{.motion = found.orbit.trajectory, .residual = found.orbit.residual};
  orbit.error_bar = *found.bar;
  orbit.source = fmt::format("exact orbit on {} vectors, corrected by {}", found.solved, found.vectors);
  orbit.events = events_of(*found.orbit.trajectory);
  take_multipliers(found.orbit, orbit);
  return orbit;
}

/// What `work` finds, or why it failed.
CertifiedOrbit or_reason(const std::function<CertifiedOrbit()>& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw;                                 // the child's memory limit is told apart
  } catch (const std::exception& error) {  // a singular structure, a flow that fails
    return {.reason = error.what()};
  }
}

}  // namespace

OrbitPolisher exact_orbits(std::shared_ptr<KeptSpace> spaces) {
  return [spaces = std::move(spaces)](const Problem& problem, const Trajectory& answer,
                                      std::span<const Certificate> confirmed,
                                      Deadline deadline) -> CertifiedOrbit {
    return or_reason([&] {
      return prefers_reduction(problem) ? corrected_orbit(problem, &answer, *spaces, deadline)
                                        : polish(problem, answer, confirmed, deadline);
    });
  };
}

LargeOrbitFinder reduced_orbits(std::shared_ptr<KeptSpace> spaces) {
  return [spaces = std::move(spaces)](const Problem& problem, Deadline deadline) -> CertifiedOrbit {
    if (!prefers_reduction(problem)) {
      const std::string obstacle = reduction_obstacle(problem);
      return {.reason = obstacle.empty() ? "the structure is small" : obstacle};
    }
    return or_reason([&] { return corrected_orbit(problem, nullptr, *spaces, deadline); });
  };
}

OrbitTools orbit_tools() {
  auto spaces = std::make_shared<KeptSpace>();
  return {flow_orbits(), exact_orbits(spaces), reduced_orbits(spaces), spaces};
}

}  // namespace signorini
