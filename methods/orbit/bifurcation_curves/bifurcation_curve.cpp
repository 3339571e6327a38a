#include "methods/orbit/bifurcation_curves/bifurcation_curve.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "methods/orbit/bifurcation_curves/special_equations.hpp"
#include "methods/orbit/continuation/contact_changes.hpp"
#include "methods/orbit/continuation/grazing_starts.hpp"
#include "methods/orbit/continuation/station.hpp"
#include "methods/orbit/family/orbit_section.hpp"

namespace signorini {

namespace {

// The first guard that is zero where the equations are evaluated: those of events come before those of
// contacts.
std::optional<OrbitGuard> vanishing_guard(const ExtendedEquations& equations) {
  const std::vector<OrbitGuard> guards = survey(equations).guards;
  const auto zero =
      std::ranges::find_if(guards, [](const auto& guard) { return std::abs(guard.value) < kGuardZero; });
  return zero == guards.end() ? std::nullopt : std::optional(*zero);
}

// The orbits of the same order beyond a grazing: without the impact that fades, or with as many of those that
// begin as can.
ChangeOfSequence past_grazing(OrbitFamily& family, const TracedCurve& end) {
  const auto grazing = grazing_orbit(family, end);
  if (!grazing) return {.obstacle = "the grazing orbit cannot be evaluated"};
  if (!grazing->obstacle.empty()) return {.obstacle = grazing->obstacle};
  if (end.guard->kind != GuardKind::clearance) {
    auto clear = start_clear(family, *grazing);
    return {.start = clear, .obstacle = clear ? "" : "the orbit without the impact cannot be evaluated"};
  }
  ChangeOfSequence beyond{.obstacle = "no motion of the same period begins there"};
  const auto starts = start_impacting(family, *grazing, grazing->base.order);
  for (const CurveStart& start : starts.value_or(std::vector<CurveStart>())) {
    if (start.orbit.order != grazing->base.order) continue;
    if (!beyond.start || start.orbit.events.size() > beyond.start->orbit.events.size())
      beyond = {.start = start};
  }
  return beyond;
}

// Where the motions of a curve go on at another one, at a value of the second number in its unit.
struct Onward {
  CurveStart start;
  double second = 0.0;
};

// A guard that is negative there, but for the one that the curve holds at zero and its double: where an
// impact fades a maximum of the displacement takes its place.
std::optional<OrbitGuard> violated(SpecialEquations& special) {
  const auto& own = special.guard();
  for (const OrbitGuard& guard : survey(special.orbits()).guards) {
    if (guard.value >= kViolated || (own && guard.same(*own))) continue;
    if (own && guard.kind == GuardKind::clearance && guard.value > -kGuardZero) continue;
    return guard;
  }
  return std::nullopt;
}

// Of a special point at the beginning of the second interval.
std::optional<SequencedOrbit> orbit_of_start(OrbitPlane& plane, const SolutionPoint& at,
                                             const OrbitGuess& known) {
  const auto family = plane.family(plane.scene().from);
  const double period = kTwoPi * at.order / at.frequency;
  return with_quiet_section(*family, sequenced(*family, known, period, at.frequency, at.parameter));
}

// The orbit at which the equations are evaluated as a point of a curve.
SolutionPoint point_of(SpecialKind kind, SpecialEquations& special) {
  const Station station = station_at(special.orbits(), special.reference());
  return kind == SpecialKind::phase_resonance ? resonance_point(special.orbits(), station)
                                              : solution_point(special.orbits(), station);
}

// The motions beyond the orbit at which the equations are evaluated, where a guard vanishes.
ChangeOfSequence past_end(const ExtendedEquations& equations, const OrbitGuard& guard) {
  TracedCurve end;
  end.guard = guard_of(equations, guard.kind, guard.index).value_or(guard);
  end.last = equations.orbit();
  return is_grazing(*end.guard, equations) ? past_grazing(equations.family(), end)
                                           : past_change(equations.family(), end);
}

// By which sign the guard that vanishes at a point of a curve changes along its tangent; 0 where it is not to
// be told. The equations are left evaluated there.
double rise_of_guard(SpecialEquations& special, const Eigen::VectorXd& x, const Eigen::VectorXd& tangent) {
  constexpr double kBeside = 1e-5, kNoise = 1e-10;  // in the units of the curve; of a guard
  const auto guard = vanishing_guard(special.orbits());
  if (!guard) return 0.0;
  const auto at = [&](double way) {
    return special.evaluate(x + way * tangent) ? guard_value(special.orbits(), *guard) : std::nullopt;
  };
  const auto ahead = at(kBeside), behind = at(-kBeside);
  special.evaluate(x);
  const double change = ahead && behind ? *ahead - *behind : 0.0;
  return std::abs(change) > kNoise ? change : 0.0;
}

constexpr CorrectorLimits kLimits{.iterations = 10, .tolerance = 1e-12};

class BifurcationCurveTracer {
 public:
  BifurcationCurveTracer(OrbitPlane& plane, SpecialKind kind, const CurveLimits& limits)
      : plane_(plane), limits_(limits), kind_(kind) {}

  // From a special point and its orbit, or where another curve goes on.
  Branch run(const auto&... start) {
    begin(start...);
    while (!done_) advance();
    return std::move(result_);
  }

  // Beyond the end of what has run.
  [[nodiscard]] const std::optional<Onward>& onward() const { return onward_; }

 private:
  void finish(std::string reason) {
    result_.ended = std::move(reason);
    done_ = true;
  }
  void shorten(double factor) { step_ *= factor; }

  void begin(const SpecialPoint& start, const OrbitGuess& known) {
    const auto orbit = orbit_of_start(plane_, start.point, known);
    if (!orbit) return finish("the start cannot be evaluated");
    result_.sequence = describe_sequence(*orbit);
    result_.began = fmt::format("{} at {:.10g}", describe(start.kind), start.point.parameter);
    place(*orbit, plane_.scene().from / plane_.unit());
    if (done_) return;
    const Eigen::VectorXd fixed = Eigen::VectorXd::Unit(special_->size() + 1, special_->size());
    if (!correct(*special_, special_->x(), fixed, kLimits)) return finish("the start cannot be corrected");
    x_ = special_->x();
    tangent_ = first_tangent(*special_, plane_.scene().to > plane_.scene().from);
    append();
  }

  // What begins has no length or speed yet: its guard rises the right way, and where that is not to
  // be told a first step the wrong way shows at once (`turns_back`).
  void begin(const Onward& onward) {
    result_.sequence = describe_sequence(onward.start.orbit);
    result_.began = onward.start.origin;
    step_ *= onward.start.first_step_share;
    place(onward.start.orbit, onward.second);
    if (done_) return;
    tangent_ = first_tangent(*special_);
    if (tangent_.head(special_->size()).dot(onward.start.tangent) < 0.0) tangent_ = -tangent_;
    if (!correct(*special_, x_, tangent_, kLimits) && !special_->evaluate(x_))
      return finish("the start cannot be evaluated");
    x_ = special_->x();
    append();
    const double rise = rise_of_guard(*special_, x_, tangent_);
    may_turn_ = rise == 0.0;
    if (rise < 0.0) tangent_ = -tangent_;
  }

  // Takes an orbit with its section as the place where the equations are evaluated.
  void place(const SequencedOrbit& orbit, double q) {
    const auto family = plane_.family(q * plane_.unit());
    ExtendedEquations equations(*family, orbit);
    if (!equations.evaluate(orbit.x)) return finish("the flow is not finite");
    std::optional<OrbitGuard> guard;
    if (kind_ == SpecialKind::grazing || kind_ == SpecialKind::contact_change) {
      guard = vanishing_guard(equations);
      if (!guard) return finish("no test function vanishes there");
    }
    special_ = std::make_unique<SpecialEquations>(plane_, orbit, kind_, guard, first_tangent(equations));
    x_.resize(orbit.x.size() + 1);
    x_ << orbit.x, q;
    if (!special_->evaluate(x_) || !special_->rescale())
      return finish("its test function has no derivative there");
  }

  void append() {
    result_.points.push_back(point_of(kind_, *special_));
    result_.points.back().second = special_->second();
  }

  [[nodiscard]] CurveStep whole_step() const { return {.x = x_, .tangent = tangent_, .length = step_}; }
  void advance() {
    if (limits_.expired()) return finish("the time is up");
    if (step_ < kOrbitSteps.shortest) return finish("the corrector fails");
    const auto iterations = correct(*special_, x_ + step_ * tangent_, tangent_, kLimits);
    if (!iterations) return shorten(0.4);
    if (clearance_of_section(special_->orbits().orbit()) <= 0.0) return shorten(0.5);
    if (leaves()) return;
    const auto tangent = tangent_of(*special_, tangent_);
    const bool turned = tangent && tangent->dot(tangent_) < std::cos(kOrbitSteps.turned);
    if (!tangent || (turned && step_ > kOrbitSteps.any_turn)) return shorten(0.5);
    if (const auto guard = violated(*special_)) return turns_back() ? void() : end_at(*guard);
    const double turn = std::acos(std::min(1.0, tangent->dot(tangent_)));
    x_ = special_->x();
    tangent_ = *tangent;
    append();
    special_->take_reference();
    const double longest =
        longest_step(limits_.step_share * kOrbitSteps.longest, x_.lpNorm<Eigen::Infinity>());
    step_ = next_step(step_, *iterations, turn, longest);
    if (static_cast<int>(result_.points.size()) >= limits_.max_points)
      return finish(fmt::format("limit of {} points", limits_.max_points));
    keep_section_clear();
    if (!done_ && !special_->rescale()) finish("its test function has no derivative there");
  }

  // Ends the curve where the step leaves one of the intervals, in the second one first.
  bool leaves() {
    const Eigen::Index last = x_.size() - 1;
    const ScenePlane& scene = plane_.scene();
    const ParametrisedScene first = special_->orbits().family().scene();  // locate() takes other families
    const auto end_on = [&](Eigen::Index place, double unit, double low, double high,
                            const std::string& name) {
      const double value = special_->x()[place] * unit;
      if (done_ || (value >= low && value <= high)) return;
      const double bound = value < low ? low : high;
      const auto distance = [&](SpecialEquations& at) { return std::optional(at.x()[place] - bound / unit); };
      const double before = x_[place] - bound / unit, after = special_->x()[place] - bound / unit;
      if (before * after < 0.0 && locate(*special_, whole_step(), distance, before, after)) append();
      finish(fmt::format("end of the interval of {}", name));
    };
    end_on(last, plane_.unit(), std::min(scene.from, scene.to), std::max(scene.from, scene.to), scene.second);
    end_on(last - 1, special_->orbits().family().units().parameter, first.low(), first.high(),
           first.parameter);
    return done_;
  }

  void end_at(const OrbitGuard& guard) {
    const auto value = [&](SpecialEquations& at) { return guard_value(at.orbits(), guard); };
    const auto before = special_->evaluate(x_) ? value(*special_) : std::nullopt;
    const bool positive = before && *before > 0.0;
    if (!locate(*special_, whole_step(), value, positive ? before : std::nullopt, guard.value))
      return shorten(0.5);
    append();
    const ExtendedEquations& orbits = special_->orbits();
    finish(describe(guard, orbits.orbit(), orbits.model().dynamics));
    if (kind_ != SpecialKind::phase_resonance) return;
    const double second = special_->x()[special_->size()];
    ChangeOfSequence beyond = past_end(orbits, guard);
    if (beyond.start)
      onward_ = Onward{.start = std::move(*beyond.start), .second = second};
    else
      result_.ended += ": " + beyond.obstacle;
  }

  // The first step of what begins at the end of another curve goes the wrong way: it is taken the other way.
  bool turns_back() {
    if (!std::exchange(may_turn_, false) || result_.points.size() > 1) return false;
    tangent_ = -tangent_;
    return true;
  }

  // As of a branch: an event that slid over the section would make the arcs run backwards.
  void keep_section_clear() {
    constexpr double kNear = 0.2;  // rad
    const ExtendedEquations& orbits = special_->orbits();
    if (clearance_of_section(orbits.orbit()) > kNear) return;
    const SequencedOrbit moved = with_section(orbits.orbit(), orbits, quiet_phase(orbits.orbit()));
    const Eigen::Vector2d shared = tangent_.tail(2);
    const double q = x_[x_.size() - 1];
    place(moved, q);
    if (done_) return;
    tangent_ = first_tangent(*special_);
    if (tangent_.tail(2).dot(shared) < 0.0) tangent_ = -tangent_;
  }

  OrbitPlane& plane_;
  const CurveLimits& limits_;
  SpecialKind kind_;
  double step_ = kOrbitSteps.first;
  bool done_ = false, may_turn_ = false;
  std::optional<Onward> onward_;
  std::unique_ptr<SpecialEquations> special_;
  Eigen::VectorXd x_, tangent_;
  Branch result_;
};

constexpr double kSameValue = 1e-9;  // of a parameter: it has the same value

// Whether a curve leads anywhere: one that ends where it begins would lead back along the curve before.
bool has_length(const Branch& curve) {
  if (curve.points.size() != 2) return curve.points.size() > 2;
  const SolutionPoint &first = curve.points.front(), &last = curve.points.back();
  return std::abs(first.frequency - last.frequency) > kSameValue * first.frequency ||
         std::abs(*first.second - *last.second) > kSameValue * std::abs(*first.second);
}

// The curve through a special point, and those that go on where its sequence of events changes.
std::vector<Branch> trace_from(OrbitPlane& plane, const SpecialPoint& start, const OrbitGuess& orbit,
                               const CurveLimits& limits) {
  BifurcationCurveTracer first(plane, start.kind, limits);
  std::vector<Branch> curves{first.run(start, orbit)};
  std::optional<Onward> onward = first.onward();
  while (onward && static_cast<int>(curves.size()) < limits.max_branches) {
    BifurcationCurveTracer next(plane, start.kind, limits);
    Branch curve = next.run(*onward);
    onward = next.onward();
    if (has_length(curve)) {
      curves.push_back(std::move(curve));
      continue;
    }
    onward.reset();
    curves.back().ended += fmt::format(": beyond, {}", curve.ended);
  }
  return curves;
}

// Whether two points are one motion.
bool one_motion(const SolutionPoint& a, const SolutionPoint& b) {
  constexpr double kAlike = 1e-6;
  const auto near = [](double x, double y) { return std::abs(x - y) <= kAlike * std::abs(x + y); };
  return near(a.parameter, b.parameter) && std::ranges::equal(a.x_max, b.x_max, near) &&
         std::ranges::equal(a.amplitude, b.amplitude, near);
}

}  // namespace

bool has_curve(SpecialKind kind) { return kind != SpecialKind::branch_point; }

std::string why_none(const ScenePlane& plane, SpecialKind kind) {
  std::string reason = fmt::format("no {} at {} = {:.6g}", describe(kind), plane.second, plane.from);
  if (kind != SpecialKind::phase_resonance) return reason;
  const ParametrisedScene scene = plane.at(plane.from);
  const OrbitModel model(scene.at(scene.middle()));
  const std::string obstacle = phase_obstacle(model.dynamics.structure());
  return obstacle.empty() ? reason + " between these frequencies" : reason + ": " + obstacle;
}

std::vector<Branch> bifurcation_curves(const ScenePlane& plane, const OrbitDiagram& diagram, SpecialKind kind,
                                       const CurveLimits& limits) {
  if (!has_curve(kind)) throw std::invalid_argument("branch points have no curve in two parameters");
  struct Begin {
    const SpecialPoint* special;
    const OrbitGuess* orbit;
    [[nodiscard]] auto rank() const { return std::pair(special->point.order, orbit->events.size()); }
  };
  std::vector<Begin> starts;
  for (const OrbitBranch& branch : diagram.branches) {
    for (std::size_t i = 0; i < branch.special.size(); ++i) {
      if (branch.special[i].kind == kind) starts.push_back({&branch.special[i], &branch.special_orbits[i]});
    }
  }
  std::ranges::stable_sort(starts, {}, &Begin::rank);
  OrbitPlane orbits(plane);
  std::vector<Branch> curves;
  std::vector<SolutionPoint> known;
  for (const Begin& start : starts) {
    const SolutionPoint& point = start.special->point;
    if (std::ranges::any_of(known, [&](const auto& other) { return one_motion(point, other); })) continue;
    known.push_back(point);
    for (Branch& curve : trace_from(orbits, *start.special, *start.orbit, limits)) {
      if (limits.take) limits.take(curve);
      curves.push_back(std::move(curve));
    }
    const Branch& curve = curves.back();
    const bool returns = curve.points.size() > 1 && std::abs(*curve.points.back().second - plane.from) <
                                                        kSameValue * std::abs(plane.to - plane.from);
    if (returns) known.push_back(curve.points.back());
  }
  return curves;
}

}  // namespace signorini
