#include "methods/structure/dynamic_stiffness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/damped_chain.hpp"

namespace signorini::dynamic_stiffness_test {
namespace {

using Complex = std::complex<double>;

TEST(DynamicStiffness, SolvesWithDenseAndWithSparseFactors) {
  const Problem problem = test::damped_chain(20);
  const Eigen::MatrixXcd right = Eigen::MatrixXcd::Random(20, 3);
  for (const bool dense : {true, false}) {
    DynamicStiffness stiffness(problem, dense);
    // One analysis of the pattern serves all harmonics, also where weights are complex.
    for (const HarmonicWeights& weights :
         {exact_weights(0.0), exact_weights(1.7), scheme_weights(HatScheme::backward, 0.9, 0.1)}) {
      stiffness.factorise(weights);
      const Eigen::MatrixXcd z =
          test::dense_stiffness(problem, weights.mass, weights.damping, weights.stiffness);
      const Eigen::MatrixXcd solution = stiffness.solve(right);
      EXPECT_LE((z * solution - right).norm(), 1e-12 * z.norm() * solution.norm());
    }
  }
}

TEST(DynamicStiffness, RefusesAStructureFreeToMoveAtRest) {
  Problem problem = test::damped_chain(3);
  problem.edit_structure([](Structure& s) {
    s.stiffness = SparseMatrix(3, 3);
    for (int i = 0; i < 3; ++i) {
      s.stiffness.insert(i, i) = i == 1 ? 2.0 : 1.0;
      if (i + 1 < 3) s.stiffness.insert(i, i + 1) = s.stiffness.insert(i + 1, i) = -1.0;
    }
  });
  for (const bool dense : {true, false}) {
    DynamicStiffness stiffness(problem, dense);
    EXPECT_THROW(stiffness.factorise(exact_weights(0.0)), SingularStiffness);
    EXPECT_NO_THROW(stiffness.factorise(exact_weights(0.4)));
  }
}

TEST(DynamicStiffness, RefusesAnUndampedResonance) {
  Problem problem = test::damped_chain(2, 1);
  problem.edit_structure([](Structure& s) {
    s.mass = s.stiffness = s.damping = SparseMatrix(2, 2);
    for (int i = 0; i < 2; ++i) {
      s.mass.insert(i, i) = 1.0;
      s.stiffness.insert(i, i) = i == 0 ? 4.0 : 7.0;
    }
  });
  DynamicStiffness stiffness(problem, true);
  EXPECT_THROW(stiffness.factorise(exact_weights(2.0)), SingularStiffness);
}

TEST(PrefersDense, IsForSmallStructures) {
  EXPECT_TRUE(prefers_dense(test::damped_chain(32)));
  EXPECT_FALSE(prefers_dense(test::damped_chain(33)));
}

TEST(LoadCoefficient, IsTheFourierIntegralOfTheLoad) {
  constexpr int kInstants = 64;  // more than twice the highest harmonic: the sum is exact
  Problem problem = test::damped_chain(4);
  problem.subharmonic = 2;
  for (int n = 0; n <= 8; ++n) {
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(4);
    for (int k = 0; k < kInstants; ++k) {
      const double share = static_cast<double>(k) / kInstants;
      sum += load_at(problem, share * problem.period()) *
             std::polar(1.0 / kInstants, -2.0 * std::numbers::pi * n * share);
    }
    EXPECT_LE((load_coefficient(problem, n) - sum).norm(), 1e-13) << "harmonic " << n;
  }
}

}  // namespace
}  // namespace signorini::dynamic_stiffness_test
