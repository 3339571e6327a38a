#pragma once
// Products of parts of dense matrices, compiled once. Sums go in the order of Eigen's own products, whatever
// the BLAS; those of large matrices: dense_products.hpp.

#include <Eigen/Core>
#include <vector>

namespace signorini {

/// A B, A m x k and B k x n.
Eigen::MatrixXd block_product(const Eigen::Ref<const Eigen::MatrixXd>& A,
                              const Eigen::Ref<const Eigen::MatrixXd>& B);
/// C = A B, which is part of neither factor.
void set_product(Eigen::Ref<Eigen::MatrixXd> C, const Eigen::Ref<const Eigen::MatrixXd>& A,
                 const Eigen::Ref<const Eigen::MatrixXd>& B);
/// A^T B, A k x m and B k x n.
Eigen::MatrixXd transposed_times(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
/// A B^T, A m x k and B n x k.
Eigen::MatrixXd times_transposed(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
/// C = A B^T likewise.
void set_times_transposed(Eigen::Ref<Eigen::MatrixXd> C, const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
/// A B of complex entries.
Eigen::MatrixXcd complex_block_product(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B);
/// A^T v, A m x n and v of length m.
Eigen::VectorXd transposed_times_vector(const Eigen::MatrixXd& A, const Eigen::Ref<const Eigen::VectorXd>& v);
/// (-A) v, A m x n.
Eigen::VectorXd minus_times(const Eigen::MatrixXd& A, const Eigen::VectorXd& v);
/// A v, A m x n.
Eigen::VectorXd times(const Eigen::Ref<const Eigen::MatrixXd>& A, const Eigen::Ref<const Eigen::VectorXd>& v);
/// The row r A, A m x n.
Eigen::RowVectorXd row_times(const Eigen::Ref<const Eigen::RowVectorXd>& r,
                             const Eigen::Ref<const Eigen::MatrixXd>& A);

/// A_J v, A_J the columns J of A and v of their number, summed column by column.
Eigen::VectorXd columns_times(const Eigen::MatrixXd& A, const std::vector<int>& J, const Eigen::VectorXd& v);
/// A_J^T v, A_J the columns J of A and v of length m, summed from the first entry on.
Eigen::VectorXd transposed_columns_times(const Eigen::MatrixXd& A, const std::vector<int>& J,
                                         const Eigen::VectorXd& v);
/// The columns J of A, m x |J|.
Eigen::MatrixXd chosen_columns(const Eigen::MatrixXd& A, const std::vector<int>& J);

}  // namespace signorini
