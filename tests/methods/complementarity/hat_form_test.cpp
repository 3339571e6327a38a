#include "methods/complementarity/hat_form.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "methods/structure/receptance.hpp"
#include "tests/support/damped_chain.hpp"

namespace signorini {
namespace {

constexpr int kSamples = 16;

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

class HatFormWith : public testing::TestWithParam<std::optional<double>> {};

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
      if (GetParam()) {
        const double e = *GetParam();
        x = (motion(receptance, pressure, c, k + 1) + e * motion(receptance, pressure, c, k - 1)) / (1.0 + e);
      }
      const double slack = stops.gap[c] - x + stops.compliance[c] * pressure[c * kSamples + k];
      EXPECT_NEAR(w[c * kSamples + k], form.unit[c] * slack, 1e-11) << "contact " << c << ", node " << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Restitutions, HatFormWith,
                         testing::Values(std::optional<double>{}, std::optional<double>{0.0},
                                         std::optional<double>{0.6}, std::optional<double>{1.0}));

TEST(HatForm, HasADiagonalOfOrderOne) {
  const Problem problem = test::damped_chain(3);
  const HatForm form = hat_form(receptance_of(problem), nodal_stops(problem, 0.5), kSamples);
  for (int i = 0; i < 2 * kSamples; ++i) {
    Eigen::VectorXd entry;
    form.lcp.matrix->gather_column(std::vector<int>{i}, i, entry);
    EXPECT_NEAR(std::abs(entry[0]), 1.0, 1e-12);
  }
}

TEST(HatForm, ScalesPressuresBackAndForth) {
  const Problem problem = test::damped_chain(3);
  const HatForm form = hat_form(receptance_of(problem), nodal_stops(problem, std::nullopt), kSamples);
  EXPECT_EQ(form.lcp.samples, kSamples);
  const Eigen::VectorXd z = Eigen::VectorXd::Random(2 * kSamples);
  EXPECT_LE((form.scaled(form.pressure(z)) - z).norm(), 1e-15 * z.norm());
  EXPECT_NEAR(form.pressure(z)[kSamples], form.unit[1] * z[kSamples], 1e-15 * form.unit[1]);
}

TEST(NodalStops, AreCompliantWhereTheSceneHasSprings) {
  Problem problem = test::damped_chain(3);
  EXPECT_EQ(nodal_stops(problem, 0.4).compliance, Eigen::Vector2d::Zero());
  EXPECT_EQ(nodal_stops(problem, 0.4).restitution, 0.4);
  problem.law = Penalty{{50.0, 20.0}};
  const NodalStops stops = nodal_stops(problem, std::nullopt);
  EXPECT_NEAR(stops.compliance[0], 0.02, 1e-17);
  EXPECT_NEAR(stops.compliance[1], 0.05, 1e-17);
  EXPECT_EQ(stops.gap, contact_gaps(problem));
}

}  // namespace
}  // namespace signorini
