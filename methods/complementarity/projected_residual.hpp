#pragma once
// The residual of the projected contact equations and its derivatives.

#include <Eigen/Core>
#include <vector>

#include "methods/complementarity/contact_nodes.hpp"
#include "methods/complementarity/exact_quadrature.hpp"
#include "methods/complementarity/jacobian_solver.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/discretisation/contact_phases.hpp"
#include "methods/solvers/newton_krylov.hpp"

namespace signorini {

/// How the contact integral P max(0, y) is taken.
enum class ContactIntegral {
  exact,    ///< between the instants where y changes its sign
  sampled,  ///< as the sum over the samples
};

/// R(lambda) = lambda + P max(0, y) of the law of `equations` (ProjectedLaw) as a JacobianSystem, x = x_f + C
/// lambda, in units of sqrt(c) per contact and packed as in fourier_series.hpp. On a structure with rigid
/// motions the unknown is mu (MeanBalance) wherever lambda is said: with P chi B of the held structure its
/// Jacobian is 1 - U V^T + P chi B, U V^T of rank m on the means.
class ProjectedResidual {
 public:
  /// \param samples  exact: instants on which sign changes of y are bracketed, at least 8 H; sampled: N >= 2
  ///        H + 1
  /// \param tolerance  on `error` [-]
  /// \param shifts  the stops stand at g - shift(t); empty: at g. Only with the exact integral
  ProjectedResidual(const ProjectedEquations& equations, int samples, double tolerance,
                    const StopShifts& shifts = {}, ContactIntegral integral = ContactIntegral::exact);

  /// Instants that the contacts are looked for on, or that are summed over.
  [[nodiscard]] int samples() const { return samples_; }
  /// sqrt(c), Nc.
  [[nodiscard]] const Eigen::VectorXd& root() const { return symbol_.root(); }
  /// A force, coefficients n = 0..H, (H+1) x Nc [N], as the packed lambda of these equations.
  [[nodiscard]] Eigen::VectorXd unknowns_of(const Eigen::MatrixXcd& force) const;
  /// A packed lambda as the force, coefficients n = 0..H, (H+1) x Nc [N].
  [[nodiscard]] Eigen::MatrixXcd force_of(const Eigen::VectorXd& lambda) const;
  /// |R|_2 / |lambda|_2. Short contacts press little on the mean, and much less than the load would: the
  /// force is the scale. Where it lies below the rounding of y, in which the load and the response to the
  /// force cancel, R may be as large as that rounding, as long as a force of that size moves nothing by more
  /// than 1e-6 of x_f - g: with c up to some 1e8 times the structure's stiffness. Infinite where only R is
  /// left.
  [[nodiscard]] double error(const Eigen::VectorXd& lambda, const Eigen::VectorXd& r) const;
  /// What rounding leaves of R, in its units.
  [[nodiscard]] double rounding() const { return rounding_; }

  /// R(lambda); keeps the contacts for the derivatives.
  Eigen::VectorXd residual(const Eigen::VectorXd& lambda);
  /// J^{-1} r at the contacts of the last residual, J = 1 + P chi B. Moving an edge of contact contributes
  /// nothing to J, since y = 0 there.
  [[nodiscard]] KrylovSolve solve_jacobian(const Eigen::VectorXd& r);
  /// J as a matrix, (2 H + 1) Nc square.
  [[nodiscard]] Eigen::MatrixXd jacobian() const;
  /// P chi s of functions s of each contact, n = 0..H, (H+1) x Nc: the derivative of R - lambda along y' = s.
  [[nodiscard]] Eigen::MatrixXcd pressed(const Eigen::MatrixXcd& s) const;

  /// When each contact presses at the last residual, Nc lists.
  [[nodiscard]] const std::vector<std::vector<ContactInterval>>& contacts() const { return contacts_; }
  /// The indicator functions of these, Nc.
  [[nodiscard]] const std::vector<ContactIndicator>& indicators() const { return indicators_; }

 private:
  [[nodiscard]] Eigen::MatrixXd pressed_jacobian() const;  // 1 + P chi B
  void take_balance(const ProjectedEquations& equations);
  [[nodiscard]] KrylovSolve with_balance(KrylovSolve plain, const JacobianSolver::Contacts& contacts);
  [[nodiscard]] Eigen::VectorXd product(const Eigen::VectorXd& v) const;
  [[nodiscard]] std::vector<ContactNodes> nodes() const;
  void fill_block(Eigen::Index row, Eigen::Index column, Eigen::Ref<Eigen::MatrixXd> block) const;
  void take_contacts(Eigen::Index contact, const Eigen::VectorXcd& y);

  int harmonics_;
  int samples_;
  ContactIntegral integral_;
  ContactSymbol symbol_;
  Eigen::MatrixXcd free_;          // of sqrt(c) (x_f - g)
  Eigen::VectorXd balance_;        // lambda_b; empty without rigid motions
  Eigen::MatrixXd share_, along_;  // U, Nc x m, and V^T
  double rounding_ = 0.0;
  double least_scale_ = 0.0;
  StopShifts shifts_;
  std::vector<std::vector<ContactInterval>> contacts_;
  std::vector<ContactIndicator> indicators_;
  JacobianSolver solver_;
};

}  // namespace signorini
