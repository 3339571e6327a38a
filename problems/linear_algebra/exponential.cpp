#include "problems/linear_algebra/exponential.hpp"

#include <unsupported/Eigen/MatrixFunctions>

namespace signorini {

Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& A) {
  if (A.size() == 0) return A;  // a norm of no columns is undefined
  return A.exp();
}

}  // namespace signorini
