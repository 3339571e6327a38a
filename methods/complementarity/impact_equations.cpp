#include "methods/complementarity/impact_equations.hpp"

#include <Eigen/LU>
#include <utility>

#include "methods/solvers/constants.hpp"
#include "methods/solvers/damped_newton.hpp"

namespace signorini {

namespace {

/// ImpactEquations as damped_newton sees them. A trial in which an impact pulls is outside their domain.
class ImpactNewton {
 public:
  ImpactNewton(const ImpactEquations& equations, Impacts impacts, double tolerance)
      : equations_(equations),
        tolerance_(tolerance),
        impacts_(std::move(impacts)),
        value_(equations.residual(impacts_)) {}

  [[nodiscard]] double largest() const { return value_.lpNorm<Eigen::Infinity>(); }
  [[nodiscard]] bool solved() const { return largest() <= tolerance_; }
  [[nodiscard]] double merit() const { return value_.norm(); }

  [[nodiscard]] std::optional<double> find_step() {
    correction_ = equations_.jacobian(impacts_).partialPivLu().solve(value_);
    return correction_.allFinite() ? std::optional(1.0) : std::nullopt;
  }

  [[nodiscard]] std::optional<double> merit_at(double length) {
    trial_ = impacts_;
    for (Eigen::Index k = 0; k < trial_.time.size(); ++k) {
      trial_.time[k] -= length * correction_[2 * k];
      trial_.force[k] -= length * correction_[2 * k + 1];
    }
    if (!(trial_.force.minCoeff() > 0.0)) return std::nullopt;
    trial_value_ = equations_.residual(trial_);
    return trial_value_.norm();
  }

  void accept() {
    std::swap(impacts_, trial_);
    value_.swap(trial_value_);
  }

  [[nodiscard]] const Impacts& impacts() const { return impacts_; }

 private:
  const ImpactEquations& equations_;
  double tolerance_;
  Impacts impacts_;
  Eigen::VectorXd value_;
  Eigen::VectorXd correction_;
  Impacts trial_;
  Eigen::VectorXd trial_value_;
};

}  // namespace

Impacts impacts_of(const std::vector<ContactEpisode>& episodes) {
  const auto count = static_cast<Eigen::Index>(episodes.size());
  Impacts impacts{Eigen::VectorXd(count), Eigen::VectorXd(count)};
  for (Eigen::Index k = 0; k < count; ++k) {
    impacts.time[k] = episodes[static_cast<std::size_t>(k)].centre;
    impacts.force[k] = episodes[static_cast<std::size_t>(k)].force;
  }
  return impacts;
}

ImpactEquations::ImpactEquations(const PeriodicGreenFunction& response, const Eigen::VectorXd& gap,
                                 const std::vector<ContactEpisode>& impacts, Eigen::MatrixXcd lasting_motion)
    : response_(response), gap_(gap), impacts_(impacts), lasting_motion_(std::move(lasting_motion)) {}

Eigen::VectorXd ImpactEquations::residual(const Impacts& p) const {
  Eigen::VectorXd result(2 * count());
  for (int k = 0; k < count(); ++k) {
    const int c = contact(k);
    Jet x = trigonometric_jet(lasting_motion_.col(c), p.time[k]);
    for (int l = 0; l < count(); ++l) {
      // The kink of an impact's own response lies exactly at its instant: turn 0, the mean of both sides.
      const Jet g = response_.at(c, contact(l), l == k ? 0.0 : p.time[k] - p.time[l]);
      x.value -= p.force[l] * g.value;
      x.slope -= p.force[l] * g.slope;
    }
    result[2 * k] = x.value - gap_[c];
    result[2 * k + 1] = x.slope / kTwoPi;
  }
  return result;
}

Eigen::MatrixXd ImpactEquations::jacobian(const Impacts& p) const {
  Eigen::MatrixXd matrix(2 * count(), 2 * count());
  for (int k = 0; k < count(); ++k) {
    const int c = contact(k);
    const Jet x = trigonometric_jet(lasting_motion_.col(c), p.time[k]);
    // dX(t_k) / dt_k, at which the impact's own response moves along and does not count.
    double rate = x.slope;
    double change = x.curvature;
    for (int l = 0; l < count(); ++l) {
      const Jet g = response_.at(c, contact(l), l == k ? 0.0 : p.time[k] - p.time[l]);
      matrix(2 * k, 2 * l + 1) = -g.value;
      matrix(2 * k + 1, 2 * l + 1) = -g.slope / kTwoPi;
      if (l == k) continue;
      matrix(2 * k, 2 * l) = p.force[l] * g.slope;
      matrix(2 * k + 1, 2 * l) = p.force[l] * g.curvature / kTwoPi;
      rate -= p.force[l] * g.slope;
      change -= p.force[l] * g.curvature;
    }
    matrix(2 * k, 2 * k) = rate;
    matrix(2 * k + 1, 2 * k) = change / kTwoPi;
  }
  return matrix;
}

std::optional<Impacts> ImpactEquations::solve(const Impacts& from, double tolerance, double rounding) const {
  ImpactNewton newton(*this, from, tolerance);
  const DampedNewtonResult result = damped_newton(newton, {.max_steps = 50, .max_halvings = 9});
  if (result.end == NewtonEnd::singular) return std::nullopt;
  if (result.end != NewtonEnd::solved && !(newton.largest() <= rounding)) return std::nullopt;
  return newton.impacts();
}

}  // namespace signorini
