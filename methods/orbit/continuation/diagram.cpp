#include "methods/orbit/continuation/diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "methods/continuation/curve_queue.hpp"
#include "methods/continuation/interval_gaps.hpp"
#include "methods/orbit/continuation/branch_section.hpp"
#include "methods/orbit/continuation/contact_changes.hpp"
#include "methods/orbit/continuation/grazing_starts.hpp"
#include "methods/orbit/continuation/station.hpp"
#include "methods/orbit/continuation/switching.hpp"
#include "methods/orbit/family/chatter.hpp"
#include "methods/orbit/family/orbit_section.hpp"

namespace signorini {

namespace {

bool contains(const std::vector<OrbitMark>& marks, const OrbitMark& mark, bool loosely = false) {
  return std::ranges::any_of(marks, [&](const OrbitMark& other) { return mark.same(other, loosely); });
}

// Whether there is no such mark among those so far; it is one of them then.
bool is_new(const OrbitMark& mark, std::vector<OrbitMark>& known, bool loosely = false) {
  if (contains(known, mark, loosely)) return false;
  known.push_back(mark);
  return true;
}

// A branch ends where another one is to start.
bool is_among(const std::vector<OrbitMark>& ends, const OrbitMark& mark, const CurveStart& start) {
  // The branch that was left ends at this very orbit, with its events the other way round.
  if (start.exchanges)
    return std::ranges::any_of(ends, [&](const OrbitMark& end) {
      return mark.same(end) && mark.order_of_events == end.order_of_events;
    });
  // A doubled branch ends beside its doubling, not at it.
  return contains(ends, mark, start.leaves == LeftBranch::repetition);
}

// The two halves of a curve from the same orbit as one branch: the first backwards, then the second.
OrbitBranch joined(OrbitBranch backward, const OrbitBranch& forward) {
  const std::size_t half = backward.points.size();
  for (SpecialPoint& special : backward.special) special.after = half - special.after;
  const auto join = [](auto& first, const auto& second, std::ptrdiff_t left_out) {
    std::reverse(first.begin(), first.end());
    first.insert(first.end(), second.begin() + left_out, second.end());
  };
  const std::size_t specials = backward.special.size();
  join(backward.points, forward.points, 1);
  join(backward.orbits, forward.orbits, 1);
  join(backward.special, forward.special, 0);
  join(backward.special_orbits, forward.special_orbits, 0);
  for (std::size_t i = specials; i < backward.special.size(); ++i) backward.special[i].after += half - 1;
  backward.began = std::exchange(backward.ended, forward.ended);
  return backward;
}

// What the halves of a curve from one orbit are, of which one at least is not rejected.
std::vector<OrbitBranch> branches_of(const TracedCurve& forward, const TracedCurve& backward) {
  if (!backward.rejected.empty()) return {forward.branch};
  if (!forward.rejected.empty()) return {backward.branch};
  // Impacts of one instant at the start, in either order.
  if (forward.branch.sequence != backward.branch.sequence) return {backward.branch, forward.branch};
  return {joined(backward.branch, forward.branch)};
}

// Parts of the interval that no range holds and that are worth a search.
std::vector<ParameterRange> wide_gaps(std::vector<ParameterRange> held, const ParametrisedScene& scene) {
  constexpr double kWide = 0.002;  // of the interval
  std::vector<ParameterRange> gaps = uncovered(std::move(held), scene.from, scene.to);
  std::erase_if(gaps, [&](const ParameterRange& gap) {
    return gap.high - gap.low < kWide * (scene.high() - scene.low());
  });
  return gaps;
}

// What branches leave out of the interval, and the values at which motions are searched there, as long as
// this finds some.
class GapSearch {
 public:
  explicit GapSearch(const ParametrisedScene& scene) : scene_(scene) {}

  // Wide parts of the interval that no branch holds. \param branches  those of the last call and others after
  std::vector<ParameterRange> gaps(const std::vector<OrbitBranch>& branches) {
    while (held_.size() < branches.size()) held_.push_back(range_of(branches[held_.size()]));
    return wide_gaps(held_, scene_);
  }
  // A value in the widest part that neither the branches of the last call hold nor was asked; empty where
  // none is wide, or enough was searched.
  std::optional<double> next() {
    constexpr std::size_t kMost = 16;
    constexpr int kMostInVain = 4;    // in a row
    constexpr double kInside = 0.47;  // of the gap: nothing special is there
    constexpr double kApart = 1e-3;   // of the gap, which it parts
    if (asked_.size() >= kMost || in_vain_ >= kMostInVain) return std::nullopt;
    std::vector<ParameterRange> known = held_;
    known.insert(known.end(), asked_.begin(), asked_.end());
    const std::vector<ParameterRange> gaps = wide_gaps(std::move(known), scene_);
    const auto width = [](const ParameterRange& gap) { return gap.high - gap.low; };
    const auto widest = std::ranges::max_element(gaps, {}, width);
    if (widest == gaps.end()) return std::nullopt;
    const double value = widest->low + kInside * width(*widest);
    asked_.push_back({value, value + kApart * width(*widest)});
    return value;
  }
  void ended(bool in_vain) { in_vain_ = in_vain ? in_vain_ + 1 : 0; }

 private:
  const ParametrisedScene& scene_;
  std::vector<ParameterRange> held_, asked_;  // by branches; short parts beside the values
  int in_vain_ = 0;
};

// Whether a curve begins in a gap, or at an end of it and inwards.
bool leads_into(const CurveStart& start, double unit, const std::vector<ParameterRange>& gaps) {
  constexpr double kAtEnd = 1e-6;  // of the gap
  const double value = unit * start.orbit.parameter();
  const bool rises = start.tangent[start.tangent.size() - 1] > 0.0;
  return std::ranges::any_of(gaps, [&](const ParameterRange& gap) {
    const double near = kAtEnd * (gap.high - gap.low);
    if (value < gap.low - near || value > gap.high + near) return false;
    return rises ? value < gap.high - near : value > gap.low + near;
  });
}

// Whether what begins on a branch is followed: cascades are infinite, and of motions of more than two periods
// only those lead on that are stable somewhere.
bool leads_on(const OrbitBranch& branch) {
  constexpr int kAllLeadOn = 2;  // forcing periods
  return branch.points.front().order <= kAllLeadOn ||
         std::ranges::any_of(branch.points, [](const SolutionPoint& point) {
           return point.stability == OrbitStability::stable || point.stability == OrbitStability::elliptic;
         });
}

// What is said of period doublings that lead beyond the longest period.
std::string doublings_left(int count, int max_order) {
  constexpr int kMostOrder = 64;  // that a scene, and so --max-order, may have
  return fmt::format(
      "{} period doublings not followed (period > {}{})", count, max_order,
      max_order < kMostOrder ? fmt::format("; --max-order {}", std::min(kMostOrder, 2 * max_order)) : "");
}

constexpr std::size_t kMostEvents = 48;  // of a period, beyond which a branch counts as rattling

class DiagramTracer {
 public:
  DiagramTracer(OrbitFamily& family, const CurveLimits& limits, const std::optional<ParameterRange>& energies)
      : family_(family), limits_(limits), energies_(energies), queue_(limits), search_(family.scene()) {}

  OrbitDiagram run(const std::vector<SequencedOrbit>& seeds, const OrbitsAt& more,
                   const std::vector<CurveStart>& starts) {
    for (const CurveStart& start : starts)
      if (!queue_.is_over()) follow(start);
    for (const SequencedOrbit& seed : seeds)
      if (!queue_.is_over()) add_seed(seed);
    while (true) {
      const std::vector<ParameterRange> gaps = search_.gaps(queue_.branches());
      const auto fills = [&](const CurveStart& start) {
        return start.periods() == 1 && leads_into(start, family_.units().parameter, gaps);
      };
      if (more && !queue_.holds(fills) && fill(more)) continue;
      const auto start =
          queue_.next([&](const CurveStart& one) { return std::pair(!fills(one), one.periods()); });
      if (!start) break;
      if (start->leaves != LeftBranch::crossing && is_an_end(*start)) continue;
      if (queue_.is_full()) break;
      follow(*start);
    }
    if (too_long_ > 0) queue_.note(doublings_left(too_long_, limits_.max_order));
    if (dead_ends_ > 0)
      queue_.note(fmt::format("{} unstable branches of more than two periods not followed on", dead_ends_));
    return queue_.finish<OrbitDiagram>();
  }

 private:
  // Looks for orbits in the widest part of the interval that no branch holds; false where this has an end.
  bool fill(const OrbitsAt& more) {
    const auto value = search_.next();
    if (!value || queue_.is_over()) return false;
    const std::size_t before = queue_.branches().size();
    for (const SequencedOrbit& orbit : more(*value)) add_seed(orbit);
    search_.ended(queue_.branches().size() == before);
    return true;
  }

  void add_seed(const SequencedOrbit& seed) {
    ExtendedEquations given(family_, seed);
    const std::string origin = fmt::format("start at {:.10g}", family_.units().parameter * seed.parameter());
    if (!correct_at_parameter(given, seed.x))
      return queue_.note(origin + ": Newton's method does not converge beside this motion; not followed");
    const ResolvedChatter resolved = resolve_chatter(given);
    if (!resolved.obstacle.empty())
      return queue_.note(fmt::format("{}: complete chatter: {}; not followed", origin, resolved.obstacle));
    if (resolved.orbit) return add_seed(*resolved.orbit);
    const SequencedOrbit orbit = of_least_period(given.orbit(), given);
    ExtendedEquations equations(family_, orbit);
    if (!equations.evaluate(orbit.x) || is_known(equations)) return;
    const Eigen::VectorXd tangent = first_tangent(equations);
    if (violates(survey(equations))) return;  // no motion of the scene
    const auto half = [&](double sign) {
      const CurveStart start{.orbit = orbit, .tangent = sign * tangent, .origin = origin};
      return trace_curve(family_, in_order_along(family_, start), limits_, energies_);
    };
    const TracedCurve forward = half(1.0);
    if (forward.closes) {
      queue_.keep(forward.branch);
      return leave(forward);
    }
    const TracedCurve backward = half(-1.0);
    if (!forward.rejected.empty() && !backward.rejected.empty())
      return queue_.note(origin + ": " + forward.rejected);
    for (OrbitBranch& branch : branches_of(forward, backward)) queue_.keep(std::move(branch));
    if (forward.rejected.empty()) leave(forward);
    if (backward.rejected.empty()) leave(backward);
  }

  // An orbit of a branch that has been traced.
  bool is_known(const ExtendedEquations& equations) {
    const OrbitMark mark = mark_of(equations);
    for (const OrbitBranch& branch : queue_.branches()) {
      if (branch.points.front().order != mark.order) continue;
      // The number of impacts of a chatter changes along a branch.
      if (branch.orbits.front().events.size() != equations.orbit().events.size() &&
          chatter_ends(equations).empty())
        continue;
      for (const SequencedOrbit& orbit : orbits_at(family_, branch, equations.parameter())) {
        const auto there = mark_at(orbit);
        if (there && there->same(mark)) return true;
      }
    }
    return false;
  }

  std::optional<OrbitMark> mark_at(const SequencedOrbit& orbit) {
    ExtendedEquations equations(family_, orbit);
    return equations.evaluate(orbit.x) ? std::optional(mark_of(equations)) : std::nullopt;
  }
  // A branch that has been traced ends here, or began.
  bool is_an_end(const CurveStart& start) {
    const auto mark = mark_at(start.orbit);
    return mark && is_among(ends_, *mark, start);
  }
  void end_here(const SequencedOrbit& orbit) {
    if (auto mark = mark_at(orbit)) ends_.push_back(std::move(*mark));
  }

  void follow(const CurveStart& start) {
    const TracedCurve curve = trace_curve(family_, start, limits_, energies_);
    if (!curve.rejected.empty()) {
      if (curve.rejected != kEndOfInterval) queue_.note(start.origin + ": " + curve.rejected);
      return;
    }
    for (const std::string& undecided : curve.notes) queue_.note(undecided);
    queue_.keep(curve.branch);
    end_here(start.orbit);
    if (!leads_on(curve.branch)) return void(++dead_ends_);
    leave(curve);
  }

  void double_period(const SequencedOrbit& orbit) {
    const auto mark = mark_at(orbit);
    if (!mark || !is_new(*mark, doubled_)) return;
    if (2 * orbit.order > limits_.max_order) {
      ++too_long_;
      return;
    }
    if (auto start = start_doubled(family_, orbit)) queue_.add(std::move(*start));
  }

  // Queues what begins at the doublings and at the end of a branch.
  void leave(const TracedCurve& curve) {
    for (const SequencedOrbit& orbit : curve.doublings) double_period(orbit);
    for (const auto& [orbit, across] : curve.crossings) cross(orbit, across);
    if (curve.meets_half_period) end_here(curve.last);
    if (!curve.guard) return;
    ExtendedEquations equations(family_, curve.last);
    if (!equations.evaluate(curve.last.x)) return;
    const OrbitMark end = mark_of(equations);
    ends_.push_back(end);
    if (is_grazing(*curve.guard, equations)) return graze(curve, end);
    if (!is_new(end, changed_)) return;
    ChangeOfSequence change = past_change(family_, curve);
    if (!change.start) return queue_.note(fmt::format("{}: {}", curve.branch.ended, change.obstacle));
    queue_.add(std::move(*change.start));
  }

  void cross(const SequencedOrbit& orbit, const Eigen::VectorXd& across) {
    const auto mark = mark_at(orbit);
    if (!mark || !is_new(*mark, crossed_, true)) return;
    for (CurveStart& start : start_crossing(family_, orbit, across)) queue_.add(std::move(start));
  }

  void graze(const TracedCurve& curve, const OrbitMark& end) {
    const std::string where = fmt::format("grazing at {:.10g}", curve.branch.points.back().parameter);
    const auto leave_out = [&](std::string_view why) {
      queue_.note(fmt::format("{}: {}; not followed", where, why));
    };
    const auto grazing = grazing_orbit(family_, curve);
    if (!grazing) return leave_out("the motion there cannot be evaluated");
    if (!is_new(grazing->mark, grazings_)) return;
    if (!family_.driven() && grazing->base.events.empty())
      return queue_.note(fmt::format("{}: {}", where, kLinearMode));
    if (!end.same(grazing->mark)) {
      if (auto start = start_clear(family_, *grazing)) queue_.add(std::move(*start));
    }
    if (!grazing->obstacle.empty()) return leave_out(grazing->obstacle);
    auto starts = start_impacting(family_, *grazing, limits_.max_order);
    if (!starts) return leave_out("the equations of first order do not decide which motions begin");
    for (CurveStart& start : *starts) {
      if (start.orbit.events.size() > kMostEvents)
        leave_out(fmt::format("more than {} events in a period", kMostEvents));
      else
        queue_.add(std::move(start));
    }
  }

  OrbitFamily& family_;
  const CurveLimits& limits_;
  const std::optional<ParameterRange>& energies_;
  CurveQueue<CurveStart, OrbitBranch> queue_;
  std::vector<OrbitMark> ends_, grazings_, doubled_, crossed_, changed_;
  GapSearch search_;
  int too_long_ = 0, dead_ends_ = 0;
};

}  // namespace

OrbitDiagram trace_diagram(OrbitFamily& family, const std::vector<SequencedOrbit>& seeds,
                           const CurveLimits& limits, const OrbitsAt& more,
                           const std::vector<CurveStart>& starts,
                           const std::optional<ParameterRange>& energies) {
  return DiagramTracer(family, limits, energies).run(seeds, more, starts);
}

}  // namespace signorini
