#pragma once
// Products of dense matrices by the BLAS, several times faster than generic code where a tuned one is
// installed (docs/decisions/0019).

#include <Eigen/Core>

namespace signorini {

/// A B, A m x k and B k x n.
Eigen::MatrixXd dense_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// A B for real A, by the real and the imaginary part of B: half the work of a complex product.
Eigen::MatrixXcd dense_product(const Eigen::MatrixXd& A, const Eigen::MatrixXcd& B);

/// A diag(d) B for real A and B: an eighth of a complex product's work.
Eigen::MatrixXcd scaled_product(const Eigen::MatrixXd& A, const Eigen::VectorXcd& d,
                                const Eigen::MatrixXd& B);

/// A^T B, A k x m and B k x n.
Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// C -= A S for C m x n, A m x k and S k x n.
void subtract_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& S, Eigen::MatrixXd& C);

/// Has the BLAS map the memory that it works in. OpenBLAS does so at its first product, 128 MiB of address
/// space, and where a limit of it refuses them it asks again without end: to be called before such a limit.
void map_work_space_of_products();

}  // namespace signorini
