#include "methods/orbit/bifurcation_curves/bifurcation_curve.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "methods/orbit/bifurcation_curves/special_equations.hpp"
#include "methods/orbit/continuation/curve.hpp"
#include "methods/orbit/continuation/station.hpp"
#include "methods/orbit/family/orbit_section.hpp"

namespace signorini {

namespace {

// The first guard that is zero where the equations are evaluated: those of events come before those of
// contacts.
std::optional<OrbitGuard> vanishing_guard(const ExtendedEquations& equations) {
  std::optional<OrbitGuard> least;
  constexpr double kZero = 1e-8;
  for (const OrbitGuard& guard : survey(equations).guards) {
    if (std::abs(guard.value) < kZero && !least) least = guard;
  }
  return least;
}

class BifurcationCurveTracer {
 public:
  BifurcationCurveTracer(const ScenePlane& plane, const SpecialPoint& start, const OrbitGuess& orbit,
                         const CurveLimits& limits)
      : plane_(plane), limits_(limits) {
    result_.kind = start.kind;
    begin(start, orbit);
  }

  BifurcationCurve run() {
    while (!done_) advance();
    return std::move(result_);
  }

 private:
  void finish(std::string reason) {
    result_.ended = std::move(reason);
    done_ = true;
  }
  void shorten(double factor) { step_ *= factor; }

  void begin(const SpecialPoint& start, const OrbitGuess& known) {
    const SolutionPoint& at = start.point;
    const auto family = plane_.family(plane_.scene().from);
    const SequencedOrbit given =
        sequenced(*family, known, kTwoPi * at.order / at.frequency, at.frequency, at.parameter);
    const auto orbit = with_quiet_section(*family, given);
    if (!orbit) return finish("the start cannot be evaluated");
    result_.sequence = describe_sequence(*orbit);
    result_.began = fmt::format("{} at {:.10g}", describe(start.kind), at.parameter);
    const double q = plane_.scene().from / plane_.unit();
    place(*orbit, q);
    if (done_) return;
    const double inwards = plane_.scene().to > plane_.scene().from ? 1.0 : -1.0;
    const Eigen::VectorXd fixed = Eigen::VectorXd::Unit(special_->size() + 1, special_->size());
    if (!correct(*special_, special_->x(), fixed, kLimits)) return finish("the start cannot be corrected");
    x_ = special_->x();
    tangent_ = first_tangent(*special_, inwards > 0.0);
    append();
  }

  // Takes an orbit with its section as the place where the equations are evaluated.
  void place(const SequencedOrbit& orbit, double q) {
    const auto family = plane_.family(q * plane_.unit());
    ExtendedEquations equations(*family, orbit);
    if (!equations.evaluate(orbit.x)) return finish("the flow is not finite");
    std::optional<OrbitGuard> guard;
    if (result_.kind == SpecialKind::grazing || result_.kind == SpecialKind::contact_change) {
      guard = vanishing_guard(equations);
      if (!guard) return finish("no test function vanishes there");
    }
    special_ =
        std::make_unique<SpecialEquations>(plane_, orbit, result_.kind, guard, first_tangent(equations));
    x_.resize(orbit.x.size() + 1);
    x_ << orbit.x, q;
    if (!special_->evaluate(x_) || !special_->rescale())
      return finish("its test function has no derivative there");
  }

  void append() {
    const Station station = station_at(special_->orbits(), special_->reference());
    result_.points.push_back(solution_point(special_->orbits(), station));
    result_.second.push_back(special_->second());
  }

  [[nodiscard]] CurveStep whole_step() const { return {.x = x_, .tangent = tangent_, .length = step_}; }

  void advance() {
    constexpr double kTurned = 0.35, kShort = 1e-4;  // rad; a step at which every turn is taken
    constexpr double kShortest = 1e-7;               // below, the curve ends
    if (limits_.expired()) return finish("the time is up");
    if (step_ < kShortest) return finish("the corrector fails");
    const auto iterations = correct(*special_, x_ + step_ * tangent_, tangent_, kLimits);
    if (!iterations) return shorten(0.4);
    if (clearance_of_section(special_->orbits().orbit()) <= 0.0) return shorten(0.5);
    if (leaves()) return;
    const auto tangent = tangent_of(*special_, tangent_);
    if (!tangent || (tangent->dot(tangent_) < std::cos(kTurned) && step_ > kShort)) return shorten(0.5);
    if (const auto guard = violated()) return end_at(*guard);
    const double turn = std::acos(std::min(1.0, tangent->dot(tangent_)));
    x_ = special_->x();
    tangent_ = *tangent;
    append();
    special_->take_reference();
    step_ = next_step(step_, *iterations, turn, limits_.step_share * kLongestStep);
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

  // A guard that is negative there, but for the one that the curve holds at zero and its double: where an
  // impact fades a maximum of the displacement takes its place.
  [[nodiscard]] std::optional<OrbitGuard> violated() {
    constexpr double kDouble = -1e-8;
    const auto& own = special_->guard();
    for (const OrbitGuard& guard : survey(special_->orbits()).guards) {
      if (guard.value >= kViolated || (own && guard.same(*own))) continue;
      if (own && guard.kind == GuardKind::clearance && guard.value > kDouble) continue;
      return guard;
    }
    return std::nullopt;
  }

  void end_at(const OrbitGuard& guard) {
    const auto value = [&](SpecialEquations& at) -> std::optional<double> {
      const auto found = guard_of(at.orbits(), guard.kind, guard.index);
      return found ? std::optional(found->value) : std::nullopt;
    };
    const auto before = special_->evaluate(x_) ? value(*special_) : std::nullopt;
    const bool positive = before && *before > 0.0;
    if (!locate(*special_, whole_step(), value, positive ? before : std::nullopt, guard.value))
      return shorten(0.5);
    append();
    const ExtendedEquations& orbits = special_->orbits();
    finish(describe(guard, orbits.orbit(), orbits.model().dynamics));
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

  static constexpr CorrectorLimits kLimits{.iterations = 10, .tolerance = 1e-12};

  OrbitPlane plane_;
  const CurveLimits& limits_;
  double step_ = 0.01;  // the first one
  bool done_ = false;
  std::unique_ptr<SpecialEquations> special_;
  Eigen::VectorXd x_, tangent_;
  BifurcationCurve result_;
};

// Whether two points are one motion.
bool one_motion(const SolutionPoint& a, const SolutionPoint& b) {
  constexpr double kSame = 1e-6;
  const auto near = [](double x, double y) { return std::abs(x - y) <= kSame * std::abs(x + y); };
  return near(a.parameter, b.parameter) &&
         std::equal(a.x_max.begin(), a.x_max.end(), b.x_max.begin(), b.x_max.end(), near) &&
         std::equal(a.amplitude.begin(), a.amplitude.end(), b.amplitude.begin(), b.amplitude.end(), near);
}

}  // namespace

bool has_curve(SpecialKind kind) { return kind != SpecialKind::branch_point; }

BifurcationCurve trace_bifurcation_curve(const ScenePlane& plane, const SpecialPoint& start,
                                         const OrbitGuess& orbit, const CurveLimits& limits) {
  return BifurcationCurveTracer(plane, start, orbit, limits).run();
}

std::vector<BifurcationCurve> bifurcation_curves(const ScenePlane& plane, const OrbitDiagram& diagram,
                                                 SpecialKind kind, const CurveLimits& limits) {
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
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Begin& a, const Begin& b) { return a.rank() < b.rank(); });
  std::vector<BifurcationCurve> curves;
  std::vector<SolutionPoint> known;
  constexpr double kAtEnd = 1e-9;
  for (const Begin& start : starts) {
    const SolutionPoint& point = start.special->point;
    if (std::any_of(known.begin(), known.end(),
                    [&](const SolutionPoint& other) { return one_motion(point, other); }))
      continue;
    known.push_back(point);
    curves.push_back(trace_bifurcation_curve(plane, *start.special, *start.orbit, limits));
    const BifurcationCurve& curve = curves.back();
    const bool returns = curve.points.size() > 1 && std::abs(curve.second.back() - plane.from) <
                                                        kAtEnd * std::abs(plane.to - plane.from);
    if (returns) known.push_back(curve.points.back());
  }
  return curves;
}

}  // namespace signorini
