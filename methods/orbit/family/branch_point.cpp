#include "methods/orbit/family/branch_point.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/singular_values.hpp"

namespace signorini {

namespace {

class BranchPointSystem {
 public:
  // Precondition: the equations are evaluated.
  explicit BranchPointSystem(ExtendedEquations& equations) : equations_(equations) {
    const SingularValues svd = singular_vectors(equations.accurate_jacobian());
    b_ = svd.U.rightCols(1);
    C_ = svd.V.rightCols(2);
  }

  [[nodiscard]] const Eigen::MatrixXd& null_space() const { return C_; }
  [[nodiscard]] const Eigen::Matrix2d& curvature() const { return H_; }

  // H_jk = dg_j along column k of C; false where the flow is not finite beside x.
  bool differentiate(const Eigen::VectorXd& x) {
    constexpr double kBeside = 2e-5;
    for (Eigen::Index k = 0; k < 2; ++k) {
      if (!equations_.evaluate(x + kBeside * C_.col(k))) return false;
      const Eigen::Vector2d ahead = rank_condition();
      if (!equations_.evaluate(x - kBeside * C_.col(k))) return false;
      H_.col(k) = (ahead - rank_condition()) / (2.0 * kBeside);
    }
    return H_.allFinite();
  }

  // The step of (x, nu) where the equations are evaluated; its last entry that of nu.
  Eigen::VectorXd step(double nu) {
    const Eigen::Index n = equations_.size();
    Eigen::VectorXd right(n + 2);
    right << -(equations_.residual() + nu * b_), -rank_condition();
    Eigen::MatrixXd B = bordered();
    B.bottomLeftCorner(2, n + 1) = H_ * C_.transpose();
    return lu_solve(B, right);
  }

 private:
  // [R_x b; C^T 0].
  Eigen::MatrixXd bordered() {
    const Eigen::Index n = equations_.size();
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(n + 2, n + 2);
    B.topLeftCorner(n, n + 1) = equations_.accurate_jacobian();
    B.topRightCorner(n, 1) = b_;
    B.bottomLeftCorner(2, n + 1) = C_.transpose();
    return B;
  }
  Eigen::Vector2d rank_condition() {
    const Eigen::Index n = equations_.size();
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n + 2, 2);
    right.bottomRows(2).setIdentity();
    return lu_solve(bordered(), right).row(n + 1).transpose();
  }

  ExtendedEquations& equations_;
  Eigen::VectorXd b_;
  Eigen::MatrixXd C_;
  Eigen::Matrix2d H_ = Eigen::Matrix2d::Zero();
};

// The two directions a with a^T H a = 0; empty unless H is indefinite by more than its error.
std::optional<std::pair<Eigen::Vector2d, Eigen::Vector2d>> isotropic_directions(const Eigen::Matrix2d& H) {
  constexpr double kFlat = 1e-6;  // of |H|^2
  const double p = H(0, 0), q = 0.5 * (H(0, 1) + H(1, 0)), r = H(1, 1);
  const double discriminant = q * q - p * r;
  if (!(discriminant > kFlat * H.squaredNorm())) return std::nullopt;
  // p s^2 + 2 q s t + r t^2 = 0, without cancellation: s : t = w : p and r : w.
  const double w = -(q + std::copysign(std::sqrt(discriminant), q));
  return std::pair(Eigen::Vector2d(w, p).normalized(), Eigen::Vector2d(r, w).normalized());
}

}  // namespace

std::optional<BranchPointSolution> solve_branch_point(ExtendedEquations& equations, const Eigen::VectorXd& x,
                                                      double reach) {
  constexpr int kIterations = 12;
  constexpr double kSettled = 1e-13, kVanishes = 1e-11;  // of |x|
  const Eigen::VectorXd begin = x;                       // that of the equations may be given
  if (equations.size() == 0 || !equations.family().driven() || !equations.evaluate(begin))
    return std::nullopt;
  BranchPointSystem system(equations);
  if (!system.differentiate(begin) || !equations.evaluate(begin)) return std::nullopt;
  const double size = std::max(1.0, begin.lpNorm<Eigen::Infinity>());
  Eigen::VectorXd at = begin;
  double nu = 0.0, before = reach;
  bool settled = false;
  for (int k = 0; k < kIterations && !settled; ++k) {
    const Eigen::VectorXd step = system.step(nu);
    if (!step.allFinite()) return std::nullopt;
    at += step.head(at.size());
    nu += step[at.size()];
    const double length = step.lpNorm<Eigen::Infinity>();
    if ((at - begin).norm() > reach || !equations.evaluate(at)) return std::nullopt;
    // Steps of rounding no longer fall.
    settled = length < kSettled * size || (k >= 2 && length < 1e-9 * size && length > 0.5 * before);
    before = length;
  }
  const double zero = std::max(kVanishes * size, kNoiseMargin * equations.noise());
  if (!settled || !(std::abs(nu) < zero)) return std::nullopt;
  const auto directions = isotropic_directions(system.curvature());
  if (!directions) return std::nullopt;
  return BranchPointSolution{.x = at,
                             .first = system.null_space() * directions->first,
                             .second = system.null_space() * directions->second};
}

}  // namespace signorini
