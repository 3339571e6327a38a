#include "methods/orbit/continuation/switching.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <utility>

#include "methods/continuation/arc_length.hpp"
#include "methods/orbit/family/branch_point.hpp"
#include "methods/orbit/family/chatter.hpp"
#include "methods/orbit/family/orbit_section.hpp"
#include "methods/orbit/impact_orders.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/singular_values.hpp"

namespace signorini {

bool OrbitMark::same(const OrbitMark& other, bool loosely) const {
  const double factor = loosely ? 100.0 : 1.0;
  const double tolerance = 1e-6 * factor, speed_tolerance = 1e-4 * factor;
  return order == other.order && std::abs(parameter - other.parameter) <= tolerance &&
         std::equal(events.begin(), events.end(), other.events.begin(), other.events.end(),
                    [&](const auto& a, const auto& b) {
                      return a.first == b.first && std::abs(a.second - b.second) <= speed_tolerance;
                    });
}

namespace {

// Of each event whether it is one of the last of a chatter: how many of these are resolved does not tell
// orbits apart.
std::vector<bool> last_impacts(const ExtendedEquations& equations) {
  constexpr double kSlow = 1e-3;  // of V
  const SequencedOrbit& orbit = equations.orbit();
  std::vector<bool> last(orbit.events.size(), false);
  for (const ChatterEnd& end : chatter_ends(equations)) {
    const int contact = orbit.event(end.closing).contact;
    for (auto i = static_cast<std::size_t>(end.closing) + 1; i-- > 0;) {
      if (orbit.events[i].contact != contact) continue;
      if (equations.equations().crossings()[i].approach >= kSlow * equations.family().units().velocity ||
          orbit.events[i].kind == ContactEvent::Kind::open)
        break;
      last[i] = true;
    }
  }
  return last;
}

// A period may be said to begin after any of its longest breaks: never between events of one instant, whose
// order would be lost.
std::vector<int> least_rotation(const std::vector<int>& events, const std::vector<double>& phases,
                                double end) {
  const auto before = [&](std::size_t i) {
    return phases[i] - (i == 0 ? phases.back() - end : phases[i - 1]);
  };
  double longest = 0.0;
  for (std::size_t i = 0; i < events.size(); ++i) longest = std::max(longest, before(i));
  std::vector<int> least;
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (before(i) < longest - kAtOnce) continue;
    std::vector<int> rotated = events;
    std::rotate(rotated.begin(), rotated.begin() + static_cast<std::ptrdiff_t>(i), rotated.end());
    if (least.empty() || rotated < least) least = std::move(rotated);
  }
  return least;
}

}  // namespace

OrbitMark mark_of(const ExtendedEquations& equations) {
  const SequencedOrbit& orbit = equations.orbit();
  OrbitMark mark{.parameter = orbit.parameter(), .order = orbit.order};
  const std::vector<bool> tail = last_impacts(equations);
  std::vector<double> phases;
  for (std::size_t i = 0; i < orbit.events.size(); ++i) {
    const double speed = equations.equations().crossings()[i].approach / equations.family().units().velocity;
    if (tail[i]) continue;
    mark.events.emplace_back(3 * orbit.events[i].contact + static_cast<int>(orbit.events[i].kind), speed);
    phases.push_back(orbit.phase(static_cast<Eigen::Index>(i)));
  }
  for (const auto& [event, speed] : mark.events) mark.order_of_events.push_back(event);
  mark.order_of_events = least_rotation(mark.order_of_events, phases, orbit.end());
  std::sort(mark.events.begin(), mark.events.end());
  return mark;
}

OrbitQuantity quantity_of(GuardKind kind, int index) {
  return [=](const ExtendedEquations& at) { return guard_value(at, kind, index).value_or(std::nan("")); };
}

std::optional<CurveStart> start_where_grows(OrbitFamily& family, const SequencedOrbit& orbit,
                                            const OrbitQuantity& quantity, std::string origin) {
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

namespace {

// The speeds of the impacts that have none at an orbit, over V, and the lengths of the phases of contact that
// have none there [-], [rad].
class NewEvents {
 public:
  explicit NewEvents(const ExtendedEquations& equations) {
    const SequencedOrbit& orbit = equations.orbit();
    for (Eigen::Index i = 0; i < orbit.count(); ++i) {
      const SequenceEvent& event = orbit.event(i);
      const bool impact = event.kind == ContactEvent::Kind::impact;
      if (impact && std::abs(equations.speed(i)) < kNew) impacts_.push_back(i);
      if (!impact && i > 0 && orbit.event(i - 1).contact == event.contact &&
          orbit.phase(i) - orbit.phase(i - 1) < kNew)
        phases_.push_back(i);
    }
  }
  [[nodiscard]] Eigen::VectorXd of(const ExtendedEquations& at) const {
    std::vector<double> all;
    for (const Eigen::Index i : impacts_) all.push_back(at.speed(i));
    for (const Eigen::Index i : phases_) all.push_back(at.orbit().phase(i) - at.orbit().phase(i - 1));
    return Eigen::VectorXd::Map(all.data(), static_cast<Eigen::Index>(all.size()));
  }

 private:
  std::vector<Eigen::Index> impacts_, phases_;
};

}  // namespace

std::optional<CurveStart> start_growing(OrbitFamily& family, const SequencedOrbit& orbit,
                                        std::string origin) {
  constexpr double kSingular = 1e-8, kResolved = 1e-6;  // of the largest singular value
  ExtendedEquations equations(family, orbit);
  if (!equations.evaluate(orbit.x)) return std::nullopt;
  const NewEvents fresh(equations);
  const Eigen::MatrixXd J = equations.accurate_jacobian(), C = equations.conditions();
  Eigen::MatrixXd all(J.rows() + C.rows(), J.cols());
  all << J, C;
  if (!all.allFinite()) return std::nullopt;
  const SingularValues svd = singular_vectors(all);
  const Eigen::Index rank = (svd.values.array() > kSingular * svd.values[0]).count();
  const Eigen::MatrixXd ways = svd.V.rightCols(svd.V.cols() - rank);
  Eigen::MatrixXd rates(fresh.of(equations).size(), ways.cols());
  for (Eigen::Index k = 0; k < ways.cols(); ++k) {
    if (!equations.evaluate(orbit.x + kBeside * ways.col(k))) return std::nullopt;
    const Eigen::VectorXd ahead = fresh.of(equations);
    if (!equations.evaluate(orbit.x - kBeside * ways.col(k))) return std::nullopt;
    rates.col(k) = (ahead - fresh.of(equations)) / (2.0 * kBeside);
  }
  if (rates.size() == 0 || !rates.allFinite()) return std::nullopt;
  const SingularValues by_way = singular_vectors(rates);
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(ways.cols());
  for (Eigen::Index k = 0; k < by_way.values.size(); ++k) {
    if (by_way.values[k] > kResolved * by_way.values[0])
      shares += by_way.U.col(k).sum() / by_way.values[k] * by_way.V.col(k);
  }
  if (!((rates * shares).array() > 0.0).all()) return std::nullopt;
  return CurveStart{.orbit = orbit, .tangent = (ways * shares).normalized(), .origin = std::move(origin)};
}

namespace {

// How fast events of one instant that follow each other part along a way: the least and the largest rate.
struct Parting {
  double least = 0.0, largest = 0.0;
};
constexpr double kParts = 1e-7;

Parting parting(const SequencedOrbit& orbit, const Eigen::VectorXd& way) {
  Parting found;
  for (Eigen::Index i = 1; i < orbit.count(); ++i) {
    if (orbit.phase(i) - orbit.phase(i - 1) > kOneInstant) continue;
    const double rate = way[orbit.states() + i] - way[orbit.states() + i - 1];
    found.least = std::min(found.least, rate);
    found.largest = std::max(found.largest, std::abs(rate));
  }
  return found;
}

// All orders of impacts of one instant that do not feel each other through the mass, that of the orbit first.
std::vector<std::vector<std::size_t>> exchanged_orders(OrbitFamily& family, const SequencedOrbit& orbit) {
  std::vector<double> phases;
  for (Eigen::Index i = 0; i < orbit.count(); ++i) phases.push_back(orbit.phase(i));
  const auto model = family.model(orbit.parameter() * family.units().parameter);
  return impact_orders(model->dynamics.structure(), orbit.events, phases, true);
}

// What belongs to the events of an orbit, phases or rates, in another order.
Eigen::VectorXd in_order(const Eigen::VectorXd& x, Eigen::Index states,
                         const std::vector<std::size_t>& order) {
  Eigen::VectorXd moved = x;
  for (std::size_t i = 0; i < order.size(); ++i)
    moved[states + static_cast<Eigen::Index>(i)] = x[states + static_cast<Eigen::Index>(order[i])];
  return moved;
}

SequencedOrbit in_order(const SequencedOrbit& orbit, const std::vector<std::size_t>& order) {
  SequencedOrbit result = orbit;
  result.events = reordered(orbit.events, orbit.closed, order);
  result.x = in_order(orbit.x, orbit.states(), order);
  return result;
}

}  // namespace

CurveStart in_order_along(OrbitFamily& family, CurveStart start) {
  if (parting(start.orbit, start.tangent).least >= -kParts) return start;
  for (const auto& order : exchanged_orders(family, start.orbit)) {
    const SequencedOrbit other = in_order(start.orbit, order);
    const Eigen::VectorXd tangent = in_order(start.tangent, start.orbit.states(), order);
    if (parting(other, tangent).least < -kParts) continue;
    start.orbit = other;
    start.tangent = tangent;
    break;
  }
  return start;
}

std::optional<CurveStart> start_doubled(OrbitFamily& family, const SequencedOrbit& orbit) {
  const auto quiet = with_quiet_section(family, orbit);
  if (!quiet) return std::nullopt;
  ExtendedEquations equations(family, *quiet);
  if (!equations.evaluate(quiet->x)) return std::nullopt;
  const Eigen::MatrixXd M = equations.monodromy();
  if (M.size() == 0 || !M.allFinite()) return std::nullopt;
  const GeneralEigen found = general_eigen(M);
  if (!found.converged) return std::nullopt;
  Eigen::Index nearest = 0;
  (found.values.array() + 1.0).abs().minCoeff(&nearest);
  const Eigen::VectorXd phi = found.vectors.col(nearest).real();
  const Eigen::Index states = quiet->states(), m = quiet->count();
  Eigen::VectorXd way = Eigen::VectorXd::Zero(states + 2 * m + 1);
  way.head(states) = phi;
  if (m > 0) {
    const Eigen::MatrixXd& J = equations.jacobian();
    const Eigen::VectorXd follow =
        -lu_solve(J.block(states, states, m, m), image(J.block(states, 0, m, states), phi));
    way.segment(states, m) = follow;
    way.segment(states + m, m) = -follow;
  }
  return in_order_along(family, {.orbit = repeated(*quiet, 2),
                                 .tangent = way.normalized(),
                                 .origin = fmt::format("period doubling at {:.10g}", equations.parameter()),
                                 .leaves = LeftBranch::repetition});
}

std::vector<CurveStart> start_crossing(OrbitFamily& family, const SequencedOrbit& orbit,
                                       const Eigen::VectorXd& across) {
  constexpr double kReach = 1e-3;  // in CurveUnits
  const double parameter = orbit.parameter() * family.units().parameter;
  std::vector<CurveStart> starts;
  const auto add = [&](const SequencedOrbit& at, const Eigen::VectorXd& x, const Eigen::VectorXd& way) {
    for (const double sign : {1.0, -1.0}) {
      if (parting(at, sign * way).least < -kParts) continue;
      starts.push_back({.orbit = at,
                        .tangent = sign * way,
                        .origin = fmt::format("branch point at {:.10g}", parameter),
                        .leaves = LeftBranch::crossing});
      starts.back().orbit.x = x;
    }
  };
  add(orbit, orbit.x, across);
  if (parting(orbit, across).largest < kParts) return starts;
  const auto orders = exchanged_orders(family, orbit);
  for (std::size_t k = 1; k < orders.size(); ++k) {
    const SequencedOrbit other = in_order(orbit, orders[k]);
    ExtendedEquations equations(family, other);
    if (!equations.evaluate(other.x)) continue;
    const auto point = solve_branch_point(equations, other.x, kReach);
    if (!point) continue;
    const bool first = parting(other, point->first).largest > parting(other, point->second).largest;
    add(other, point->x, first ? point->first : point->second);
  }
  return starts;
}

}  // namespace signorini
