#include "methods/solvers/extended/reflections.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace signorini::reflections_test {
namespace {

TEST(ExtendedReflection, MakesAVectorAMultipleOfTheFirstUnitVector) {
  for (const long double first : {2.0L, -2.0L, 0.0L}) {
    const long double x[] = {first, 3.0L, 6.0L};
    long double u[] = {first, 3.0L, 6.0L}, image[] = {first, 3.0L, 6.0L};
    const long double multiple = extended::reflect(u, 3);
    EXPECT_NEAR(static_cast<double>(std::abs(multiple) - std::sqrt(45.0L + first * first)), 0.0, 1e-18);
    EXPECT_LE(multiple * first, 0.0L);  // no digits cancel
    extended::apply_reflection(u, image, 3);
    EXPECT_LT(std::abs(image[0] - multiple), 4e-18L);
    EXPECT_LT(std::abs(image[1]) + std::abs(image[2]), 4e-18L);
    extended::apply_reflection(u, image, 3);  // back
    for (int i = 0; i < 3; ++i) EXPECT_LT(std::abs(image[i] - x[i]), 4e-18L);
  }
}

TEST(ExtendedReflection, LeavesAMultipleOfTheFirstUnitVector) {
  long double u[] = {-5.0L, 0.0L, 0.0L};
  EXPECT_EQ(extended::reflect(u, 3), -5.0L);
  for (const long double entry : u) EXPECT_EQ(entry, 0.0L);
}

TEST(ExtendedReflection, ProductsAreOrthogonalAndHaveTheFirstAtTheLeft) {
  ExtendedMatrix A(4, 4);
  for (Eigen::Index i = 0; i < 16; ++i) A.data()[i] = static_cast<long double>((5 * i * i + i) % 7) - 2.5L;
  for (const Eigen::Index k : {0, 1}) extended::reflect(&A(k + 1, k), 3 - k);
  const ExtendedMatrix Q = extended::product_of_reflections(A);
  for (Eigen::Index j = 0; j < 4; ++j) {
    long double image[] = {0.0L, 0.0L, 0.0L, 0.0L};
    image[j] = 1.0L;
    extended::apply_reflection(&A(2, 1), image + 2, 2);
    extended::apply_reflection(&A(1, 0), image + 1, 3);
    for (Eigen::Index i = 0; i < 4; ++i) EXPECT_LT(std::abs(Q(i, j) - image[i]), 1e-18L);
  }
}

TEST(ExtendedReflection, EntriesAreNegligibleAgainstTheirNeighbours) {
  constexpr long double kRounding = std::numeric_limits<long double>::epsilon();
  EXPECT_TRUE(extended::negligible(-kRounding, 1.0L, 1e9L));
  EXPECT_FALSE(extended::negligible(2.0L * kRounding, 1.0L, 1e9L));
  EXPECT_TRUE(extended::negligible(kRounding * kRounding, 0.0L, 1.0L));
  EXPECT_FALSE(extended::negligible(kRounding, 0.0L, 1.0L));
  EXPECT_FALSE(extended::negligible(std::numeric_limits<long double>::quiet_NaN(), 1.0L, 1.0L));
}

TEST(ExtendedReflection, KnowsWhatIsFinite) {
  ExtendedMatrix A = extended::identity(3);
  EXPECT_TRUE(extended::all_finite(A));
  A(1, 2) = std::numeric_limits<long double>::infinity();
  EXPECT_FALSE(extended::all_finite(A));
  A(1, 2) = std::numeric_limits<long double>::quiet_NaN();
  EXPECT_FALSE(extended::all_finite(A));
}

}  // namespace
}  // namespace signorini::reflections_test
