#include "methods/orbit/continuation/switching.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "methods/continuation/arc_length.hpp"
#include "methods/orbit/continuation/grazing_families.hpp"
#include "methods/orbit/continuation/orbit_section.hpp"

namespace signorini {

bool OrbitMark::same(const OrbitMark& other, bool loosely) const {
  const double factor = loosely ? 100.0 : 1.0;
  const double tolerance = 1e-6 * factor, speed_tolerance = 1e-4 * factor;
  if (order != other.order || events != other.events || speeds.size() != other.speeds.size() ||
      std::abs(parameter - other.parameter) > tolerance)
    return false;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    if (std::abs(speeds[i] - other.speeds[i]) > speed_tolerance) return false;
  }
  return true;
}

OrbitMark mark_of(const ExtendedEquations& equations) {
  const SequencedOrbit& orbit = equations.orbit();
  OrbitMark mark{.parameter = orbit.x[orbit.x.size() - 1], .order = orbit.order, .events = {}, .speeds = {}};
  for (std::size_t i = 0; i < orbit.events.size(); ++i) {
    mark.events.push_back(3 * orbit.events[i].contact + static_cast<int>(orbit.events[i].kind));
    mark.speeds.push_back(equations.equations().crossings()[i].approach /
                          equations.family().units().velocity);
  }
  std::sort(mark.events.begin(), mark.events.end());
  std::sort(mark.speeds.begin(), mark.speeds.end());
  return mark;
}

std::optional<CurveStart> start_where_grows(OrbitFamily& family, const SequencedOrbit& orbit,
                                            const OrbitQuantity& quantity, std::string origin) {
  constexpr double kBeside = 1e-6;
  ExtendedEquations equations(family, orbit);
  if (!equations.evaluate(orbit.x)) return std::nullopt;
  const Eigen::VectorXd tangent = first_tangent(equations);
  if (!equations.evaluate(orbit.x + kBeside * tangent)) return std::nullopt;
  const double ahead = quantity(equations);
  if (!equations.evaluate(orbit.x - kBeside * tangent)) return std::nullopt;
  const double behind = quantity(equations);
  if (!std::isfinite(ahead - behind)) return std::nullopt;
  return CurveStart{.orbit = orbit,
                    .tangent = ahead > behind ? tangent : Eigen::VectorXd(-tangent),
                    .origin = std::move(origin)};
}

std::optional<CurveStart> start_doubled(OrbitFamily& family, const SequencedOrbit& orbit) {
  const auto quiet = with_quiet_section(family, orbit);
  if (!quiet) return std::nullopt;
  ExtendedEquations equations(family, *quiet);
  if (!equations.evaluate(quiet->x)) return std::nullopt;
  const Eigen::MatrixXd M = equations.monodromy();
  if (M.size() == 0 || !M.allFinite()) return std::nullopt;
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(M);
  Eigen::Index nearest = 0;
  (solver.eigenvalues().array() + 1.0).abs().minCoeff(&nearest);
  const Eigen::VectorXd phi = solver.eigenvectors().col(nearest).real();
  const Eigen::Index states = quiet->states(), m = quiet->count();
  Eigen::VectorXd way = Eigen::VectorXd::Zero(states + 2 * m + 1);
  way.head(states) = phi;
  if (m > 0) {
    const Eigen::MatrixXd& J = equations.jacobian();
    const Eigen::VectorXd follow =
        -J.block(states, states, m, m).partialPivLu().solve(J.block(states, 0, m, states) * phi);
    way.segment(states, m) = follow;
    way.segment(states + m, m) = -follow;
  }
  return CurveStart{.orbit = repeated(*quiet, 2),
                    .tangent = way.normalized(),
                    .origin = fmt::format("period doubling at {:.10g}", equations.parameter()),
                    .leaves_repetition = true};
}

std::optional<GrazingOrbit> grazing_orbit(OrbitFamily& family, const TracedCurve& curve) {
  const OrbitGuard& guard = *curve.guard;
  GrazingOrbit grazing{
      .base = curve.last, .contact = guard.index, .phase = guard.phase, .mark = {}, .others = false};
  if (guard.kind == GuardKind::approach) {
    grazing.contact = curve.last.events[static_cast<std::size_t>(guard.index)].contact;
    grazing.base = without_event(curve.last, guard.index);
  }
  ExtendedEquations equations(family, grazing.base);
  if (!equations.evaluate(grazing.base.x)) return std::nullopt;
  grazing.base = of_least_period(grazing.base, equations);
  grazing.phase = std::fmod(grazing.phase, grazing.base.end());
  ExtendedEquations shortest(family, grazing.base);
  if (!shortest.evaluate(grazing.base.x)) return std::nullopt;
  grazing.mark = mark_of(shortest);
  constexpr double kGrazes = 1e-8;  // of X
  for (const OrbitGuard& other : survey(shortest).guards) {
    const bool fades = other.kind == GuardKind::approach && other.value < kGrazes;
    const bool touches =
        other.kind == GuardKind::clearance && other.index != grazing.contact && other.value < kGrazes;
    grazing.others = grazing.others || fades || touches;
  }
  return grazing;
}

std::optional<CurveStart> start_clear(OrbitFamily& family, const GrazingOrbit& grazing) {
  const auto clearance = [&](const ExtendedEquations& equations) {
    const OrbitSurvey found = survey(equations);
    const OrbitGuard* guard = found.find(GuardKind::clearance, grazing.contact);
    return guard == nullptr ? std::nan("") : guard->value;
  };
  const auto quiet = with_quiet_section(family, grazing.base);
  if (!quiet) return std::nullopt;
  return start_where_grows(family, *quiet, clearance,
                           fmt::format("contact {} clears its stop", grazing.contact));
}

std::optional<std::vector<CurveStart>> start_impacting(OrbitFamily& family, const GrazingOrbit& grazing,
                                                       int max_order) {
  const int most = std::max(1, max_order / grazing.base.order);
  const auto families = grazing_families(family, grazing.base, grazing.contact, grazing.phase, most);
  if (!families) return std::nullopt;
  const double p = grazing.base.x[grazing.base.x.size() - 1] * family.units().parameter;
  const SequenceEvent impact{.kind = ContactEvent::Kind::impact,
                             .contact = grazing.contact,
                             .pushed = {grazing.contact},
                             .restitution = {family.model(p)->dynamics.restitution()}};
  const auto speed_of_new = [](const std::vector<bool>& fresh, const ExtendedEquations& equations) {
    double sum = 0.0;
    for (std::size_t i = 0; i < fresh.size(); ++i) {
      if (fresh[i]) sum += equations.equations().crossings()[i].approach;
    }
    return sum;
  };
  std::vector<CurveStart> starts;
  for (const GrazingFamily& found : *families) {
    std::vector<double> phases;
    for (const int hit : found.hits) phases.push_back(grazing.phase + hit * grazing.base.end());
    const auto orbit =
        with_quiet_section(family, with_impacts(repeated(grazing.base, found.periods), impact, phases));
    if (!orbit) continue;
    ExtendedEquations equations(family, *orbit);
    if (!equations.evaluate(orbit->x)) continue;
    std::vector<bool> fresh;
    for (const auto& crossing : equations.equations().crossings())
      fresh.push_back(std::abs(crossing.approach) < 1e-7 * family.units().velocity);
    auto start = start_where_grows(
        family, *orbit, [&](const ExtendedEquations& at) { return speed_of_new(fresh, at); },
        fmt::format("grazing of contact {} at {:.10g}", grazing.contact, p));
    if (start) starts.push_back(std::move(*start));
  }
  return starts;
}

std::optional<CurveStart> start_exchanged(OrbitFamily& family, const SequencedOrbit& orbit, int i) {
  SequencedOrbit exchanged = orbit;
  const auto later = static_cast<std::size_t>(i);
  std::swap(exchanged.events[later - 1], exchanged.events[later]);
  std::swap(exchanged.events[later - 1].closed, exchanged.events[later].closed);  // impacts only: the same
  return start_where_grows(
      family, exchanged,
      [i](const ExtendedEquations& at) { return at.orbit().phase(i) - at.orbit().phase(i - 1); },
      "impacts of two contacts exchanged");
}

}  // namespace signorini
