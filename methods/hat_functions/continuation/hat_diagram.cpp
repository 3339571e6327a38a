#include "methods/hat_functions/continuation/hat_diagram.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "methods/continuation/arc_length.hpp"
#include "methods/continuation/method_diagram.hpp"

namespace signorini {

namespace {

/// Nodes times contacts up to which a curve is followed.
constexpr int kMostNodes = 16384;

class HatDiagram final : public MethodDiagram<HatStart> {
 public:
  HatDiagram(const HatFamily& family, const CurveLimits& limits) : MethodDiagram(limits), family_(family) {}

 private:
  std::optional<HatStart> contact_free(double frequency) override {
    HatCurve curve(family_, 1);
    if (curve.rigid_count() > 0) return std::nullopt;  // one of a family, to any mean
    const Eigen::VectorXd x = Eigen::VectorXd::Constant(1, frequency / family_.frequency_unit);
    const bool free = curve.evaluate(x) && curve.gaps().minCoeff() > 0.0;
    return free ? std::optional(into_interval(curve)) : std::nullopt;
  }

  // Its pressing nodes, and the equations solved with them.
  std::optional<HatStart> on_curve(const EndAnswer& answer) override {
    HatCurve curve(family_, 1);
    const Eigen::MatrixXd force = answer.motion->sample(curve.samples()).force;
    Eigen::VectorXd all = Eigen::VectorXd::Zero(curve.nodes() + curve.rigid_count() + 1);
    std::vector<int> pressing;
    for (int node = 0; node < curve.nodes(); ++node) {
      const double pressure = -force(node % curve.samples(), node / curve.samples());
      if (!(pressure > 0.0)) continue;
      pressing.push_back(node);
      all[node] = pressure * curve.weight(node);
    }
    all[all.size() - 1] = answer.problem.frequency / family_.frequency_unit;
    if (curve.rigid_count() > 0 && pressing.empty()) return std::nullopt;
    curve.press(pressing);
    const bool solved = correct_at_parameter(curve, curve.on_pressing(all)).has_value();
    return solved ? std::optional(into_interval(curve)) : std::nullopt;
  }

  [[nodiscard]] HatStart into_interval(HatCurve& curve) const {
    const bool upwards = family_.is_below_middle(curve.frequency());
    return {.multiple = 1,
            .pressing = curve.pressing(),
            .x = curve.x(),
            .tangent = first_tangent(curve, upwards),
            .origin = {}};
  }

  [[nodiscard]] bool is_known(const HatStart& start) const override {
    HatCurve curve(family_, start.multiple);
    curve.press(start.pressing);
    return contain(start.multiple, curve.on_all(start.x));
  }

  TracedBranch<HatStart> trace(const HatStart& start) override {
    TracedBranch<HatStart> traced = trace_hat(family_, start, limits(), *this);
    for (const HatStart& grazing : std::exchange(traced.others, {}))
      add_grazing_branches(grazing, traced.others);
    return traced;
  }

  // One of the passages presses; of the others, which graze at the same frequency, the gaps must open.
  void add_grazing_branches(const HatStart& grazing, std::vector<HatStart>& others) const {
    const HatCurve one(family_, 1);
    for (int multiple = 2; multiple * family_.problem.subharmonic <= limits().max_order; ++multiple) {
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
      others.push_back({.multiple = multiple,
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

  [[nodiscard]] Eigen::VectorXd begun_later(const Eigen::VectorXd& all, int periods,
                                            int shift) const override {
    const int samples = periods * family_.samples;
    Eigen::VectorXd later = all;
    for (int first = 0; first + samples < all.size(); first += samples) {  // means of rigid motions stay
      for (int i = 0; i < samples; ++i)
        later[first + (i + shift * family_.samples) % samples] = all[first + i];
    }
    return later;
  }
  [[nodiscard]] double rounding_of(const Eigen::VectorXd& /*all*/) const override {
    return 1e-9;  // of the units
  }

  const HatFamily& family_;
};

}  // namespace

BranchDiagram hat_diagram(const HatFamily& family, const ParametrisedScene& scene, const Method& method,
                          const CurveLimits& limits) {
  const int nodes = family.samples * family.problem.contact_count();
  if (nodes == 0) return {.unfinished = "the scene has no contact"};
  if (nodes > kMostNodes) return {.unfinished = fmt::format("{} nodes are more than {}", nodes, kMostNodes)};
  try {
    std::vector<std::string> notes;
    const std::vector<EndAnswer> answers = end_answers(scene, method, limits, notes);
    BranchDiagram diagram = HatDiagram(family, limits).run(scene, answers);
    diagram.notes.insert(diagram.notes.begin(), notes.begin(), notes.end());
    return diagram;
  } catch (const std::runtime_error& error) {  // of a structure that cannot be factorised
    return {.unfinished = error.what()};
  }
}

}  // namespace signorini
