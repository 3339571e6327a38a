#include "methods/aft_hbm/newton_krylov.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "methods/solvers/gmres.hpp"

namespace signorini {

namespace {

constexpr double kLinearTolerance = 1e-12;  // of each linear solve, relative to its right-hand side

KrylovSolve solve_jacobian(AftResidual& residual, const std::vector<char>& contact,
                           const Eigen::VectorXd& rhs) {
  const LastingContactInverse lasting = residual.lasting_inverse(contact);
  return solve_by_gmres([&](const Eigen::VectorXd& v) { return residual.product(contact, v); },
                        [&](const Eigen::VectorXd& v) { return lasting * v; }, rhs, kLinearTolerance);
}

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
    const auto [step, condition] = solve_jacobian(residual, contact, r);
    if (step.size() == 0) break;
    ++result.iterations;
    result.condition = condition;
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

}  // namespace signorini
