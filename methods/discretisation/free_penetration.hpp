#pragma once
// How far the contact-free motion reaches beyond the stops, on the time grid.

#include <Eigen/Core>

namespace signorini {

/// The penetration of the motion without contact forces, scale_c (x_f - g)_c at t_k = k T / N: positive
/// where that motion lies beyond a stop. With the opposite sign it is q of a complementarity problem.
/// \param free_response  coefficients n = 0..H of x_f, (H+1) x Nc [m]; those beyond N / 2 are dropped
/// \param gap      g, Nc [m]
/// \param scale    Nc, the unit of the result per metre
/// \param samples  N >= 1 [-]
/// \return contacts one after another, N Nc
Eigen::VectorXd free_penetration(const Eigen::MatrixXcd& free_response, const Eigen::VectorXd& gap,
                                 const Eigen::VectorXd& scale, int samples);

}  // namespace signorini
