#include "methods/solvers/newton_krylov.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "problems/linear_algebra/lu.hpp"

namespace signorini::newton_krylov_test {
namespace {

Eigen::VectorXd unchanged(const Eigen::VectorXd& v) { return v; }

TEST(SolveByGmres, MatchesDenseSolve) {
  std::srand(1);
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(30, 30) + 3.0 * Eigen::MatrixXd::Identity(30, 30);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(30);
  const auto product = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return a * v; };
  const auto [x, condition] = solve_by_gmres(product, unchanged, b, 1e-13);
  ASSERT_EQ(x.size(), 30);
  EXPECT_LE((x - lu_solve(a, b)).norm(), 1e-11 * x.norm());
  // On the whole space, in another norm and another basis: within a factor of the size.
  const double exact = 1.0 / LuFactors(a).reciprocal_condition();
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
  const LuFactors lu(a);
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

/// r_i = v_i^3 + sum_j A_ij v_j - b_i with a positive definite A: one root, which Newton finds from anywhere.
struct CubicSystem {
  Eigen::Matrix2d a{{2.0, 0.5}, {0.5, 1.0}};
  Eigen::Vector2d b{1.0, -3.0};
  Eigen::Vector2d at{0.0, 0.0};
  int residuals = 0;
  bool singular = false;

  Eigen::VectorXd residual(const Eigen::VectorXd& v) {
    ++residuals;
    at = v;
    return v.array().cube().matrix() + a * v - b;
  }
  KrylovSolve solve_jacobian(const Eigen::VectorXd& r) const {
    if (singular) return {};
    const Eigen::Matrix2d jacobian = Eigen::Matrix2d(3.0 * at.array().square().matrix().asDiagonal()) + a;
    return {.x = lu_solve(jacobian, r), .condition = 7.0};
  }
  [[nodiscard]] double error(const Eigen::VectorXd& v, const Eigen::VectorXd& r) const {
    return r.norm() == 0.0 ? 0.0 : r.norm() / v.norm();
  }
};

TEST(NewtonKrylov, FindsTheRootOfASmoothSystem) {
  CubicSystem system;
  const NewtonKrylovResult result =
      solve_newton_krylov(system, Eigen::Vector2d(10.0, 10.0), 1e-12, {.max_steps = 50});
  ASSERT_EQ(result.end, NewtonEnd::solved);
  EXPECT_LE(result.residual, 1e-12);
  EXPECT_LE(result.iterations, 12);
  EXPECT_EQ(result.condition, 7.0);
  CubicSystem check;
  EXPECT_LE(check.residual(result.unknowns).norm(), 1e-11);
}

TEST(NewtonKrylov, SolvesALinearSystemInOneStep) {
  struct Linear {
    Eigen::VectorXd residual(const Eigen::VectorXd& v) const { return 4.0 * v - Eigen::VectorXd::Ones(3); }
    KrylovSolve solve_jacobian(const Eigen::VectorXd& r) const { return {.x = 0.25 * r}; }
    [[nodiscard]] double error(const Eigen::VectorXd& /*v*/, const Eigen::VectorXd& r) const {
      return r.norm();
    }
  } system;
  const NewtonKrylovResult result = solve_newton_krylov(system, Eigen::VectorXd::Zero(3), 1e-14, {});
  EXPECT_EQ(result.end, NewtonEnd::solved);
  EXPECT_EQ(result.iterations, 1);
  EXPECT_LE((result.unknowns - Eigen::VectorXd::Constant(3, 0.25)).norm(), 1e-15);
}

TEST(NewtonKrylov, CountsNoStepAndNoConditionAtARoot) {
  CubicSystem system;
  system.b.setZero();
  const NewtonKrylovResult result = solve_newton_krylov(system, Eigen::Vector2d(0.0, 0.0), 1e-12, {});
  EXPECT_EQ(result.end, NewtonEnd::solved);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(result.residual, 0.0);
  EXPECT_FALSE(result.condition);
  EXPECT_EQ(system.residuals, 1);
}

TEST(NewtonKrylov, EndsWhereTheLinearSolveFails) {
  CubicSystem system;
  system.singular = true;
  const Eigen::Vector2d first(1.0, 2.0);
  const NewtonKrylovResult result = solve_newton_krylov(system, first, 1e-12, {});
  EXPECT_EQ(result.end, NewtonEnd::singular);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(result.unknowns, Eigen::VectorXd(first));
}

TEST(NewtonKrylov, KeepsTheBestIterateAtItsLimit) {
  CubicSystem system;
  const NewtonKrylovResult result =
      solve_newton_krylov(system, Eigen::Vector2d(100.0, 100.0), 1e-12, {.max_steps = 2});
  EXPECT_EQ(result.end, NewtonEnd::limit);
  EXPECT_EQ(result.iterations, 2);
  EXPECT_LT(result.unknowns.norm(), 100.0);
}

}  // namespace
}  // namespace signorini::newton_krylov_test
