#include "methods/solvers/gmres.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace signorini {
namespace {

Eigen::VectorXd unchanged(const Eigen::VectorXd& v) { return v; }

TEST(SolveByGmres, MatchesDenseSolve) {
  std::srand(1);
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(30, 30) + 3.0 * Eigen::MatrixXd::Identity(30, 30);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(30);
  const auto product = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return a * v; };
  const auto [x, condition] = solve_by_gmres(product, unchanged, b, 1e-13);
  ASSERT_EQ(x.size(), 30);
  EXPECT_LE((x - a.lu().solve(b)).norm(), 1e-11 * x.norm());
  // On the whole space, in another norm and another basis: within a factor of the size.
  const double exact = 1.0 / Eigen::PartialPivLU<Eigen::MatrixXd>(a).rcond();
  EXPECT_GE(condition, exact / 30.0);
  EXPECT_LE(condition, exact * 30.0);
}

TEST(SolveByGmres, NeedsOneStepMoreThanTheRankOfADeparture) {
  std::srand(2);
  const Eigen::MatrixXd u = Eigen::MatrixXd::Random(50, 3);
  int products = 0;
  const auto product = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
    ++products;
    return v + u * (u.transpose() * v);
  };
  const Eigen::VectorXd b = Eigen::VectorXd::Random(50);
  const Eigen::VectorXd x = solve_by_gmres(product, unchanged, b, 1e-12).x;
  ASSERT_EQ(x.size(), 50);
  EXPECT_LE(products, 5);  // four for the Krylov space, one for the true residual
}

TEST(SolveByGmres, ExactPreconditionerNeedsOneStep) {
  std::srand(3);
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(20, 20) + 4.0 * Eigen::MatrixXd::Identity(20, 20);
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(a);
  int products = 0;
  const Eigen::VectorXd x = solve_by_gmres(
                                [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
                                  ++products;
                                  return a * v;
                                },
                                [&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return lu.solve(v); },
                                Eigen::VectorXd::Ones(20), 1e-10)
                                .x;
  ASSERT_EQ(x.size(), 20);
  EXPECT_EQ(products, 2);
}

TEST(SolveByGmres, SaysSoWhenTheSystemIsSingular) {
  const auto product = [](const Eigen::VectorXd& v) -> Eigen::VectorXd {
    Eigen::VectorXd out = v;
    out[0] = 0.0;
    return out;
  };
  EXPECT_EQ(solve_by_gmres(product, unchanged, Eigen::VectorXd::Ones(5), 1e-12).x.size(), 0);
}

TEST(SolveByGmres, SaysSoWhenTheRightHandSideIsNotFinite) {
  const Eigen::VectorXd b = Eigen::VectorXd::Constant(3, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(solve_by_gmres(unchanged, unchanged, b, 1e-12).x.size(), 0);
}

TEST(SolveByGmres, ZeroRightHandSideGivesZero) {
  EXPECT_EQ(solve_by_gmres(unchanged, unchanged, Eigen::VectorXd::Zero(3), 1e-12).x,
            Eigen::VectorXd::Zero(3));
}

}  // namespace
}  // namespace signorini
