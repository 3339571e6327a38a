#pragma once
// Products of tall dense matrices by the BLAS, several times faster than generic code where a tuned one is
// installed.

#include <Eigen/Core>

namespace signorini {

/// A^T B for A Nd x k and B Nd x m.
Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// C -= A S for C Nd x m, A Nd x k and S k x m.
void subtract_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& S, Eigen::MatrixXd& C);

}  // namespace signorini
