#include "methods/aft_hbm/gap_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "methods/kernels/gmres.hpp"

namespace signorini {

namespace {

constexpr double kLinearTolerance = 1e-12;  // of each linear solve, relative to its right-hand side
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Eigen::VectorXd solve_jacobian(AftResidual& residual, const std::vector<char>& contact,
                               const Eigen::VectorXd& rhs) {
  residual.prepare_preconditioner(contact);
  return solve_by_gmres([&](const Eigen::VectorXd& v) { return residual.product(contact, v); },
                        [&](const Eigen::VectorXd& v) { return residual.precondition(v); }, rhs,
                        kLinearTolerance);
}

/// Solves J v - s P chi d = r, (B v - s d)_i = rate for (v, s), stacked; empty on failure.
Eigen::VectorXd solve_bordered(AftResidual& residual, const std::vector<char>& contact,
                               const Eigen::VectorXd& r, int sample, double rate) {
  residual.prepare_preconditioner(contact);
  Eigen::VectorXd shifted = residual.shift();
  for (Eigen::Index i = 0; i < shifted.size(); ++i) {
    if (contact[static_cast<std::size_t>(i)] == 0) shifted[i] = 0.0;
  }
  const Eigen::VectorXd border = residual.project(shifted);
  const auto size = static_cast<Eigen::Index>(residual.unknowns());
  const auto product = [&](const Eigen::VectorXd& x) {
    const Eigen::VectorXd signal = residual.gap_rate(x.head(size));
    Eigen::VectorXd pressed = signal;
    for (Eigen::Index i = 0; i < pressed.size(); ++i) {
      if (contact[static_cast<std::size_t>(i)] == 0) pressed[i] = 0.0;
    }
    Eigen::VectorXd out(size + 1);
    out.head(size) = x.head(size) + residual.project(pressed) - x[size] * border;
    out[size] = signal[sample] - x[size] * residual.shift()[sample];
    return out;
  };
  const auto precondition = [&](const Eigen::VectorXd& x) {
    Eigen::VectorXd out(size + 1);
    out.head(size) = residual.precondition(x.head(size));
    out[size] = -x[size] / residual.shift()[sample];
    return out;
  };
  Eigen::VectorXd rhs(size + 1);
  rhs << r, rate;
  return solve_by_gmres(product, precondition, rhs, kLinearTolerance);
}

class Path {
 public:
  explicit Path(AftResidual& residual) : residual_(residual) {
    lambda_ = Eigen::VectorXd::Zero(residual.unknowns());
    const Eigen::VectorXd open = residual.gap_function(lambda_, 0.0);
    tau_ = (open.array() / residual.shift().array()).maxCoeff(&driving_);
    contact_.assign(static_cast<std::size_t>(open.size()), 0);
    contact_[static_cast<std::size_t>(driving_)] = 1;
  }

  [[nodiscard]] double tau() const { return tau_; }
  [[nodiscard]] const Eigen::VectorXd& lambda() const { return lambda_; }

  /// Walks one piece. nullopt-like: returns the reason to stop, or `limit` to go on.
  GapPath::End step() {
    const double rate = contact_[static_cast<std::size_t>(driving_)] != 0 ? 1.0 : -1.0;
    Eigen::VectorXd y = residual_.gap_function(lambda_, tau_);
    if (!settle(y)) return GapPath::End::singular;
    const Eigen::VectorXd direction =
        solve_bordered(residual_, contact_, Eigen::VectorXd::Zero(lambda_.size()), driving_, rate);
    if (direction.size() == 0) return GapPath::End::singular;
    const Eigen::VectorXd v = direction.head(lambda_.size());
    const double s = direction[lambda_.size()];
    const Eigen::VectorXd dy = residual_.gap_rate(v) - s * residual_.shift();
    const auto [length, next] = first_switch(y, dy);
    const double to_zero = s < 0.0 ? tau_ / -s : std::numeric_limits<double>::infinity();
    if (next < 0 && !std::isfinite(to_zero)) return GapPath::End::ray;
    if (to_zero <= length) {
      lambda_ += to_zero * v;
      tau_ = 0.0;
      return GapPath::End::arrived;
    }
    lambda_ += length * v;
    tau_ += length * s;
    driving_ = next;
    char& closed = contact_[static_cast<std::size_t>(next)];
    closed = closed != 0 ? 0 : 1;
    return GapPath::End::limit;
  }

 private:
  /// Pulls (lambda, tau) back onto the path, the driving sample on its switch, where rounding has moved it.
  bool settle(Eigen::VectorXd& y) {
    Eigen::VectorXd pressed = y;
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      if (contact_[static_cast<std::size_t>(i)] == 0) pressed[i] = 0.0;
    }
    const Eigen::VectorXd r = lambda_ + residual_.project(pressed);
    const double scale = std::max(residual_.load_scale(), lambda_.norm());
    constexpr double kDrift = 1e-10;  // relative to the load or the force
    if (r.norm() <= kDrift * scale && std::abs(y[driving_]) <= kDrift * scale) return true;
    const Eigen::VectorXd correction = solve_bordered(residual_, contact_, -r, driving_, -y[driving_]);
    if (correction.size() == 0) return false;
    lambda_ += correction.head(lambda_.size());
    tau_ += correction[lambda_.size()];
    y = residual_.gap_function(lambda_, tau_);
    return true;
  }

  /// The nearest switch along y + t dy; index -1 if there is none.
  [[nodiscard]] std::pair<double, int> first_switch(const Eigen::VectorXd& y,
                                                    const Eigen::VectorXd& dy) const {
    double length = std::numeric_limits<double>::infinity();
    int next = -1;
    const double threshold = 64 * kEpsilon * std::max(1.0, dy.lpNorm<Eigen::Infinity>());
    for (int i = 0; i < static_cast<int>(y.size()); ++i) {
      if (i == driving_) continue;
      const bool closed = contact_[static_cast<std::size_t>(i)] != 0;
      const double towards = closed ? -dy[i] : dy[i];
      if (towards <= threshold) continue;
      const double distance = std::max(0.0, closed ? y[i] : -y[i]) / towards;
      if (distance < length) {
        length = distance;
        next = i;
      }
    }
    return {length, next};
  }

  AftResidual& residual_;
  Eigen::VectorXd lambda_;
  double tau_ = 0.0;
  int driving_ = 0;
  std::vector<char> contact_;
};

}  // namespace

NewtonKrylov solve_newton_krylov(AftResidual& residual, Eigen::VectorXd lambda, double tolerance,
                                 int max_iterations, const Start& start) {
  NewtonKrylov result;
  std::vector<char> contact;
  Eigen::VectorXd r = residual.residual(lambda, contact);
  while (true) {
    const double scale = std::max(residual.load_scale(), (r - lambda).norm());
    result.residual = scale > 0.0 ? r.norm() / scale : 0.0;
    result.converged = result.residual <= tolerance;
    if (result.converged || result.iterations >= max_iterations || start.expired()) break;
    const Eigen::VectorXd step = solve_jacobian(residual, contact, r);
    if (step.size() == 0) break;
    ++result.iterations;
    constexpr int kHalvings = 16;
    double length = 1.0;
    bool descended = false;
    for (int k = 0; k <= kHalvings && !descended; ++k, length *= 0.5) {
      std::vector<char> trial_contact;
      const Eigen::VectorXd trial = lambda - length * step;
      const Eigen::VectorXd trial_r = residual.residual(trial, trial_contact);
      descended = trial_r.norm() < (1.0 - 1e-4 * length) * r.norm();
      if (!descended) continue;
      lambda = trial;
      r = trial_r;
      contact = std::move(trial_contact);
    }
    if (!descended) break;
  }
  result.lambda = std::move(lambda);
  return result;
}

GapPath follow_gap_path(AftResidual& residual, int max_switches, const Start& start) {
  GapPath result;
  Path path(residual);
  if (path.tau() <= 0.0) {
    result.end = GapPath::End::arrived;
    result.lambda = path.lambda();
    return result;
  }
  for (; result.switches < max_switches; ++result.switches) {
    if (start.expired()) {
      result.end = GapPath::End::interrupted;
      break;
    }
    result.end = path.step();
    if (result.end != GapPath::End::limit) break;
  }
  result.lambda = path.lambda();
  return result;
}

}  // namespace signorini
