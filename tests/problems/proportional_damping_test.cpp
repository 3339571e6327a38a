#include "problems/proportional_damping.hpp"

#include <gtest/gtest.h>

#include "tests/problems/chain_problems.hpp"

namespace signorini {
namespace {

Structure chain() { return *test::three_masses().structure; }

TEST(ProportionalDamping, IsFoundAgainFromTheMatrices) {
  const Structure s = chain();
  const auto found = proportional_damping(s.mass, s.stiffness, 0.3 * s.mass + 2e-5 * s.stiffness);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->alpha, 0.3, 1e-13);
  EXPECT_NEAR(found->beta, 2e-5, 1e-13);
}

TEST(ProportionalDamping, IsNothingForADamperOfItsOwn) {
  const Structure s = chain();
  SparseMatrix D = 0.3 * s.mass + 0.02 * s.stiffness;
  D.coeffRef(1, 1) += 1e-9;
  EXPECT_FALSE(proportional_damping(s.mass, s.stiffness, D));
}

TEST(ProportionalDamping, OfNoDampingIsZero) {
  const Structure s = chain();
  const auto found = proportional_damping(s.mass, s.stiffness, SparseMatrix(3, 3));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->alpha, 0.0);
  EXPECT_EQ(found->beta, 0.0);
}

TEST(ProportionalDamping, OfAFreeStructureIsThatOfItsMass) {
  const Structure s = chain();
  const auto found = proportional_damping(s.mass, SparseMatrix(3, 3), 0.7 * s.mass);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->alpha, 0.7, 1e-15);
  EXPECT_EQ(found->beta, 0.0);
}

// alpha and beta are not determined then; their sum is.
TEST(ProportionalDamping, WhereMassAndStiffnessAreProportionalTooGivesTheDampingBack) {
  const SparseMatrix M = chain().mass;
  const auto found = proportional_damping(M, 4.0 * M, 2.0 * M);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->alpha + 4.0 * found->beta, 2.0, 1e-14);
}

}  // namespace
}  // namespace signorini
