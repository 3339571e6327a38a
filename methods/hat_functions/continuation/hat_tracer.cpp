#include "methods/hat_functions/continuation/hat_tracer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "methods/continuation/arc_length.hpp"
#include "methods/discretisation/trajectories.hpp"

namespace signorini {

namespace {

constexpr double kRounding = 1e-13;  // of gaps and pressures in their units, and of their rates

/// Phases of contact: runs of pressing nodes, around the period.
int phases_of(const HatCurve& curve) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(curve.nodes());
  force(curve.pressing()).setConstant(-1.0);
  std::size_t phases = 0;
  for (int first = 0; first < curve.nodes(); first += curve.samples())
    phases += contact_phases(force.segment(first, curve.samples()), 0.0, 1).size();
  return static_cast<int>(phases);
}

SolutionPoint point_of(const HatCurve& curve) {
  SolutionPoint point{.parameter = curve.frequency(),
                      .frequency = curve.frequency(),
                      .order = curve.order(),
                      .impacts = phases_of(curve),
                      .stability = OrbitStability::unknown};
  const Eigen::MatrixXd x = curve.motion();
  for (Eigen::Index c = 0; c < x.cols(); ++c) {
    point.x_max.push_back(x.col(c).maxCoeff());
    point.amplitude.push_back(0.5 * (x.col(c).maxCoeff() - x.col(c).minCoeff()));
  }
  return point;
}

/// A node whose gap or pressure becomes zero on a step.
struct NodeChange {
  int node = 0;
  bool joins = false;   // the pressing ones
  double length = 0.0;  // of the step up to there
};

/// A gap or a pressure that is negative where a curve is evaluated, with its values at both ends of a step.
struct Violation {
  NodeChange change;
  Eigen::Index place = 0;  // among the unknowns, of a pressure
  double before = 0.0, last = 0.0;
};

/// All of them. \param x, gaps  at the beginning of the step
std::vector<Violation> violations(const HatCurve& curve, const Eigen::VectorXd& x,
                                  const Eigen::VectorXd& gaps) {
  const std::vector<int>& pressing = curve.pressing();
  std::vector<Violation> found;
  for (Eigen::Index k = 0; k < curve.pressing_count(); ++k) {
    if (curve.x()[k] < -kRounding)
      found.push_back({{pressing[static_cast<std::size_t>(k)], false, 0.0}, k, x[k], curve.x()[k]});
  }
  for (int node = 0; node < curve.nodes(); ++node) {
    if (curve.gaps()[node] < -kRounding && !std::ranges::binary_search(pressing, node))
      found.push_back({{node, true, 0.0}, 0, gaps[node], curve.gaps()[node]});
  }
  return found;
}

/// The first node that violates its condition on a step, at whose end the curve is evaluated, and the length
/// up to there; a negative length where it cannot be located. The violation that a straight line meets first
/// is located, and again on what is left of the step while others are violated there. \param released  a node
/// that has just changed sides, zero at the beginning and about to grow: where it does
///        not, the step is too long
std::optional<NodeChange> first_change(HatCurve& curve, const CurveStep& step, int released) {
  const Eigen::VectorXd end = curve.x();
  if (!curve.evaluate(step.x)) return NodeChange{released, false, -1.0};
  const Eigen::VectorXd gaps = curve.gaps();
  if (!curve.evaluate(end)) return NodeChange{released, false, -1.0};
  std::optional<NodeChange> first;
  double length = step.length;
  for (int k = 0; k <= curve.nodes(); ++k) {
    std::vector<Violation> found = violations(curve, step.x, gaps);
    const bool turned =
        std::erase_if(found, [&](const Violation& v) { return v.change.node == released; }) > 0;
    if (found.empty()) return turned ? NodeChange{released, false, -1.0} : first;
    const auto share = [](const Violation& v) {
      return std::max(v.before, 0.0) / (std::max(v.before, 0.0) - v.last);
    };
    const Violation next = *std::ranges::min_element(found, {}, share);
    first = next.change;
    if (next.before <= 0.0) return first;
    const auto value = [&](HatCurve& at) {
      return std::optional(next.change.joins ? at.gaps()[next.change.node] : at.x()[next.place]);
    };
    const auto located = locate(curve, {step.x, step.tangent, length}, value, next.before, next.last);
    if (!located) return NodeChange{next.change.node, next.change.joins, -1.0};
    first->length = length = *located;
  }
  return first;
}

/// Takes out pairs of folds between which the frequency goes back by less than a node's share of it: a
/// staircase has them at every step, the motion none.
void leave_out_folds_of_grid(int samples, Branch& branch) {
  const auto fold = [](const SpecialPoint& special) { return special.kind == SpecialKind::fold; };
  for (;;) {
    auto narrowest = branch.special.end(), partner = narrowest, before = narrowest;
    double least = 1.0 / samples;
    for (auto here = branch.special.begin(); here != branch.special.end(); ++here) {
      if (!fold(*here)) continue;
      if (before != branch.special.end()) {
        const double back = std::abs(here->point.frequency / before->point.frequency - 1.0);
        if (back < least) std::tie(least, narrowest, partner) = std::tuple(back, before, here);
      }
      before = here;
    }
    if (narrowest == branch.special.end()) return;
    branch.special.erase(partner);  // the later one first
    branch.special.erase(narrowest);
  }
}

class HatTracer final : public CurveTracer<HatStart> {
 public:
  HatTracer(const HatFamily& family, const HatStart& start, const CurveLimits& limits,
            const FollowedCurves& followed)
      : CurveTracer(start, limits, followed), curve_(family, start.multiple), tangent_(start.tangent) {
    curve_.press(start.pressing);
    result().branch.sequence = fmt::format("order {}, {} nodes", curve_.order(), curve_.samples());
  }

 private:
  static constexpr CorrectorLimits kTight{.iterations = 14, .tolerance = 1e-14};

  [[nodiscard]] double length() const override { return step_; }
  [[nodiscard]] CurveStep whole_step() const { return {x_, tangent_, step_}; }

  void begin() override {
    x_ = start().x;
    if (!curve_.evaluate(x_)) return finish("the structure resonates undamped");
    append();
  }

  void append() {
    motion_ = curve_.motion();
    SolutionPoint point = point_of(curve_);
    if (limits().phases > 0)
      point.motion = NodalTrajectory(1.0, motion_, motion_).sample(limits().phases * curve_.order()).x;
    CurveTracer::append(std::move(point), curve_.on_all(x_), curve_.on_all(tangent_));
  }

  void mark(SpecialKind kind, std::string text = {}) {
    add({.kind = kind, .point = point_of(curve_), .text = std::move(text)});
  }

  void advance() override {
    const auto iterations = correct(curve_, Eigen::VectorXd(x_ + step_ * tangent_), tangent_);
    if (!iterations || (curve_.x() - x_).norm() > kMethodSteps.far * step_) return shorten(0.4);
    const auto tangent = tangent_of(curve_, tangent_);
    if (!tangent || tangent->dot(tangent_) < std::cos(kMethodSteps.turned) || moves_too_far())
      return shorten(0.5);
    const HatFamily& family = curve_.family();
    if (family.turns_past(limits().at, whole_step(), curve_.frequency(), *tangent)) return shorten(0.5);
    const Eigen::VectorXd end = curve_.x();
    const auto change = first_change(curve_, whole_step(), just_changed_);
    if (change && change->length < 0.0) return shorten(0.5);  // not to be located on so long a step
    double length = change ? change->length : step_;
    const double unit = family.frequency_unit;
    const auto target = family.target(limits().at, x_, end[end.size() - 1] * unit);
    const auto stop =
        target ? length_to_parameter(curve_, whole_step(), end, target->value / unit) : std::nullopt;
    if (target && !stop) return target->leaves ? finish("end of the interval") : shorten(0.5);
    const bool stops = stop && (*stop < length || (target->leaves && *stop == length));
    if (stops) length = *stop;
    fold_before(length, *tangent);
    if (!correct(curve_, Eigen::VectorXd(x_ + length * tangent_), tangent_, kTight)) return shorten(0.5);
    take(*iterations, length);
    if (stops && target->leaves) return finish("end of the interval");
    if (stops) return end_if_over();
    if (change) change_set(*change);
    if (!is_done()) end_if_over();
    if (!is_done() && x_.head(curve_.size()).norm() > kMostGrown) finish(kGrown);
  }

  void shorten(double factor) { step_ *= factor; }

  // Neighbours for points, on a branch of few unknowns too.
  [[nodiscard]] bool moves_too_far() const {
    const double small = kMethodSteps.small * curve_.family().displacement_unit;
    return kMethodSteps.moves_too_far(curve_.motion(), motion_, small * std::sqrt(motion_.size()));
  }

  // A fold within the set.
  void fold_before(double length, const Eigen::VectorXd& last) {
    const Eigen::Index n = x_.size() - 1;
    if (!(tangent_[n] * last[n] < 0.0)) return;
    const auto slope = [&](HatCurve& at) {
      const auto tangent = tangent_of(at, tangent_);
      return tangent ? std::optional((*tangent)[n]) : std::nullopt;
    };
    const auto fold = locate(curve_, whole_step(), slope, tangent_[n], last[n]);
    if (fold && *fold < length) mark(SpecialKind::fold);
  }

  void take(int iterations, double length) {
    const auto tangent = tangent_of(curve_, tangent_);
    const double turn = tangent ? std::acos(std::clamp(tangent->dot(tangent_), -1.0, 1.0)) : 0.0;
    x_ = curve_.x();
    if (tangent) tangent_ = *tangent;
    if (!(length > 1e-12 * step_)) return;  // between two changes at one point
    append();
    just_changed_ = -1;
    const double longest =
        longest_step(limits().step_share * kMethodSteps.longest, x_.head(curve_.size()).norm());
    if (length == step_) step_ = next_step(step_, iterations, turn, longest);
  }

  // One node joins the pressing ones or leaves them.
  void change_set(const NodeChange& change) {
    constexpr int kMostChanges = 20000;
    if (++changes_ > kMostChanges)
      return finish(fmt::format("limit of {} changes of the pressing nodes", kMostChanges));
    const Eigen::VectorXd all = curve_.on_all(x_), before = curve_.on_all(tangent_);
    std::vector<int> pressing = curve_.pressing();
    const bool was_free = pressing.empty();
    if (was_free && start().multiple == 1)
      result().others.push_back({.multiple = 1, .pressing = {}, .x = x_, .tangent = tangent_, .origin = {}});
    if (change.joins) {
      pressing.insert(std::upper_bound(pressing.begin(), pressing.end(), change.node), change.node);
    } else {
      std::erase(pressing, change.node);
    }
    if (pressing.empty() && curve_.rigid_count() > 0)
      return finish("nothing presses any more: free motions at any mean");
    curve_.press(pressing);
    x_ = curve_.on_pressing(all);
    if (!curve_.evaluate(x_)) return end_broken();
    if (was_free || pressing.empty()) {
      const bool rigid = has_impacts(curve_.family().problem);
      mark(rigid ? SpecialKind::grazing : SpecialKind::contact_change,
           fmt::format("contact {} {} to press", change.node / curve_.samples(),
                       was_free ? "begins" : "ceases"));
    }
    const auto tangent = tangent_after_change(curve_, change.node);
    if (!tangent) return end_broken();
    tangent_ = *tangent;
    just_changed_ = change.node;
    const Eigen::Index last = before.size() - 1;
    if (before[last] * tangent_[curve_.size()] < 0.0)
      mark(SpecialKind::fold, "at a change of the pressing nodes");
  }

  HatCurve curve_;
  Eigen::VectorXd x_, tangent_;
  Eigen::MatrixXd motion_;
  double step_ = kMethodSteps.first;
  int just_changed_ = -1, changes_ = 0;
};

}  // namespace

std::optional<Eigen::VectorXd> tangent_after_change(HatCurve& curve, int changed) {
  Eigen::VectorXd tangent = first_tangent(curve);
  const auto& pressing = curve.pressing();
  const auto place = std::find(pressing.begin(), pressing.end(), changed);
  const double rate =
      place != pressing.end() ? tangent[place - pressing.begin()] : curve.gap_rate(changed, tangent);
  if (!(std::abs(rate) > kRounding)) return std::nullopt;
  return rate > 0.0 ? tangent : Eigen::VectorXd(-tangent);
}

TracedBranch<HatStart> trace_hat(const HatFamily& family, const HatStart& start, const CurveLimits& limits,
                                 const FollowedCurves& followed) {
  TracedBranch<HatStart> traced = HatTracer(family, start, limits, followed).run();
  leave_out_folds_of_grid(family.samples, traced.branch);
  return traced;
}

}  // namespace signorini
