#include "methods/complementarity/forms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

using Complex = std::complex<double>;

constexpr int kHarmonics = 3;
constexpr int kSamples = 16;

/// x at the samples under pressures z: x_f + C lambda with lambda = -P z, by sums over samples and harmonics.
Eigen::VectorXd motion_under(const ContactReceptance& receptance, const Eigen::VectorXd& z,
                             Eigen::VectorXd* lambda_samples) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(kSamples);
  *lambda_samples = Eigen::VectorXd::Zero(kSamples);
  for (int n = 0; n <= kHarmonics; ++n) {
    Complex lambda = 0.0;
    for (int i = 0; i < kSamples; ++i)
      lambda -= z[i] * std::polar(1.0 / kSamples, -2.0 * std::numbers::pi * n * i / kSamples);
    const Complex motion =
        receptance.free_response(n, 0) + receptance.receptance[static_cast<std::size_t>(n)](0, 0) * lambda;
    for (int i = 0; i < kSamples; ++i) {
      const Complex turn = std::polar(n == 0 ? 1.0 : 2.0, 2.0 * std::numbers::pi * n * i / kSamples);
      x[i] += (motion * turn).real();
      (*lambda_samples)[i] += (lambda * turn).real();
    }
  }
  return x;
}

/// w = q + A z as the form has it, and as the contact law says: w = z - y, y = c (x - g) - alpha lambda.
void expect_form_of(const ProjectedLaw& law) {
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  const ContactReceptance receptance = fourier_receptance(problem, kHarmonics);
  Lcp lcp = projected_lcp(receptance, contact_gaps(problem), law, kSamples);
  Eigen::VectorXd z(kSamples);
  for (int i = 0; i < kSamples; ++i) z[i] = 1.0 + std::sin(1.0 + i * i);
  const double root = std::sqrt(law.constant[0]);
  const Eigen::VectorXd w = root * (lcp.offset + *lcp.matrix * Eigen::VectorXd(z / root));
  Eigen::VectorXd lambda;
  const Eigen::VectorXd x = motion_under(receptance, z, &lambda);
  const Eigen::VectorXd y = law.constant[0] * (x.array() - 0.2).matrix() - law.multiplier_weight[0] * lambda;
  EXPECT_LE((w - (z - y)).norm(), 1e-12 * w.norm());
}

TEST(ProjectedLcp, IsTheLipschitzForm) {
  expect_form_of({Eigen::VectorXd::Constant(1, 20.0), Eigen::VectorXd::Ones(1)});
}

TEST(ProjectedLcp, IsThePenaltyForm) {
  expect_form_of({Eigen::VectorXd::Constant(1, 20.0), Eigen::VectorXd::Zero(1)});
}

TEST(ForceCoefficients, AreThoseOfMinusTheProjectedPressure) {
  const ProjectedLaw law{Eigen::VectorXd::Constant(1, 9.0), Eigen::VectorXd::Ones(1)};
  Eigen::VectorXd z(kSamples);
  for (int i = 0; i < kSamples; ++i)
    z[i] = 2.0 + std::cos(2.0 * std::numbers::pi * i / kSamples) +
           std::sin(14.0 * std::numbers::pi * i / kSamples);
  const Eigen::MatrixXcd lambda = force_coefficients(law, z, kSamples, kHarmonics);
  ASSERT_EQ(lambda.rows(), kHarmonics + 1);
  EXPECT_LE(std::abs(lambda(0, 0) + 6.0), 1e-14);
  EXPECT_LE(std::abs(lambda(1, 0) + 1.5), 1e-14);
  EXPECT_LE(lambda.bottomRows(2).norm(), 1e-14);  // harmonic 7 is projected away
}

}  // namespace
}  // namespace signorini
