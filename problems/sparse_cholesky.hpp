#pragma once
// Supernodal Cholesky factorisation of large sparse matrices.

#include <Eigen/Core>
#include <memory>

#include "problems/definite_solver.hpp"
#include "problems/structure.hpp"

namespace signorini {

/// Least pivot of a definite matrix scaled to unit diagonal: below, A^{-1} means nothing [-].
inline constexpr double kDefinitePivot = 1e-13;

/// A = L L^T, columns in the order found best of minimum degree and nested dissection. CHOLMOD [chen2008];
/// one thread with a serial BLAS.
class SparseCholesky final : public DefiniteSolver {
 public:
  /// What a factorisation takes.
  struct Cost {
    double operations = 0.0;  ///< in floating point
    double entries = 0.0;     ///< numbers kept in L
  };
  /// What that of A would take, from its pattern alone: its order and symbolic factor are made, no number is.
  /// \throws std::bad_alloc where memory does not suffice, or the factor has too many entries to count
  static Cost cost_of(const SparseMatrix& A);

  /// Factorises A, symmetric, Nd x Nd; only its lower triangle is looked at.
  /// \throws std::bad_alloc where memory does not suffice
  explicit SparseCholesky(const SparseMatrix& A);
  ~SparseCholesky() override;
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// Smallest pivot of A scaled to unit diagonal, min L_jj^2 / a_jj [-]; not positive where A is not positive
  /// definite to working precision.
  [[nodiscard]] double smallest_pivot() const;
  /// Whether that is more than kDefinitePivot.
  [[nodiscard]] bool definite() const override;
  /// A^{-1} rhs, Nd x k.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) override;
  /// Numbers kept in L, zeros that fill its supernodes included.
  [[nodiscard]] double entries() const override;
  /// Floating-point operations of the factorisation.
  [[nodiscard]] double operations() const override;

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

}  // namespace signorini
