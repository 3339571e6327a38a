#include "methods/orbit/continuation/station.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "methods/orbit/family/branch_point.hpp"
#include "methods/orbit/family/followed_quantity.hpp"
#include "methods/orbit/impact_orders.hpp"

namespace signorini {

Station station_at(ExtendedEquations& equations, const Eigen::VectorXd& tangent, MultiplierRange range,
                   std::shared_ptr<const CurveFactors> factors) {
  return {.x = equations.orbit().x,
          .tangent = tangent,
          .tests = bifurcation_tests(equations, tangent, range, factors.get()),
          .survey = survey(equations),
          .factors = std::move(factors)};
}

namespace {

// SolutionPoint::motion.
Eigen::MatrixXd sampled_motion(const ExtendedEquations& equations, int phases) {
  const SequencedOrbit& orbit = equations.orbit();
  const int contacts = equations.model().dynamics.contact_count();
  const Eigen::Index count = Eigen::Index{phases} * orbit.order;
  Eigen::MatrixXd x(count, contacts);
  for (Eigen::Index i = 0; i < count; ++i) {
    double phase = std::fmod(
        orbit.end() * static_cast<double>(i) / static_cast<double>(count) - orbit.section, orbit.end());
    if (phase < 0.0) phase += orbit.end();
    const LinearArc& arc = equations.arc(orbit.passed(phase));
    for (int j = 0; j < contacts; ++j) x(i, j) = arc.displacement(j, equations.time_of(phase));
  }
  return x;
}

}  // namespace

OrbitGuess orbit_at(const ExtendedEquations& equations) {
  const SequencedOrbit& orbit = equations.orbit();
  OrbitGuess result{
      .start = {.time = equations.time_of(0.0),
                .state = state_of(orbit.x, equations.model().dynamics, equations.family().units()),
                .closed = orbit.closed},
      .events = orbit.events,
      .origin = "continuation"};
  for (Eigen::Index i = 0; i < orbit.count(); ++i)
    result.events[static_cast<std::size_t>(i)].time = equations.time_of(orbit.phase(i));
  return result;
}

SolutionPoint solution_point(const ExtendedEquations& equations, const Station& station, int phases) {
  SolutionPoint point{.parameter = equations.parameter(),
                      .frequency = equations.frequency(),
                      .order = equations.orbit().order,
                      .multipliers = station.tests.multipliers};
  const OrbitGuess orbit = orbit_at(equations);
  if (simultaneous_coupling(equations.model().dynamics, orbit) != ImpactCoupling::none) {
    OrbitMultipliers own = multipliers_of_orbit(*equations.shared_model(), orbit, equations.equations());
    if (!own.undefined.empty()) point.undefined = describe_orders(own);
    point.multipliers = std::move(own.values);
  }
  point.stability = stability_of(equations, point.multipliers);
  for (const SequenceEvent& event : equations.orbit().events) {
    const bool closes =
        event.kind == ContactEvent::Kind::close && !equations.model().dynamics.rigid(event.contact);
    if (event.kind == ContactEvent::Kind::impact || closes) ++point.impacts;
  }
  if (point.stability == OrbitStability::undefined) point.multipliers.resize(0);
  if (!equations.family().driven()) point.energy = energy_of(equations.model(), orbit.start);
  for (Eigen::Index j = 0; j < station.survey.highest.size(); ++j) {
    point.x_max.push_back(station.survey.highest[j]);
    point.amplitude.push_back(0.5 * (station.survey.highest[j] - station.survey.lowest[j]));
  }
  if (phases > 0) point.motion = sampled_motion(equations, phases);
  return point;
}

SolutionPoint resonance_point(const ExtendedEquations& equations, const Station& station) {
  SolutionPoint point = solution_point(equations, station);
  if (const auto phase = load_phase(equations)) point.damping_ratio = phase->damping_ratio;
  return point;
}

namespace {

// A contact that is pressed into its stop after an impact passes it: what is wrong is the impact.
bool follows_from_release(const OrbitGuard& guard, const Station& station, const SequencedOrbit& orbit) {
  return guard.kind == GuardKind::clearance &&
         std::ranges::any_of(station.survey.guards, [&](const OrbitGuard& other) {
           return other.kind == GuardKind::release && other.value < kViolated &&
                  orbit.event(other.index).contact == guard.index;
         });
}

}  // namespace

bool violates(const OrbitSurvey& survey) {
  return std::ranges::any_of(survey.guards, [](const OrbitGuard& guard) { return guard.value < kViolated; });
}

namespace {

// A step from a station, with secants where that has factors.
CurveStep step_from(const Station& begin, double length) {
  return {.x = begin.x, .tangent = begin.tangent, .length = length, .by_secants = begin.factors != nullptr};
}

// For functions of the motion alone: where secants do, the Jacobian is evaluated where it is asked for.
AnyEquations by_motions(ExtendedEquations& equations, const Station& begin) {
  AnyEquations result(equations);
  if (begin.factors == nullptr) return result;
  result.evaluate = [&equations](const Eigen::VectorXd& x) { return equations.evaluate_motion(x); };
  result.jacobian = [&equations]() -> Eigen::MatrixXd {
    const Eigen::VectorXd x = equations.orbit().x;
    if (equations.evaluate(x)) return equations.jacobian();
    return Eigen::MatrixXd::Constant(x.size() - 1, x.size(), std::numeric_limits<double>::quiet_NaN());
  };
  return result;
}

}  // namespace

bool move_along(ExtendedEquations& equations, const Station& begin, double length,
                const CorrectorLimits& limits) {
  CorrectorLimits along = limits;
  along.near = begin.factors.get();
  return correct(equations, begin.x + length * begin.tangent, begin.tangent, along).has_value();
}

std::optional<GuardCrossing> first_crossing(ExtendedEquations& equations, const Station& begin, double length,
                                            const Station& end) {
  constexpr double kSame = 1e-9;  // of the step: two zeros are one
  std::optional<GuardCrossing> first;
  for (const OrbitGuard& guard : end.survey.guards) {
    if (guard.value >= kViolated || follows_from_release(guard, end, equations.orbit())) continue;
    const OrbitGuard* before = begin.survey.find(guard.kind, guard.index);
    const auto value = [&](const Eigen::VectorXd&) {
      return guard_value(equations, guard.kind, guard.index);
    };
    // Where another one is zero this one still holds: it comes later. Where a contact with a damped stop
    // fades those passages clear it by the square of the way that do not touch it: to rounding.
    const ContactDynamics& dynamics = equations.model().dynamics;
    const bool squared =
        guard.kind == GuardKind::clearance && dynamics.halts(guard.index) && !dynamics.rigid(guard.index);
    if (first && value({}).value_or(0.0) > (squared ? kViolated : 0.0)) continue;
    // What had no maximum before, or is no larger than rounding, gets its sign inside the step.
    const bool positive = before != nullptr && before->value > 0.0;
    const auto zero = locate(by_motions(equations, begin), step_from(begin, length), value,
                             positive ? std::optional(before->value) : std::nullopt, guard.value);
    if (!zero) return std::nullopt;
    // An impact that fades leaves a maximum of x at its instant: events, which are listed first, have
    // priority.
    if (!first || *zero < first->length - kSame * length) first = {.guard = guard, .length = *zero};
  }
  return first;
}

namespace {

// Whether a zero of the phase of the load is a resonance: it falls there as the frequency rises.
bool falls_with_frequency(ExtendedEquations& equations, const Eigen::VectorXd& along, double change) {
  const auto tangent = tangent_of(equations, along);
  return tangent && change * (*tangent)[equations.size()] < 0.0;
}

// Of the two curves through a branch point that which the step is not on.
Eigen::VectorXd crossing_tangent(const BranchPointSolution& point, const Station& begin, double length,
                                 const Station& end) {
  const double share = begin.tangent.dot(point.x - begin.x) / length;
  const Eigen::VectorXd along = begin.tangent + share * (end.tangent - begin.tangent);
  return std::abs(point.first.dot(along)) < std::abs(point.second.dot(along)) ? point.first : point.second;
}

// Those whose test functions have different signs at both ends of the step.
StepBifurcations changes_of_sign(ExtendedEquations& equations, const Station& begin, double length,
                                 const Station& end, double inside) {
  constexpr double kReach = 0.05;     // of the step: of a branch point located to the root of rounding
  constexpr double kUnscaled = 1e-4;  // determinants of many equations are small wherever they are
  StepBifurcations result;
  for (const SpecialKind kind : BifurcationTests::kKinds) {
    const auto &before = begin.tests.of(kind), &after = end.tests.of(kind);
    if (!before || !after || !(*before * *after < 0.0)) continue;
    const bool determinant = kind == SpecialKind::branch_point || kind == SpecialKind::period_doubling;
    const double least = std::max(std::abs(*before), std::abs(*after)) / kUnscaled;
    const double unit = determinant ? std::min(1.0, least) : 1.0;
    const bool of_load = kind == SpecialKind::phase_resonance;
    const bool untangent = of_load && begin.factors != nullptr;
    const auto value = [&](const Eigen::VectorXd&) -> std::optional<double> {
      const auto tangent = untangent ? std::optional(begin.tangent) : tangent_of(equations, begin.tangent);
      const auto test = tangent ? bifurcation_test(equations, *tangent, kind) : std::nullopt;
      return test ? std::optional(*test / unit) : std::nullopt;
    };
    auto zero = locate(of_load ? by_motions(equations, begin) : AnyEquations(equations),
                       step_from(begin, length), value, *before / unit, *after / unit);
    if (zero && !equations.evaluate(Eigen::VectorXd(equations.orbit().x))) zero.reset();
    Eigen::VectorXd across;
    if (zero && kind == SpecialKind::branch_point) {
      // On the curve's own equations it is known to the root of rounding.
      const auto solution = solve_branch_point(equations, equations.orbit().x, kReach * length);
      zero.reset();
      if (solution) {
        zero = begin.tangent.dot(solution->x - begin.x);
        across = crossing_tangent(*solution, begin, length, end);
      }
    }
    if (!zero) result.undecided = true;
    if (!zero || *zero > inside) continue;
    if (of_load && !falls_with_frequency(equations, begin.tangent, *after - *before)) continue;
    const Station there = station_at(equations, begin.tangent);
    const bool energy_turns = kind == SpecialKind::fold && !equations.family().driven();
    if (!of_load && !energy_turns && !confirmed(kind, there.tests.multipliers)) continue;
    SolutionPoint point = of_load ? resonance_point(equations, there) : solution_point(equations, there);
    std::string text = energy_turns          ? "the energy turns"
                       : point.damping_ratio ? fmt::format("damping ratio {:.4g}", *point.damping_ratio)
                                             : "";
    result.found.push_back({.length = *zero,
                            .special = {.kind = kind, .point = std::move(point), .text = std::move(text)},
                            .special_orbit = orbit_at(equations),
                            .orbit = equations.orbit(),
                            .across = std::move(across)});
  }
  return result;
}

}  // namespace

StepBifurcations bifurcations(ExtendedEquations& equations, const Station& begin, double length,
                              const Station& end, double inside) {
  StepBifurcations result = changes_of_sign(equations, begin, length, end, inside);
  std::vector<LocatedBifurcation>& found = result.found;
  constexpr double kBefore = 0.999;  // of the part that counts
  const double shorter = kBefore * inside;
  const bool corrected = inside < length && move_along(equations, begin, shorter);
  if (const auto tangent = corrected ? tangent_of(equations, begin.tangent) : std::nullopt) {
    const Station before = station_at(equations, *tangent, MultiplierRange::leading);
    StepBifurcations others = changes_of_sign(equations, begin, shorter, before, shorter);
    for (LocatedBifurcation& other : others.found) {
      const SpecialKind kind = other.special.kind;
      if (std::ranges::none_of(found, [kind](const auto& one) { return one.special.kind == kind; }))
        found.push_back(std::move(other));
    }
  }
  std::ranges::sort(found, {}, &LocatedBifurcation::length);
  return result;
}

std::optional<Station> guards_at(ExtendedEquations& equations, const Station& begin, double length) {
  if (!move_along(equations, begin, length, kTight)) return std::nullopt;
  const auto tangent = tangent_of(equations, begin.tangent);
  if (!tangent) return std::nullopt;
  std::optional<Station> station(std::in_place);
  station->x = equations.orbit().x;
  station->tangent = *tangent;
  station->survey = survey(equations);
  return station;
}

namespace {

class DipSearch {
 public:
  DipSearch(ExtendedEquations& equations, Station& begin, double length)
      : equations_(equations), begin_(begin), step_(length) {}

  HiddenViolation run(Station& end) {
    search({.length = 0.0, .station = &begin_}, {.length = step_, .station = &end});
    return std::move(result_);
  }

 private:
  struct End {
    double length;
    Station* station;
  };

  void track(Station& station) {
    if (station.tracked.empty())
      station.tracked = tracked_guards(equations_, station.x, station.tangent, station.survey);
  }

  // The derivative of a guard by the length in the plane of the step.
  double slope(const TrackedGuard& guard, const Station& station) const {
    return guard.rate / begin_.tangent.dot(station.tangent);
  }

  // A maximum that an impact leaves behind as it fades, and that is gone where it has a speed.
  static bool left_by_an_event(double value) { return value < kGuardZero; }

  // The least bound of those guards between two points that may be lower there than at both of them.
  GuardCubic::Lowest lowest(const End& a, const End& b) const {
    const double h = b.length - a.length;
    GuardCubic::Lowest least{.at = 0.5, .bound = 0.0};
    const auto consider = [&](const GuardCubic& cubic, const GuardCubic::Lowest& here) {
      if (here.bound < std::min({0.0, cubic.value, cubic.last}) + kViolated && here.bound < least.bound)
        least = here;
    };
    const auto &first = a.station->tracked, &second = b.station->tracked;
    for (const TrackedGuard& guard : first) {
      GuardCubic cubic{.value = guard.value, .slope = h * slope(guard, *a.station)};
      if (const TrackedGuard* other = counterpart(guard, first, second)) {
        cubic.last = other->value;
        cubic.last_slope = h * slope(*other, *b.station);
        consider(cubic, cubic.lowest());
      } else if (!left_by_an_event(cubic.value)) {
        consider(cubic, {.at = 0.5, .bound = cubic.value + cubic.slope});
      }
    }
    for (const TrackedGuard& guard : second) {
      const double value = guard.value;
      if (left_by_an_event(value) || counterpart(guard, second, first) != nullptr) continue;
      consider({.last = value}, {.at = 0.5, .bound = value - h * slope(guard, *b.station)});
    }
    return least;
  }

  // Leaves what it finds in result_.
  void search(const End& a, const End& b) {
    constexpr int kChecks = 24;
    constexpr double kNarrow = 1e-6;  // of the step
    const double h = b.length - a.length;
    if (result_.found || h < kNarrow * step_) return;
    track(*a.station);
    track(*b.station);
    const GuardCubic::Lowest least = lowest(a, b);
    if (least.bound >= 0.0) return;
    const double length = a.length + least.at * h;
    auto between = checks_++ < kChecks ? guards_at(equations_, begin_, length) : std::optional<Station>();
    if (!between) {
      result_.undecided = true;
      return;
    }
    if (violates(between->survey)) {
      result_.found = {.length = length,
                       .station = station_at(equations_, between->tangent, MultiplierRange::leading)};
      return;
    }
    const End middle{.length = length, .station = &*between};
    search(a, middle);
    search(middle, b);
  }

  ExtendedEquations& equations_;
  Station& begin_;
  double step_;
  int checks_ = 0;
  HiddenViolation result_ = {};
};

}  // namespace

HiddenViolation hidden_violation(ExtendedEquations& equations, Station& begin, double length, Station& end) {
  return DipSearch(equations, begin, length).run(end);
}

StepEnd cut_at_violation(ExtendedEquations& equations, Station& begin, double& length, Station& end) {
  constexpr int kTimes = 8;  // a zero before the dip that was found
  StepEnd result;
  bool cut = violates(end.survey);
  for (int k = 0; k <= kTimes; ++k) {
    if (cut) {
      result.crossing = first_crossing(equations, begin, length, end);
      if (!result.crossing) return {.undecided = true};
    }
    auto zero =
        result.crossing ? guards_at(equations, begin, result.crossing->length) : std::optional<Station>();
    if (result.crossing && !zero) {
      result.undecided = true;
      break;
    }
    HiddenViolation hidden = hidden_violation(
        equations, begin, result.crossing ? result.crossing->length : length, zero ? *zero : end);
    // What is found ends the step wherever else it came to no end, unless that lies before.
    result.undecided = hidden.undecided;
    cut = hidden.found.has_value();
    if (!cut) break;
    length = hidden.found->length;
    end = std::move(hidden.found->station);
    equations.evaluate(end.x);
  }
  result.undecided = result.undecided || cut;
  equations.evaluate(end.x);
  return result;
}

}  // namespace signorini
