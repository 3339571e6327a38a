#pragma once
// Matrices whose inverses, eigenvalues or factors are known in closed form, and products by plain loops in
// long double: oracles for the tests of problems/linear_algebra, which share nothing with what they test.

#include <Eigen/Core>
#include <array>

namespace signorini::test {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

inline constexpr double kEps = 0x1p-52;
/// Sizes on both sides of kLeastForLapack, and one beyond the blocks of the libraries.
inline constexpr std::array kSizes = {1, 2, 31, 32, 33, 80};

/// Entries of a normal distribution.
Matrix random_matrix(int rows, int columns, unsigned seed);
Vector random_vector(int size, unsigned seed);
/// 2 on the diagonal, -1 beside it: unit masses between n + 1 unit springs.
Matrix spring_chain(int size);
/// Its eigenvalue of number k = 0, 1, ..., rising: 4 sin^2((k + 1) pi / (2 (n + 1))).
double chain_eigenvalue(int size, int k);
/// Entry i of its eigenvector k, of length 1.
double chain_mode(int size, int i, int k);
/// Entry (i, j) of the inverse of spring_chain(size).
double chain_flexibility(int size, int i, int j);
/// min(i, j) + 1: symmetric, definite, L L^T with L of ones, of determinant 1.
Matrix least_index_matrix(int size);
/// Its inverse: the chain with its last mass on one spring only.
Matrix least_index_inverse(int size);
/// One on and below the diagonal.
Matrix lower_ones(int size);
/// Orthogonal, full: reflections made by hand, one after another.
Matrix orthogonal_matrix(int size, unsigned seed);
/// Q diag(values) P^T of two such, `rows` x `columns`.
Matrix with_singular_values(int rows, int columns, const Vector& values, unsigned seed);

Matrix transposed(const Matrix& A);
Matrix product(const Matrix& A, const Matrix& B);
/// The same of a vector.
Vector product(const Matrix& A, const Vector& b);
Eigen::MatrixXcd complex_product(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B);
/// The largest magnitude of an entry; NaN where there is one, 0 without entries.
double largest(const Matrix& A);
/// Of A - B; NaN where sizes differ.
double distance(const Matrix& A, const Matrix& B);
double complex_distance(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B);
/// Of A^T A less the unit matrix.
double distance_from_orthonormal(const Matrix& A);
/// The largest sum of magnitudes of a column.
double column_norm(const Matrix& A);
bool any_nan(const Matrix& A);
bool any_complex_nan(const Eigen::MatrixXcd& A);

}  // namespace signorini::test
