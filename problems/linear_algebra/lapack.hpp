#pragma once
// The routines of LAPACK [anderson1999] that the decompositions of this room call, with the lengths of their
// texts as Fortran compilers pass them. Arrays are column by column; `info` is 0 where a routine succeeds.
// With a work space of size -1 it tells the best size in its first entry and does nothing else.

#include <Eigen/Core>
#include <algorithm>
#include <complex>
#include <cstddef>

extern "C" {
/// Singular values of A, m x n, falling, and vectors: job 'A' all, 'S' the first min(m, n), 'N' none.
// NOLINTNEXTLINE(readability-identifier-naming): Fortran's name of it
void dgesdd_(const char* job, const int* m, const int* n, double* a, const int* a_stride, double* s,
             double* u, const int* u_stride, double* vt, const int* vt_stride, double* work,
             const int* work_size, int* integers, int* info, std::size_t);
/// Eigenvalues re + i im of A, n x n, which is lost: conjugate pairs one after the other, the one with im > 0
/// first. Jobs 'N': no vectors. info > 0: not all of them converged.
// NOLINTNEXTLINE(readability-identifier-naming): Fortran's name of it
void dgeev_(const char* left, const char* right, const int* n, double* a, const int* a_stride, double* re,
            double* im, double* vl, const int* vl_stride, double* vr, const int* vr_stride, double* work,
            const int* work_size, int* info, std::size_t, std::size_t);
/// P A = L U, A m x n, in place; row i, from 1 on, was exchanged with row pivots[i]. info > 0: U is singular.
// NOLINTNEXTLINE(readability-identifier-naming): Fortran's name of it
void dgetrf_(const int* m, const int* n, double* a, const int* a_stride, int* pivots, int* info);
/// Eigenvalues w of symmetric A, n x n, rising, of which the triangle `uplo`, 'L' or 'U', is looked at; job
/// 'V': A becomes its orthonormal vectors, 'N': A is lost.
// NOLINTNEXTLINE(readability-identifier-naming): Fortran's name of it
void dsyevd_(const char* job, const char* uplo, const int* n, double* a, const int* a_stride, double* w,
             double* work, const int* work_size, int* integers, const int* integers_size, int* info,
             std::size_t, std::size_t);
/// The same of A x = w B x with x^T B x = 1 as kind 1; B becomes a factor of it. info > n: B is not definite.
// NOLINTNEXTLINE(readability-identifier-naming): Fortran's name of it
void dsygvd_(const int* kind, const char* job, const char* uplo, const int* n, double* a, const int* a_stride,
             double* b, const int* b_stride, double* w, double* work, const int* work_size, int* integers,
             const int* integers_size, int* info, std::size_t, std::size_t);
/// A X = B of complex A, n x n, and B, n x right, both lost: B becomes X. info > 0: A is singular.
// NOLINTNEXTLINE(readability-identifier-naming): Fortran's name of it
void zgesv_(const int* n, const int* right, std::complex<double>* a, const int* a_stride, int* pivots,
            std::complex<double>* b, const int* b_stride, int* info);
}

namespace signorini {

/// Rows and columns from which LAPACK is called: below, Eigen's loops give the same bits on every
/// processor.
inline constexpr int kLeastForLapack = 32;

/// Whether A, m x n, goes to LAPACK: large enough, and finite, for its iterations may not end on NaN.
template <class Matrix>
bool is_for_lapack(const Matrix& A) {
  return std::min(A.rows(), A.cols()) >= kLeastForLapack && A.allFinite();
}

}  // namespace signorini
