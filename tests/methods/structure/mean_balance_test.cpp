#include "methods/structure/mean_balance.hpp"

#include <gtest/gtest.h>

#include "methods/structure/receptance.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/loose_parts.hpp"

namespace signorini::mean_balance_test {
namespace {

TEST(MeanBalance, IsEmptyAndCarriesTheForceItselfOnSprings) {
  const ContactReceptance receptance = fourier_receptance(test::to_problem({}), 4);
  EXPECT_EQ(MeanBalance(receptance).share.size(), 0);
  const Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Random(5, 1);
  EXPECT_EQ(balanced_force(receptance, lambda), lambda);
  EXPECT_EQ(carried_force(receptance, lambda, Eigen::RowVectorXd::Zero(1)), lambda);
}

TEST(MeanBalance, BalancesTheMeanLoadAndMovesTheMeanAtWill) {
  const ContactReceptance receptance = fourier_receptance(test::gear_backlash(), 4);
  Eigen::MatrixXcd carried = Eigen::MatrixXcd::Random(5, 2);
  carried.row(0) = carried.row(0).real().cast<std::complex<double>>();
  const Eigen::MatrixXcd lambda = balanced_force(receptance, carried);
  // x = x_0 = -x_1: the load 0.1 and the forces on the mass, lambda_0 - lambda_1.
  EXPECT_NEAR(0.1 + lambda(0, 0).real() - lambda(0, 1).real(), 0.0, 1e-14);
  const Eigen::MatrixXcd x = carried_motion(receptance, carried);
  EXPECT_NEAR(x(0, 0).real(), -x(0, 1).real(), 1e-14);

  const double mean = 0.37;
  const Eigen::MatrixXcd held =
      carried_motion(receptance, carried_force(receptance, lambda, Eigen::RowVector2d(0.0, 0.0)));
  const Eigen::MatrixXcd moved = carried_force(receptance, lambda, Eigen::RowVector2d(mean, -mean));
  EXPECT_LE((balanced_force(receptance, moved) - lambda).norm(), 1e-13);
  EXPECT_NEAR((carried_motion(receptance, moved) - held)(0, 0).real(), mean, 1e-13);
}

}  // namespace
}  // namespace signorini::mean_balance_test
