#pragma once
// The routines of LAPACK [anderson1999] that the decompositions of this room call, with the lengths of their
// texts as Fortran compilers pass them. Arrays are column by column; `info` is 0 where a routine succeeds.
// With a work space of size -1 it tells the best size in its first entry and does nothing else.

#include <Eigen/Core>
#include <cstddef>

extern "C" {
/// Eigenvalues w of symmetric A, n x n, rising; with job 'V' A becomes their vectors.
void dsyevd_(const char* job, const char* triangle, const int* n, double* a, const int* stride, double* w,
             double* work, const int* work_size, int* integers, const int* integers_size, int* info,
             std::size_t, std::size_t);
/// The same of A x = w B x (type 1); B becomes its Cholesky factor.
void dsygvd_(const int* type, const char* job, const char* triangle, const int* n, double* a,
             const int* a_stride, double* b, const int* b_stride, double* w, double* work,
             const int* work_size, int* integers, const int* integers_size, int* info, std::size_t,
             std::size_t);
/// Eigenvalues of A, n x n, and vectors, those of a conjugate pair as real and imaginary part.
void dgeev_(const char* left_job, const char* right_job, const int* n, double* a, const int* a_stride,
            double* real, double* imaginary, double* left, const int* left_stride, double* right,
            const int* right_stride, double* work, const int* work_size, int* info, std::size_t, std::size_t);
/// Singular values of A, m x n, falling, and vectors: job 'A' all, 'S' the first min(m, n), 'N' none.
void dgesdd_(const char* job, const int* m, const int* n, double* a, const int* a_stride, double* s,
             double* u, const int* u_stride, double* vt, const int* vt_stride, double* work,
             const int* work_size, int* integers, int* info, std::size_t);
}

namespace signorini {

/// Rows and columns from which LAPACK is called: below, Eigen's loops are as fast and of the same bits on
/// every processor.
inline constexpr int kLeastForLapack = 32;

/// Whether A, m x n, goes to LAPACK: large enough, and finite, for its iterations may not end on NaN.
bool is_for_lapack(const Eigen::MatrixXd& A);

}  // namespace signorini
