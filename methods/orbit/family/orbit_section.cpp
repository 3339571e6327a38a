#include "methods/orbit/family/orbit_section.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace signorini {

SequencedOrbit with_section(const SequencedOrbit& orbit, const ExtendedEquations& equations, double phase) {
  std::vector<PlacedEvent> placed = placed_events(orbit);
  SequencedOrbit moved = orbit;
  moved.x.head(orbit.states()) = equations.state_at(phase);
  for (auto& [at, event] : placed) {
    if (at < phase) moved.closed = event.closed;
    at += at < phase ? orbit.end() - phase : -phase;
  }
  moved.section = std::fmod(orbit.section + phase, orbit.end());
  return with_events(moved, std::move(placed));
}

std::optional<SequencedOrbit> with_quiet_section(OrbitFamily& family, const SequencedOrbit& orbit) {
  if (orbit.events.empty()) return orbit;
  ExtendedEquations equations(family, orbit);
  if (!equations.evaluate(orbit.x)) return std::nullopt;
  return with_section(orbit, equations, quiet_phase(orbit));
}

namespace {

// Whether a list of events is one of a shorter period so many times over.
bool repeats(const std::vector<SequenceEvent>& events, int parts) {
  const std::size_t count = events.size() / static_cast<std::size_t>(parts);
  if (events.size() % static_cast<std::size_t>(parts) != 0) return false;
  for (std::size_t i = count; i < events.size(); ++i) {
    if (events[i].contact != events[i - count].contact || events[i].kind != events[i - count].kind)
      return false;
  }
  return true;
}

}  // namespace

SequencedOrbit of_least_period(const SequencedOrbit& orbit, const ExtendedEquations& equations) {
  constexpr double kSame = 1e-7;
  const Eigen::Index states = orbit.states();
  for (int parts = orbit.order; parts > 1; --parts) {
    if (orbit.order % parts != 0 || !repeats(orbit.events, parts)) continue;
    const double end = orbit.end() / parts;
    if ((equations.state_at(end) - orbit.x.head(states)).lpNorm<Eigen::Infinity>() > kSame) continue;
    std::vector<PlacedEvent> placed = placed_events(orbit);
    placed.resize(placed.size() / static_cast<std::size_t>(parts));
    SequencedOrbit shorter = orbit;
    shorter.order /= parts;
    shorter.section = std::fmod(orbit.section, end);
    return with_events(shorter, std::move(placed));
  }
  return orbit;
}

bool passes(ExtendedEquations& equations, const Eigen::VectorXd& from, const Eigen::VectorXd& to,
            const SequencedOrbit& orbit) {
  constexpr double kSame = 1e-6;
  if (from.size() != orbit.x.size()) return false;  // the impacts of a chatter are others
  const Eigen::Index last = orbit.x.size() - 1;
  const double before = from[last] - orbit.x[last], after = to[last] - orbit.x[last];
  if (before * after > 0.0) return false;
  Eigen::VectorXd guess = from + before / (before - after) * (to - from);
  guess[last] = orbit.x[last];
  if (!correct_at_parameter(equations, guess)) return false;
  const SequencedOrbit& here = equations.orbit();
  for (int k = 0; k < here.order; ++k) {
    const double phase = std::fmod(orbit.section - here.section + here.end() + kTwoPi * k, here.end());
    if ((equations.state_at(phase) - orbit.x.head(orbit.states())).lpNorm<Eigen::Infinity>() < kSame)
      return true;
  }
  return false;
}

Eigen::VectorXd half_way(const ExtendedEquations& equations) {
  const SequencedOrbit& orbit = equations.orbit();
  if (orbit.order % 2 != 0 || orbit.count() % 2 != 0) return {};
  return equations.state_at(0.5 * orbit.end()) - orbit.x.head(orbit.states());
}

std::optional<double> half_period_on_step(ExtendedEquations& equations, const CurveStep& step,
                                          const Eigen::VectorXd& begin) {
  constexpr double kSame = 1e-4, kRounding = 1e-10;  // of y(T / 2) - y_0, in CurveUnits
  const Eigen::VectorXd after = half_way(equations);
  if (after.size() == 0 || begin.norm() < kRounding || !(begin.dot(after) < 0.0)) return std::nullopt;
  const Eigen::VectorXd direction = begin.normalized();
  const auto along = [&](ExtendedEquations& at) { return std::optional(direction.dot(half_way(at))); };
  const auto length = locate(equations, step, along, begin.norm(), direction.dot(after));
  return length && half_way(equations).norm() < kSame ? *length : 0.0;
}

}  // namespace signorini
