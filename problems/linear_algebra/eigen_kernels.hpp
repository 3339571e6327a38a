#pragma once
// The kernels of Eigen's dense products, compiled once in eigen_kernels.cpp. Parsed before every file of the
// libraries, with their precompiled headers, and named in none: the same code as where each compiles its own.

#include <Eigen/Core>
#include <complex>

/// \param keyword  `extern`, or none where they are compiled
/// \param S        the entries of both factors
#define SIGNORINI_EIGEN_KERNELS(keyword, S)                                                           \
  keyword template struct gebp_kernel<S, S, Index, blas_data_mapper<S, Index, ColMajor>,              \
                                      gebp_traits<S, S>::mr, gebp_traits<S, S>::nr, false, false>;    \
  keyword template void evaluateProductBlockingSizesHeuristic<S, S, 1, Index>(Index&, Index&, Index&, \
                                                                              Index);                 \
  keyword template void evaluateProductBlockingSizesHeuristic<S, S, 4, Index>(Index&, Index&, Index&, \
                                                                              Index);                 \
  SIGNORINI_EIGEN_KERNELS_OF_ORDER(keyword, S, ColMajor)                                              \
  SIGNORINI_EIGEN_KERNELS_OF_ORDER(keyword, S, RowMajor)                                              \
  keyword template struct general_matrix_vector_product<                                              \
      Index, S, const_blas_data_mapper<S, Index, RowMajor>, RowMajor, false, S,                       \
      const_blas_data_mapper<S, Index, RowMajor>, false, 1>;

/// \param order  of the entries of the factor on the left in products of a matrix and a vector, and of
///               packing
#define SIGNORINI_EIGEN_KERNELS_OF_ORDER(keyword, S, order)                                         \
  keyword template struct general_matrix_vector_product<                                            \
      Index, S, const_blas_data_mapper<S, Index, order>, order, false, S,                           \
      const_blas_data_mapper<S, Index, ColMajor>, false, 0>;                                        \
  keyword template struct general_matrix_vector_product<                                            \
      Index, S, const_blas_data_mapper<S, Index, order>, order, false, S,                           \
      const_blas_data_mapper<S, Index, RowMajor>, false, 0>;                                        \
  keyword template struct gemm_pack_lhs<S, Index, const_blas_data_mapper<S, Index, order>,          \
                                        gebp_traits<S, S>::mr, gebp_traits<S, S>::LhsProgress,      \
                                        gebp_traits<S, S>::LhsPacket4Packing, order>;               \
  keyword template struct gemm_pack_rhs<S, Index, const_blas_data_mapper<S, Index, order>,          \
                                        gebp_traits<S, S>::nr, order>;                              \
  keyword template struct general_matrix_matrix_product<Index, S, order, false, S, ColMajor, false, \
                                                        ColMajor, 1>;                               \
  keyword template struct general_matrix_matrix_product<Index, S, order, false, S, RowMajor, false, \
                                                        ColMajor, 1>;

namespace Eigen::internal {

SIGNORINI_EIGEN_KERNELS(extern, double)
SIGNORINI_EIGEN_KERNELS(extern, std::complex<double>)

}  // namespace Eigen::internal
