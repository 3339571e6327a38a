#include "methods/linear_flow/matrix_exponential.hpp"

#include <unsupported/Eigen/MatrixFunctions>

namespace signorini {

Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& A) { return A.exp(); }

}  // namespace signorini
