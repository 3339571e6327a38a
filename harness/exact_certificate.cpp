#include "harness/exact_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <exception>
#include <new>

#include "methods/kernels/exact_orbit/exact_orbit.hpp"
#include "methods/kernels/exact_orbit/return_check.hpp"
#include "methods/kernels/periodic_time.hpp"

namespace signorini {

namespace {

constexpr int kNormInstants = 4096;

std::string_view kind_name(ContactEvent::Kind kind) {
  switch (kind) {
    case ContactEvent::Kind::impact:
      return "impact";
    case ContactEvent::Kind::close:
      return "close";
    case ContactEvent::Kind::open:
      return "open";
  }
  return "event";
}

std::vector<OrbitEvent> events_of(const ExactTrajectory& orbit) {
  std::vector<OrbitEvent> events;
  const double period = orbit.period();
  const std::vector<Impulse> impulses = orbit.impulses();
  for (const SequenceEvent& event : orbit.orbit().events) {
    OrbitEvent listed{
        wrapped_time(event.time, period), event.contact, std::string(kind_name(event.kind)), {}};
    for (const Impulse& impulse : impulses) {
      const double apart =
          std::abs(wrapped_time(impulse.time - event.time + 0.5 * period, period) - 0.5 * period);
      if (impulse.contact == event.contact && apart <= 1e-12 * period) listed.value = impulse.value;
    }
    events.push_back(std::move(listed));
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const OrbitEvent& a, const OrbitEvent& b) { return a.time < b.time; });
  return events;
}

/// The error bar of the motion, relative to X, as one of x in the mean square.
double relative_error_bar(const ExactOrbit& orbit, const Trajectory& motion, double displacement_scale) {
  const Samples samples = motion.sample(kNormInstants);
  if (samples.x.size() == 0) return orbit.error_bar;
  const double norm = samples.x.norm() / std::sqrt(static_cast<double>(kNormInstants));
  return norm > 0.0 ? orbit.error_bar * displacement_scale / norm : orbit.error_bar;
}

/// Whether small disturbances die out; open where no multiplier is defined or round-off would decide.
std::optional<bool> stability(const ExactOrbit& orbit) {
  constexpr double kUndecided = 1e-9;
  if (orbit.multipliers.size() == 0) return std::nullopt;
  const double largest = orbit.largest_multiplier();
  if (std::abs(largest - 1.0) <= std::max(kUndecided, orbit.error_bar)) return std::nullopt;
  return largest < 1.0;
}

CheckedOrbit polish(const Problem& problem, const Trajectory& answer,
                    std::chrono::steady_clock::time_point deadline) {
  const auto expired = [deadline] { return Start{.guess = {}, .deadline = deadline}.expired(); };
  OrbitFinder finder(problem);
  SearchOptions options;
  options.polish.second_evaluation = true;
  options.expired = expired;
  const OrbitSearch search = finder.find(answer, options);
  const ExactOrbit& found = search.orbit;
  if (!found.certified()) {
    return {.reason = found.reason.empty() ? describe(found.outcome)
                                           : describe(found.outcome) + ": " + found.reason};
  }
  const ContactDynamics& dynamics = finder.model()->dynamics;
  const ReturnCheck check = cvode_return(dynamics, *found.trajectory, expired);
  if (!check.returned) {
    return {.reason =
                fmt::format("an exact orbit, but CVODE returns {:.1e} away from it where {:.1e} is allowed",
                            check.distance, check.allowed)};
  }
  CheckedOrbit orbit{.orbit = found.trajectory, .residual = found.residual};
  orbit.error_bar = relative_error_bar(found, *found.trajectory, dynamics.scales().displacement);
  orbit.source =
      found.outcome == OrbitOutcome::chatter ? "exact orbit with a complete chatter" : "exact orbit";
  orbit.events = events_of(*found.trajectory);
  orbit.return_distance = check.distance;
  orbit.floquet.emplace();
  for (const std::complex<double>& multiplier : found.multipliers)
    orbit.floquet->emplace_back(multiplier.real(), multiplier.imag());
  orbit.stable = stability(found);
  return orbit;
}

}  // namespace

OrbitPolisher exact_orbits() {
  return [](const Problem& problem, const Trajectory& answer,
            std::chrono::steady_clock::time_point deadline) -> CheckedOrbit {
    try {
      return polish(problem, answer, deadline);
    } catch (const std::bad_alloc&) {
      throw;                                 // the child's memory limit is told apart
    } catch (const std::exception& error) {  // a singular structure, a flow that fails
      return {.reason = error.what()};
    }
  };
}

OrbitTools orbit_tools() { return {event_driven_orbits(), exact_orbits()}; }

}  // namespace signorini
