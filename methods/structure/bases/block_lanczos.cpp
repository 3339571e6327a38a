#include "methods/structure/bases/block_lanczos.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/solvers/dense_products.hpp"
#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/sparse/sparse_products.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"

namespace signorini {

namespace {

// Squared length of a direction, relative to the longest of its block, below which it is rounding: the Gram
// matrix knows squared lengths to its own precision only.
constexpr double kRounding = 1e-14;
// The same relative to the columns before they were made orthogonal to the basis, whose rounding it is then.
constexpr double kInvariant = 1e-26;

Eigen::MatrixXd symmetrised(const Eigen::MatrixXd& A) { return 0.5 * (A + A.transpose()); }

// V^T A V for symmetric A.
Eigen::MatrixXd gram_in(const SparseMatrix& A, const Eigen::MatrixXd& V) {
  return symmetrised(transposed_product(V, product_by_rows(A, V)));
}

// [A, B].
Eigen::MatrixXd beside(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  Eigen::MatrixXd both(A.rows(), A.cols() + B.cols());
  both << A, B;
  return both;
}

}  // namespace

BlockLanczos::BlockLanczos(const SparseMatrix& P, const SparseMatrix& M, const SparseMatrix& B,
                           Eigen::Index most, const Factorise& factorise)
    : P_(P),
      M_(M),
      factors_(factorise(P)),
      most_(most > 0 ? most : P.rows()),
      definite_(factors_->definite()) {
  if (!definite_) return;
  const Eigen::MatrixXd columns = factors_->solve(Eigen::MatrixXd(B));
  const Eigen::MatrixXd gram = symmetrised(sparse_product_of_transposed(B, columns));
  // Loads and contacts in their own units.
  left_out_of_start_ =
      orthonormalise(columns, gram, gram.diagonal().cwiseMax(0.0).cwiseSqrt(), Eigen::MatrixXd(P.rows(), 0))
          .extent();
  start_ = coupling_;
  grow();
}

BlockLanczos::Remainder BlockLanczos::orthonormalise(const Eigen::MatrixXd& columns,
                                                     const Eigen::MatrixXd& gram,
                                                     const Eigen::VectorXd& length,
                                                     const Eigen::MatrixXd& waiting) {
  // With D the lengths, D^-1 gram D^-1 = X s^2 X^T: columns D^-1 X / s is P-orthonormal, and the eigenvalues
  // s^2 tell how much each direction adds. A Cholesky factor would do as well while the columns are
  // independent; only eigenvectors order them by length, so that those of rounding size can be left out.
  const Eigen::VectorXd unit = length.unaryExpr([](double value) { return value > 0.0 ? 1.0 / value : 0.0; });
  const SymmetricEigen directions = symmetric_eigen(unit.asDiagonal() * gram * unit.asDiagonal());
  const Eigen::VectorXd& squares = directions.values;  // rising
  const Eigen::Index count = squares.size();
  const double least = count > 0 ? std::max(kRounding * squares[count - 1], kInvariant) : 0.0;
  Eigen::Index dropped = 0;
  while (dropped < count && !(squares[dropped] > least)) ++dropped;
  const Eigen::Index room = std::max<Eigen::Index>(0, most_ - size_ - waiting.cols());
  dropped = std::max(dropped, count - room);
  const Eigen::Index kept = count - dropped;
  const Eigen::MatrixXd vectors = directions.vectors.rightCols(kept);
  const Eigen::VectorXd extent = squares.tail(kept).cwiseSqrt();
  const Eigen::MatrixXd normalising = unit.asDiagonal() * vectors * extent.cwiseInverse().asDiagonal();
  next_ = dense_product(columns, normalising);
  coupling_ = extent.asDiagonal() * vectors.transpose() * length.asDiagonal();
  if (kept > 0) polish_next(waiting);
  // What is left out, columns D^-1 X_dropped X_dropped^T D. The Gram matrix knows squared lengths to its own
  // precision alone: these are measured on the vectors themselves.
  const Eigen::MatrixXd left_out = unit.asDiagonal() * directions.vectors.leftCols(dropped);
  Remainder rest{.vectors = dense_product(columns, left_out),
                 .coefficients = Eigen::MatrixXd(dropped, count),
                 .lengths = Eigen::VectorXd(dropped)};
  if (dropped == 0) return rest;
  const SymmetricEigen own = symmetric_eigen(gram_in(P_, rest.vectors));
  rest.lengths = own.values.cwiseMax(0.0).cwiseSqrt();  // rising
  rest.coefficients = product_by_transposed(own.vectors.transpose(), directions.vectors.leftCols(dropped)) *
                      length.asDiagonal();
  const Eigen::Index known = (own.values.array() > kInvariant).count();
  rest.vectors = dense_product(rest.vectors, Eigen::MatrixXd(own.vectors.rightCols(known)));
  return rest;
}

// Short directions of a block carry the rounding of its long ones, magnified by the ratio of their lengths.
// So the block is made orthogonal to the basis and orthonormal once more, now that each column has its own
// unit length: next_ <- (next_ - V V^T P next_) U^{-1}, U^T U its Gram matrix, and U joins the coupling
// ("twice is enough").
void BlockLanczos::polish_next(const Eigen::MatrixXd& waiting) {
  const Eigen::MatrixXd dual = product_by_rows(P_, next_);
  Eigen::MatrixXd gram = transposed_product(next_, dual);
  const auto take_out = [&](const Eigen::MatrixXd& block) {
    const Eigen::MatrixXd left = transposed_product(block, dual);
    subtract_product(block, left, next_);
    subtract_product_of_transposed(left, left, gram);
  };
  for (const Eigen::MatrixXd& block : basis_) take_out(block);
  take_out(waiting);
  const CholeskyFactors factor(symmetrised(gram));
  factor.normalise_columns(next_);
  coupling_ = factor.upper_times(coupling_);
}

void BlockLanczos::subtract_basis(const Eigen::MatrixXd& dual, Eigen::MatrixXd& columns) const {
  for (const Eigen::MatrixXd& block : basis_)
    subtract_product(block, transposed_product(block, dual), columns);
}

void BlockLanczos::grow() {
  if (exhausted()) return;
  const Eigen::MatrixXd newest = std::move(next_);
  extend(newest, Eigen::MatrixXd(P_.rows(), 0));
}

// Products with few columns at a time are several times slower: the last groups are joined while they are
// narrow, each with one no wider than itself, so that no vector is copied often.
void BlockLanczos::take_in(const Eigen::MatrixXd& block) {
  constexpr Eigen::Index kGroup = 64;
  size_ += block.cols();
  basis_.push_back(block);
  while (basis_.size() > 1) {
    const Eigen::MatrixXd &before = basis_[basis_.size() - 2], &last = basis_.back();
    const Eigen::Index width = before.cols() + last.cols();
    if (before.cols() > last.cols() || width > kGroup) return;
    Eigen::MatrixXd both = beside(before, last);
    basis_.pop_back();
    basis_.back().swap(both);
  }
}

Eigen::MatrixXd BlockLanczos::extend(const Eigen::MatrixXd& newest, const Eigen::MatrixXd& waiting) {
  take_in(newest);
  // P^{-1} M V_j against the whole basis. In exact arithmetic two blocks would do; rounding brings converged
  // directions back into the newest block, and with them copies of their eigenvalues [grimes1994].
  const Eigen::MatrixXd momentum = product_by_rows(M_, newest);
  Eigen::MatrixXd columns = factors_->solve(momentum);
  // |P^{-1} m|_P^2 = m^T P^{-1} m for each column m of M V_j.
  // A power of two, by which nothing is rounded.
  const double longest = std::sqrt(std::max(0.0, momentum.cwiseProduct(columns).colwise().sum().maxCoeff()));
  const double before = longest > 0.0 ? std::ldexp(1.0, std::ilogb(longest)) : 0.0;
  const Eigen::Index width = momentum.cols();
  projected_.emplace_back(size_, width);
  Eigen::Index row = 0;
  for (const Eigen::MatrixXd& block : basis_) {
    const Eigen::MatrixXd part = transposed_product(block, momentum);
    subtract_product(block, part, columns);
    projected_.back().middleRows(row, block.cols()) = part;
    row += block.cols();
  }
  const Eigen::MatrixXd in_waiting = transposed_product(waiting, momentum);
  subtract_product(waiting, in_waiting, columns);
  left_out_.push_back(
      orthonormalise(columns, gram_in(P_, columns), Eigen::VectorXd::Constant(width, before), waiting));
  return in_waiting;
}

void BlockLanczos::grow_along(const Eigen::MatrixXd& directions) {
  const Eigen::Index taken = directions.cols(), waits = width() - taken;
  if (taken == 0) return;
  const Eigen::MatrixXd whole = householder_basis(directions);
  const Eigen::MatrixXd others = whole.rightCols(waits);
  Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(waits, size_ + taken);  // coefficients of what waits
  rest.middleCols(size_ - coupling_.cols(), coupling_.cols()) = product_of_transposed(others, coupling_);
  const Eigen::MatrixXd waiting = dense_product(next_, others);
  const Eigen::MatrixXd newest = dense_product(next_, Eigen::MatrixXd(whole.leftCols(taken)));
  next_.resize(0, 0);
  rest.rightCols(taken) = extend(newest, waiting);
  const Eigen::Index led = next_.cols();
  next_ = beside(waiting, next_);
  Eigen::MatrixXd coupling = Eigen::MatrixXd::Zero(waits + led, size_);
  coupling.topRows(waits) = rest;
  coupling.bottomRightCorner(led, taken) = coupling_;
  coupling_.swap(coupling);
}

void BlockLanczos::offer(Eigen::MatrixXd columns) {
  const Eigen::MatrixXd waiting = std::move(next_), coupling = std::move(coupling_);
  const Eigen::MatrixXd dual = product_by_rows(P_, columns);
  const Eigen::VectorXd length =
      columns.cwiseProduct(dual).colwise().sum().transpose().cwiseMax(0.0).cwiseSqrt();
  subtract_basis(dual, columns);
  subtract_product(waiting, transposed_product(waiting, dual), columns);
  Eigen::MatrixXd gram = gram_in(P_, columns);
  // What is left of a column may be its rounding.
  const Eigen::VectorXd known =
      (gram.diagonal().array() > kRounding * length.array().square()).cast<double>();
  columns = columns * known.asDiagonal();
  gram = known.asDiagonal() * gram * known.asDiagonal();
  orthonormalise(columns, gram, length, waiting);
  next_ = beside(waiting, next_);
  coupling_ = Eigen::MatrixXd::Zero(next_.cols(), coupling.cols());
  coupling_.topRows(waiting.cols()) = coupling;
}

Eigen::MatrixXd BlockLanczos::projected_mass() const {
  Eigen::MatrixXd mass(size_, size_);
  Eigen::Index column = 0;
  for (const Eigen::MatrixXd& part : projected_) {
    mass.block(0, column, part.rows(), part.cols()) = part;
    mass.block(column, 0, part.cols(), part.rows()) = part.transpose();
    column += part.cols();
  }
  return symmetrised(mass);
}

Eigen::MatrixXd BlockLanczos::projected_start() const {
  Eigen::MatrixXd start = Eigen::MatrixXd::Zero(size_, start_.cols());
  start.topRows(start_.rows()) = start_;
  return start;
}

template <class OfGroup>
Eigen::MatrixXd BlockLanczos::stacked(Eigen::Index first, Eigen::Index columns, OfGroup of_group) const {
  Eigen::MatrixXd rows(size_ - first, columns);
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd& group : basis_) {
    const Eigen::Index known = std::clamp<Eigen::Index>(first - at, 0, group.cols());
    if (known == 0)
      rows.middleRows(at - first, group.cols()) = of_group(group);
    else if (known < group.cols())
      rows.topRows(group.cols() - known) = of_group(Eigen::MatrixXd(group.rightCols(group.cols() - known)));
    at += group.cols();
  }
  return rows;
}

Eigen::MatrixXd BlockLanczos::projected(const SparseMatrix& A, Eigen::Index first) const {
  return stacked(first, A.cols(), [&A](const Eigen::MatrixXd& group) {
    return Eigen::MatrixXd(sparse_product_of_transposed(A, group).transpose());
  });
}

Eigen::MatrixXd BlockLanczos::projected(const Eigen::MatrixXd& A, Eigen::Index first) const {
  return stacked(first, A.cols(),
                 [&A](const Eigen::MatrixXd& group) { return transposed_product(group, A); });
}

Eigen::MatrixXd BlockLanczos::projected_on_next(const SparseMatrix& A) const {
  return sparse_product_of_transposed(A, next_).transpose();
}

Eigen::MatrixXd BlockLanczos::gram() const {
  Eigen::MatrixXd gram(size_, size_);
  Eigen::Index row = 0;
  for (const Eigen::MatrixXd& left : basis_) {
    Eigen::Index column = 0;
    for (const Eigen::MatrixXd& right : basis_) {
      if (column > row) break;
      const Eigen::MatrixXd part = transposed_product(left, right);
      if (column == row) {
        gram.block(row, row, part.rows(), part.rows()) = part.selfadjointView<Eigen::Upper>();
      } else {
        gram.block(row, column, part.rows(), part.cols()) = part;
        gram.block(column, row, part.cols(), part.rows()) = part.transpose();
      }
      column += right.cols();
    }
    row += left.cols();
  }
  return gram;
}

Eigen::MatrixXd BlockLanczos::combined(const Eigen::MatrixXd& coefficients) const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(P_.rows(), coefficients.cols());
  Eigen::Index first = 0;
  for (const Eigen::MatrixXd& block : basis_) {
    subtract_product(block, -coefficients.middleRows(first, block.cols()), result);
    first += block.cols();
  }
  return result;
}

Eigen::MatrixXd BlockLanczos::left_out() const {
  Eigen::Index rows = 0;
  double parts = 0.0;
  for (const Remainder& part : left_out_) {
    rows += part.lengths.size();
    parts += part.lengths.size() > 0 ? 1.0 : 0.0;
  }
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rows, size_);
  Eigen::Index row = 0, column = 0;
  for (const Remainder& part : left_out_) {
    result.block(row, column, part.coefficients.rows(), part.coefficients.cols()) =
        std::sqrt(parts) * part.extent();
    row += part.coefficients.rows();
    column += part.coefficients.cols();
  }
  return result;
}

void BlockLanczos::grow_by_left_out() {
  const Eigen::Index width = width_with_left_out();
  if (width == 0) return;
  Eigen::MatrixXd columns(P_.rows(), width);
  columns.leftCols(next_.cols()) = next_;
  Eigen::Index filled = next_.cols();
  for (Remainder& part : left_out_) {
    const Eigen::Index known = part.vectors.cols(), unknown = part.lengths.size() - known;
    columns.middleCols(filled, known) = part.vectors * part.lengths.tail(known).cwiseInverse().asDiagonal();
    filled += known;
    part = {.vectors = Eigen::MatrixXd(P_.rows(), 0),
            .coefficients = part.coefficients.topRows(unknown).eval(),
            .lengths = part.lengths.head(unknown).eval()};
  }
  // Of unit length now, and what rounding has put into them of the basis is taken out before they are
  // compared.
  subtract_basis(product_by_rows(P_, columns), columns);
  orthonormalise(columns, gram_in(P_, columns), Eigen::VectorXd::Ones(width),
                 Eigen::MatrixXd(P_.rows(), 0));  // leaves out 1e-7 of what was left out
  grow();
}

// What was left out is a small part of blocks, and yet all that there is of a structure's stiffest parts.
void BlockLanczos::grow_to(Eigen::Index enough) {
  while (size_ < enough && !invariant()) exhausted() ? grow_by_left_out() : grow();
}

Eigen::Index BlockLanczos::width_with_left_out() const {
  Eigen::Index width = next_.cols();
  for (const Remainder& part : left_out_) width += part.vectors.cols();
  return width;
}

double BlockLanczos::operations_of_growth(bool with_left_out) const {
  const auto width = static_cast<double>(with_left_out ? width_with_left_out() : next_.cols());
  const auto rows = static_cast<double>(P_.rows());
  return width * (4.0 * factors_->entries() + 8.0 * rows * (static_cast<double>(size_) + width));
}

double BlockLanczos::bytes() const {
  const auto vectors = static_cast<double>(size_ + width_with_left_out());
  return 8.0 * (static_cast<double>(P_.rows()) * vectors + factors_->entries());
}

RitzPairs ritz_pairs(const BlockLanczos& space) {
  SymmetricEigen modes = symmetric_eigen(space.projected_mass());
  return {std::move(modes.values), std::move(modes.vectors)};
}

}  // namespace signorini
