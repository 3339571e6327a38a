#include "methods/orbit/periodic_closure.hpp"

namespace signorini {

PeriodicClosure::PeriodicClosure(const LinearFlow& flow, const MotionScales& scales, double period)
    : units_(flow.states()) {
  units_ << Eigen::VectorXd::Constant(flow.positions(), scales.displacement),
      Eigen::VectorXd::Constant(flow.size(), scales.velocity);
  const Eigen::MatrixXd transition =
      units_.cwiseInverse().asDiagonal() * flow.transition(period) * units_.asDiagonal();
  lu_ = CompleteLuFactors(Eigen::MatrixXd::Identity(units_.size(), units_.size()) - transition);
}

bool PeriodicClosure::unique() const {
  constexpr double kUnique = 1e-12;
  return lu_.least_pivot() > kUnique;
}

Eigen::VectorXd PeriodicClosure::solve(const Eigen::VectorXd& d) const {
  return units_.cwiseProduct(lu_.solve(d.cwiseQuotient(units_)));
}

}  // namespace signorini
