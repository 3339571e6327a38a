#include "methods/complementarity/projected_residual.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "methods/discretisation/fourier_series.hpp"

namespace signorini::projected_residual_test {
namespace {

using Complex = std::complex<double>;

constexpr int kHarmonics = 4;

/// Two coupled contacts whose C_n are those of a mass, with a free response that presses now and then.
ContactReceptance coupled() {
  ContactReceptance receptance;
  receptance.free_response = Eigen::MatrixXcd::Zero(kHarmonics + 1, 2);
  receptance.free_response.row(1) << Complex(0.6, 0.2), Complex(-0.3, 0.5);
  for (int n = 0; n <= kHarmonics; ++n) {
    Eigen::Matrix2cd C;
    C << 1.0, 0.4, 0.4, 1.5;
    receptance.receptance.emplace_back(C / Complex(2.0 - n * n, 0.3 * n));
  }
  return receptance;
}

struct Scene {
  ContactReceptance receptance = coupled();
  Eigen::VectorXd gap = Eigen::Vector2d(0.3, 0.2);
  ProjectedLaw law{Eigen::Vector2d(3.0, 5.0), Eigen::Vector2d(1.0, 0.4)};
  [[nodiscard]] ProjectedEquations equations() const { return {receptance, gap, law}; }
};

Eigen::VectorXd some_force() {
  Eigen::MatrixXcd lambda(kHarmonics + 1, 2);
  for (int n = 0; n <= kHarmonics; ++n)
    lambda.row(n) << Complex(-0.3 / (n + 1), 0.1 * n), Complex(-0.2, 0.15 * (n - 2));
  lambda.row(0) = lambda.row(0).real();
  return pack_harmonics(lambda);
}

/// lambda + P max(0, y) with the integral as a sum over so many instants, in the units of the class.
Eigen::VectorXd summed(const Scene& scene, const Eigen::VectorXd& scaled, int samples) {
  const Eigen::VectorXd root = scene.law.constant.cwiseSqrt();
  const Eigen::MatrixXcd lambda = unpack_harmonics(scaled, kHarmonics) * root.asDiagonal();
  const Eigen::MatrixXcd x = contact_motion(scene.receptance, lambda);
  Eigen::MatrixXcd pressed = Eigen::MatrixXcd::Zero(kHarmonics + 1, 2);
  for (int i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / samples;
    for (int c = 0; c < 2; ++c) {
      const double y = scene.law.constant[c] * (trigonometric_jet(x.col(c), t).value - scene.gap[c]) -
                       scene.law.multiplier_weight[c] * trigonometric_jet(lambda.col(c), t).value;
      for (int n = 0; n <= kHarmonics; ++n)
        pressed(n, c) += std::max(0.0, y) / samples * std::polar(1.0, -2.0 * std::numbers::pi * n * t);
    }
  }
  return scaled + pack_harmonics(pressed * root.cwiseInverse().asDiagonal());
}

TEST(ProjectedResidual, OfSamplesIsTheSumOverThem) {
  const Scene scene;
  // 9 = 2 H + 1 samples fold products onto each other; 40 do not.
  for (const int samples : {9, 40}) {
    ProjectedResidual residual(scene.equations(), samples, 1e-10, {}, ContactIntegral::sampled);
    EXPECT_LT((residual.residual(some_force()) - summed(scene, some_force(), samples)).norm(), 1e-13);
  }
}

TEST(ProjectedResidual, ExactIsTheLimitOfManySamples) {
  const Scene scene;
  ProjectedResidual residual(scene.equations(), 64, 1e-10);
  EXPECT_LT((residual.residual(some_force()) - summed(scene, some_force(), 100000)).norm(), 1e-7);
}

// The stop is pressed by the free response. A force that is nothing but rounding keeps it open at a constant
// so large that rounding of y exceeds the true force.
TEST(ProjectedResidual, DoesNotTakeRoundingForTheForceOfAStiffStop) {
  for (const double c : {1e12, 1e16, 1e300}) {
    Scene scene;
    scene.law = {Eigen::Vector2d(c, c), Eigen::Vector2d::Zero()};
    ProjectedResidual residual(scene.equations(), 64, 1e-10);
    const Eigen::VectorXd force =
        Eigen::VectorXd::Constant(2 * (2 * kHarmonics + 1), 1e-3 * residual.rounding());
    EXPECT_GE(residual.error(force, Eigen::VectorXd::Constant(force.size(), 1e-3 * residual.rounding())),
              1.0);
  }
  const Scene usual;
  const ProjectedResidual residual(usual.equations(), 64, 1e-10);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(2 * (2 * kHarmonics + 1));
  EXPECT_EQ(residual.error(none, none), 0.0);
  EXPECT_LT(residual.error(none, Eigen::VectorXd::Constant(none.size(), 0.1 * residual.rounding())), 1e-10);
}

TEST(ProjectedResidual, JacobianIsThatOfDifferences) {
  const Scene scene;
  for (const ContactIntegral integral : {ContactIntegral::exact, ContactIntegral::sampled}) {
    ProjectedResidual residual(scene.equations(), 64, 1e-10, {}, integral);
    const Eigen::VectorXd lambda = some_force();
    (void)residual.residual(lambda);
    const Eigen::MatrixXd jacobian = residual.jacobian();
    for (Eigen::Index i = 0; i < lambda.size(); ++i) {
      constexpr double kStep = 1e-6;
      const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(lambda.size(), i);
      const Eigen::VectorXd slope =
          (residual.residual(lambda + step) - residual.residual(lambda - step)) / (2.0 * kStep);
      EXPECT_LT((slope - jacobian.col(i)).norm(), 1e-7) << i;
    }
  }
}

TEST(ProjectedResidual, SolvesWithTheJacobianOfEitherIntegral) {
  const Scene scene;
  for (const ContactIntegral integral : {ContactIntegral::exact, ContactIntegral::sampled}) {
    ProjectedResidual residual(scene.equations(), 64, 1e-10, {}, integral);
    const Eigen::VectorXd r = residual.residual(some_force());
    const KrylovSolve solve = residual.solve_jacobian(r);
    ASSERT_EQ(solve.x.size(), r.size());
    EXPECT_LE((residual.jacobian() * solve.x - r).norm(), 1e-10 * r.norm());
    EXPECT_GE(solve.condition.value(), 1.0);
  }
}

TEST(ProjectedResidual, TakesAForceInItsUnitsAndBack) {
  const Scene scene;
  const ProjectedResidual residual(scene.equations(), 64, 1e-10);
  const Eigen::MatrixXcd force = residual.force_of(some_force());
  EXPECT_DOUBLE_EQ(force(0, 1).real(),
                   std::sqrt(5.0) * unpack_harmonics(some_force(), kHarmonics)(0, 1).real());
  EXPECT_LE((residual.unknowns_of(force) - some_force()).norm(), 1e-15);
}

TEST(ProjectedResidual, SampledContactsLastFromHalfAStepBeforeToHalfAStepBehind) {
  Scene scene;
  scene.receptance.free_response.setZero();
  scene.receptance.free_response(1, 0) = -0.5;  // x = -cos 2 pi t, beyond the stop around t = 1 / 2
  ProjectedResidual residual(scene.equations(), 8, 1e-10, {}, ContactIntegral::sampled);
  (void)residual.residual(Eigen::VectorXd::Zero(18));
  ASSERT_EQ(residual.contacts()[0].size(), 1U);
  EXPECT_DOUBLE_EQ(residual.contacts()[0][0].begin, 2.5 / 8.0);
  EXPECT_DOUBLE_EQ(residual.contacts()[0][0].end, 5.5 / 8.0);
  EXPECT_TRUE(residual.contacts()[1].empty());
}

}  // namespace
}  // namespace signorini::projected_residual_test
