#pragma once
// Products of dense matrices and parts of them, compiled once (docs/decisions/0052). Sums go in the order of
// Eigen's own products, whatever the BLAS, but for `product` and `set_product` of large matrices.

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace signorini {

/// Multiply-adds from which `product` calls the BLAS: those of kLeastForLapack rows and columns. Below, the
/// bits are the same on every processor.
inline constexpr Eigen::Index kLeastForBlas = 32 * 32 * 32;

/// A B, A m x k and B k x n.
Eigen::MatrixXd product(const Eigen::Ref<const Eigen::MatrixXd>& A,
                        const Eigen::Ref<const Eigen::MatrixXd>& B);
/// C = A B, which is part of neither factor.
void set_product(Eigen::Ref<Eigen::MatrixXd> C, const Eigen::Ref<const Eigen::MatrixXd>& A,
                 const Eigen::Ref<const Eigen::MatrixXd>& B);
/// The same of complex B.
Eigen::MatrixXcd product_of_complex(const Eigen::MatrixXd& A, const Eigen::MatrixXcd& B);
/// C += A B, C m x n.
void add_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, Eigen::MatrixXd& C);
/// A B of complex A and real B.
Eigen::MatrixXcd product_by_real(const Eigen::MatrixXcd& A, const Eigen::MatrixXd& B);
/// A B^T likewise.
Eigen::MatrixXcd product_by_real_transposed(const Eigen::MatrixXcd& A, const Eigen::MatrixXd& B);
/// A^T B, A k x m and B k x n.
Eigen::MatrixXd product_of_transposed(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
/// A B^T, A m x k and B n x k.
Eigen::MatrixXd product_by_transposed(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
/// C = A B^T likewise.
void set_product_by_transposed(Eigen::Ref<Eigen::MatrixXd> C, const Eigen::MatrixXd& A,
                               const Eigen::MatrixXd& B);
/// C -= A^T B, C m x n.
void subtract_product_of_transposed(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, Eigen::MatrixXd& C);
/// C + A^T B.
Eigen::MatrixXd plus_product_of_transposed(const Eigen::MatrixXd& C, const Eigen::MatrixXd& A,
                                           const Eigen::MatrixXd& B);
/// C + A B^T, C m x n.
Eigen::MatrixXd plus_product_by_transposed(const Eigen::MatrixXd& C, const Eigen::MatrixXd& A,
                                           const Eigen::MatrixXd& B);

/// A B of complex A and B.
Eigen::MatrixXcd complex_product(const Eigen::MatrixXcd& A, const Eigen::MatrixXcd& B);
/// (factor A) B.
Eigen::MatrixXcd complex_product(std::complex<double> factor, const Eigen::MatrixXcd& A,
                                 const Eigen::MatrixXcd& B);
/// A^T B.
Eigen::MatrixXcd complex_product_of_transposed(const Eigen::Ref<const Eigen::MatrixXcd>& A,
                                               const Eigen::Ref<const Eigen::MatrixXcd>& B);
/// A B of real A, each entry as a complex number.
Eigen::MatrixXcd product_in_complex(const Eigen::MatrixXd& A, const Eigen::MatrixXcd& B);
/// C - A B likewise, C m x n.
Eigen::MatrixXcd minus_product_in_complex(const Eigen::MatrixXcd& C, const Eigen::MatrixXd& A,
                                          const Eigen::MatrixXcd& B);

/// A v, A m x n.
Eigen::VectorXd image(const Eigen::Ref<const Eigen::MatrixXd>& A, const Eigen::Ref<const Eigen::VectorXd>& v);
/// y += A v, y of length m.
void add_image(const Eigen::Ref<const Eigen::MatrixXd>& A, const Eigen::Ref<const Eigen::VectorXd>& v,
               Eigen::VectorXd& y);
/// -A v.
Eigen::VectorXd negative_image(const Eigen::MatrixXd& A, const Eigen::Ref<const Eigen::VectorXd>& v);
/// A^T v, v of length m.
Eigen::VectorXd image_by_transposed(const Eigen::Ref<const Eigen::MatrixXd>& A,
                                    const Eigen::Ref<const Eigen::VectorXd>& v);
/// The row r A, A m x n.
Eigen::RowVectorXd row_image(const Eigen::Ref<const Eigen::RowVectorXd>& r,
                             const Eigen::Ref<const Eigen::MatrixXd>& A);
/// A v of real A and complex v.
Eigen::VectorXcd image_of_complex(const Eigen::Ref<const Eigen::MatrixXd>& A, const Eigen::VectorXcd& v);
/// y -= A v likewise.
void subtract_image_of_complex(const Eigen::MatrixXd& A, const Eigen::VectorXcd& v, Eigen::VectorXcd& y);
/// A v of real A, each entry as a complex number.
Eigen::VectorXcd image_in_complex(const Eigen::Ref<const Eigen::MatrixXd>& A,
                                  const Eigen::Ref<const Eigen::VectorXcd>& v);
/// The same of `factor` A.
Eigen::VectorXcd image_in_complex(std::complex<double> factor, const Eigen::MatrixXd& A,
                                  const Eigen::Ref<const Eigen::VectorXcd>& v);
/// A v of complex A.
Eigen::VectorXcd complex_image(const Eigen::Ref<const Eigen::MatrixXcd>& A, const Eigen::VectorXcd& v);
/// A^T v of complex v.
Eigen::VectorXcd image_of_complex_by_transposed(const Eigen::MatrixXd& A, const Eigen::VectorXcd& v);

/// A_J v, A_J the columns J of A and v of their number.
Eigen::VectorXd image_by_columns(const Eigen::MatrixXd& A, const std::vector<int>& J,
                                 const Eigen::VectorXd& v);
/// A_J^T v, v of length m.
Eigen::VectorXd image_by_transposed_columns(const Eigen::MatrixXd& A, const std::vector<int>& J,
                                            const Eigen::Ref<const Eigen::VectorXd>& v);

/// The columns J of A, m x |J|.
Eigen::MatrixXd columns_of(const Eigen::MatrixXd& A, const std::vector<int>& J);
/// The rows I of A, |I| x n.
Eigen::MatrixXcd rows_of(const Eigen::MatrixXcd& A, const std::vector<int>& I);
/// The rows I of the columns J of A, |I| x |J|.
Eigen::MatrixXd block_of(const Eigen::MatrixXd& A, const std::vector<int>& I, const std::vector<int>& J);
/// The entries I of v, |I|.
Eigen::VectorXd entries_of(const Eigen::VectorXd& v, const std::vector<int>& I);
/// Writes the rows of B, |I| x n, into the rows I of A.
void set_rows(Eigen::MatrixXd& A, const std::vector<int>& I, const Eigen::MatrixXd& B);

}  // namespace signorini
