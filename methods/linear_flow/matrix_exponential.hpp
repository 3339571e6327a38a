#pragma once
// The exponential of a matrix.

#include <Eigen/Core>

namespace signorini {

/// e^A of a square matrix, by scaling and squaring with Padé approximants (Higham 2005); its error is a small
/// multiple of the rounding of ||A|| ||e^A|| as long as no power of e^A on the way is much larger than e^A.
/// Kept apart because Eigen's templates for it take long to compile.
Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& A);

}  // namespace signorini
