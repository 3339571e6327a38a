#include "methods/orbit/continuation/grazing_starts.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "methods/continuation/arc_length.hpp"
#include "methods/orbit/family/orbit_section.hpp"

namespace signorini {

namespace {

// The orbit without the impacts that fade, or why they cannot be left out.
std::string leave_out_impacts(SequencedOrbit& orbit, const ExtendedEquations& equations) {
  for (Eigen::Index i = orbit.count() - 1; i >= 0; --i) {
    const SequenceEvent& event = orbit.event(i);
    if (event.kind == ContactEvent::Kind::open || equations.speed(i) >= kGuardZero) continue;
    if (event.kind != ContactEvent::Kind::impact) {  // at a damped stop it has opened at once
      const bool opens = i + 1 < orbit.count() && orbit.event(i + 1).contact == event.contact;
      if (!opens || equations.model().dynamics.rigid(event.contact)) return "a closing fades with it";
      orbit = without_event(orbit, i + 1);
    }
    orbit = without_event(orbit, i);
  }
  return {};
}

// How fast each touch penetrates along the orbits without impact, over the first; empty where that cannot be
// told.
Eigen::VectorXd rates_of(OrbitFamily& family, const GrazingOrbit& grazing) {
  constexpr double kNone = 1e-6;
  const auto count = static_cast<Eigen::Index>(grazing.touches.size());
  if (count == 1) return Eigen::VectorXd::Ones(1);
  ExtendedEquations equations(family, grazing.base);
  if (!equations.evaluate(grazing.base.x)) return {};
  const Eigen::VectorXd tangent = first_tangent(equations);
  Eigen::VectorXd rates = Eigen::VectorXd::Zero(count);
  for (const double side : {1.0, -1.0}) {
    if (!equations.evaluate(grazing.base.x + side * kBeside * tangent)) return {};
    for (Eigen::Index a = 0; a < count; ++a) {
      const int contact = grazing.touches[static_cast<std::size_t>(a)].contact;
      const auto clearance = guard_value(equations, GuardKind::clearance, contact);
      if (!clearance) return {};
      rates[a] -= side * *clearance / (2.0 * kBeside);
    }
  }
  if (!(std::abs(rates[0]) > kNone)) return {};
  return rates / rates[0];
}

}  // namespace

std::optional<GrazingOrbit> grazing_orbit(OrbitFamily& family, const TracedCurve& curve) {
  GrazingOrbit grazing{.base = curve.last};
  ExtendedEquations last(family, curve.last);
  if (!last.evaluate(curve.last.x)) return std::nullopt;
  grazing.obstacle = leave_out_impacts(grazing.base, last);
  ExtendedEquations equations(family, grazing.base);
  if (!equations.evaluate(grazing.base.x)) return std::nullopt;
  grazing.base = of_least_period(grazing.base, equations);
  ExtendedEquations shortest(family, grazing.base);
  if (!shortest.evaluate(grazing.base.x)) return std::nullopt;
  grazing.mark = mark_of(shortest);
  for (const OrbitGuard& guard : survey(shortest).guards) {
    if (guard.kind == GuardKind::clearance && guard.value < kGuardZero &&
        shortest.model().dynamics.halts(guard.index))
      grazing.touches.push_back(
          {.contact = guard.index, .phase = std::fmod(guard.phase, grazing.base.end())});
  }
  if (grazing.touches.empty()) return std::nullopt;
  std::ranges::sort(grazing.touches, {}, &GrazingTouch::phase);
  for (std::size_t a = 1; a < grazing.touches.size(); ++a) {
    if (grazing.touches[a].phase - grazing.touches[a - 1].phase < kAtOnce)
      grazing.obstacle = "two contacts graze at one instant";
  }
  const Eigen::VectorXd rates = rates_of(family, grazing);
  if (rates.size() == 0) {
    grazing.obstacle = "how fast its contacts approach their stops cannot be told";
  } else {
    for (std::size_t a = 0; a < grazing.touches.size(); ++a)
      grazing.touches[a].rate = rates[static_cast<Eigen::Index>(a)];
  }
  return grazing;
}

std::optional<CurveStart> start_clear(OrbitFamily& family, const GrazingOrbit& grazing) {
  const int contact = grazing.touches.front().contact;
  const auto quiet = with_quiet_section(family, grazing.base);
  if (!quiet) return std::nullopt;
  return start_where_grows(family, *quiet, quantity_of(GuardKind::clearance, contact),
                           fmt::format("contact {} no longer reaches its stop", contact));
}

namespace {

bool sticks(const SequencedOrbit& orbit, const ContactDynamics& dynamics) {
  const auto any = [&](const std::vector<bool>& closed) {
    return std::ranges::any_of(dynamics.mode(closed).active, [&](int j) { return dynamics.rigid(j); });
  };
  return any(orbit.closed) || std::ranges::any_of(orbit.events, any, &SequenceEvent::closed);
}

// `periods` periods of the orbit with impacts of no speed, or contacts of no length, at some passages of its
// touches (GrazingFamily).
std::optional<SequencedOrbit> struck_at(OrbitFamily& family, const GrazingOrbit& grazing, int periods,
                                        const std::vector<int>& hits) {
  const auto model = family.model(grazing.base.parameter() * family.units().parameter);
  const auto count = static_cast<int>(grazing.touches.size());
  SequencedOrbit struck = repeated(grazing.base, periods);
  for (const int hit : hits) {
    const GrazingTouch& touch = grazing.touches[static_cast<std::size_t>(hit % count)];
    const int passed = hit / count;  // periods
    const double phase = touch.phase + passed * grazing.base.end();
    struck = with_touch(struck, touch.contact, phase, model->dynamics);
  }
  return with_quiet_section(family, struck);
}

// The speeds of new impacts grow at first order; the equations are smooth in them.
std::optional<CurveStart> start_struck(OrbitFamily& family, const SequencedOrbit& orbit,
                                       const std::string& origin) {
  ExtendedEquations equations(family, orbit);
  if (!equations.evaluate(orbit.x)) return std::nullopt;
  std::vector<Eigen::Index> fresh;
  for (Eigen::Index i = 0; i < orbit.count(); ++i) {
    if (std::abs(equations.speed(i)) < kNew) fresh.push_back(i);
  }
  const auto speed_of_new = [&](const ExtendedEquations& at) {
    double sum = 0.0;
    for (const Eigen::Index i : fresh) sum += at.speed(i);
    return sum;
  };
  return start_where_grows(family, orbit, speed_of_new, origin);
}

// The instants at which new contacts with damped stops begin have no part in the equations where these have
// no length: each comes earlier as the root of its impulse, all else at second order.
CurveStart start_pressed(const SequencedOrbit& orbit, const GrazingOrbit& grazing, const GrazingFamily& found,
                         const std::string& origin) {
  const auto touches = static_cast<int>(grazing.touches.size());
  CurveStart start{.orbit = orbit, .tangent = Eigen::VectorXd::Zero(orbit.x.size()), .origin = origin};
  for (Eigen::Index i = 0; i < orbit.count(); ++i) {
    const double passed = orbit.section + orbit.phase(i) - grazing.base.section;
    for (std::size_t k = 0; k < found.hits.size(); ++k) {
      const GrazingTouch& touch = grazing.touches[static_cast<std::size_t>(found.hits[k] % touches)];
      const int periods = found.hits[k] / touches;
      const double apart = std::remainder(passed - touch.phase - periods * grazing.base.end(), orbit.end());
      const SequenceEvent& event = orbit.event(i);
      if (std::abs(apart) > kAtOnce || event.contact != touch.contact ||
          event.kind != ContactEvent::Kind::close)
        continue;
      const bool told = found.impulses.size() > 0;
      start.tangent[orbit.states() + i] =
          told ? -std::sqrt(found.impulses[static_cast<Eigen::Index>(k)]) : -1.0;
    }
  }
  start.tangent.normalize();
  return start;
}

std::optional<CurveStart> start_of(OrbitFamily& family, const GrazingOrbit& grazing,
                                   const GrazingFamily& found, const std::string& origin) {
  const auto orbit = struck_at(family, grazing, found.periods, found.hits);
  if (!orbit) return std::nullopt;
  const auto model = family.model(orbit->parameter() * family.units().parameter);
  return model->dynamics.rigid(grazing.touches.front().contact)
             ? start_struck(family, *orbit, origin)
             : start_pressed(*orbit, grazing, found, origin);
}

// Of free motions: each touch struck alone and, as symmetric motions have them, all of them.
std::optional<std::vector<CurveStart>> start_struck_freely(OrbitFamily& family, const GrazingOrbit& grazing,
                                                           const std::string& origin) {
  std::vector<int> all(grazing.touches.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::vector<int>> patterns(all.size() > 1 ? 1 : 0, all);
  for (const int touch : all) patterns.push_back({touch});
  std::vector<CurveStart> starts;
  for (const std::vector<int>& hits : patterns) {
    const auto orbit = struck_at(family, grazing, 1, hits);
    if (auto start = orbit ? start_growing(family, *orbit, origin) : std::nullopt) starts.push_back(*start);
  }
  return starts.empty() ? std::nullopt : std::optional(std::move(starts));
}

}  // namespace

std::optional<std::vector<CurveStart>> start_impacting(OrbitFamily& family, const GrazingOrbit& grazing,
                                                       int max_order) {
  const double p = grazing.base.parameter() * family.units().parameter;
  const std::string origin =
      fmt::format("grazing of contact {} at {:.10g}", grazing.touches.front().contact, p);
  if (!family.driven()) return start_struck_freely(family, grazing, origin);
  const int most = std::max(1, max_order / grazing.base.order);
  auto families = grazing_families(family, grazing.base, grazing.touches, most);
  // An orbit that keeps no memory of the impact, being brought to rest on its stop by it or in each period,
  // or next to none, its stop being damped: v^2 is as the penetration, one impact in each period all there
  // can be.
  const auto model = family.model(p);
  const int first = grazing.touches.front().contact;
  const bool forgets = !model->dynamics.rigid(first) || model->dynamics.restitution(first) == 0.0 ||
                       sticks(grazing.base, model->dynamics);
  if (!families && grazing.touches.size() == 1 && forgets)
    families = std::vector<GrazingFamily>{{.periods = 1, .hits = {0}, .beyond = true, .impulses = {}}};
  if (!families) return std::nullopt;
  std::vector<CurveStart> starts;
  for (const GrazingFamily& found : *families) {
    auto start = start_of(family, grazing, found, origin);
    if (start) starts.push_back(std::move(*start));
  }
  return starts;
}

}  // namespace signorini
