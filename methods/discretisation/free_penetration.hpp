#pragma once
// How far the contact-free motion reaches beyond the stops, on the time grid.

#include <Eigen/Core>

namespace signorini {

/// scale_c (x_f - g)_c at N equidistant instants, contacts one after another, N Nc.
/// \param free_response  coefficients n = 0..H of x_f, (H+1) x Nc [m]; those beyond N / 2 are dropped
/// \param gap  g, Nc [m]  \param scale  Nc, in the unit of the result per metre
Eigen::VectorXd free_penetration(const Eigen::MatrixXcd& free_response, const Eigen::VectorXd& gap,
                                 const Eigen::VectorXd& scale, int samples);

}  // namespace signorini
