#pragma once
// The alternating frequency/time equations on a grid, by Newton-Krylov and a homotopy in the gap.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "methods/complementarity/contact_nodes.hpp"
#include "methods/complementarity/jacobian_solver.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/solvers/lcp/lcp.hpp"
#include "methods/solvers/newton_krylov.hpp"

namespace signorini {

/// R(lambda) = lambda + P max(0, y),   y = y_f + B lambda,
///
/// per contact in units of sqrt(c): lambda = lambda_physical / sqrt(c), y_f = sqrt(c) (x_f - g),
/// B_n = sqrt(c) C_n sqrt(c) - alpha. Unknowns are real, as in fourier_series.hpp: |lambda|_2 is the root
/// mean square in time. Jacobian, products and solves belong to the lambda of the last call of `residual`:
/// there J = 1 + P chi B, chi = 1 at the samples where y > 0. A JacobianSystem (newton_krylov.hpp).
class AftResidual {
 public:
  /// On `samples` instants of the period, more than 2 H.
  AftResidual(const ProjectedEquations& equations, int samples);

  [[nodiscard]] int unknowns() const { return symbol_.unknowns(); }
  [[nodiscard]] int samples() const { return samples_; }
  [[nodiscard]] int contacts() const { return symbol_.contacts(); }

  /// B v at the samples, N Nc.
  [[nodiscard]] Eigen::VectorXd gap_rate(const Eigen::VectorXd& v);
  /// P s of a signal at the samples.
  [[nodiscard]] Eigen::VectorXd project(const Eigen::VectorXd& signal);

  /// R(lambda).
  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& lambda);
  /// J v.
  [[nodiscard]] Eigen::VectorXd product(const Eigen::VectorXd& v);
  /// J^{-1} r.
  [[nodiscard]] KrylovSolve solve_jacobian(const Eigen::VectorXd& r);
  /// |R|_2 over the larger of |P max(0, y)|_2 = |R - lambda|_2 and of the load on the constraint,
  /// |max(0, y_f)|_2, which counts where nothing touches; 0 where both vanish [-].
  [[nodiscard]] double error(const Eigen::VectorXd& lambda, const Eigen::VectorXd& r) const;

  /// Unscaled coefficients n = 0..H of lambda, (H+1) x Nc [N], and back.
  [[nodiscard]] Eigen::MatrixXcd coefficients(const Eigen::VectorXd& lambda) const;
  [[nodiscard]] Eigen::VectorXd unknowns_of(const Eigen::MatrixXcd& coefficients) const;

 private:
  [[nodiscard]] std::vector<ContactNodes> nodes() const;

  ContactSymbol symbol_;
  int samples_;
  Eigen::VectorXd free_;  // y_f at the samples
  double load_scale_ = 0.0;
  RealFft fft_;
  Eigen::Array<bool, Eigen::Dynamic, 1> in_contact_;  // chi, N Nc
  JacobianSolver solver_;
};

/// Newton-Krylov (AftResidual) from the grid before, the guess or the contact-free response; failing that,
/// from the end of the gap homotopy of the same equations on the same samples, which pivoting follows
/// (complementarity_solver.hpp).
/// \param settings  tolerance on AftResidual::error; limit on Newton steps plus pivots in all
/// \param homotopy  whether the gap homotopy follows where Newton fails
std::unique_ptr<GridSolver> aft_grid_solver(const SolverSettings& settings, bool homotopy = true);

}  // namespace signorini
