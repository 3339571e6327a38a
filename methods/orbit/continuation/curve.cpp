#include "methods/orbit/continuation/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <tuple>
#include <utility>

#include "methods/orbit/continuation/hidden_bifurcations.hpp"
#include "methods/orbit/continuation/station.hpp"
#include "methods/orbit/family/chatter.hpp"
#include "methods/orbit/family/followed_quantity.hpp"
#include "methods/orbit/family/orbit_section.hpp"
#include "methods/orbit/impact_orders.hpp"

namespace signorini {

namespace {

// Evaluates the equations at the start, corrected where the curve is regular: an impact put in at a grazing
// is there to the accuracy of its instant, half the digits of the motion. False where they are not finite.
bool begin(ExtendedEquations& equations, const CurveStart& start) {
  const bool regular = start.leaves == LeftBranch::none;
  return (regular && correct(equations, start.orbit.x, start.tangent)) || equations.evaluate(start.orbit.x);
}

// Why the point after the start is no orbit of the scene, or on the curve that was to be left; else empty.
std::string why_rejected(const ExtendedEquations& equations, const CurveStart& start, const Station& begin,
                         const Station& next) {
  std::string why;
  for (const OrbitGuard& guard : next.survey.guards) {
    const OrbitGuard* before = begin.survey.find(guard.kind, guard.index);
    if (guard.value >= kViolated || before == nullptr || before->value > kTouches) continue;
    why =
        "not admissible beside its start: " + describe(guard, equations.orbit(), equations.model().dynamics);
  }
  if (start.leaves == LeftBranch::repetition &&
      of_least_period(equations.orbit(), equations).order < equations.orbit().order)
    why = "the corrector fell back on the branch that was to be left";
  return why;
}

// The orbit of a curve in other unknowns, with the tangent there; or why it cannot be had.
struct OtherUnknowns {
  std::unique_ptr<ExtendedEquations> equations = {};
  Eigen::VectorXd tangent = {};
  std::string obstacle = {};
};

// The tangent is on the side of `way`, of which the entries are 0 that are no unknowns of both.
OtherUnknowns going_on(OrbitFamily& family, const SequencedOrbit& orbit, const Eigen::VectorXd& way) {
  OtherUnknowns other{.equations = std::make_unique<ExtendedEquations>(family, orbit)};
  if (!other.equations->evaluate(orbit.x)) return {.obstacle = "the corrector fails"};
  other.tangent = first_tangent(*other.equations);
  if (other.tangent.dot(way) < 0.0) other.tangent = -other.tangent;
  return other;
}

// An event that slid over the section would make the arcs run backwards. Empty where none is near.
std::optional<OtherUnknowns> with_section_clear(const ExtendedEquations& here,
                                                const Eigen::VectorXd& tangent) {
  constexpr double kNear = 0.2, kBetter = 1.2;  // rad; a share
  const SequencedOrbit& orbit = here.orbit();
  if (clearance_of_section(orbit) > kNear) return std::nullopt;
  const double phase = quiet_phase(orbit);
  const SequencedOrbit moved = with_section(orbit, here, phase);
  if (clearance_of_section(moved) < kBetter * clearance_of_section(orbit)) return std::nullopt;
  Eigen::VectorXd way = tangent;
  way.head(orbit.states()).setZero();
  const auto first = tangent.begin() + orbit.states();
  std::rotate_copy(first, first + orbit.passed(phase), first + orbit.count(), way.begin() + orbit.states());
  OtherUnknowns other = going_on(here.family(), moved, way);
  return other.obstacle.empty() ? std::optional(std::move(other)) : std::nullopt;
}

// Along the curve the last impacts of a chatter come to matter, or cease to. Empty where they are as before.
std::optional<OtherUnknowns> with_chatter_resolved(const ExtendedEquations& here,
                                                   const Eigen::VectorXd& tangent) {
  ResolvedChatter resolved = resolve_chatter(here);
  if (!resolved.obstacle.empty()) return OtherUnknowns{.obstacle = std::move(resolved.obstacle)};
  if (!resolved.orbit) return std::nullopt;
  const SequencedOrbit& orbit = *resolved.orbit;
  Eigen::VectorXd way = Eigen::VectorXd::Zero(orbit.x.size());
  way.head(orbit.states()) = tangent.head(orbit.states());
  way[way.size() - 1] = tangent[tangent.size() - 1];
  return going_on(here.family(), orbit, way);
}

// A step along the length L of the shortest phase of contact, or break of one, that is about to end: the
// parameter turns there, being even in L, at a stiff stop on a radius below any step; in L the curve is
// straight. The step prescribes -L/2, so that the end of the phase lies on it. With its point, the length of
// L as tangent. Empty unless the step refused came near such an end.
std::optional<std::pair<Station, double>> along_ending_phase(const ExtendedEquations& equations,
                                                             const Station& here, double refused) {
  constexpr double kBrief = 5e-5, kReach = 4.0, kBeyond = 1.5;  // rad; of the step refused; of L
  SequencedOrbit orbit = equations.orbit();
  orbit.x = here.x;  // the equations may have been left elsewhere
  if (here.tracked.empty()) return std::nullopt;
  double shortest = kBrief;
  Eigen::VectorXd along;
  for (Eigen::Index i = 1; i < orbit.count(); ++i) {
    const Eigen::Index row = orbit.states() + i;
    const double length = orbit.phase(i) - orbit.phase(i - 1);
    const double rate = here.tangent[row] - here.tangent[row - 1];
    const int contact = orbit.event(i).contact;
    const bool one = contact == orbit.event(i - 1).contact && !equations.model().dynamics.halts(contact);
    if (!one || !(length < shortest) || !(-rate * kReach * refused > length)) continue;
    shortest = length;
    along = Eigen::VectorXd::Unit(here.x.size(), row - 1) - Eigen::VectorXd::Unit(here.x.size(), row);
  }
  if (along.size() == 0) return std::nullopt;
  Station steered = here;
  steered.tangent = along.normalized();
  steered.factors.reset();
  for (TrackedGuard& guard : steered.tracked) guard.rate /= steered.tangent.dot(here.tangent);
  return std::pair(std::move(steered), kBeyond * shortest / along.norm());
}

// What the order of two impacts that come together changes beyond; else empty.
std::string why_order_matters(const ExtendedEquations& equations, const OrbitGuard& guard) {
  if (guard.kind != GuardKind::interval) return {};
  const SequencedOrbit& orbit = equations.orbit();
  const SequenceEvent& before = orbit.event((guard.index + orbit.count() - 1) % orbit.count());
  switch (coupling_of(equations.model().dynamics.structure(), before, orbit.event(guard.index))) {
    case ImpactCoupling::mass:
      return fmt::format(": what follows {}", kDependsOnOrder);
    case ImpactCoupling::dampers:
      return fmt::format(": a corner, for the derivative of what follows {}", kDependsOnOrder);
    default:
      return {};
  }
}

// The end of a curve at the zero of a guard.
SpecialPoint change_at(const ExtendedEquations& equations, const OrbitGuard& guard,
                       const SolutionPoint& point) {
  const bool grazes = is_grazing(guard, equations);
  const std::string limit = ends_chatter(equations, guard) ? std::string(kChatterLimit) + ": " : "";
  return {.kind = grazes ? SpecialKind::grazing : SpecialKind::contact_change,
          .point = point,
          .text = limit + describe(guard, equations.orbit(), equations.model().dynamics) +
                  why_order_matters(equations, guard)};
}

// A special point before the next point of the branch.
void add(SpecialPoint special, OrbitGuess orbit, TracedCurve& result) {
  special.after = result.branch.points.size();
  result.branch.special.push_back(std::move(special));
  result.branch.special_orbits.push_back(std::move(orbit));
}

// The same with the orbit at which the branch may be left.
void record(LocatedBifurcation found, TracedCurve& result) {
  if (found.special.kind == SpecialKind::period_doubling)
    result.doublings.push_back(std::move(found.orbit));
  else if (found.special.kind == SpecialKind::branch_point)
    result.crossings.emplace_back(std::move(found.orbit), std::move(found.across));
  add(std::move(found.special), std::move(found.special_orbit), result);
}

// |y_0| in CurveUnits.
double size_of_state(const SequencedOrbit& orbit) {
  return orbit.x.head(orbit.states()).lpNorm<Eigen::Infinity>();
}

// Of many equations, which are solved by secants; else none.
std::shared_ptr<const CurveFactors> factors_at(ExtendedEquations& equations, const Eigen::VectorXd& row) {
  if (equations.size() < kManyStates || !equations.family().driven()) return nullptr;
  return std::make_shared<const CurveFactors>(equations, row);
}

// All multipliers where a step ends at a value asked for, and every so many points: they cost what some ten
// other points do.
MultiplierRange range_at(std::size_t points, bool asked) {
  constexpr std::size_t kBetween = 64;
  return asked || points % kBetween == 0 ? MultiplierRange::all : MultiplierRange::leading;
}

class Tracer {
 public:
  Tracer(OrbitFamily& family, const CurveStart& start, const CurveLimits& limits,
         const std::optional<ParameterRange>& energies)
      : family_(family),
        limits_(limits),
        followed_(family, energies),
        start_(start),
        equations_(std::make_unique<ExtendedEquations>(family, start.orbit)),
        step_(kOrbitSteps.first * start.first_step_share) {}

  TracedCurve run() {
    result_.branch.sequence = describe_sequence(start_.orbit);
    result_.branch.began = start_.origin;
    if (!begin(*equations_, start_)) {
      result_.rejected = "the flow is not finite";
      return std::move(result_);
    }
    here_ = station_at(*equations_, start_.tangent.normalized());
    if (start_.leaves != LeftBranch::none) here_.tests.values = {};  // the branch point there is known
    half_way_ = start_.leaves == LeftBranch::repetition ? Eigen::VectorXd::Zero(start_.orbit.states())
                                                        : half_way(*equations_);
    append();
    while (!done_) advance();
    result_.last = equations_->orbit();
    if (result_.branch.points.size() < 2 && result_.rejected.empty()) result_.rejected = result_.branch.ended;
    return std::move(result_);
  }

 private:
  [[nodiscard]] CurveStep whole_step() const {
    return {here_.x, here_.tangent, step_, here_.factors != nullptr};
  }
  void append() {
    result_.branch.points.push_back(solution_point(*equations_, here_, limits_.phases));
    result_.branch.orbits.push_back(orbit_at(*equations_));
  }
  void note(std::string_view what) {
    const double parameter = here_.x[here_.x.size() - 1] * family_.units().parameter;
    result_.notes.push_back(fmt::format("{} at {:.10g}", what, parameter));
  }
  void finish(std::string reason) {
    result_.branch.ended = std::move(reason);
    done_ = true;
  }

  void advance();
  void shorten(double factor) {
    if (unsteered_) {
      std::tie(here_, step_) = *std::exchange(unsteered_, std::nullopt);
    } else if (auto steered =
                   steered_before_ ? std::nullopt : along_ending_phase(*equations_, here_, step_)) {
      steered_before_ = true;
      unsteered_ = {std::exchange(here_, std::move(steered->first)), std::exchange(step_, steered->second)};
    } else {
      step_ *= factor;
    }
  }

  bool shorten_to(const StepTarget& target) {
    const auto length = followed_.length_to(target.value, *equations_, whole_step());
    if (length && !target.leaves) planned_ = step_;
    if (length) step_ = *length;
    return length.has_value();
  }

  bool rejects(const Station& next) {
    if (result_.branch.points.size() > 1) return false;
    result_.rejected = why_rejected(*equations_, start_, here_, next);
    return !result_.rejected.empty();
  }
  void reject() {
    constexpr double kShortest = 1e-5;  // beside it what begins may end: contact at a stiff stop, a grazing
    if (step_ < kShortest) return finish(result_.rejected);
    result_.rejected.clear();
    shorten(0.2);
  }

  bool move_to(double length) {
    if (!move_along(*equations_, here_, length, kTight)) return false;
    here_ = station_at(*equations_, here_.tangent);
    append();
    return true;
  }

  // What follows are the same orbits once more.
  void end_at_half_period(double length) {
    if (length == 0.0 || !move_to(length)) equations_->evaluate(here_.x);
    result_.meets_half_period = true;
    finish(fmt::format("period doubling of orbits of order {}", equations_->orbit().order / 2));
  }

  void close() {
    here_ = station_at(*equations_, here_.tangent);
    append();
    result_.closes = true;
    finish("the branch closes");
  }

  void end_at(const GuardCrossing& crossing) {
    if (!move_to(crossing.length)) return finish("the corrector fails");
    const OrbitGuard* there = here_.survey.find(crossing.guard.kind, crossing.guard.index);
    result_.guard = there != nullptr ? *there : crossing.guard;
    SpecialPoint end = change_at(*equations_, *result_.guard, result_.branch.points.back());
    finish(end.text);
    add(std::move(end), result_.branch.orbits.back(), result_);
    result_.branch.special.back().after = result_.branch.points.size() - 1;
  }

  void accept(Station next, int iterations) {
    // `locate` may have left the equations elsewhere on the step.
    if (equations_->orbit().x != next.x && !equations_->evaluate(next.x))
      return finish("the corrector fails");
    const double turn = std::acos(std::min(1.0, next.tangent.dot(here_.tangent)));
    before_ = {std::move(here_.tests), step_};
    here_ = std::move(next);
    unsteered_.reset();
    steered_before_ = false;
    half_way_ = half_way(*equations_);
    append();
    travelled_ += step_;
    const double longest =
        longest_step(limits_.step_share * kOrbitSteps.longest, size_of_state(equations_->orbit()));
    step_ = std::max(next_step(step_, iterations, turn, longest), planned_);
    planned_ = 0.0;
    if (size_of_state(equations_->orbit()) > kMostGrown) return finish(kGrown);
    if (static_cast<int>(result_.branch.points.size()) >= limits_.max_points)
      return finish(fmt::format("limit of {} points", limits_.max_points));
    if (auto moved = with_section_clear(*equations_, here_.tangent)) go_on_with(std::move(*moved));
    if (auto resolved = with_chatter_resolved(*equations_, here_.tangent)) go_on_with(std::move(*resolved));
  }

  void go_on_with(OtherUnknowns other) {
    if (!other.obstacle.empty()) return finish(std::move(other.obstacle));
    equations_ = std::move(other.equations);
    if (before_) before_->tests.values = {};  // of other unknowns; multipliers are the orbit's
    here_ = station_at(*equations_, other.tangent, MultiplierRange::leading);
    half_way_ = half_way(*equations_);
  }

  OrbitFamily& family_;
  const CurveLimits& limits_;
  const FollowedQuantity followed_;
  const CurveStart& start_;
  std::unique_ptr<ExtendedEquations> equations_;
  Station here_;
  std::optional<TestsBefore> before_;
  Eigen::VectorXd half_way_;     // at here_
  double step_, planned_ = 0.0;  // the latter of a step that ended at a value asked for
  double travelled_ = 0.0;       // along the curve
  std::optional<std::pair<Station, double>> unsteered_;  // the point and the step before steer()
  bool done_ = false, steered_before_ = false;
  TracedCurve result_;
};

// One attempt at a step: taken, or shortened.
void Tracer::advance() {
  constexpr double kShortestTurn = 1e-6;  // over a value that is asked for
  if (limits_.expired()) return finish("the time is up");
  if (step_ < kOrbitSteps.shortest && !unsteered_) return finish("the corrector fails");
  auto iterations =
      correct(*equations_, here_.x + step_ * here_.tangent, here_.tangent, {.near = here_.factors.get()});
  const bool lands = !iterations && (iterations = followed_.land(*equations_, here_.x, here_.tangent, step_));
  if (!iterations) return shorten(0.4);
  if (clearance_of_section(equations_->orbit()) <= 0.0) return shorten(0.5);
  const auto target = followed_.target(limits_.at, *equations_, here_.x);
  const bool beyond = target ? target->leaves : lands;
  if (target && !shorten_to(*target)) return beyond ? finish(std::string(kEndOfInterval)) : shorten(0.5);
  const auto factors = factors_at(*equations_, here_.tangent);
  const auto tangent = factors ? factors->tangent() : tangent_of(*equations_, here_.tangent);
  const bool turned = tangent && tangent->dot(here_.tangent) < std::cos(kOrbitSteps.turned);
  if (!tangent || (turned && step_ > kOrbitSteps.any_turn)) return shorten(0.5);
  if (step_ > kShortestTurn && followed_.turns(limits_.at, *equations_, whole_step(), *tangent))
    return shorten(0.5);
  Station next =
      station_at(*equations_, *tangent, range_at(result_.branch.points.size(), target || lands), factors);
  if (rejects(next)) return reject();
  if (leaves_out_too_much(*equations_))
    return step_ > kOrbitSteps.any_turn ? shorten(0.5) : finish(kChatterLimit);
  const auto [crossing, unseen] = cut_at_violation(*equations_, here_, step_, next);
  if (crossing && rejects(next)) return reject();
  if (unseen && (step_ > kOrbitSteps.any_turn || (violates(next.survey) && !crossing))) return shorten(0.5);
  if (unseen) note("whether a contact passes its stop between two points is not decided");
  const auto halved = half_period_on_step(*equations_, whole_step(), half_way_);
  if (halved && *halved == 0.0 && step_ > kOrbitSteps.any_turn) return shorten(0.5);  // to end nearer to it
  // Tests vanish too where a phase of no length begins, and at a doubling to the root of rounding.
  constexpr double kBefore = 1.0 - 1e-6, kAtDoubling = 1e-3;  // of the step; of length
  const double inside = std::min({step_, crossing ? kBefore * crossing->length : step_,
                                  halved ? std::max(0.0, *halved - kAtDoubling) : step_});
  StepBifurcations met = bifurcations(*equations_, here_, step_, next, inside);
  const bool hides = inside == step_ && may_hide_bifurcations(before_, here_.tests, step_, next.tests);
  if ((met.undecided || hides) && step_ > kOrbitSteps.any_turn) return shorten(0.5);
  if (met.undecided) note("a bifurcation is not located");
  if (hides && !met.undecided) note("two bifurcations may be one");
  for (LocatedBifurcation& found : met.found) record(std::move(found), result_);
  if (halved && !(crossing && crossing->length < *halved)) return end_at_half_period(*halved);
  if (crossing) return end_at(*crossing);
  constexpr double kAway = 1e-2;  // of length: next to the start all orbits are the same to rounding
  if (start_.leaves == LeftBranch::none && travelled_ > kAway &&
      passes(*equations_, here_.x, next.x, start_.orbit))
    return close();
  next.factors = factors;
  accept(std::move(next), *iterations);
  if (beyond && !done_) finish(std::string(kEndOfInterval));
}

}  // namespace

TracedCurve trace_curve(OrbitFamily& family, const CurveStart& start, const CurveLimits& limits,
                        const std::optional<ParameterRange>& energies) {
  return Tracer(family, start, limits, energies).run();
}

}  // namespace signorini
