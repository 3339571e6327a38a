#include "methods/complementarity/exact_projection.hpp"

#include <algorithm>
#include <vector>

#include "methods/complementarity/projected_residual.hpp"
#include "methods/discretisation/fourier_series.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/solvers/lcp/lcp.hpp"
#include "methods/solvers/newton_krylov.hpp"
#include "problems/linear_algebra/complex_lu.hpp"

namespace signorini {

namespace {

/// The contacts that the mean of the load alone closes, in rising order: the static complementarity problem
/// of x_0 = x_f,0 + C_0 lambda_0 with the compliance of the stop, 1 / k_p = (1 - alpha) / c.
std::vector<int> closed_under_mean_load(const ProjectedEquations& equations) {
  const auto& [receptance, gap, law] = equations;
  Eigen::MatrixXd compliance = receptance.receptance[0].real();
  compliance.diagonal().array() += (1.0 - law.multiplier_weight.array()) / law.constant.array();
  const Eigen::VectorXd open = gap - receptance.free_response.row(0).real().transpose();
  const std::vector<bool> none(static_cast<std::size_t>(gap.size()), false);
  std::vector<int> closed;
  if (const auto pressure = solve_small_lcp(compliance, open, none)) {
    for (int c = 0; c < gap.size(); ++c) {
      if ((*pressure)[c] > 0.0) closed.push_back(c);
    }
  }
  return closed;
}

/// lambda with these contacts closed throughout and the others open, n = 0..H.
Eigen::MatrixXcd force_on_closed(const ProjectedEquations& equations, const std::vector<int>& closed) {
  const auto& [receptance, gap, law] = equations;
  Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Zero(receptance.harmonics() + 1, receptance.contacts());
  for (int n = 0; n <= receptance.harmonics(); ++n) {
    Eigen::VectorXcd free = receptance.free_response.row(n).transpose();
    if (n == 0) free -= gap;
    // Where closed y = -lambda throughout: c (x_f - g) + (c C + 1 - alpha) lambda = 0.
    Eigen::MatrixXcd block = law.constant.asDiagonal() * receptance.receptance[static_cast<std::size_t>(n)];
    block.diagonal() += (1.0 - law.multiplier_weight.array()).matrix();
    const Eigen::MatrixXcd held = block(closed, closed);
    const Eigen::VectorXcd load = law.constant.cwiseProduct(free)(closed);
    const Eigen::VectorXcd force = -lu_solve(held, load);
    lambda(n, closed) = force.transpose();
  }
  return lambda;
}

/// Whether the closed contacts press and the others stay open at every sample.
bool is_consistent(const ProjectedEquations& equations, const std::vector<int>& closed,
                   const Eigen::MatrixXcd& lambda, int samples) {
  Eigen::MatrixXcd penetration = contact_motion(equations.receptance, lambda);
  penetration.row(0) -= equations.gap.transpose();
  RealFft fft(samples);
  Eigen::VectorXd signal(samples);
  for (int c = 0; c < equations.receptance.contacts(); ++c) {
    // Negative at all times: the force of a contact that presses, the penetration of one that is open.
    const bool presses = std::binary_search(closed.begin(), closed.end(), c);
    const Eigen::MatrixXcd& negative = presses ? lambda : penetration;
    fft.inverse(negative.col(c), signal);
    if (signal.maxCoeff() >= 0.0) return false;
  }
  return true;
}

}  // namespace

ExactProjection project_exactly(const ProjectedEquations& equations, const Eigen::MatrixXcd& lambda,
                                const ExactProjectionSettings& settings, const StopShifts& shifts) {
  ProjectedResidual residual(equations, settings.samples, settings.tolerance, shifts);
  // Far from the solution a full step may lose a contact; a shorter one keeps it.
  NewtonKrylovResult newton =
      solve_newton_krylov(residual, residual.unknowns_of(lambda), settings.tolerance,
                          {.max_steps = settings.most, .max_halvings = 10, .deadline = settings.deadline});
  return {.converged = newton.end == NewtonEnd::solved,
          .iterations = newton.iterations,
          .residual = newton.residual,
          .condition = newton.condition,
          .lambda = residual.force_of(newton.unknowns)};
}

ExactProjection solve_permanent_contact(const ProjectedEquations& equations, double tolerance) {
  if (equations.receptance.rigid_count() > 0) return {};  // the mean alone does not say which contacts press
  const std::vector<int> closed = closed_under_mean_load(equations);
  if (closed.empty()) return {};
  const Eigen::MatrixXcd lambda = force_on_closed(equations, closed);
  if (!lambda.allFinite()) return {};
  const int samples = kResolvingSamples * std::max(1, equations.receptance.harmonics());
  if (!is_consistent(equations, closed, lambda, samples)) return {};
  return project_exactly(equations, lambda, {.samples = samples, .tolerance = tolerance});
}

}  // namespace signorini
