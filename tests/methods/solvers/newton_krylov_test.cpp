#include "methods/solvers/newton_krylov.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace signorini {
namespace {

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
    return {.x = jacobian.partialPivLu().solve(r), .condition = 7.0};
  }
  [[nodiscard]] double scale(const Eigen::VectorXd& v, const Eigen::VectorXd& /*r*/) const {
    return v.norm();
  }
};

TEST(NewtonKrylov, FindsTheRootOfASmoothSystem) {
  CubicSystem system;
  const NewtonKrylovResult result =
      solve_newton_krylov(system, Eigen::Vector2d(10.0, 10.0), 1e-12, {.max_steps = 50});
  ASSERT_TRUE(result.converged);
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
    [[nodiscard]] double scale(const Eigen::VectorXd& /*v*/, const Eigen::VectorXd& /*r*/) const {
      return 1.0;
    }
  } system;
  const NewtonKrylovResult result = solve_newton_krylov(system, Eigen::VectorXd::Zero(3), 1e-14, {});
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 1);
  EXPECT_LE((result.unknowns - Eigen::VectorXd::Constant(3, 0.25)).norm(), 1e-15);
}

TEST(NewtonKrylov, CountsNoStepAndNoConditionAtARoot) {
  CubicSystem system;
  system.b.setZero();
  const NewtonKrylovResult result = solve_newton_krylov(system, Eigen::Vector2d(0.0, 0.0), 1e-12, {});
  EXPECT_TRUE(result.converged);
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
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(result.unknowns, Eigen::VectorXd(first));
}

TEST(NewtonKrylov, KeepsTheBestIterateAtItsLimit) {
  CubicSystem system;
  const NewtonKrylovResult result =
      solve_newton_krylov(system, Eigen::Vector2d(100.0, 100.0), 1e-12, {.max_steps = 2});
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 2);
  EXPECT_LT(result.unknowns.norm(), 100.0);
}

}  // namespace
}  // namespace signorini
