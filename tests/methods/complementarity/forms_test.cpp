#include "methods/complementarity/forms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "methods/structure/receptance.hpp"
#include "tests/support/damped_chain.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::forms_test {
namespace {

/// scale (sum_{|n| <= H} x_n e^{2 pi i n k / N} - gap) by a direct sum over the first `kept` coefficients.
double direct(const Eigen::VectorXcd& x, double gap, double scale, int k, int samples, Eigen::Index kept) {
  double sum = x[0].real();
  for (Eigen::Index n = 1; n < kept; ++n) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(n) * k / samples;
    sum += 2.0 * (x[n] * std::polar(1.0, angle)).real();
  }
  return scale * (sum - gap);
}

TEST(FreePenetration, IsTheScaledDistanceBeyondTheStopAtEveryInstant) {
  constexpr int kSamples = 16;
  Eigen::MatrixXcd response = Eigen::MatrixXcd::Random(5, 2);
  response.row(0) = response.row(0).real().cast<std::complex<double>>();
  const Eigen::Vector2d gap(0.3, -0.1), scale(2.0, 0.5);
  const Eigen::VectorXd penetration = free_penetration(response, gap, scale, kSamples);
  ASSERT_EQ(penetration.size(), 2 * kSamples);
  for (int c = 0; c < 2; ++c) {
    for (int k = 0; k < kSamples; ++k) {
      EXPECT_NEAR(penetration[c * kSamples + k], direct(response.col(c), gap[c], scale[c], k, kSamples, 5),
                  1e-13);
    }
  }
}

TEST(FreePenetration, DropsHarmonicsThatTheGridDoesNotCarry) {
  constexpr int kSamples = 7;  // carries harmonics 0..3
  Eigen::MatrixXcd response = Eigen::MatrixXcd::Random(9, 1);
  response(0, 0) = 0.4;
  const Eigen::VectorXd gap = Eigen::VectorXd::Zero(1), scale = Eigen::VectorXd::Ones(1);
  const Eigen::VectorXd penetration = free_penetration(response, gap, scale, kSamples);
  for (int k = 0; k < kSamples; ++k)
    EXPECT_NEAR(penetration[k], direct(response.col(0), 0.0, 1.0, k, kSamples, 4), 1e-13);
}

using Complex = std::complex<double>;

constexpr int kSamples = 16;
constexpr int kHarmonics = 3;
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
  const Eigen::VectorXd gap = contact_gaps(problem);
  Lcp lcp = projected_lcp(receptance, gap, law, kSamples);
  Eigen::VectorXd z(kSamples);
  for (int i = 0; i < kSamples; ++i) z[i] = 1.0 + std::sin(1.0 + i * i);
  const double root = std::sqrt(law.constant[0]);
  const Eigen::VectorXd w = root * (lcp.offset + *lcp.matrix * Eigen::VectorXd(z / root));
  Eigen::VectorXd lambda;
  const Eigen::VectorXd x = motion_under(receptance, z, &lambda);
  const Eigen::VectorXd y = law.constant[0] * (x.array() - 0.2).matrix() - law.multiplier_weight[0] * lambda;
  EXPECT_LE((w - (z - y)).norm(), 1e-12 * w.norm());
  const Eigen::MatrixXcd forces = force_coefficients(law, z / root, kSamples, kHarmonics);
  EXPECT_LE((root * augmented_multiplier({receptance, gap, law}, forces, kSamples) - y).norm(),
            1e-12 * y.norm());
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

/// x_c at node k under nodal pressures (contact by contact), by direct sums over harmonics and nodes.
double motion(const ContactReceptance& receptance, const Eigen::VectorXd& pressure, int c, int k) {
  double x = 0.0;
  for (int n = -kSamples / 2 + 1; n <= kSamples / 2; ++n) {
    const auto place = static_cast<std::size_t>(std::abs(n));
    std::complex<double> value = receptance.free_response(std::abs(n), c);
    for (Eigen::Index d = 0; d < receptance.contacts(); ++d) {
      std::complex<double> lambda = 0.0;
      for (int i = 0; i < kSamples; ++i) {
        lambda -= pressure[d * kSamples + i] *
                  std::polar(1.0 / kSamples, -2.0 * std::numbers::pi * std::abs(n) * i / kSamples);
      }
      value += receptance.receptance[place](c, d) * lambda;
    }
    if (n < 0) value = std::conj(value);
    x += (value * std::polar(1.0, 2.0 * std::numbers::pi * n * k / kSamples)).real();
  }
  return x;
}

/// Galerkin, whose symbol is real up to damping at N / 2, so that nodal values are those of a real operator.
ContactReceptance receptance_of(const Problem& problem) {
  const double step = problem.period() / kSamples;
  return contact_receptance(problem, kSamples / 2, [step](int n) {
    return scheme_weights(HatScheme::galerkin, 2.0 * std::numbers::pi * n / kSamples, step);
  });
}

class HatFormWith : public testing::TestWithParam<NodalRestitution> {};

TEST_P(HatFormWith, HasForItsSlackTheDistanceThatTheImpactLawLooksAt) {
  const Problem problem = test::damped_chain(3);
  const ContactReceptance receptance = receptance_of(problem);
  NodalStops stops = nodal_stops(problem, GetParam());
  stops.compliance << 0.3, 0.0;
  const HatForm form = hat_form(receptance, stops, kSamples);
  const Eigen::VectorXd z = Eigen::VectorXd::Random(2 * kSamples).cwiseAbs();
  const Eigen::VectorXd pressure = form.pressure(z);
  const Eigen::VectorXd w = form.lcp.offset + *form.lcp.matrix * z;
  for (int c = 0; c < 2; ++c) {
    for (int k = 0; k < kSamples; ++k) {
      double x = motion(receptance, pressure, c, k);
      if (stops.restitution[static_cast<std::size_t>(c)]) {
        const double e = *stops.restitution[static_cast<std::size_t>(c)];
        x = (motion(receptance, pressure, c, k + 1) + e * motion(receptance, pressure, c, k - 1)) / (1.0 + e);
      }
      const double slack = stops.gap[c] - x + stops.compliance[c] * pressure[c * kSamples + k];
      EXPECT_NEAR(w[c * kSamples + k], form.unit[c] * slack, 1e-11) << "contact " << c << ", node " << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Restitutions, HatFormWith,
                         testing::Values(NodalRestitution{}, NodalRestitution{0.0, 0.0},
                                         NodalRestitution{0.6, 0.6}, NodalRestitution{1.0, 1.0},
                                         NodalRestitution{std::nullopt, 0.6}, NodalRestitution{0.9, 0.2}));

TEST(HatForm, HasADiagonalOfOrderOne) {
  const Problem problem = test::damped_chain(3);
  const HatForm form = hat_form(receptance_of(problem), nodal_stops(problem, {0.5, 0.5}), kSamples);
  for (int i = 0; i < 2 * kSamples; ++i) {
    EXPECT_NEAR(std::abs(form.lcp.matrix->submatrix({&i, 1}, {&i, 1})(0, 0)), 1.0, 1e-12);
  }
}

TEST(HatForm, ScalesPressuresBackAndForth) {
  const Problem problem = test::damped_chain(3);
  const HatForm form = hat_form(receptance_of(problem), nodal_stops(problem, {}), kSamples);
  EXPECT_EQ(form.lcp.samples, kSamples);
  const Eigen::VectorXd z = Eigen::VectorXd::Random(2 * kSamples);
  EXPECT_LE((form.scaled(form.pressure(z)) - z).norm(), 1e-15 * z.norm());
  EXPECT_NEAR(form.pressure(z)[kSamples], form.unit[1] * z[kSamples], 1e-15 * form.unit[1]);
}

TEST(NodalStops, AreCompliantWhereTheSceneHasSprings) {
  Problem problem = test::damped_chain(3);
  EXPECT_EQ(nodal_stops(problem, {0.4, 0.4}).compliance, Eigen::Vector2d::Zero());
  problem.set_law(Penalty{{50.0, 20.0}});
  const NodalStops stops = nodal_stops(problem, {});
  EXPECT_NEAR(stops.compliance[0], 0.02, 1e-17);
  EXPECT_NEAR(stops.compliance[1], 0.05, 1e-17);
  EXPECT_EQ(stops.gap, contact_gaps(problem));
}

TEST(SceneRestitution, IsThatOfEachRigidContactWithMass) {
  Problem problem = test::damped_chain(3);
  problem.contacts[0].law = Spring{50.0};
  problem.contacts[1].law = Restitution{0.4};
  EXPECT_EQ(scene_restitution(problem), (NodalRestitution{std::nullopt, 0.4}));
}

}  // namespace
}  // namespace signorini::forms_test
