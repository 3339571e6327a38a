#include "methods/orbit/bifurcation_curves/special_equations.hpp"

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>

#include "methods/continuation/arc_length.hpp"
#include "methods/orbit/continuation/bifurcations.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/orthogonal.hpp"

namespace signorini {

namespace {

// Unit vectors: the two along the surface R = 0, the null space of R_x (`jacobian`), and, where R is more
// than its noise, the shortest step to it, -R_x^+ R.
Eigen::MatrixXd ways_to(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& R, double noise) {
  const Eigen::Index n = jacobian.rows();
  const QrFactors qr = householder_qr(jacobian.transpose());
  Eigen::MatrixXd ways = qr.Q.rightCols(2);
  if (R.lpNorm<Eigen::Infinity>() <= noise) return ways;
  const Eigen::VectorXd back = qr.Q.leftCols(n) * lower_solve(qr.R.topRows(n).transpose(), R);
  if (!back.allFinite() || back.isZero(0.0)) return ways;
  ways.conservativeResize(Eigen::NoChange, 3);
  ways.col(2) = back.normalized();
  return ways;
}

}  // namespace

std::optional<double> guard_value(const ExtendedEquations& at, const OrbitGuard& guard) {
  const auto found = guard_of(at, guard.kind, guard.index);
  return found ? std::optional(found->value) : std::nullopt;
}

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
  auto found = evaluated(x, true);
  if (!found) return false;
  here_ = std::move(*found);
  jacobian_.resize(0, 0);
  return true;
}

std::optional<SpecialEquations::Evaluation> SpecialEquations::evaluated(const Eigen::VectorXd& x,
                                                                        bool derivatives) const {
  if (!x.allFinite()) return std::nullopt;
  Evaluation found{.x = x};
  try {
    found.family = plane_.family(x[size()] * plane_.unit());
    found.equations = std::make_unique<ExtendedEquations>(*found.family, orbit_);
    const Eigen::VectorXd orbit = x.head(size());
    if (!(derivatives ? found.equations->evaluate(orbit) : found.equations->evaluate_motion(orbit)))
      return std::nullopt;
  } catch (const std::runtime_error&) {  // no scene, or no flow of a mode
    return std::nullopt;
  }
  const auto value = condition(*found.equations);
  if (!value) return std::nullopt;
  found.residual.resize(size());
  found.residual << found.equations->residual(), *value / scale_;
  return found.residual.allFinite() ? std::optional(std::move(found)) : std::nullopt;
}

const Eigen::MatrixXd& SpecialEquations::jacobian() {
  if (jacobian_.size() == 0) differentiate();
  return jacobian_;
}

bool SpecialEquations::rescale() {
  const Eigen::Index last = size() - 1;
  (void)jacobian();
  if (!(slope_ > 0.0) || !std::isfinite(slope_)) return false;
  here_.residual[last] /= slope_;
  jacobian_.row(last) /= slope_;
  scale_ *= slope_;
  slope_ = 1.0;
  return true;
}

void SpecialEquations::take_reference() {
  if (const auto tangent = tangent_of(*here_.equations, reference_)) reference_ = *tangent;
}

std::optional<double> SpecialEquations::condition(ExtendedEquations& at) const {
  if (guard_) return guard_value(at, *guard_);
  if (!needs_derivatives()) return bifurcation_test(at, reference_, kind_);
  const auto tangent = tangent_of(at, reference_);
  return tangent ? bifurcation_test(at, *tangent, kind_) : std::nullopt;
}

void SpecialEquations::differentiate() {
  constexpr double kBeside = 1e-5;  // in the units of the curve
  const Eigen::Index n = size() - 1;
  const Eigen::VectorXd &x = here_.x, &residual = here_.residual;
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n + 1, n + 2);
  J.topLeftCorner(n, n + 1) = here_.equations->jacobian();
  const auto beside = [&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
    const auto found = evaluated(at, needs_derivatives());
    return found ? found->residual : Eigen::VectorXd::Constant(n + 1, std::nan(""));
  };
  J.topRightCorner(n, 1) =
      (beside(x + kDifference * Eigen::VectorXd::Unit(n + 2, n + 1)) - residual).head(n) / kDifference;
  slope_ = 0.0;
  if (J.allFinite()) {
    const Eigen::MatrixXd ways = ways_to(J.topRows(n), residual.head(n), kNoiseMargin * noise());
    for (Eigen::Index k = 0; k < ways.cols(); ++k) {
      const double ahead = beside(x + kBeside * ways.col(k))[n],
                   behind = beside(x - kBeside * ways.col(k))[n];
      const double slope = (ahead - behind) / (2.0 * kBeside);
      if (k < 2) slope_ = std::hypot(slope_, slope);
      J.row(n) += slope * ways.col(k).transpose();
    }
  }
  jacobian_ = std::move(J);
}

}  // namespace signorini
