#include "methods/orbit/family/followed_quantity.hpp"

#include <algorithm>
#include <cmath>

namespace signorini {

double energy_of(const OrbitModel& model, const FlowState& at) {
  const FlowStructure& s = model.dynamics.structure();
  const State& y = at.state;
  double energy = 0.5 * (y.v.dot(s.mass * y.v) + y.u.dot(s.stiffness * y.u)) - y.u.dot(s.load_at(at.time));
  std::vector<bool> pressed = at.closed;  // springs alone
  for (int j = 0; j < model.dynamics.contact_count(); ++j)
    if (model.dynamics.rigid(j)) pressed[static_cast<std::size_t>(j)] = false;
  const ContactMode mode = model.dynamics.mode(pressed);
  if (mode.active.empty()) return energy;
  const Eigen::VectorXd over = s.unloaded(at.time, y.u, 0)(mode.active) - s.gaps(mode.active);
  return energy + 0.5 * over.dot(mode.response * over);
}

FollowedQuantity::FollowedQuantity(const OrbitFamily& family, const std::optional<ParameterRange>& energies)
    : family_(family),
      of_energy_(energies.has_value()),
      range_(energies.value_or(ParameterRange{family.scene().low(), family.scene().high()})) {}

double FollowedQuantity::at(const ExtendedEquations& equations, const Eigen::VectorXd& x) const {
  if (!of_energy_) return x[x.size() - 1] * family_.units().parameter;
  return energy_of(equations.model(), {.time = 0.0,
                                       .state = state_of(x, equations.model().dynamics, family_.units()),
                                       .closed = equations.orbit().closed});
}

std::optional<StepTarget> FollowedQuantity::target(const std::vector<double>& values,
                                                   const ExtendedEquations& equations,
                                                   const Eigen::VectorXd& begin) const {
  return first_target(values, range_.low, range_.high, at(equations, begin),
                      at(equations, equations.orbit().x));
}

std::optional<double> FollowedQuantity::length_to(double value, ExtendedEquations& equations,
                                                  const CurveStep& step) const {
  const Eigen::VectorXd end = equations.orbit().x;
  if (!of_energy_) return length_to_parameter(equations, step, end, value / family_.units().parameter);
  const double unit = std::max(std::abs(range_.low), std::abs(range_.high));
  const auto missed = [&](ExtendedEquations& here) {
    return std::optional((at(here, here.orbit().x) - value) / unit);
  };
  return locate(equations, step, missed, (at(equations, step.x) - value) / unit,
                (at(equations, end) - value) / unit);
}

std::optional<int> FollowedQuantity::land(ExtendedEquations& equations, const Eigen::VectorXd& x,
                                          const Eigen::VectorXd& tangent, double& length) const {
  const Eigen::Index last = x.size() - 1;
  const ParametrisedScene& scene = family_.scene();
  const double end = (tangent[last] < 0.0 ? scene.low() : scene.high()) / family_.units().parameter;
  const double reach = (end - x[last]) / tangent[last];
  if (!(reach > 0.0 && reach < length)) return std::nullopt;
  Eigen::VectorXd predicted = x + reach * tangent;
  predicted[last] = end;
  const auto iterations = correct_at_parameter(equations, predicted);
  if (!iterations) return std::nullopt;
  const double along = tangent.dot(equations.orbit().x - x);
  if (!(along > 0.0 && along < 2.0 * reach)) return std::nullopt;
  length = along;
  return iterations;
}

bool FollowedQuantity::turns(const std::vector<double>& values, const ExtendedEquations& equations,
                             const CurveStep& step, const Eigen::VectorXd& tangent) const {
  if (values.empty()) return false;
  const Eigen::VectorXd along = tangent / tangent.dot(step.tangent);
  const Eigen::VectorXd& end = equations.orbit().x;
  return turns_past(values, range_.low, range_.high,
                    {at(equations, step.x), rate(equations, step.x, step.length * step.tangent)},
                    {at(equations, end), rate(equations, end, step.length * along)});
}

double FollowedQuantity::rate(const ExtendedEquations& equations, const Eigen::VectorXd& x,
                              const Eigen::VectorXd& way) const {
  return 0.5 * (at(equations, x + way) - at(equations, x - way));
}

}  // namespace signorini
