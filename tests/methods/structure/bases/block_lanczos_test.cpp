#include "methods/structure/bases/block_lanczos.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "tests/support/damped_chain.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::block_lanczos_test {
namespace {

class BlockLanczosOfChain : public testing::Test {
 protected:
  BlockLanczosOfChain()
      : problem_(test::damped_chain(24)),
        start_(contact_directions(problem_)),
        space_(problem_.stiffness(), problem_.mass(), start_),
        p_(problem_.stiffness()),
        m_(problem_.mass()),
        b_(start_) {}

  Problem problem_;
  SparseMatrix start_;
  BlockLanczos space_;
  Eigen::MatrixXd p_, m_, b_;
};

// With k powers in the space, r^T t^j r = B^T P^{-1} (M P^{-1})^j B for j = 0 ... 2 k - 1: the moments of
// which the space is made, and as many again by symmetry.
TEST_F(BlockLanczosOfChain, MatchesTwiceAsManyMomentsAsItHasPowers) {
  ASSERT_TRUE(space_.definite());
  for (int powers = 1; powers <= 5; ++powers) {
    // Less than two columns each: on a chain, powers of neighbouring contacts share directions.
    EXPECT_LE(space_.size(), 2 * powers);
    EXPECT_GT(space_.size(), powers);
    const Eigen::MatrixXd t = space_.projected_mass();
    const Eigen::MatrixXd r = space_.projected_start();
    Eigen::MatrixXd projected = r;
    Eigen::MatrixXd exact = CholeskyFactors(p_).solve(b_);
    for (int j = 0; j < 2 * powers; ++j) {
      const Eigen::MatrixXd moment = b_.transpose() * exact;
      EXPECT_LE((r.transpose() * projected - moment).norm(), 1e-11 * moment.norm())
          << powers << " powers, moment " << j;
      projected = t * projected;
      exact = CholeskyFactors(p_).solve(Eigen::MatrixXd(m_ * exact));
    }
    space_.grow();
  }
}

TEST_F(BlockLanczosOfChain, HoldsTheWholeSpectrumOnceExhausted) {
  for (int k = 0; k < 30 && !space_.exhausted(); ++k) space_.grow();
  ASSERT_TRUE(space_.exhausted());
  EXPECT_EQ(space_.size(), 24);
  const Eigen::VectorXd found = symmetric_eigenvalues(space_.projected_mass());
  const Eigen::VectorXd exact = generalised_eigen(m_, p_).values;
  EXPECT_LE((found - exact).norm(), 1e-10 * exact.norm());
  const Eigen::Index before = space_.size();
  space_.grow();
  EXPECT_EQ(space_.size(), before);
}

// Of the whole space: t = U theta U^T, and projected columns are those of the start.
TEST_F(BlockLanczosOfChain, GivesRitzPairsAndProjectsOtherColumns) {
  const Eigen::MatrixXd start = space_.projected_start();
  EXPECT_LE((space_.projected(start_) - start).norm(), 1e-12 * start.norm());
  EXPECT_LE((space_.solve(b_) - CholeskyFactors(p_).solve(b_)).norm(), 1e-11 * b_.norm());
  const Eigen::Index before = space_.size(), width = space_.width();
  space_.grow();
  EXPECT_EQ(space_.size(), before + width);
  const RitzPairs pairs = ritz_pairs(space_);
  const Eigen::MatrixXd t = space_.projected_mass();
  EXPECT_LE((t * pairs.vectors - pairs.vectors * pairs.values.asDiagonal()).norm(), 1e-12 * t.norm());
  EXPECT_LE(
      (pairs.vectors.transpose() * pairs.vectors - Eigen::MatrixXd::Identity(t.rows(), t.rows())).norm(),
      1e-12);
  for (Eigen::Index k = 1; k < pairs.values.size(); ++k) EXPECT_LE(pairs.values[k - 1], pairs.values[k]);
  // Columns outside the space: (V^T A)^T V^T A is at most A^T P^-1 A.
  Eigen::MatrixXd others = Eigen::MatrixXd::Zero(24, 2);
  others(3, 0) = others(17, 1) = 1.0;
  const SparseMatrix sparse = others.sparseView();
  const Eigen::MatrixXd rows = space_.projected(sparse), newest = rows.bottomRows(width);
  EXPECT_LE((space_.projected(sparse, before) - newest).norm(), 1e-14 * newest.norm());
  EXPECT_LE((space_.projected(others, before) - newest).norm(), 1e-14 * newest.norm());
  const Eigen::MatrixXd missed =
      others.transpose() * CholeskyFactors(p_).solve(others) - rows.transpose() * rows;
  EXPECT_GE(symmetric_eigenvalues(missed)[0], -1e-12);
  EXPECT_GT(missed.norm(), 1e-6);
}

TEST_F(BlockLanczosOfChain, LeavesOutWhatOnlyRepeatsADirection) {
  SparseMatrix twice(24, 4);
  for (int j = 0; j < 4; ++j) {
    for (SparseMatrix::InnerIterator it(start_, j % 2); it; ++it)
      twice.insert(it.row(), j) = (1.0 + j) * it.value();
  }
  const BlockLanczos space(problem_.stiffness(), problem_.mass(), twice);
  EXPECT_EQ(space.size(), 2);
  const Eigen::MatrixXd r = space.projected_start();
  const Eigen::MatrixXd exact =
      Eigen::MatrixXd(twice).transpose() * CholeskyFactors(p_).solve(Eigen::MatrixXd(twice));
  EXPECT_LE((r.transpose() * r - exact).norm(), 1e-12 * exact.norm());
}

// A slender block over a pad of many nodes: what one node alone moves is of a stiffness by many digits larger
// than the block's lowest, and most of it is left out of the first powers. Whatever is left out, L bounds it;
// taken in later, nothing is left.
TEST(BlockLanczos, BoundsWhatIsLeftOutOfABlockAndTakesItIn) {
  const Problem block = test::padded_block_problem(
      {.elements = {100, 2, 2}, .lengths = {20.0, 0.2, 0.2}, .patch = {{{18.0, 20.0}, {0.0, 0.2}}}});
  ASSERT_GE(block.contact_count(), 15);
  const SparseMatrix start = contact_directions(block);
  BlockLanczos space(block.stiffness(), block.mass(), start);
  ASSERT_TRUE(space.definite());
  const auto defect = [&](const Eigen::VectorXd& y) {
    const Eigen::MatrixXd moved =
        space.solve(block.mass() * space.combined(y)) - space.combined(space.projected_mass() * y);
    const Eigen::VectorXd x = moved.col(0);
    return std::sqrt(std::max(0.0, x.dot(block.stiffness() * x)));
  };
  const auto bound = [&](const Eigen::VectorXd& y) {
    return (space.coupling() * y.tail(space.coupling().cols())).norm() + (space.left_out() * y).norm();
  };
  for (int k = 0; k < 4; ++k) space.grow();
  EXPECT_GT(space.left_out().rows(), 0);
  const double rounding =
      1e-8 * space.projected_mass().norm();  // of solutions with K, whose condition is 1e9
  for (const bool taken : {false, true}) {
    if (taken) space.grow_by_left_out();
    std::srand(3);
    for (int i = 0; i < 20; ++i) {
      const Eigen::VectorXd y = Eigen::VectorXd::Random(space.size());
      EXPECT_LE(defect(y), bound(y) + rounding * y.norm());
    }
    // Of the first block alone: nothing but what was left out of it.
    const Eigen::Index first = space.projected_start().cols();
    Eigen::VectorXd y = Eigen::VectorXd::Zero(space.size());
    y.head(first).setRandom();
    EXPECT_LE(defect(y), (space.left_out() * y).norm() + rounding * y.norm());
  }
  EXPECT_EQ(space.left_out().leftCols(space.projected_start().cols()).norm(), 0.0);
  space.grow_by_left_out();  // again: of the newest block, if anything
  const Eigen::MatrixXd basis = space.combined(Eigen::MatrixXd::Identity(space.size(), space.size()));
  EXPECT_LT(
      (basis.transpose() * block.stiffness() * basis - Eigen::MatrixXd::Identity(space.size(), space.size()))
          .cwiseAbs()
          .maxCoeff(),
      1e-7);
}

TEST(BlockLanczos, SaysWherePIsNotDefinite) {
  SparseMatrix p(2, 2), m(2, 2), b(2, 1);
  p.insert(0, 0) = 1.0;
  p.insert(1, 1) = 0.0;
  m.setIdentity();
  b.insert(0, 0) = 1.0;
  EXPECT_FALSE(BlockLanczos(p, m, b).definite());
}

// Some directions of a power, then others: what waits is in the bound of every vector, old and new, and a
// power taken in all its directions is the power.
TEST(BlockLanczos, GrowsAlongSomeDirections) {
  const Problem block =
      test::padded_block_problem({.elements = {8, 3, 3}, .patch = {{{1.5, 2.0}, {0.0, 0.5}}}});
  const SparseMatrix start = contact_directions(block);
  BlockLanczos space(block.stiffness(), block.mass(), start), whole(block.stiffness(), block.mass(), start);
  std::srand(11);
  const auto directions = [](Eigen::Index rows, Eigen::Index columns) -> Eigen::MatrixXd {
    const Eigen::MatrixXd random = Eigen::MatrixXd::Random(rows, columns);
    return householder_basis(random).leftCols(columns);
  };
  for (const Eigen::Index taken : {2, 3, 1}) {
    const Eigen::Index before = space.size();
    ASSERT_GT(space.width(), taken);
    space.grow_along(directions(space.width(), taken));
    EXPECT_EQ(space.size(), before + taken);
    const Eigen::MatrixXd basis = space.combined(Eigen::MatrixXd::Identity(space.size(), space.size()));
    const Eigen::MatrixXd moved = space.solve(block.mass() * basis) - basis * space.projected_mass();
    EXPECT_EQ(space.coupling().rows(), space.width());
    const Eigen::MatrixXd outside = moved.transpose() * block.stiffness() * moved;
    Eigen::MatrixXd coupling = Eigen::MatrixXd::Zero(space.width(), space.size());
    coupling.rightCols(space.coupling().cols()) = space.coupling();
    EXPECT_LT((outside - coupling.transpose() * coupling).norm(), 1e-9 * outside.norm());
    EXPECT_LT((basis.transpose() * block.stiffness() * basis -
               Eigen::MatrixXd::Identity(space.size(), space.size()))
                  .norm(),
              1e-10);
  }
  const BlockLanczos& once = whole;
  const Eigen::Index width = once.width();
  BlockLanczos all(block.stiffness(), block.mass(), start);
  all.grow_along(directions(width, width));
  whole.grow();
  EXPECT_EQ(all.size(), whole.size());
  const Eigen::VectorXd found = ritz_pairs(all).values, expected = ritz_pairs(whole).values;
  EXPECT_LT((found - expected).norm(), 1e-11 * expected.norm());
  EXPECT_LT(std::abs(all.coupling().norm() - whole.coupling().norm()), 1e-9 * whole.coupling().norm());
}

// Columns that are offered wait beside the next power, of which they are no part; taken in, the space holds
// them. What the space holds already is not offered.
TEST(BlockLanczos, TakesInColumnsThatAreOffered) {
  const Problem block =
      test::padded_block_problem({.elements = {8, 3, 3}, .patch = {{{1.5, 2.0}, {0.0, 0.5}}}});
  const SparseMatrix start = contact_directions(block);
  BlockLanczos space(block.stiffness(), block.mass(), SparseMatrix(start.leftCols(3)));
  const Eigen::Index width = space.width(), size = space.size();
  const Eigen::MatrixXd columns = space.solve(Eigen::MatrixXd(start.middleCols(3, 2)));
  space.offer(columns);
  ASSERT_EQ(space.width(), width + 2);
  EXPECT_EQ(space.coupling().bottomRows(2).norm(), 0.0);
  space.offer(space.combined(Eigen::MatrixXd::Identity(size, 2)));
  EXPECT_EQ(space.width(), width + 2);
  space.grow();
  const Eigen::MatrixXd basis = space.combined(Eigen::MatrixXd::Identity(space.size(), space.size()));
  const Eigen::MatrixXd left = columns - basis * (basis.transpose() * (block.stiffness() * columns));
  EXPECT_LT(left.norm(), 1e-10 * columns.norm());
  EXPECT_LT(
      (basis.transpose() * block.stiffness() * basis - Eigen::MatrixXd::Identity(space.size(), space.size()))
          .norm(),
      1e-10);
}

}  // namespace
}  // namespace signorini::block_lanczos_test
