#include "methods/structure/bases/ritz_reduction.hpp"

#include <gtest/gtest.h>

#include "methods/solvers/extended/matrix.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::ritz_reduction_test {
namespace {

// A slender block, whose softest bending is most of its compliance: what the space leaves out is a
// thousandth of that and less, and known to six digits nonetheless, against sums in long double.
TEST(StaticCompliance, KnowsWhatASpaceLeavesOut) {
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
  // B^T K^-1 B = Y^T Y for K = L L^T and Y = L^-1 B.
  const auto compliance = [](const ExtendedMatrix& K, const ExtendedMatrix& B) {
    const ExtendedMatrix Y = extended::solve_lower(extended::cholesky(K).L, B);
    return extended::transposed_product(Y, Y);
  };
  const ExtendedMatrix K = extended::widened(block.stiffness()), B = extended::widened(columns.all());
  const ExtendedMatrix V =
      extended::widened(space.combined(Eigen::MatrixXd::Identity(space.size(), space.size())));
  ExtendedMatrix left_out = compliance(K, B);
  const Eigen::MatrixXd whole = extended::rounded(left_out);
  const ExtendedMatrix held = compliance(extended::transposed_product(V, extended::product(K, V)),
                                         extended::transposed_product(V, B));
  for (Eigen::Index i = 0; i < held.size(); ++i) left_out.data()[i] -= held.data()[i];
  const Eigen::MatrixXd outside = extended::rounded(left_out);
  ASSERT_LT(outside.diagonal().maxCoeff(), 1e-3 * whole.diagonal().maxCoeff());
  EXPECT_LT((projection.outside - outside).norm(), 1e-6 * outside.norm());
  const Eigen::VectorXd lengths = whole.diagonal().cwiseSqrt();
  statics.forget_vectors();
  const SpaceProjection anew = statics.projection(space);
  EXPECT_EQ(anew.contacts, projection.contacts);
  EXPECT_LT((anew.outside - projection.outside).norm(), 1e-12 * projection.outside.norm());
  EXPECT_LT((statics.lengths() - lengths).norm(), 1e-6 * lengths.norm());
}

}  // namespace
}  // namespace signorini::ritz_reduction_test
