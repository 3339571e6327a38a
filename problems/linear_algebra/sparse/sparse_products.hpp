#pragma once
// Products of sparse and dense matrices and sums of sparse ones, compiled once (docs/decisions/0052).

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace signorini {

/// Columns that are worked on at a time: more would take memory, and be no faster.
inline constexpr Eigen::Index kColumnsAtOnce = 32;

/// A v, A m x n.
Eigen::VectorXd sparse_image(const Eigen::SparseMatrix<double>& A,
                             const Eigen::Ref<const Eigen::VectorXd>& v);
/// y -= A v, y of length m, entry by entry of A.
void subtract_sparse_image(const Eigen::SparseMatrix<double>& A, const Eigen::Ref<const Eigen::VectorXd>& v,
                           Eigen::VectorXd& y);
/// A^T v, v of length m.
Eigen::VectorXd sparse_image_by_transposed(const Eigen::SparseMatrix<double>& A,
                                           const Eigen::Ref<const Eigen::VectorXd>& v);
/// A B, B n x k.
Eigen::MatrixXd sparse_product(const Eigen::SparseMatrix<double>& A, const Eigen::MatrixXd& B);
/// A B by rows of B, side by side in memory: several times faster where B has many columns.
Eigen::MatrixXd product_by_rows(const Eigen::SparseMatrix<double>& A, const Eigen::MatrixXd& B);
/// A B of sparse B.
Eigen::SparseMatrix<double> sparse_product(const Eigen::SparseMatrix<double>& A,
                                           const Eigen::SparseMatrix<double>& B);
/// A^T B, B m x k.
Eigen::MatrixXd sparse_product_of_transposed(const Eigen::SparseMatrix<double>& A, const Eigen::MatrixXd& B);
/// A^T B of sparse B, sums over entries that both have.
Eigen::SparseMatrix<double> sparse_product_of_transposed(const Eigen::SparseMatrix<double>& A,
                                                         const Eigen::SparseMatrix<double>& B);
/// B A, B k x m.
Eigen::MatrixXd product_by_sparse(const Eigen::MatrixXd& B, const Eigen::SparseMatrix<double>& A);

/// `count` columns of A from `first` on.
Eigen::SparseMatrix<double> sparse_columns(const Eigen::SparseMatrix<double>& A, Eigen::Index first,
                                           Eigen::Index count);
/// a A + b B, entries of either.
Eigen::SparseMatrix<double> sparse_sum(double a, const Eigen::SparseMatrix<double>& A, double b,
                                       const Eigen::SparseMatrix<double>& B);

}  // namespace signorini
