#include "methods/structure/receptance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "methods/structure/dynamic_stiffness.hpp"
#include "problems/assembly/beam.hpp"
#include "problems/assembly/chain.hpp"
#include "problems/assembly/damping.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/sparse_cholesky.hpp"
#include "problems/validation.hpp"
#include "tests/support/damped_chain.hpp"
#include "tests/support/elastic_block.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/massless_scenes.hpp"

namespace signorini::receptance_test {
namespace {

TEST(ContactMotion, IsTheFreeMotionAndWhatEachForceAddsHarmonicByHarmonic) {
  ContactReceptance receptance;
  for (int n = 0; n < 4; ++n) receptance.receptance.push_back(Eigen::MatrixXcd::Random(2, 2));
  receptance.free_response = Eigen::MatrixXcd::Random(4, 2);
  const Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Random(6, 2);  // harmonics beyond H do not count
  const Eigen::MatrixXcd x = contact_motion(receptance, lambda);
  ASSERT_EQ(x.rows(), 4);
  for (int n = 0; n < 4; ++n) {
    for (int c = 0; c < 2; ++c) {
      std::complex<double> expected = receptance.free_response(n, c);
      for (int d = 0; d < 2; ++d)
        expected += receptance.receptance[static_cast<std::size_t>(n)](c, d) * lambda(n, d);
      EXPECT_LE(std::abs(x(n, c) - expected), 1e-14);
    }
  }
}

TEST(ContactReceptance, CountsItsHarmonicsAndContacts) {
  ContactReceptance receptance;
  receptance.receptance.assign(8, Eigen::MatrixXcd::Zero(3, 3));
  receptance.free_response = Eigen::MatrixXcd::Zero(8, 3);
  EXPECT_EQ(receptance.harmonics(), 7);
  EXPECT_EQ(receptance.contacts(), 3);
}

// 40 contacts: more columns than are solved for at a time.
TEST(FactorisedReceptance, IsTheInverseOfEachDynamicStiffnessSeenByTheContacts) {
  constexpr int kHarmonics = 4;
  const Problem problem = test::damped_chain(45, 40);
  const Eigen::MatrixXd directions(contact_directions(problem));
  const auto weights = [](int n) { return scheme_weights(HatScheme::galerkin, 0.4 * n, 0.3); };
  for (const bool dense : {true, false}) {
    const ContactReceptance receptance = factorised_receptance(problem, kHarmonics, weights, dense);
    ASSERT_EQ(receptance.harmonics(), kHarmonics);
    for (int n = 0; n <= kHarmonics; ++n) {
      const HarmonicWeights w = weights(n);
      const Eigen::MatrixXcd inverse =
          signorini::inverse(test::dense_stiffness(problem, w.mass, w.damping, w.stiffness));
      const Eigen::MatrixXcd expected = directions.transpose() * inverse * directions;
      EXPECT_LE((receptance.receptance[static_cast<std::size_t>(n)] - expected).norm(),
                1e-11 * expected.norm());
      const Eigen::VectorXcd free =
          directions.transpose() * inverse * (w.load * load_coefficient(problem, n));
      EXPECT_LE((receptance.free_response.row(n).transpose() - free).norm(), 1e-11 * (1e-3 + free.norm()));
    }
  }
}

TEST(FactorisedReceptance, DropsLoadsBeyondItsHarmonics) {
  const Problem problem = test::damped_chain(5);  // loaded at harmonics 0, 1 and 3
  const auto weights = [](int n) { return exact_weights(1.3 * n); };
  const ContactReceptance few = factorised_receptance(problem, 2, weights, true);
  const ContactReceptance more = factorised_receptance(problem, 3, weights, true);
  EXPECT_EQ(few.free_response, more.free_response.topRows(3));
  EXPECT_EQ(few.free_response.row(2).norm(), 0.0);
  EXPECT_GT(more.free_response.row(3).norm(), 0.0);
}

/// Masses in a row, unequal, with loads and contacts away from each other.
Problem chain_problem(int masses) {
  Problem problem;
  problem.name = "chain";
  problem.kind = "chain";
  problem.edit_structure([&](Structure& s) {
    s.mass = SparseMatrix(masses, masses);
    s.damping = SparseMatrix(masses, masses);
    s.stiffness = SparseMatrix(masses, masses);
    for (int i = 0; i < masses; ++i) {
      s.mass.insert(i, i) = 1.0 + 0.1 * i;
      s.stiffness.insert(i, i) = 2.0 + 0.3 * i;
      s.damping.insert(i, i) = 0.02 * (i + 1);
      if (i + 1 == masses) continue;
      s.stiffness.insert(i, i + 1) = -1.0;
      s.stiffness.insert(i + 1, i) = -1.0;
    }
  });
  problem.frequency = 1.3;
  problem.force = {{0, 1, 1.0, 0.5}, {masses - 1, 3, 0.0, 0.7}, {0, 0, 0.25, 0.0}};
  problem.contacts = {{{{masses - 1, 1.0}}, 0.1}, {{{0, 0.6}, {1, -0.8}}, 0.2}};
  problem.set_law(Restitution{1.0});
  validate(problem);
  return problem;
}

class ReceptanceOfChain : public testing::TestWithParam<int> {};

TEST_P(ReceptanceOfChain, MatchesTheDenseInverse) {
  const Problem problem = chain_problem(GetParam());
  const ContactReceptance receptance = fourier_receptance(problem, 5);
  const Eigen::MatrixXcd m = Eigen::MatrixXd(problem.mass()).cast<std::complex<double>>();
  const Eigen::MatrixXcd d = Eigen::MatrixXd(problem.damping()).cast<std::complex<double>>();
  const Eigen::MatrixXcd k = Eigen::MatrixXd(problem.stiffness()).cast<std::complex<double>>();
  const Eigen::MatrixXcd w = Eigen::MatrixXd(contact_directions(problem)).cast<std::complex<double>>();
  for (int n = 0; n <= 5; ++n) {
    const double omega = 1.3 * n;
    const Eigen::MatrixXcd z = k - omega * omega * m + std::complex<double>(0.0, omega) * d;
    const Eigen::MatrixXcd inverse = signorini::inverse(z);
    const Eigen::MatrixXcd expected = w.transpose() * inverse * w;
    EXPECT_LE((receptance.receptance[static_cast<std::size_t>(n)] - expected).norm(),
              1e-12 * expected.norm());
    const Eigen::VectorXcd load = (n == 0 ? 1.0 : 0.5) * load_harmonic(problem, n);
    const Eigen::VectorXcd free = w.transpose() * inverse * load;
    EXPECT_LE((receptance.free_response.row(n).transpose() - free).norm(), 1e-12 * (free.norm() + 1e-300));
  }
}

// 3 masses take the dense path, 60 the sparse one.
INSTANTIATE_TEST_SUITE_P(DenseAndSparse, ReceptanceOfChain, testing::Values(3, 60));

TEST(ContactReceptance, OfASubharmonicMotionCarriesTheLoadAtItsOwnHarmonic) {
  Problem problem = test::to_problem({.frequency = 4.0, .gap = 0.1});
  problem.subharmonic = 2;
  const ContactReceptance receptance = fourier_receptance(problem, 4);
  EXPECT_DOUBLE_EQ(receptance.period, std::numbers::pi);
  EXPECT_EQ(std::abs(receptance.free_response(1, 0)), 0.0);
  const std::complex<double> expected = 0.5 / std::complex<double>(1.0 - 16.0, 0.4);
  EXPECT_LE(std::abs(receptance.free_response(2, 0) - expected), 1e-15);
  const std::complex<double> half = 1.0 / std::complex<double>(1.0 - 4.0, 0.2);
  EXPECT_LE(std::abs(receptance.receptance[1](0, 0) - half), 1e-15);
}

TEST(ContactReceptance, RefusesAnUndampedResonance) {
  Problem problem = test::to_problem({.damping = 0.0, .frequency = 1.0, .gap = 0.1});
  EXPECT_THROW(fourier_receptance(problem, 2), std::runtime_error);
}

TEST(InertialLimit, IsThatOfTheMassWithAnErrorOfFourthOrder) {
  constexpr double kDamping = 0.1, kFrequency = 2.2;
  const Problem mass = test::to_problem({.damping = kDamping, .frequency = kFrequency, .gap = 0.2});
  const double a = std::pow(kFrequency, -2), b = kDamping * std::pow(kFrequency, -3);  // of 1 kg
  const auto error = [&](int harmonics) {
    const InertialLimit limit = inertial_limit(fourier_receptance(mass, harmonics));
    EXPECT_NEAR(limit.b(0, 0), b, 1e-2 * b);
    return std::abs(limit.a(0, 0) / a - 1.0);
  };
  const double coarse = error(20), fine = error(40);
  EXPECT_LE(coarse, 1e-4);
  EXPECT_GT(coarse / fine, 12.0);
  EXPECT_LT(coarse / fine, 20.0);
}

TEST(IsMassBeyond, TellsAMassFromWhatAnswersOtherwise) {
  const Problem mass = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  EXPECT_TRUE(is_mass_beyond(fourier_receptance(mass, 20), 0, 10));
  EXPECT_FALSE(is_mass_beyond(fourier_receptance(test::massless_node(), 20), 0, 10));
  // An eigenfrequency among the harmonics beyond.
  const Problem slow = test::to_problem({.damping = 0.1, .frequency = 0.07, .gap = 0.2});
  EXPECT_FALSE(is_mass_beyond(fourier_receptance(slow, 20), 0, 10));
}

}  // namespace
}  // namespace signorini::receptance_test
