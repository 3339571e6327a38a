#include "methods/aft_hbm/aft_grid_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/structure/receptance.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::aft_grid_solver_test {
namespace {

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 1.0};

/// A mass between two stops, six harmonics on 64 samples.
class AftResidualTest : public testing::Test {
 protected:
  AftResidualTest() {
    problem_ = test::to_problem(kStop);
    problem_.contacts.push_back({{{0, -1.0}}, 0.4});
    residual_ = residual_with({0.2, 0.4});
    std::srand(7);
    lambda_ = Eigen::VectorXd::Random(residual_->unknowns());
  }

  [[nodiscard]] std::unique_ptr<AftResidual> residual_with(const Eigen::Vector2d& gap) const {
    const ContactReceptance receptance = fourier_receptance(problem_, 6);
    const ProjectedLaw law = lipschitz_law(problem_, 10.0, receptance);
    const Eigen::VectorXd gaps = gap;
    return std::make_unique<AftResidual>(ProjectedEquations{receptance, gaps, law}, 64);
  }

  Problem problem_;
  std::unique_ptr<AftResidual> residual_;
  Eigen::VectorXd lambda_;
};

TEST_F(AftResidualTest, JacobianVectorProductMatchesFiniteDifferences) {
  for (int k = 0; k < 5; ++k) {
    const Eigen::VectorXd v = Eigen::VectorXd::Random(residual_->unknowns());
    constexpr double kStep = 1e-7;  // piecewise linear: exact unless a sample switches on the way
    const Eigen::VectorXd stepped = residual_->residual(lambda_ + kStep * v);
    const Eigen::VectorXd r = residual_->residual(lambda_);
    const Eigen::VectorXd difference = (stepped - r) / kStep;
    EXPECT_LE((residual_->product(v) - difference).norm(), 1e-6 * difference.norm());
  }
}

TEST_F(AftResidualTest, ProjectionIsIdempotentAndSelfAdjoint) {
  const Eigen::VectorXd signal = Eigen::VectorXd::Random(128);
  const Eigen::VectorXd coefficients = residual_->project(signal);
  // |P s|_2 in coefficients is the root mean square of the projected signal.
  EXPECT_LE(coefficients.norm(), std::sqrt(signal.squaredNorm() / 64));
  const auto round_trip = residual_->unknowns_of(residual_->coefficients(coefficients));
  EXPECT_LE((round_trip - coefficients).norm(), 1e-14 * coefficients.norm());
}

TEST_F(AftResidualTest, SolvesWithItsJacobian) {
  const Eigen::VectorXd r = residual_->residual(lambda_);
  const KrylovSolve solve = residual_->solve_jacobian(r);
  ASSERT_EQ(solve.x.size(), r.size());
  EXPECT_LE((residual_->product(solve.x) - r).norm(), 1e-10 * r.norm());
  EXPECT_GE(solve.condition.value(), 1.0);
}

TEST_F(AftResidualTest, ErrorIsRelativeToTheProjectedPressureOrTheLoad) {
  const Eigen::VectorXd r = residual_->residual(lambda_);
  EXPECT_LE(residual_->error(lambda_, r), r.norm() / (r - lambda_).norm());
  EXPECT_GT(residual_->error(lambda_, r), 0.0);
  // Nothing touches and nothing pulls: there is no error, not even 0 / 0.
  const auto open = residual_with({100.0, 100.0});
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(open->unknowns());
  EXPECT_EQ(open->error(zero, open->residual(zero)), 0.0);
}

/// The oscillator "S-A" under the Lipschitz law, ten harmonics on 320 samples.
struct Scene {
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  ContactReceptance receptance = fourier_receptance(problem, 10);
  Eigen::VectorXd gap = contact_gaps(problem);
  ProjectedLaw law = lipschitz_law(problem, {}, receptance);

  [[nodiscard]] GridSolution solve(const GridSolver& solver, Work& work,
                                   const Eigen::MatrixXcd& previous = {}) const {
    return solver.solve({receptance, gap, law}, 320, previous, {}, work);
  }
};

TEST(AftGridSolver, FindsWhatPivotingFinds) {
  const Scene scene;
  Work work, pivots;
  const GridSolution aft = scene.solve(*aft_grid_solver({}), work);
  const GridSolution lcp = scene.solve(*lcp_grid_solver({}), pivots);
  ASSERT_TRUE(aft.solved) << aft.message;
  ASSERT_TRUE(lcp.solved) << lcp.message;
  EXPECT_LE((aft.lambda - lcp.lambda).norm(), 1e-8 * lcp.lambda.norm());
  EXPECT_EQ(aft.message, "gap homotopy and Newton-Krylov");
}

TEST(AftGridSolver, GoesOnFromTheGridBefore) {
  const Scene scene;
  Work cold, warm;
  const GridSolution first = scene.solve(*aft_grid_solver({}), cold);
  const GridSolution second = scene.solve(*aft_grid_solver({}), warm, first.lambda);
  ASSERT_TRUE(second.solved);
  EXPECT_EQ(second.message, "Newton-Krylov");
  EXPECT_LE(warm.iterations.value(), 1);
  EXPECT_FALSE(warm.pivots);
}

TEST(AftGridSolver, AsksForNoFinerGridWhereNewtonAloneHasLostItsWay) {
  const Scene scene;
  Work work;
  const GridSolution alone = scene.solve(*aft_grid_solver({}, false), work);
  EXPECT_FALSE(alone.solved);
  EXPECT_FALSE(alone.finer_may_help);
  EXPECT_EQ(alone.message, "Newton-Krylov found no descent");
}

TEST(AftGridSolver, KeepsWithinItsLimit) {
  const Scene scene;
  Work work;
  const GridSolution limited = scene.solve(*aft_grid_solver({.max_iterations = 6}), work);
  EXPECT_FALSE(limited.solved);
  EXPECT_LE(work.iterations.value() + work.pivots.value_or(0), 6);
}

TEST(AftGridSolver, ReportsNewtonStepsOfEverySolve) {
  EXPECT_EQ(aft_grid_solver({})->initial_counts().iterations, 0);
  EXPECT_FALSE(lcp_grid_solver({})->initial_counts().iterations);
}

}  // namespace
}  // namespace signorini::aft_grid_solver_test
