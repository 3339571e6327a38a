#pragma once
// The exponential of a dense matrix, compiled once (docs/decisions/0052).

#include <Eigen/Core>

namespace signorini {

/// e^A of a square matrix, by scaling and squaring with Padé approximants [higham2005]; its error is a small
/// multiple of the rounding of ||A|| ||e^A|| as long as no power of e^A on the way is much larger than e^A.
Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& A);

}  // namespace signorini
