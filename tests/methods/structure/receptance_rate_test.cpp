#include "methods/structure/receptance_rate.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <complex>
#include <numbers>

#include "tests/support/impact_oscillator.hpp"

namespace signorini::receptance_rate_test {
namespace {

using Complex = std::complex<double>;

TEST(ReceptanceWithRate, IsTheClosedFormOfOneMass) {
  const Problem problem = with_subharmonic(test::to_problem({.damping = 0.3, .frequency = 1.7}), 2);
  const ReceptanceRate found =
      receptance_with_rate(problem, 5, [](int n) { return exact_weights(n * 1.7 / 2.0); });
  for (int n = 0; n <= 5; ++n) {
    const double share = n / 2.0, w = share * 1.7;  // of the harmonic
    const Complex Z(1.0 - w * w, 0.3 * w), slope = share * Complex(-2.0 * w, 0.3);
    const auto i = static_cast<std::size_t>(n);
    EXPECT_LT(std::abs(found.value.receptance[i](0, 0) - 1.0 / Z), 1e-14);
    EXPECT_LT(std::abs(found.receptance[i](0, 0) + slope / (Z * Z)), 1e-14);
    const Complex load = n == 2 ? 0.5 : 0.0;  // cos(omega t), of both signs of n
    EXPECT_LT(std::abs(found.value.free_response(n, 0) - load / Z), 1e-14);
    EXPECT_LT(std::abs(found.free_response(n, 0) + load * slope / (Z * Z)), 1e-14);
  }
}

TEST(ReceptanceWithRate, AgreesWithDifferencesOnAGridOfEveryScheme) {
  constexpr int kSamples = 16;
  for (const HatScheme scheme : {HatScheme::galerkin, HatScheme::nodal, HatScheme::backward}) {
    const auto at = [&](double frequency) {
      const Problem problem = test::to_problem({.damping = 0.2, .frequency = frequency});
      return receptance_with_rate(problem, kSamples / 2, [&](int n) {
        return scheme_weights(scheme, 2.0 * std::numbers::pi * n / kSamples, problem.period() / kSamples);
      });
    };
    constexpr double kStep = 1e-5;
    const ReceptanceRate below = at(1.3 - kStep), here = at(1.3), above = at(1.3 + kStep);
    for (std::size_t n = 0; n < here.receptance.size(); ++n) {
      const Complex slope =
          (above.value.receptance[n](0, 0) - below.value.receptance[n](0, 0)) / (2.0 * kStep);
      EXPECT_LT(std::abs(here.receptance[n](0, 0) - slope), 1e-8 * (1.0 + std::abs(slope))) << n;
    }
  }
}

TEST(ReceptanceWithRate, IsThatOfTheOthersBesideAPartThatNoContactFeels) {
  const Problem alone = test::to_problem({.damping = 0.3, .frequency = 1.7});
  Problem beside = alone;
  beside.edit_structure([](Structure& s) {
    for (SparseMatrix* A : {&s.mass, &s.damping, &s.stiffness}) A->conservativeResize(2, 2);
    s.mass.coeffRef(1, 1) = 1.0;
  });
  const auto weights = [](int n) { return exact_weights(n * 1.7); };
  const ReceptanceRate expected = receptance_with_rate(alone, 3, weights),
                       found = receptance_with_rate(beside, 3, weights);
  EXPECT_EQ(found.value.rigid.cols(), 0);
  for (std::size_t n = 0; n <= 3; ++n) {
    ASSERT_EQ(found.receptance[n].size(), 1) << n;
    EXPECT_LT((found.value.receptance[n] - expected.value.receptance[n]).norm(), 1e-14) << n;
    EXPECT_LT((found.receptance[n] - expected.receptance[n]).norm(), 1e-14) << n;
  }
  EXPECT_LT((found.free_response - expected.free_response).norm(), 1e-14);
}

// An unbalance: f = 0.4 omega^2 cos(omega t), so that x = 0.2 omega^2 / Z of each sign of n.
TEST(ReceptanceWithRate, HasThePartOfALoadThatGrows) {
  Problem problem = test::to_problem({.damping = 0.3, .frequency = 1.7});
  problem.force = {{.dof = 0, .cos = 0.4, .omega_power = 2}};
  const ReceptanceRate found = receptance_with_rate(problem, 2, [](int n) { return exact_weights(n * 1.7); });
  const Complex Z(1.0 - 1.7 * 1.7, 0.3 * 1.7), slope(-2.0 * 1.7, 0.3);
  EXPECT_LT(std::abs(found.value.free_response(1, 0) - 0.2 * 1.7 * 1.7 / Z), 1e-14);
  EXPECT_LT(std::abs(found.free_response(1, 0) - (0.4 * 1.7 / Z - 0.2 * 1.7 * 1.7 * slope / (Z * Z))), 1e-14);
}

// A disc in two directions that its gyroscopic moment and a seal couple, both growing with its speed. The
// inverse of [a b; -b a] has a / (a^2 + b^2) on its diagonal.
TEST(ReceptanceWithRate, HasThePartsOfMatricesThatFollowTheFrequency) {
  const auto matrix = [](double diagonal, double skew) {
    return SparseMatrix((Eigen::Matrix2d() << diagonal, skew, -skew, diagonal).finished().sparseView());
  };
  Problem disc;
  disc.edit_structure([&](Structure& s) {
    s.mass = matrix(1.0, 0.0);
    s.damping = matrix(0.2, 0.0);
    s.stiffness = matrix(3.0, 0.0);
    follow_speed(s, matrix(0.0, 0.3), matrix(0.0, 0.1));
  });
  disc.contacts = {{.normal = {{0, 1.0}}, .gap = 1.0}};
  const auto at = [&](double frequency) {
    return receptance_with_rate(at_frequency(disc, frequency), 3,
                                [&](int n) { return exact_weights(n * frequency); });
  };
  constexpr double kSpeed = 1.3, kStep = 1e-5;
  const ReceptanceRate below = at(kSpeed - kStep), here = at(kSpeed), above = at(kSpeed + kStep);
  for (std::size_t n = 0; n <= 3; ++n) {
    const double w = static_cast<double>(n) * kSpeed;
    const Complex diagonal(3.0 - w * w, 0.2 * w), skew = kSpeed * (Complex(0.0, 0.3 * w) + 0.1);
    const Complex expected = diagonal / (diagonal * diagonal + skew * skew);
    EXPECT_LT(std::abs(here.value.receptance[n](0, 0) - expected), 1e-14) << n;
    const Complex slope = (above.value.receptance[n](0, 0) - below.value.receptance[n](0, 0)) / (2.0 * kStep);
    EXPECT_LT(std::abs(here.receptance[n](0, 0) - slope), 1e-8 * (1.0 + std::abs(slope))) << n;
  }
}

TEST(ReceptanceWithRate, OfAnUndampedResonanceIsRefused) {
  const Problem problem = test::to_problem({.damping = 0.0, .frequency = 1.0});
  EXPECT_THROW(receptance_with_rate(problem, 3, [](int n) { return exact_weights(n); }), SingularStiffness);
}

}  // namespace
}  // namespace signorini::receptance_rate_test
