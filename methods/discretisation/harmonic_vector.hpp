#pragma once
// Fourier coefficients as a real vector whose Euclidean norm is the root mean square in time.

#include <Eigen/Core>

namespace signorini {

/// Per contact (s_0, sqrt(2) Re s_1, sqrt(2) Im s_1, ..., sqrt(2) Im s_H), contacts one after another.
/// \param spectrum (H+1) x Nc; the imaginary part of s_0 is dropped
Eigen::VectorXd pack_harmonics(const Eigen::MatrixXcd& spectrum);

/// The inverse; size (2 H + 1) Nc.
Eigen::MatrixXcd unpack_harmonics(const Eigen::VectorXd& packed, int harmonics);

}  // namespace signorini
