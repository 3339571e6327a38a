#pragma once
// Contact forces of a structure with rigid motions as unknowns without a condition on their mean.

#include <Eigen/Core>

#include "methods/solution.hpp"
#include "methods/structure/contact_receptance.hpp"

namespace signorini {

/// On a structure with rigid motions the mean of the contact forces has m components that are known, E^T
/// lambda_0 = -R^T f_0 (ContactReceptance), and that of the motion as many that are not. Coefficients mu,
/// (H+1) x Nc [N], carry both: mu_n = lambda_n for n > 0, and with P = E (E^T E)^{-1} E^T
///
///     lambda_0 = (1 - P) mu_0 + lambda_b,   lambda_b = -E (E^T E)^{-1} R^T f_0,   E a = E E^T mu_0 / w^2,
///
/// w the base frequency, so that equations in mu are as many as those in lambda of a structure on springs.
/// Where no rigid motion is felt, mu = lambda.
struct MeanBalance {
  /// Of a receptance with rigid motions; of others all are empty.
  explicit MeanBalance(const ContactReceptance& receptance);

  Eigen::MatrixXd share;       ///< P, Nc x Nc
  Eigen::VectorXd force;       ///< lambda_b, Nc [N]
  Eigen::MatrixXd compliance;  ///< E E^T / w^2, Nc x Nc [m/N]
  Eigen::MatrixXd moved;       ///< C_0 (1 - P) + E E^T / w^2: how x_0 answers to mu_0, Nc x Nc [m/N]
};

/// lambda of mu.
Eigen::MatrixXcd balanced_force(const ContactReceptance& receptance, const Eigen::MatrixXcd& carried);

/// x_n = free_n + C_n lambda_n, and E a, of mu, (H+1) x Nc [m].
Eigen::MatrixXcd carried_motion(const ContactReceptance& receptance, const Eigen::MatrixXcd& carried);

/// mu of a force, (H+1) x Nc [N], and the mean of rigid motions. \param mean  E a, Nc [m]
Eigen::MatrixXcd carried_force(const ContactReceptance& receptance, const Eigen::MatrixXcd& lambda,
                               const Eigen::RowVectorXd& mean);

/// mu of a motion, its force in harmonics 0..H of the receptance (force_spectrum).
Eigen::MatrixXcd carried_spectrum(const ContactReceptance& receptance, const Trajectory& motion);

}  // namespace signorini
