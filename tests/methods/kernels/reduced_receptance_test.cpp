#include "methods/kernels/reduced_receptance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/definiteness.hpp"
#include "problems/sparse_cholesky.hpp"
#include "tests/support/brick.hpp"

namespace signorini {
namespace {

constexpr double kTolerance = 1e-10;

std::function<HarmonicWeights(int)> harmonics_of(const Problem& problem) {
  return [base = problem.base_frequency()](int n) { return exact_weights(n * base); };
}

/// Largest difference of the receptances of a harmonic, relative to its norm.
double difference(const ContactReceptance& a, const ContactReceptance& b) {
  double largest = 0.0;
  for (std::size_t n = 0; n < b.receptance.size(); ++n) {
    largest = std::max(largest, (a.receptance[n] - b.receptance[n]).norm() / b.receptance[n].norm());
  }
  return largest;
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
  problem.mass = problem.stiffness = SparseMatrix(elements, elements);
  problem.mass.setFromTriplets(mass.begin(), mass.end());
  problem.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  problem.damping = beta * problem.stiffness;
  problem.frequency = frequency;
  problem.contacts = {{{{elements - 1, 1.0}}, 0.1}};
  problem.force = {{elements - 1, 1, 1.0, 0.0}};
  return problem;
}

struct Case {
  const char* name;
  test::Brick brick;
  int harmonics;
};
void PrintTo(const Case& scene, std::ostream* out) { *out << scene.name; }

class ReducedReceptanceOfBrick : public testing::TestWithParam<Case> {};

// The oracle: a dense factorisation of every Z_n.
TEST_P(ReducedReceptanceOfBrick, MeetsTheToleranceItPromises) {
  const Problem problem = test::to_problem(GetParam().brick);
  const auto weights = harmonics_of(problem);
  const auto reduced = reduced_receptance(problem, GetParam().harmonics, weights, kTolerance);
  ASSERT_TRUE(reduced);
  const ContactReceptance dense =
      contact_receptance(problem, GetParam().harmonics, weights, ReceptanceMethod::dense);
  EXPECT_EQ(reduced->report.method, ReceptanceMethod::reduced);
  EXPECT_LT(reduced->report.basis, problem.size());
  EXPECT_LE(*reduced->report.error, kTolerance);
  EXPECT_LE(difference(*reduced, dense), kTolerance);
  for (int n = 0; n <= GetParam().harmonics; ++n) {
    const auto row = static_cast<Eigen::Index>(n);
    EXPECT_LE((reduced->free_response.row(row) - dense.free_response.row(row)).norm(),
              kTolerance * dense.free_response.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Bricks, ReducedReceptanceOfBrick,
    testing::Values(Case{"damped", {.alpha = 0.02, .beta = 0.02, .frequency = 0.3}, 8},
                    Case{"light damping", {.beta = 1e-4, .frequency = 0.35}, 10},
                    Case{"nine contacts", {.nx = 5, .side = 3, .beta = 0.01, .frequency = 0.2}, 12},
                    Case{"no damping, below the first resonance", {.frequency = 0.1}, 3}));

TEST(ReducedReceptance, BoundsItsErrorWhateverItsTolerance) {
  const Problem problem = test::to_problem({.side = 3, .beta = 0.02, .frequency = 0.4});
  const auto weights = harmonics_of(problem);
  const ContactReceptance dense = contact_receptance(problem, 8, weights, ReceptanceMethod::dense);
  for (const double tolerance : {1e-1, 1e-3, 1e-5, 1e-7}) {
    const auto reduced = reduced_receptance(problem, 8, weights, tolerance);
    ASSERT_TRUE(reduced);
    EXPECT_TRUE(reduced->report.bound);
    EXPECT_LE(*reduced->report.error, tolerance);
    // What rounding leaves where the bound is far below it.
    EXPECT_LE(difference(*reduced, dense), *reduced->report.error + 1e-12);
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
      error = std::max(error, std::abs(reduced->receptance[static_cast<std::size_t>(n)](0, 0) / exact - 1.0));
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
  problem.mass = SparseMatrix(keep * problem.mass * keep);
  problem.damping = 0.01 * problem.stiffness;
  const auto weights = harmonics_of(problem);
  const auto reduced = reduced_receptance(problem, 10, weights, kTolerance);
  ASSERT_TRUE(reduced);
  EXPECT_LE(difference(*reduced, contact_receptance(problem, 10, weights, ReceptanceMethod::dense)),
            kTolerance);
}

TEST(ReducedReceptance, LeavesOtherDampingToFactorisations) {
  Problem problem = test::to_problem(test::Brick{.beta = 0.01});
  problem.damping.coeffRef(0, 0) += 1.0;
  EXPECT_FALSE(reduced_receptance(problem, 3, harmonics_of(problem), kTolerance));
  const auto automatic = contact_receptance(problem, 3, harmonics_of(problem));
  EXPECT_EQ(automatic.report.method, ReceptanceMethod::direct);
}

TEST(ReducedReceptance, RefusesAFreeStructureAtRest) {
  Problem problem = uniform_bar(60, 0.01, 0.9);
  problem.stiffness.coeffRef(0, 0) = 60.0;  // one spring less: nothing holds the bar
  problem.damping = 0.01 * problem.stiffness;
  EXPECT_THROW(reduced_receptance(problem, 3, harmonics_of(problem), kTolerance), SingularStiffness);
}

TEST(ContactReceptance, OfALargeStructureIsReducedWithoutBeingAsked) {
  const Problem problem =
      test::to_problem({.nx = 9, .ny = 8, .nz = 8, .side = 2, .beta = 0.02, .frequency = 0.2});
  ASSERT_GT(problem.size(), 2000);
  const auto weights = harmonics_of(problem);
  const ContactReceptance automatic = contact_receptance(problem, 5, weights);
  EXPECT_EQ(automatic.report.method, ReceptanceMethod::reduced);
  const ContactReceptance direct = contact_receptance(problem, 5, weights, ReceptanceMethod::direct);
  EXPECT_EQ(direct.report.method, ReceptanceMethod::direct);
  EXPECT_LE(difference(automatic, direct), kTolerance);
}

TEST(SparseCholesky, TellsDefiniteFromIndefiniteAndSolves) {
  const Problem problem = test::to_problem(test::Brick{});
  SparseCholesky factors(problem.stiffness);
  EXPECT_GT(factors.smallest_pivot(), 1e-3);
  const Eigen::MatrixXd u = Eigen::MatrixXd::Random(problem.size(), 3);
  EXPECT_LE((factors.solve(problem.stiffness * u) - u).norm(), 1e-11 * u.norm());
  const SparseMatrix indefinite = problem.stiffness - 100.0 * problem.mass;
  EXPECT_LE(SparseCholesky(indefinite).smallest_pivot(), 0.0);
}

TEST(Definiteness, OfLargeMatricesIsJudgedByCurvature) {
  const Problem problem = test::to_problem({.nx = 9, .ny = 8, .nz = 8});
  EXPECT_TRUE(is_semidefinite(problem.stiffness));
  EXPECT_TRUE(is_definite(problem.stiffness));
  // The lowest eigenfrequency of the brick lies below 1 rad/s: this matrix is indefinite by a single
  // direction or few.
  EXPECT_FALSE(is_semidefinite(problem.stiffness - 1.0 * problem.mass));
}

}  // namespace
}  // namespace signorini
