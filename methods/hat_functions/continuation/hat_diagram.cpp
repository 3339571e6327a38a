#include "methods/hat_functions/continuation/hat_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <exception>
#include <utility>
#include <vector>

#include "methods/continuation/arc_length.hpp"

namespace signorini {

namespace {

/// Nodes times contacts up to which a curve is followed.
constexpr int kMostNodes = 16384;

class HatDiagram {
 public:
  HatDiagram(const HatFamily& family, const CurveLimits& limits) : family_(family), limits_(limits) {}

  BranchDiagram run(double from, double to,
                    const std::function<std::unique_ptr<PreparedMethod>(const Problem&)>& prepare) {
    for (const double frequency : {from, to}) add_contact_free(frequency);
    for (const double frequency : {from, to}) add_answer(frequency, prepare);
    if (starts_.empty()) diagram_.unfinished = "the method has no answer at either end of the interval";
    while (!starts_.empty() && diagram_.unfinished.empty()) trace_next();
    return std::move(diagram_);
  }

 private:
  void add_contact_free(double frequency) {
    HatCurve curve(family_, 1);
    const Eigen::VectorXd x = Eigen::VectorXd::Constant(1, frequency / family_.frequency_unit);
    if (curve.evaluate(x) && curve.gaps().minCoeff() > 0.0) add_start(curve, "contact-free motion");
  }

  // The method's own answer: its pressing nodes, and the equations solved with them.
  void add_answer(double frequency,
                  const std::function<std::unique_ptr<PreparedMethod>(const Problem&)>& prepare) {
    Problem problem = family_.problem;
    problem.frequency = frequency;
    const Solution solution = prepare(problem)->solve({.guess = {}, .deadline = limits_.deadline});
    if (solution.verdict != Verdict::converged || !solution.trajectory) {
      diagram_.notes.push_back(
          fmt::format("no answer of the method at {:.10g} rad/s: {}", frequency, solution.message));
      return;
    }
    HatCurve curve(family_, 1);
    const Eigen::MatrixXd force = solution.trajectory->sample(curve.samples()).force;
    Eigen::VectorXd all = Eigen::VectorXd::Zero(curve.nodes() + 1);
    std::vector<int> pressing;
    for (int node = 0; node < curve.nodes(); ++node) {
      const double pressure = -force(node % curve.samples(), node / curve.samples());
      if (!(pressure > 0.0)) continue;
      pressing.push_back(node);
      all[node] = pressure * curve.weight(node);
    }
    all[curve.nodes()] = frequency / family_.frequency_unit;
    curve.press(pressing);
    if (correct_at_parameter(curve, curve.on_pressing(all)))
      add_start(curve, "answer of the method");
    else
      diagram_.notes.push_back(
          fmt::format("the answer of the method at {:.10g} rad/s is not on a curve", frequency));
  }

  // Into the interval from one of its ends.
  void add_start(HatCurve& curve, const std::string& origin) {
    const bool upwards = curve.frequency() < 0.5 * (family_.low + family_.high);
    starts_.push_back({.multiple = 1,
                       .pressing = curve.pressing(),
                       .x = curve.x(),
                       .tangent = first_tangent(curve, upwards),
                       .origin = fmt::format("{} at {:.10g} rad/s", origin, curve.frequency())});
  }

  void trace_next() {
    const HatStart start = std::move(starts_.front());
    starts_.pop_front();
    HatCurve curve(family_, start.multiple);
    curve.press(start.pressing);
    if (known(start.multiple, curve.on_all(start.x))) return;
    if (static_cast<int>(diagram_.branches.size()) >= limits_.max_branches) {
      diagram_.unfinished = fmt::format("limit of {} branches", limits_.max_branches);
      return;
    }
    TracedHat traced = trace_hat(family_, start, limits_,
                                 [&](const Eigen::VectorXd& all) { return known(start.multiple, all); });
    if (limits_.expired()) diagram_.unfinished = "the time is up";
    if (traced.branch.points.size() < 2) {
      diagram_.notes.push_back(fmt::format("{}: {}", start.origin, traced.branch.ended));
      return;
    }
    for (const HatStart& grazing : traced.grazings) add_grazing_branches(grazing);
    diagram_.branches.push_back(traced.branch);
    if (limits_.take) limits_.take(traced.branch);
    traced_.push_back(std::move(traced));
  }

  // One of the passages presses; of the others, which graze at the same frequency, the gaps must open.
  void add_grazing_branches(const HatStart& grazing) {
    const HatCurve one(family_, 1);
    for (int multiple = 2; multiple * family_.problem.subharmonic <= limits_.max_order; ++multiple) {
      HatCurve curve(family_, multiple);
      if (curve.nodes() > kMostNodes || !curve.evaluate(grazing.x)) return;
      int touching = 0;
      curve.gaps().minCoeff(&touching);
      const double frequency = grazing.x[0];
      curve.press({touching});
      Eigen::VectorXd x(2);
      x << 0.0, frequency;
      if (!curve.evaluate(x)) continue;
      const auto tangent = tangent_after_change(curve, touching);
      if (!tangent || !others_open(curve, touching, *tangent)) continue;
      starts_.push_back({.multiple = multiple,
                         .pressing = {touching},
                         .x = x,
                         .tangent = *tangent,
                         .origin = fmt::format("grazing of motions of order {}", one.order())});
    }
  }

  [[nodiscard]] static bool others_open(const HatCurve& curve, int touching, const Eigen::VectorXd& tangent) {
    constexpr double kTouching = 1e-9;  // of the unit of gaps
    for (int node = 0; node < curve.nodes(); ++node) {
      if (node == touching || curve.gaps()[node] > kTouching) continue;
      if (curve.gap_rate(node, tangent) < 0.0) return false;
    }
    return true;
  }

  // Whether unknowns lie on a branch that was followed, at any of the periods that they may be shifted by.
  [[nodiscard]] bool known(int multiple, const Eigen::VectorXd& all) const {
    constexpr double kRounding = 1e-9;  // of the units
    const int samples = multiple * family_.samples;
    for (int shift = 0; shift < multiple; ++shift) {
      Eigen::VectorXd later = all;
      for (int first = 0; first + samples < all.size(); first += samples) {
        for (int i = 0; i < samples; ++i)
          later[first + (i + shift * family_.samples) % samples] = all[first + i];
      }
      for (const TracedHat& traced : traced_)
        if (traced.multiple == multiple && traced.points.pass_by(later, kRounding)) return true;
    }
    return false;
  }

  const HatFamily& family_;
  const CurveLimits& limits_;
  std::deque<HatStart> starts_;
  std::vector<TracedHat> traced_;
  BranchDiagram diagram_;
};

}  // namespace

BranchDiagram hat_diagram(const HatFamily& family, double from, double to,
                          const std::function<std::unique_ptr<PreparedMethod>(const Problem&)>& prepare,
                          const CurveLimits& limits) {
  const int nodes = family.samples * family.problem.contact_count();
  if (nodes == 0) return {.unfinished = "the scene has no contact"};
  if (nodes > kMostNodes) return {.unfinished = fmt::format("{} nodes are more than {}", nodes, kMostNodes)};
  try {
    return HatDiagram(family, limits).run(from, to, prepare);
  } catch (const std::runtime_error& error) {  // of a structure that cannot be factorised
    return {.unfinished = error.what()};
  }
}

}  // namespace signorini
