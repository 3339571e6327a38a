#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "methods/structure/receptance.hpp"
#include "problems/assembly/beam.hpp"
#include "problems/assembly/chain.hpp"
#include "problems/assembly/damping.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "problems/sparse_cholesky.hpp"
#include "tests/support/elastic_block.hpp"

namespace signorini::reduced_receptance_test {
namespace {

constexpr double kTolerance = 1e-10;

using test::harmonics_of;

/// Largest difference of the receptances of a harmonic, relative to its norm.
double difference(const ContactReceptance& a, const ContactReceptance& b) {
  double largest = 0.0;
  for (std::size_t n = 0; n < b.receptance.size(); ++n) {
    largest = std::max(largest, (a.receptance[n] - b.receptance[n]).norm() / b.receptance[n].norm());
  }
  return largest;
}

/// Reduced, receptances and free response are those of every harmonic factorised.
void expect_tolerance(const Problem& problem, int harmonics, const WeightsOfHarmonic& weights) {
  const auto reduced = reduced_receptance(problem, harmonics, weights, kTolerance);
  ASSERT_TRUE(reduced);
  const ContactReceptance whole = factorised_receptance(problem, harmonics, weights, true);
  EXPECT_LE(difference(reduced->value, whole), kTolerance);
  EXPECT_LE((reduced->value.free_response - whole.free_response).norm(),
            kTolerance * whole.free_response.norm());
}

/// A uniform bar of length, stiffness and density 1, clamped at one end, in linear elements; its tip may meet
/// a stop.
Problem uniform_bar(int elements, double beta, double frequency) {
  std::vector<Eigen::Triplet<double>> mass;
  std::vector<Eigen::Triplet<double>> stiffness;
  const double h = 1.0 / elements;
  for (int i = 0; i < elements; ++i) {
    const bool tip = i + 1 == elements;
    mass.emplace_back(i, i, tip ? h / 3.0 : 2.0 * h / 3.0);
    stiffness.emplace_back(i, i, tip ? 1.0 / h : 2.0 / h);
    if (tip) continue;
    for (const auto& [row, column] : {std::pair(i, i + 1), std::pair(i + 1, i)}) {
      mass.emplace_back(row, column, h / 6.0);
      stiffness.emplace_back(row, column, -1.0 / h);
    }
  }
  Problem problem;
  problem.edit_structure([&](Structure& s) {
    s.mass = s.stiffness = SparseMatrix(elements, elements);
    s.mass.setFromTriplets(mass.begin(), mass.end());
    s.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
    s.damping = beta * s.stiffness;
  });
  problem.frequency = frequency;
  problem.contacts = {{{{elements - 1, 1.0}}, 0.1}};
  problem.force = {{elements - 1, 1, 1.0, 0.0}};
  return problem;
}

struct Case {
  const char* name;
  test::ElasticBlock block;
  int harmonics;
};
void PrintTo(const Case& scene, std::ostream* out) { *out << scene.name; }

class ReducedReceptanceOfBlock : public testing::TestWithParam<Case> {};

// The oracle: a dense factorisation of every Z_n.
TEST_P(ReducedReceptanceOfBlock, MeetsTheToleranceItPromises) {
  const Problem problem = test::elastic_block_problem(GetParam().block);
  const auto weights = harmonics_of(problem);
  const auto reduced = reduced_receptance(problem, GetParam().harmonics, weights, kTolerance);
  ASSERT_TRUE(reduced);
  const ContactReceptance dense = factorised_receptance(problem, GetParam().harmonics, weights, true);
  EXPECT_LE(difference(reduced->value, dense), kTolerance);
  for (int n = 0; n <= GetParam().harmonics; ++n) {
    const auto row = static_cast<Eigen::Index>(n);
    EXPECT_LE((reduced->value.free_response.row(row) - dense.free_response.row(row)).norm(),
              kTolerance * dense.free_response.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Blocks, ReducedReceptanceOfBlock,
    testing::Values(Case{"damped", {.alpha = 0.02, .beta = 0.02, .frequency = 0.3}, 8},
                    Case{"light damping", {.beta = 1e-4, .frequency = 0.35}, 10},
                    Case{"nine contacts", {.nx = 5, .side = 3, .beta = 0.01, .frequency = 0.2}, 12},
                    Case{"no damping, below the first resonance", {.frequency = 0.1}, 3}));

TEST(ReducedReceptance, MeetsWhateverTolerance) {
  const Problem problem = test::elastic_block_problem({.side = 3, .beta = 0.02, .frequency = 0.4});
  const auto weights = harmonics_of(problem);
  const ContactReceptance dense = factorised_receptance(problem, 8, weights, true);
  for (const double tolerance : {1e-1, 1e-3, 1e-5, 1e-7}) {
    const auto reduced = reduced_receptance(problem, 8, weights, tolerance);
    ASSERT_TRUE(reduced);
    EXPECT_LE(difference(reduced->value, dense), tolerance);
  }
}

TEST(ReducedReceptance, OfADampedBarApproachesTheClosedFormWithOrderTwo) {
  constexpr double kBeta = 0.01;
  constexpr double kFrequency = 0.9;
  double last = 0.0;
  for (const int elements : {40, 80, 160}) {
    const Problem problem = uniform_bar(elements, kBeta, kFrequency);
    const auto reduced = reduced_receptance(problem, 6, harmonics_of(problem), kTolerance);
    ASSERT_TRUE(reduced);
    double error = 0.0;
    for (int n = 1; n <= 6; ++n) {
      const double w = n * kFrequency;
      const std::complex<double> modulus(1.0, kBeta * w);
      const std::complex<double> k = w / std::sqrt(modulus);
      const std::complex<double> exact = std::tan(k) / (modulus * k);
      error = std::max(error,
                       std::abs(reduced->value.receptance[static_cast<std::size_t>(n)](0, 0) / exact - 1.0));
    }
    if (last > 0.0) {
      EXPECT_NEAR(std::log2(last / error), 2.0, 0.1) << elements;
    }
    last = error;
  }
}

TEST(ReducedReceptance, TakesMasslessContacts) {
  Problem problem = uniform_bar(60, 0.01, 0.9);
  SparseMatrix keep(60, 60);
  keep.setIdentity();
  keep.coeffRef(59, 59) = 0.0;
  problem.edit_structure([&](Structure& s) {
    s.mass = SparseMatrix(keep * s.mass * keep);
    s.damping = 0.01 * s.stiffness;
  });
  const auto weights = harmonics_of(problem);
  const auto reduced = reduced_receptance(problem, 10, weights, kTolerance);
  ASSERT_TRUE(reduced);
  EXPECT_LE(difference(reduced->value, factorised_receptance(problem, 10, weights, true)), kTolerance);
}

/// Weights of a harmonic that are not those of the undiscretised equation.
HarmonicWeights hat_weights(int n, int nodes, double period) {
  const double theta = 2.0 * std::numbers::pi * n / nodes;
  const double step = period / nodes;
  const double gram = (2.0 + std::cos(theta)) / 3.0;
  return {-(2.0 - 2.0 * std::cos(theta)) / (step * step), std::complex<double>(0.0, std::sin(theta) / step),
          gram, gram};
}

HarmonicWeights backward_weights(int n, int nodes, double period) {
  const double step = period / nodes;
  const std::complex<double> s = (1.0 - std::polar(1.0, -2.0 * std::numbers::pi * n / nodes)) / step;
  return {s * s, s, 1.0, 1.0};
}

// At the highest harmonic, theta = pi, the damping weight of hat functions is zero: the error is an estimate.
TEST(ReducedReceptance, TakesTheWeightsOfHatFunctionsAndOfBackwardDifferences) {
  constexpr int kNodes = 16;
  const Problem problem =
      test::elastic_block_problem({.side = 2, .alpha = 0.02, .beta = 0.02, .frequency = 0.2});
  for (const auto scheme : {hat_weights, backward_weights}) {
    const auto weights = [&](int n) { return scheme(n, kNodes, problem.period()); };
    expect_tolerance(problem, kNodes / 2, weights);
  }
}

// Without damping the error is an estimate: below the first resonance, and among them.
TEST(ReducedReceptance, MeetsItsToleranceAmongUndampedResonances) {
  for (const double frequency : {0.1, 0.45}) {
    const Problem problem = test::elastic_block_problem({.frequency = frequency});
    const auto weights = harmonics_of(problem);
    const auto reduced = reduced_receptance(problem, 4, weights, kTolerance);
    ASSERT_TRUE(reduced);
    const ContactReceptance dense = factorised_receptance(problem, 4, weights, true);
    EXPECT_LE(difference(reduced->value, dense), kTolerance) << frequency;
  }
}

// Hat functions do not damp the highest harmonic of their grid; here it falls among the block's modes.
TEST(ReducedReceptance, HoldsBetweenModesThatNothingDamps) {
  const Problem problem = test::elastic_block_problem(
      {.nx = 8, .ny = 4, .nz = 4, .side = 2, .alpha = 0.01, .beta = 0.01, .frequency = 0.2});
  constexpr int kSamples = 64;
  const auto weights = [&](int n) {
    return scheme_weights(HatScheme::galerkin, 2.0 * std::numbers::pi * n / kSamples,
                          problem.period() / kSamples);
  };
  EXPECT_LT(std::abs(weights(kSamples / 2).damping), 1e-12);
  expect_tolerance(problem, kSamples / 2, weights);
}

TEST(ReducedReceptance, LeavesModalDampingToOthers) {
  Problem problem = test::elastic_block_problem({.nx = 3, .ny = 2, .nz = 3, .frequency = 0.2});
  problem.edit_structure([&](Structure& s) {
    s.damping = damping_matrix(ModalDamping{{0.01, 0.03}}, s.mass, s.stiffness);
  });
  EXPECT_FALSE(reduced_receptance(problem, 4, harmonics_of(problem), kTolerance));
}

// What the rounding of P^{-1} may leave: the bound is one in exact arithmetic.
double rounding(const Problem& problem) {
  const Eigen::VectorXd values = symmetric_eigenvalues(Eigen::MatrixXd(problem.stiffness()));
  return std::numeric_limits<double>::epsilon() * values.tail(1)(0) / values(0);
}

/// A beam or a chain like no other, with some contacts and a load.
Problem random_structure(int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto among = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
  Structure structure;
  if (seed % 2 == 0) {
    structure = assemble(Beam{.elements = 20 + among(20), .length = uniform(0.5, 2.0)});
  } else {
    Chain chain;
    const int masses = 40 + among(40);
    for (int i = 0; i < masses; ++i) {
      chain.masses.push_back(uniform(0.5, 2.0));
      chain.springs.push_back(uniform(0.5, 2.0));
      chain.dampers.push_back(0.0);
    }
    chain.links = {{.first = 0, .second = masses / 2, .spring = uniform(0.1, 1.0), .damper = 0.0}};
    structure = assemble(chain);
  }
  Problem problem;
  problem.edit_structure([&](Structure& s) {
    s.mass = structure.mass;
    s.stiffness = structure.stiffness;
  });
  const auto size = static_cast<int>(problem.mass().rows());
  // The lowest frequency, by a few steps of inverse iteration, tells what is slow and what is little damping.
  const Eigen::SimplicialLDLT<SparseMatrix> factors(problem.stiffness());
  Eigen::VectorXd shape = Eigen::VectorXd::Ones(size);
  for (int i = 0; i < 30; ++i) shape = factors.solve(problem.mass() * shape).normalized();
  const double lowest = std::sqrt(shape.dot(problem.stiffness() * shape) / shape.dot(problem.mass() * shape));
  problem.edit_structure([&](Structure& s) {
    s.damping = uniform(0.0, 0.05) * lowest * s.mass + uniform(0.001, 0.05) / lowest * s.stiffness;
  });
  problem.frequency = lowest * uniform(0.3, 1.5);
  for (int c = 0; c <= among(4); ++c) problem.contacts.push_back({{{(7 * c + among(7)) % size, 1.0}}, 0.1});
  problem.force = {{among(size), 1, 1.0, uniform(-1.0, 1.0)}, {among(size), 2, 0.0, 0.5}};
  return problem;
}

TEST(ReducedReceptance, MeetsItsToleranceOnAPopulationOfBeamsAndChains) {
  constexpr int kStructures = 40;
  constexpr int kHarmonics = 5;
  int reduced_ones = 0;
  for (int seed = 0; seed < kStructures; ++seed) {
    const Problem problem = random_structure(seed);
    const auto weights = harmonics_of(problem);
    const auto reduced = reduced_receptance(problem, kHarmonics, weights, kTolerance);
    if (!reduced) continue;  // as dear as factorisations: small and banded structures may be
    ++reduced_ones;
    const ContactReceptance direct = factorised_receptance(problem, kHarmonics, weights, false);
    const double allowed = kTolerance + rounding(problem);
    ASSERT_LE(allowed, 1e-7) << "structure " << seed;
    EXPECT_LE(difference(reduced->value, direct), allowed) << "structure " << seed;
    EXPECT_LE((reduced->value.free_response - direct.free_response).norm(),
              allowed * direct.free_response.norm())
        << "structure " << seed;
  }
  EXPECT_GE(reduced_ones, kStructures / 4);
}

TEST(ReducedReceptance, LeavesOtherDampingToFactorisations) {
  Problem problem = test::elastic_block_problem({.beta = 0.01});
  problem.edit_structure([&](Structure& s) { s.damping.coeffRef(0, 0) += 1.0; });
  EXPECT_FALSE(reduced_receptance(problem, 3, harmonics_of(problem), kTolerance));
  const auto weights = harmonics_of(problem);
  EXPECT_EQ(contact_receptance(problem, 3, weights).receptance,
            factorised_receptance(problem, 3, weights, false).receptance);
}

TEST(ReducedReceptance, RefusesAFreeStructureAtRest) {
  Problem problem = uniform_bar(60, 0.01, 0.9);
  problem.edit_structure([&](Structure& s) {
    s.stiffness.coeffRef(0, 0) = 60.0;  // one spring less: nothing holds the bar
    s.damping = 0.01 * s.stiffness;
  });
  EXPECT_THROW(reduced_receptance(problem, 3, harmonics_of(problem), kTolerance), SingularStiffness);
}

TEST(ContactReceptance, OfALargeStructureIsReducedWithoutBeingAsked) {
  const Problem problem =
      test::elastic_block_problem({.nx = 9, .ny = 8, .nz = 8, .side = 2, .beta = 0.02, .frequency = 0.2});
  ASSERT_GT(problem.size(), 2000);
  const auto weights = harmonics_of(problem);
  const ContactReceptance automatic = contact_receptance(problem, 5, weights);
  EXPECT_EQ(automatic.receptance, reduced_receptance(problem, 5, weights, kTolerance)->value.receptance);
  const ContactReceptance direct = factorised_receptance(problem, 5, weights, false);
  EXPECT_LE(difference(automatic, direct), kTolerance);
}

}  // namespace
}  // namespace signorini::reduced_receptance_test
