#include "methods/orbit/family/extended_equations.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace signorini {

ExtendedEquations::ExtendedEquations(OrbitFamily& family, SequencedOrbit orbit)
    : family_(family), orbit_(std::move(orbit)) {
  jacobian_.resize(size(), size() + 1);
}

double ExtendedEquations::parameter() const {
  return orbit_.x[orbit_.x.size() - 1] * family_.units().parameter;
}

double ExtendedEquations::frequency() const { return model_->dynamics.structure().frequency; }

Eigen::VectorXd ExtendedEquations::state_factors(const OrbitModel& model) const {
  const Eigen::Index n = model.dynamics.size();
  const MotionScales& own = model.dynamics.scales();
  Eigen::VectorXd factors(2 * n);
  factors.head(n).setConstant(family_.units().displacement / own.displacement);
  factors.tail(n).setConstant(family_.units().velocity / own.velocity);
  return factors;
}

std::unique_ptr<OrbitEquations> ExtendedEquations::evaluated(OrbitModel& model,
                                                             const Eigen::VectorXd& x) const {
  const FlowStructure& structure = model.dynamics.structure();
  const Eigen::Index n = model.dynamics.size();
  model.period = orbit_.order * structure.forcing_period;
  const OrbitGuess sequence{.start = {.time = orbit_.section / structure.frequency,
                                      .state = {.u = Eigen::VectorXd::Zero(n), .v = Eigen::VectorXd::Zero(n)},
                                      .closed = orbit_.closed},
                            .events = orbit_.events,
                            .origin = {}};
  auto equations = std::make_unique<OrbitEquations>(model, sequence);
  Eigen::VectorXd unknowns = x.head(size());
  unknowns.head(2 * n).array() *= state_factors(model).array();
  if (!equations->evaluate(unknowns)) return nullptr;
  return equations;
}

// Rows of the closure in CurveUnits, so that they are those of y(2 pi n) - y_0 in the unknowns; the units of
// the events' equations do not matter.
Eigen::VectorXd ExtendedEquations::residual_of(const OrbitEquations& equations,
                                               const OrbitModel& model) const {
  Eigen::VectorXd residual = equations.residual();
  const Eigen::VectorXd factors = state_factors(model);
  residual.head(factors.size()).array() /= factors.array();
  return residual;
}

bool ExtendedEquations::evaluate(const Eigen::VectorXd& x) {
  if (!x.allFinite()) return false;
  try {
    const auto model = family_.model(x[x.size() - 1] * family_.units().parameter);
    auto equations = evaluated(*model, x);
    if (!equations) return false;
    model_ = model;
    equations_ = std::move(equations);
  } catch (const std::runtime_error&) {  // no flow of a mode
    return false;
  }
  orbit_.x = x;
  residual_ = residual_of(*equations_, *model_);
  const Eigen::VectorXd factors = state_factors(*model_);
  const Eigen::Index states = factors.size();
  auto square = jacobian_.leftCols(size());
  square = equations_->jacobian();
  square.leftCols(states) *= factors.asDiagonal();
  square.topRows(states).array().colwise() /= factors.array();
  return true;
}

const Eigen::MatrixXd& ExtendedEquations::jacobian() {
  constexpr double kStep = 1e-7, kNear = 1e-6;  // in units of the curve
  if (column_at_.size() == orbit_.x.size() && (column_at_ - orbit_.x).lpNorm<Eigen::Infinity>() < kNear)
    return jacobian_;
  Eigen::VectorXd beside = orbit_.x;
  beside[size()] += kStep;
  const auto model = family_.model(beside[size()] * family_.units().parameter);
  const auto equations = evaluated(*model, beside);
  if (equations) {
    jacobian_.col(size()) = (residual_of(*equations, *model) - residual_) / kStep;
    column_at_ = orbit_.x;
  } else {
    jacobian_.col(size()).setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  return jacobian_;
}

Eigen::VectorXd ExtendedEquations::state_at(double phase) const {
  Eigen::Index i = 0;
  while (i < orbit_.count() && orbit_.phase(i) < phase) ++i;
  State state;
  equations_->arcs()[static_cast<std::size_t>(i)]->state(time_of(phase), state);
  Eigen::VectorXd y(orbit_.states());
  y << state.u / family_.units().displacement, state.v / family_.units().velocity;
  return y;
}

Eigen::MatrixXd ExtendedEquations::monodromy() const {
  Eigen::MatrixXd M = equations_->monodromy();
  if (M.size() == 0) return M;
  const Eigen::VectorXd factors = state_factors(*model_);
  return factors.cwiseInverse().asDiagonal() * M * factors.asDiagonal();
}

}  // namespace signorini
