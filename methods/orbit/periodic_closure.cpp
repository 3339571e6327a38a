#include "methods/orbit/periodic_closure.hpp"

#include "methods/solvers/constants.hpp"

namespace signorini {

Eigen::VectorXd state_units(const LinearFlow& flow, const MotionScales& scales) {
  Eigen::VectorXd units(flow.states());
  units << Eigen::VectorXd::Constant(flow.positions(), scales.displacement),
      Eigen::VectorXd::Constant(flow.size(), scales.velocity);
  return units;
}

Eigen::MatrixXd scaled_closure(const LinearFlow& flow, const Eigen::VectorXd& units, double period) {
  const Eigen::MatrixXd transition =
      units.cwiseInverse().asDiagonal() * flow.transition(period) * units.asDiagonal();
  return Eigen::MatrixXd::Identity(units.size(), units.size()) - transition;
}

PeriodicClosure::PeriodicClosure(const LinearFlow& flow, const MotionScales& scales, double period)
    : units_(state_units(flow, scales)), lu_(scaled_closure(flow, units_, period)) {}

bool PeriodicClosure::unique() const { return lu_.least_pivot() > kMatrixRounding; }

Eigen::VectorXd PeriodicClosure::solve(const Eigen::VectorXd& d) const {
  return units_.cwiseProduct(lu_.solve(d.cwiseQuotient(units_)));
}

}  // namespace signorini
