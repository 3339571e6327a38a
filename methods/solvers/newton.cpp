#include "methods/solvers/newton.hpp"

#include <Eigen/LU>
#include <cmath>
#include <optional>
#include <utility>

#include "methods/solvers/condition_estimate.hpp"

namespace signorini {

namespace {

Eigen::VectorXd normal_map(Lcp& lcp, const Eigen::VectorXd& y) {
  return (-y).cwiseMax(0.0) - lcp.offset - lcp.matrix * y.cwiseMax(0.0);
}

/// Solution of the linear problem with the active set of y frozen; empty if that is singular. Estimates the
/// condition of its block where there is one.
Eigen::VectorXd newton_point(Lcp& lcp, const Eigen::VectorXd& y, std::optional<double>& condition) {
  std::vector<int> active;
  for (int i = 0; i < static_cast<int>(y.size()); ++i) {
    if (y[i] > 0.0) active.push_back(i);
  }
  Eigen::VectorXd next = -lcp.offset;
  condition.reset();
  if (active.empty()) return next;
  Eigen::VectorXd rhs(static_cast<Eigen::Index>(active.size()));
  for (std::size_t k = 0; k < active.size(); ++k) rhs[static_cast<Eigen::Index>(k)] = -lcp.offset[active[k]];
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(lcp.matrix.submatrix(active, active));
  const Eigen::VectorXd z = lu.solve(rhs);
  if (!z.allFinite()) return {};
  condition = condition_from(lu.rcond());
  Eigen::VectorXd full = Eigen::VectorXd::Zero(y.size());
  for (std::size_t k = 0; k < active.size(); ++k) full[active[k]] = z[static_cast<Eigen::Index>(k)];
  next = -(lcp.offset + lcp.matrix * full);
  for (std::size_t k = 0; k < active.size(); ++k) next[active[k]] = z[static_cast<Eigen::Index>(k)];
  return next;
}

/// Moves y towards `target` by the first halved step that reduces |F|; false if none does.
bool line_search(Lcp& lcp, const Eigen::VectorXd& target, Eigen::VectorXd& y, double merit) {
  constexpr int kHalvings = 20;
  double step = 1.0;
  for (int k = 0; k <= kHalvings; ++k, step *= 0.5) {
    const Eigen::VectorXd trial = y + step * (target - y);
    const double trial_merit = normal_map(lcp, trial).norm();
    if (trial_merit < (1.0 - 1e-4 * step) * merit) {
      y = trial;
      return true;
    }
  }
  return false;
}

}  // namespace

LcpResult solve_by_newton(Lcp& lcp, const NewtonOptions& options) {
  LcpResult result;
  const bool warm = options.guess.size() == lcp.offset.size();
  // Where the guess presses, y = z; elsewhere y = -w.
  Eigen::VectorXd y = -lcp.offset;
  if (warm)
    y = (options.guess.array() > 0.0).select(options.guess, -(lcp.offset + lcp.matrix * options.guess));
  result.status = LcpStatus::limit;
  while (true) {
    result.z = y.cwiseMax(0.0);
    result.residual = natural_residual(lcp, result.z);
    const Eigen::VectorXd residual = normal_map(lcp, y);
    const double scale = std::max(lcp.offset.lpNorm<Eigen::Infinity>(), y.lpNorm<Eigen::Infinity>());
    if (result.residual <= options.tolerance &&
        residual.lpNorm<Eigen::Infinity>() <= options.tolerance * scale) {
      result.status = LcpStatus::solved;
      break;
    }
    if (result.iterations >= options.max_iterations) break;
    if (std::chrono::steady_clock::now() > options.deadline) {
      result.status = LcpStatus::interrupted;
      break;
    }
    const Eigen::VectorXd target = newton_point(lcp, y, result.condition);
    ++result.factorisations;
    if (target.size() == 0) {
      result.status = LcpStatus::breakdown;
      break;
    }
    ++result.iterations;
    if (!line_search(lcp, target, y, residual.norm())) {
      result.status = LcpStatus::stalled;
      break;
    }
  }
  return result;
}

}  // namespace signorini
