#include "methods/orbit/bifurcation_curves/special_equations.hpp"

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>

#include "methods/continuation/arc_length.hpp"
#include "methods/orbit/continuation/bifurcations.hpp"
#include "problems/linear_algebra/singular_values.hpp"

namespace signorini {

OrbitPlane::OrbitPlane(const ScenePlane& plane)
    : plane_(plane), unit_(std::abs(plane.to - plane.from) / 3.0) {
  recent_.emplace_front(plane.from, std::make_shared<OrbitFamily>(plane.at(plane.from)));
  units_ = recent_.front().second->units();
}

std::shared_ptr<OrbitFamily> OrbitPlane::family(double second) {
  constexpr std::size_t kKept = 4;
  const auto found =
      std::find_if(recent_.begin(), recent_.end(), [&](const auto& entry) { return entry.first == second; });
  if (found != recent_.end()) {
    recent_.splice(recent_.begin(), recent_, found);
  } else {
    // Of a load or a gap the modes are the same.
    const auto& modes = recent_.front().second->modes();
    recent_.emplace_front(second, std::make_shared<OrbitFamily>(plane_.at(second), units_, modes));
    if (recent_.size() > kKept) recent_.pop_back();
  }
  return recent_.front().second;
}

SpecialEquations::SpecialEquations(OrbitPlane& plane, SequencedOrbit orbit, SpecialKind kind,
                                   std::optional<OrbitGuard> guard, Eigen::VectorXd reference)
    : plane_(plane),
      orbit_(std::move(orbit)),
      kind_(kind),
      guard_(std::move(guard)),
      reference_(std::move(reference)) {}

bool SpecialEquations::evaluate(const Eigen::VectorXd& x) {
  if (!x.allFinite()) return false;
  try {
    auto family = plane_.family(x[size()] * plane_.unit());
    auto equations = std::make_unique<ExtendedEquations>(*family, orbit_);
    if (!equations->evaluate(x.head(size()))) return false;
    equations_ = std::move(equations);
    family_ = std::move(family);
  } catch (const std::runtime_error&) {  // no scene, or no flow of a mode
    return false;
  }
  const auto value = condition(*equations_);
  if (!value) return false;
  x_ = x;
  jacobian_.resize(0, 0);
  residual_.resize(size());
  residual_ << equations_->residual(), *value / scale_;
  return residual_.allFinite();
}

const Eigen::MatrixXd& SpecialEquations::jacobian() {
  if (jacobian_.size() == 0) differentiate();
  return jacobian_;
}

bool SpecialEquations::rescale() {
  scale_ = 1.0;
  if (!evaluate(Eigen::VectorXd(x_))) return false;
  scale_ = jacobian().row(size() - 1).norm();
  return scale_ > 0.0 && evaluate(Eigen::VectorXd(x_));
}

void SpecialEquations::take_reference() {
  if (const auto tangent = tangent_of(*equations_, reference_)) reference_ = *tangent;
}

std::optional<double> SpecialEquations::condition(ExtendedEquations& at) const {
  if (guard_) {
    const auto found = guard_of(at, guard_->kind, guard_->index);
    return found ? std::optional(found->value) : std::nullopt;
  }
  const auto tangent = tangent_of(at, reference_);
  return tangent ? bifurcation_test(at, *tangent, kind_) : std::nullopt;
}

void SpecialEquations::differentiate() {
  constexpr double kStep = 1e-7, kBeside = 1e-5;  // in the units of the curve
  const Eigen::Index n = size() - 1;
  const Eigen::VectorXd x = x_, residual = residual_;
  Eigen::MatrixXd J(n + 1, n + 2);
  J.topLeftCorner(n, n + 1) = equations_->jacobian();
  const auto beside = [&](const Eigen::VectorXd& at) {
    return evaluate(at) ? residual_ : Eigen::VectorXd::Constant(n + 1, std::nan(""));
  };
  J.topRightCorner(n, 1) =
      (beside(x + kStep * Eigen::VectorXd::Unit(n + 2, n + 1)) - residual).head(n) / kStep;
  J.row(n).setZero();
  if (J.allFinite()) {
    const Eigen::MatrixXd V = right_singular_vectors(J.topRows(n));
    for (Eigen::Index k = n; k < n + 2; ++k) {
      const Eigen::VectorXd way = V.col(k);
      const double ahead = beside(x + kBeside * way)[n], behind = beside(x - kBeside * way)[n];
      J.row(n) += (ahead - behind) / (2.0 * kBeside) * way.transpose();
    }
  }
  evaluate(x);
  jacobian_ = std::move(J);
}

}  // namespace signorini
