#pragma once
// Directions in which a periodic vector is longest.

#include <Eigen/Core>

namespace signorini {

/// sum_n g_n w_n^2 Re(c_n c_n^H), g_0 = 1 and g_n = 2 above: the mean over time of the square of a vector
/// whose harmonics are w_n c_n, m x m.
/// \param series  c_n, m x (H+1)
/// \param weight  w_n, H+1
Eigen::MatrixXd mean_square(const Eigen::MatrixXcd& series, const Eigen::VectorXd& weight);

/// The root mean square over time of a periodic vector, its harmonics of these lengths: |w_0|^2 + 2 sum
/// |w_n|^2. \param lengths  n = 0..H
double root_mean_square(const Eigen::VectorXd& lengths);

/// Orthonormal directions without which the root mean square of a vector is at most `tolerance`, the longest
/// last, as few as possible; `most` of them if these are fewer, m x r.
/// \param mean_square  m x m, positive to rounding: lengths below 1e-8 of the largest are rounding, too
Eigen::MatrixXd principal_directions(const Eigen::MatrixXd& mean_square, double tolerance, Eigen::Index most);

}  // namespace signorini
