#include "methods/structure/ritz_reduction.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "tests/support/structure_scenes.hpp"

namespace signorini::ritz_reduction_test {
namespace {

// A slender block, whose softest bending is most of its compliance: what the space leaves out is a
// thousandth of that and less, and known to six digits nonetheless, against sums in long double.
TEST(StaticCompliance, KnowsWhatASpaceLeavesOut) {
  using Long = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  const Problem block = test::padded_block_problem(
      {.elements = {24, 2, 2}, .lengths = {2.0, 0.02, 0.02}, .patch = {{{1.5, 2.0}, {0.0, 0.02}}}});
  const ContactColumns columns = contact_columns(block);
  ASSERT_EQ(columns.obstacle, "");
  BlockLanczos space(block.stiffness(), block.mass(), SparseMatrix(columns.all().leftCols(1)));
  while (space.size() < 16) space.grow();
  StaticCompliance statics(block, space, columns);
  const SpaceProjection before = statics.projection(space);
  space.grow();
  const SpaceProjection projection = statics.projection(space);
  EXPECT_EQ(projection.contacts.topRows(before.contacts.rows()), before.contacts);
  const Long K = Eigen::MatrixXd(block.stiffness()).cast<long double>();
  const Long B = Eigen::MatrixXd(columns.all()).cast<long double>();
  const Long V = space.combined(Eigen::MatrixXd::Identity(space.size(), space.size())).cast<long double>();
  const Long whole = B.transpose() * Eigen::LDLT<Long>(K).solve(B), seen = V.transpose() * B;
  const Long held = seen.transpose() * Eigen::LDLT<Long>(Long(V.transpose() * K * V)).solve(seen);
  const Eigen::MatrixXd outside = (whole - held).cast<double>();
  ASSERT_LT(outside.diagonal().maxCoeff(), 1e-3 * static_cast<double>(whole.diagonal().maxCoeff()));
  EXPECT_LT((projection.outside - outside).norm(), 1e-6 * outside.norm());
  const Eigen::VectorXd lengths = whole.diagonal().cwiseSqrt().cast<double>();
  statics.forget_vectors();
  const SpaceProjection anew = statics.projection(space);
  EXPECT_EQ(anew.contacts, projection.contacts);
  EXPECT_LT((anew.outside - projection.outside).norm(), 1e-12 * projection.outside.norm());
  EXPECT_LT((statics.lengths() - lengths).norm(), 1e-6 * lengths.norm());
}

}  // namespace
}  // namespace signorini::ritz_reduction_test
