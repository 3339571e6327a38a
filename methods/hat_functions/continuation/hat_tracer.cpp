#include "methods/hat_functions/continuation/hat_tracer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "methods/continuation/arc_length.hpp"

namespace signorini {

namespace {

/// Phases of contact: runs of pressing nodes, around the period.
int phases_of(const HatCurve& curve) {
  const int samples = curve.samples();
  std::vector<bool> presses(static_cast<std::size_t>(curve.nodes()), false);
  for (const int node : curve.pressing()) presses[static_cast<std::size_t>(node)] = true;
  int phases = 0;
  for (int first = 0; first < curve.nodes(); first += samples) {
    int begins = 0;
    for (int i = 0; i < samples; ++i) {
      const bool before = presses[static_cast<std::size_t>(first + (i + samples - 1) % samples)];
      if (presses[static_cast<std::size_t>(first + i)] && !before) ++begins;
    }
    phases += begins == 0 && presses[static_cast<std::size_t>(first)] ? 1 : begins;
  }
  return phases;
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

/// Hat functions with these values at the nodes, at `count` equidistant instants, count x Nc.
Eigen::MatrixXd resampled(const Eigen::MatrixXd& x, Eigen::Index count) {
  Eigen::MatrixXd values(count, x.cols());
  for (Eigen::Index i = 0; i < count; ++i) {
    const double node = static_cast<double>(i * x.rows()) / static_cast<double>(count);
    const auto before = static_cast<Eigen::Index>(node);
    const double share = node - static_cast<double>(before);
    values.row(i) = (1.0 - share) * x.row(before) + share * x.row((before + 1) % x.rows());
  }
  return values;
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
  constexpr double kRounding = 1e-13;  // of gaps and pressures in their units
  std::vector<Violation> found;
  std::vector<bool> presses(static_cast<std::size_t>(curve.nodes()), false);
  for (Eigen::Index k = 0; k < curve.size(); ++k) {
    const int node = curve.pressing()[static_cast<std::size_t>(k)];
    presses[static_cast<std::size_t>(node)] = true;
    if (curve.x()[k] < -kRounding) found.push_back({{node, false, 0.0}, k, x[k], curve.x()[k]});
  }
  for (int node = 0; node < curve.nodes(); ++node) {
    if (!presses[static_cast<std::size_t>(node)] && curve.gaps()[node] < -kRounding)
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
    const Violation next =
        *std::min_element(found.begin(), found.end(),
                          [&](const Violation& a, const Violation& b) { return share(a) < share(b); });
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

class HatTracer {
 public:
  HatTracer(const HatFamily& family, const HatStart& start, const CurveLimits& limits, const KnownHat& known)
      : limits_(limits), known_(known), curve_(family, start.multiple), tangent_(start.tangent) {
    curve_.press(start.pressing);
    result_.multiple = start.multiple;
    result_.branch.sequence = fmt::format("order {}, {} nodes", curve_.order(), curve_.samples());
    result_.branch.began = start.origin;
    x_ = start.x;
    if (!curve_.evaluate(x_)) finish("the structure resonates undamped");
    if (!done_) append();
  }

  TracedHat run() {
    while (!done_) advance();
    return std::move(result_);
  }

 private:
  void append() {
    motion_ = curve_.motion();
    SolutionPoint point = point_of(curve_);
    if (limits_.phases > 0) point.motion = resampled(motion_, Eigen::Index{limits_.phases} * curve_.order());
    result_.branch.points.push_back(std::move(point));
    result_.points.x.push_back(curve_.on_all(x_));
    result_.points.tangents.push_back(curve_.on_all(tangent_));
  }

  void add(SpecialKind kind, std::string text = {}) {
    result_.branch.special.push_back({.kind = kind,
                                      .point = point_of(curve_),
                                      .text = std::move(text),
                                      .after = result_.branch.points.size()});
  }

  void finish(std::string reason) {
    result_.branch.ended = std::move(reason);
    done_ = true;
  }

  [[nodiscard]] CurveStep whole_step() const { return {x_, tangent_, step_}; }

  void advance() {
    constexpr double kTurned = 0.35, kFar = 2.0;  // rad; of the step
    constexpr double kShortest = 1e-7;            // below, the curve has broken
    if (limits_.expired()) return finish("the time is up");
    if (step_ < kShortest) return broken();
    const auto iterations = correct(curve_, Eigen::VectorXd(x_ + step_ * tangent_), tangent_);
    if (!iterations || (curve_.x() - x_).norm() > kFar * step_) return shorten(0.4);
    bool beyond = curve_.frequency() < curve_.family().low || curve_.frequency() > curve_.family().high;
    const auto tangent = tangent_of(curve_, tangent_);
    if (!tangent || tangent->dot(tangent_) < std::cos(kTurned) || moves_too_far()) return shorten(0.5);
    const auto change = first_change(curve_, whole_step(), just_changed_);
    if (change && change->length < 0.0) return shorten(0.5);  // not to be located on so long a step
    double length = change ? change->length : step_;
    if (beyond) {
      const auto bound = length_to_bound();
      if (!bound) return finish("end of the interval");
      beyond = *bound <= length;
      length = std::min(length, *bound);
    }
    const auto stop = length_to_value();
    const bool stops = stop && *stop < length;
    if (stops) length = *stop;
    fold_before(length, *tangent);
    if (!correct(curve_, Eigen::VectorXd(x_ + length * tangent_), tangent_, kTight)) return shorten(0.5);
    take(*iterations, length);
    if (stops) return;
    if (beyond) return finish("end of the interval");
    if (change) change_set(*change);
    if (!done_) meets();
  }

  void shorten(double factor) { step_ *= factor; }

  void broken() { finish(fmt::format("the curve breaks at {:.10g} rad/s", curve_frequency())); }
  [[nodiscard]] double curve_frequency() const { return x_[x_.size() - 1] * curve_.family().frequency_unit; }

  // Neighbours for points, on a branch of few unknowns too.
  [[nodiscard]] bool moves_too_far() const {
    constexpr double kShare = 0.1, kSmall = 0.05;  // of the motion; of the unit of displacement
    const double floor = kSmall * curve_.family().displacement_unit * std::sqrt(motion_.size());
    return (curve_.motion() - motion_).norm() > kShare * std::max(motion_.norm(), floor);
  }

  std::optional<double> length_to_bound() {
    constexpr double kAtBound = 1e-13;
    const HatFamily& family = curve_.family();
    if (!correct(curve_, Eigen::VectorXd(x_ + step_ * tangent_), tangent_)) return std::nullopt;
    const double bound = curve_.frequency() < family.low ? family.low : family.high;
    if (std::abs(x_[x_.size() - 1] - bound / family.frequency_unit) < kAtBound) return std::nullopt;
    return length_to(bound);
  }

  // Of the step up to where the frequency takes a value, at whose other side the curve is evaluated.
  std::optional<double> length_to(double value) {
    const double unit = curve_.family().frequency_unit;
    const auto distance = [&](HatCurve& at) { return std::optional((at.frequency() - value) / unit); };
    const double before = x_[x_.size() - 1] - value / unit;
    return locate(curve_, whole_step(), distance, before, *distance(curve_));
  }

  // Up to the first of the frequencies at which the curve is to have a point.
  std::optional<double> length_to_value() {
    if (limits_.at.empty() || !correct(curve_, Eigen::VectorXd(x_ + step_ * tangent_), tangent_))
      return std::nullopt;
    const auto value = first_passed(limits_.at, curve_frequency(), curve_.frequency());
    return value ? length_to(*value) : std::nullopt;
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
    if (fold && *fold < length) add(SpecialKind::fold);
  }

  void take(int iterations, double length) {
    const auto tangent = tangent_of(curve_, tangent_);
    const double turn = tangent ? std::acos(std::clamp(tangent->dot(tangent_), -1.0, 1.0)) : 0.0;
    x_ = curve_.x();
    if (tangent) tangent_ = *tangent;
    constexpr double kNone = 1e-12;  // a step of no length, between two changes at one point
    if (length > kNone * step_) {
      append();
      just_changed_ = -1;
      if (length == step_) step_ = next_step(step_, iterations, turn, limits_.step_share * kLongestStep);
    }
    if (static_cast<int>(result_.points.x.size()) >= limits_.max_points)
      finish(fmt::format("limit of {} points", limits_.max_points));
  }

  // One node joins the pressing ones or leaves them.
  void change_set(const NodeChange& change) {
    if (done_) return;
    constexpr int kMostChanges = 20000;
    if (++changes_ > kMostChanges)
      return finish(fmt::format("limit of {} changes of the pressing nodes", kMostChanges));
    const Eigen::VectorXd all = curve_.on_all(x_), before = curve_.on_all(tangent_);
    std::vector<int> pressing = curve_.pressing();
    const bool was_free = pressing.empty();
    if (was_free) note_grazing();
    if (change.joins) {
      pressing.insert(std::upper_bound(pressing.begin(), pressing.end(), change.node), change.node);
    } else {
      std::erase(pressing, change.node);
    }
    curve_.press(pressing);
    x_ = curve_.on_pressing(all);
    if (!curve_.evaluate(x_)) return broken();
    if (was_free || pressing.empty()) {
      const bool rigid = std::holds_alternative<Restitution>(curve_.family().problem.law);
      add(rigid ? SpecialKind::grazing : SpecialKind::contact_change,
          fmt::format("contact {} {} to press", change.node / curve_.samples(),
                      was_free ? "begins" : "ceases"));
    }
    const auto tangent = tangent_after_change(curve_, change.node);
    if (!tangent) return broken();
    tangent_ = *tangent;
    just_changed_ = change.node;
    const Eigen::Index last = before.size() - 1;
    if (before[last] * tangent_[curve_.size()] < 0.0)
      add(SpecialKind::fold, "at a change of the pressing nodes");
  }

  void note_grazing() {
    if (result_.multiple > 1) return;
    result_.grazings.push_back({.multiple = 1, .pressing = {}, .x = x_, .tangent = tangent_, .origin = {}});
  }

  void meets() {
    constexpr double kRounding = 1e-9;  // in the units of the unknowns
    constexpr std::size_t kLeft = 10;   // points, after which a branch has left the one on which it began
    if (done_) return;
    const Eigen::VectorXd& here = result_.points.x.back();
    if (result_.points.passed_before(here, kRounding)) return finish("the branch meets itself");
    if (result_.points.x.size() > kLeft && known_(here))
      finish("the branch meets one that was followed before");
  }

  static constexpr CorrectorLimits kTight{.iterations = 14, .tolerance = 1e-14};

  static constexpr double kFirstStep = 0.01, kLongestStep = 0.1;  // in the units of HatCurve

  const CurveLimits& limits_;
  const KnownHat& known_;
  HatCurve curve_;
  Eigen::VectorXd x_, tangent_;
  Eigen::MatrixXd motion_;
  double step_ = kFirstStep;
  int just_changed_ = -1, changes_ = 0;
  bool done_ = false;
  TracedHat result_;
};

}  // namespace

std::optional<Eigen::VectorXd> tangent_after_change(HatCurve& curve, int changed) {
  Eigen::VectorXd tangent = first_tangent(curve);
  const auto& pressing = curve.pressing();
  const auto place = std::find(pressing.begin(), pressing.end(), changed);
  const double rate =
      place != pressing.end() ? tangent[place - pressing.begin()] : curve.gap_rate(changed, tangent);
  constexpr double kStill = 1e-13;
  if (!(std::abs(rate) > kStill)) return std::nullopt;
  return rate > 0.0 ? tangent : Eigen::VectorXd(-tangent);
}

TracedHat trace_hat(const HatFamily& family, const HatStart& start, const CurveLimits& limits,
                    const KnownHat& known) {
  return HatTracer(family, start, limits, known).run();
}

}  // namespace signorini
