#pragma once
// Krylov spaces of a definite pencil (P, M), started from several columns at once.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "problems/definite_solver.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// The block Krylov space span{P^{-1} B, (P^{-1} M) P^{-1} B, (P^{-1} M)^2 P^{-1} B, ...}, one power at a
/// time, in a basis V with V^T P V = 1, P symmetric positive definite and M symmetric positive semi-definite.
/// Block Lanczos method [grimes1994] with full reorthogonalisation; directions that a block adds only in its
/// rounding are left out.
///
///     P^{-1} B = V r + o(n),     P^{-1} M V = V t + X,    X^T P V = 0,
///
/// X vanishing but for the columns of the newest block, and for what was left out of older ones. With
/// `grow_along` a part of the next power is taken in and the rest waits; X then does not vanish for older
/// columns.
class BlockLanczos {
 public:
  /// Factorises P; B is Nd x m. The space begins with the span of P^{-1} B.
  /// \param most  dimension beyond which directions would be rounding; 0: Nd
  /// \param factorise  P
  BlockLanczos(const SparseMatrix& P, const SparseMatrix& M, const SparseMatrix& B, Eigen::Index most = 0,
               const Factorise& factorise = factorise_here);

  /// False if the first factorisation found P not to be definite (`DefiniteSolver::definite`).
  [[nodiscard]] bool definite() const { return definite_; }
  /// Adds the next power; nothing once the space is exhausted.
  void grow();
  /// Adds the next power and what was left out of blocks so far: it is more than rounding where one contact
  /// alone moves a stiff part of the structure. The blocks of t are not tridiagonal from then on.
  void grow_by_left_out();
  /// Adds powers, and once there is none what was left out, until there are `enough` vectors or the space is
  /// invariant.
  void grow_to(Eigen::Index enough);
  /// Adds some directions of what the next power would add: those that count where X y is to be small for
  /// some y alone. The others wait beside what the new vectors lead to. The blocks of t are not tridiagonal
  /// from then on.
  /// \param directions  in the rows of coupling(): orthonormal columns, width() x r, r <= width()
  void grow_along(const Eigen::MatrixXd& directions);
  /// Adds columns to what would come next, as far as they are P-orthogonal to it and to the space: of the
  /// next power they are no part, so the new rows of coupling() are zero. \param columns  Nd x l
  void offer(Eigen::MatrixXd columns);
  /// True if no power comes next: grow() adds nothing.
  [[nodiscard]] bool exhausted() const { return next_.cols() == 0; }
  /// True if the space is invariant under P^{-1} M to rounding: exhausted, and nothing was left out.
  [[nodiscard]] bool invariant() const { return width_with_left_out() == 0; }
  /// Dimension of the space, without the block that would come next.
  [[nodiscard]] Eigen::Index size() const { return size_; }
  /// Vectors by which the next growth enlarges it.
  [[nodiscard]] Eigen::Index width() const { return next_.cols(); }
  /// The same of grow_by_left_out().
  [[nodiscard]] Eigen::Index width_with_left_out() const;
  /// t = V^T M V, k x k.
  [[nodiscard]] Eigen::MatrixXd projected_mass() const;
  /// r = V^T B, k x m.
  [[nodiscard]] Eigen::MatrixXd projected_start() const;
  /// Coefficients of X in the last columns of V, those of the newest block or, after grow_along, all;
  /// P-orthonormal rows understood: |X y|_P = |coupling() y_last| for as many of the last rows of y.
  [[nodiscard]] const Eigen::MatrixXd& coupling() const { return coupling_; }
  /// t between the newest block and itself. Not after grow_along.
  [[nodiscard]] Eigen::MatrixXd newest_mass() const {
    return projected_.back().bottomRows(projected_.back().cols());
  }
  /// L with |X y|_P <= |coupling() y_newest| + |L y|: what was left out of blocks so far as rounding, r x k.
  [[nodiscard]] Eigen::MatrixXd left_out() const;
  /// The same of the start, |(P^{-1} B - V V^T B) y|_P <= |L y|, r x m.
  [[nodiscard]] const Eigen::MatrixXd& left_out_of_start() const { return left_out_of_start_; }
  /// Floating-point operations of the next growth, roughly: of grow(), or of grow_by_left_out().
  [[nodiscard]] double operations_of_growth(bool with_left_out = false) const;
  /// V^T A for other columns A, Nd x l, of the vectors from `first` on, which is zero or a size that the
  /// space has had; (k - first) x l.
  [[nodiscard]] Eigen::MatrixXd projected(const SparseMatrix& A, Eigen::Index first = 0) const;
  /// The same of dense columns.
  [[nodiscard]] Eigen::MatrixXd projected(const Eigen::MatrixXd& A, Eigen::Index first = 0) const;
  /// The same of the vectors that would come next, width() x l.
  [[nodiscard]] Eigen::MatrixXd projected_on_next(const SparseMatrix& A) const;
  /// V^T V, k x k.
  [[nodiscard]] Eigen::MatrixXd gram() const;
  /// V times coefficients, k x l; Nd x l.
  [[nodiscard]] Eigen::MatrixXd combined(const Eigen::MatrixXd& coefficients) const;
  /// P^{-1} columns, Nd x l.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& columns) { return factors_->solve(columns); }
  /// Memory of vectors and factors, roughly [bytes].
  [[nodiscard]] double bytes() const;
  /// The factors of P.
  [[nodiscard]] const DefiniteSolver& factors() const { return *factors_; }

 private:
  // What a block leaves out: P-orthogonal vectors of these P-norms, rising, relative to those of the columns,
  // times coefficients. The last of the vectors are kept, those that are more than rounding.
  struct Remainder {
    Eigen::MatrixXd vectors, coefficients;
    Eigen::VectorXd lengths;
    [[nodiscard]] Eigen::MatrixXd extent() const { return lengths.asDiagonal() * coefficients; }
  };

  // Splits columns, P-orthogonal to the basis and of P-Gram matrix `gram`, into a P-orthonormal block and its
  // coefficients, columns = next_ * coupling_; `length` is what each counts by: a P-norm before they were
  // made orthogonal. `waiting` are P-orthonormal columns that are to join the basis, too. Returns what is
  // left out.
  Remainder orthonormalise(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& gram,
                           const Eigen::VectorXd& length, const Eigen::MatrixXd& waiting);
  void polish_next(const Eigen::MatrixXd& waiting);
  void take_in(const Eigen::MatrixXd& block);
  // Takes `newest` into the basis and makes next_ of what P^{-1} M makes of it, P-orthogonal to the basis and
  // to `waiting`, P-orthonormal columns. Returns the coefficients in waiting.
  Eigen::MatrixXd extend(const Eigen::MatrixXd& newest, const Eigen::MatrixXd& waiting);
  // columns -= V V^T dual.
  void subtract_basis(const Eigen::MatrixXd& dual, Eigen::MatrixXd& columns) const;
  // of_group(vectors), a row for each, of all vectors from `first` on.
  template <class OfGroup>
  [[nodiscard]] Eigen::MatrixXd stacked(Eigen::Index first, Eigen::Index columns, OfGroup of_group) const;

  const SparseMatrix& P_;
  const SparseMatrix& M_;
  std::unique_ptr<DefiniteSolver> factors_;
  Eigen::Index most_;
  bool definite_ = false;
  Eigen::Index size_ = 0;
  std::vector<Eigen::MatrixXd> basis_;      // several blocks in each
  std::vector<Eigen::MatrixXd> projected_;  // V^T M V_j of block j, rows up to and with its own
  std::vector<Remainder> left_out_;         // of each block
  Eigen::MatrixXd left_out_of_start_;
  Eigen::MatrixXd start_;
  Eigen::MatrixXd next_;
  Eigen::MatrixXd coupling_;
};

/// t = V^T M V in its eigenvectors: t U = U diag(values), U^T U = 1. V U / sqrt(value) are the Ritz vectors
/// of the pencil (P, M), 1 / value its Ritz values.
struct RitzPairs {
  Eigen::VectorXd values;   ///< rising, k; of zero or below: rounding, or a direction without mass
  Eigen::MatrixXd vectors;  ///< U, k x k
};

/// Of the space so far.
RitzPairs ritz_pairs(const BlockLanczos& space);

}  // namespace signorini
