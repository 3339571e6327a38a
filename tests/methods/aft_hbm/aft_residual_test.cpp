#include "methods/aft_hbm/aft_residual.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "tests/support/impact_oscillator.hpp"

namespace signorini {
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

TEST_F(AftResidualTest, PreconditionerInvertsTheJacobianOfUniformContact) {
  // Without force, y = sqrt(c) (x_f - g): a gap far behind the motion closes a stop throughout, one far ahead
  // of it leaves the stop open. The second stop of the same mass is open.
  for (const double gap : {100.0, -100.0}) {
    const auto uniform = residual_with({gap, 100.0});
    (void)uniform->residual(Eigen::VectorXd::Zero(uniform->unknowns()));
    const Eigen::VectorXd back = uniform->lasting_inverse() * uniform->product(lambda_);
    EXPECT_LE((back - lambda_).norm(), 1e-10 * lambda_.norm()) << gap;
  }
}

TEST_F(AftResidualTest, SolvesWithItsJacobian) {
  const Eigen::VectorXd r = residual_->residual(lambda_);
  const KrylovSolve solve = residual_->solve_jacobian(r);
  ASSERT_EQ(solve.x.size(), r.size());
  EXPECT_LE((residual_->product(solve.x) - r).norm(), 1e-10 * r.norm());
  EXPECT_GE(solve.condition, 1.0);
}

TEST_F(AftResidualTest, ScaleIsTheProjectedPressureOrTheLoad) {
  const Eigen::VectorXd r = residual_->residual(lambda_);
  EXPECT_GE(residual_->scale(lambda_, r), (r - lambda_).norm());
  // Nothing touches and nothing pulls: residual and scale vanish.
  const auto open = residual_with({100.0, 100.0});
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(open->unknowns());
  EXPECT_EQ(open->scale(zero, open->residual(zero)), 0.0);
}

}  // namespace
}  // namespace signorini
