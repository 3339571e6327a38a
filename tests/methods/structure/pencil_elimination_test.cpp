#include "methods/structure/pencil_elimination.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "methods/structure/factorised_receptance.hpp"
#include "tests/support/damped_chain.hpp"

namespace signorini {
namespace {

constexpr int kHarmonics = 6;
constexpr double kTolerance = 1e-8;

HarmonicWeights weights(int n) { return exact_weights(0.2 * n); }

/// Largest error of the projected receptances, relative to the exact ones.
double projected_error(const BlockLanczos& space, const std::vector<HarmonicPencil>& pencils,
                       const ContactReceptance& exact) {
  const Eigen::MatrixXcd t = space.projected_mass().cast<std::complex<double>>();
  const Eigen::MatrixXcd r = space.projected_start().leftCols(2).cast<std::complex<double>>();
  double largest = 0.0;
  for (std::size_t n = 0; n < pencils.size(); ++n) {
    Eigen::MatrixXcd z = pencils[n].mu * t;
    z.diagonal().array() += pencils[n].kappa;
    const Eigen::MatrixXcd projected = r.transpose() * z.partialPivLu().solve(r);
    const Eigen::MatrixXcd& c = exact.receptance[n];
    largest = std::max(largest, (projected - c).norm() / c.norm());
  }
  return largest;
}

TEST(PencilElimination, EndsWhereTheProjectionSufficesForEveryHarmonicAndNotMuchLater) {
  const Problem problem = test::damped_chain(120);
  const PencilLoads loads = pencil_loads(problem, kHarmonics, weights);
  const auto pencils = harmonic_pencils({0.05, 0.01}, 0.0, kHarmonics, weights, loads);
  const ContactReceptance exact = factorised_receptance(problem, kHarmonics, weights, true);
  BlockLanczos space(problem.stiffness(), problem.mass(), loads.columns);
  ASSERT_TRUE(space.definite());
  const Eigen::VectorXd theta =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(space.projected_mass()).eigenvalues();
  PencilElimination elimination(space, pencils, problem.contact_count());
  int growths = 0;
  while (!elimination.advance(kTolerance, theta)) {
    ASSERT_FALSE(space.exhausted());
    space.grow();
    elimination.take_newest_block();
    ++growths;
  }
  EXPECT_GT(growths, 2);
  EXPECT_LT(projected_error(space, pencils, exact), kTolerance);
  EXPECT_LT(space.size(), 60);  // of 120
}

TEST(StartColumns, AreTheContactsAndTheHarmonicsOwnLoad) {
  const Eigen::MatrixXd rows = Eigen::MatrixXd::Random(4, 5);
  HarmonicPencil pencil;
  EXPECT_EQ(start_columns(pencil, rows, 2), rows.leftCols(2).cast<std::complex<double>>());
  pencil.load = Eigen::VectorXcd::Random(3);
  const Eigen::MatrixXcd columns = start_columns(pencil, rows, 2);
  ASSERT_EQ(columns.cols(), 3);
  EXPECT_LE((columns.col(2) - rows.rightCols(3) * pencil.load).norm(), 1e-15);
}

}  // namespace
}  // namespace signorini
