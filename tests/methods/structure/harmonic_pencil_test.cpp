#include "methods/structure/harmonic_pencil.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "methods/structure/dynamic_stiffness.hpp"
#include "methods/structure/receptance.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"
#include "tests/support/damped_chain.hpp"

namespace signorini::harmonic_pencil_test {
namespace {

using Complex = std::complex<double>;

TEST(HarmonicPencils, AddUpToTheDynamicStiffness) {
  constexpr int kHarmonics = 5;
  constexpr double kShift = 0.7;
  const Problem problem = test::damped_chain(6);  // D = 0.05 M + 0.01 K
  const auto weights = [](int n) { return scheme_weights(HatScheme::galerkin, 0.5 * n + 0.1, 0.2); };
  const auto pencils =
      harmonic_pencils({0.05, 0.01}, kShift, kHarmonics, weights, pencil_loads(problem, kHarmonics, weights));
  const Eigen::MatrixXd m(problem.mass());
  const Eigen::MatrixXd p = Eigen::MatrixXd(problem.stiffness()) + kShift * m;
  ASSERT_EQ(pencils.size(), 6U);
  for (int n = 0; n <= kHarmonics; ++n) {
    const HarmonicPencil& pencil = pencils[static_cast<std::size_t>(n)];
    const HarmonicWeights w = weights(n);
    const Eigen::MatrixXcd z = test::dense_stiffness(problem, w.mass, w.damping, w.stiffness);
    EXPECT_LE((pencil.kappa * p + pencil.mu * m - z).norm(), 1e-13 * z.norm());
  }
}

TEST(PencilLoads, GiveBackEachHarmonicsLoadBehindTheContacts) {
  constexpr int kHarmonics = 5;
  const Problem problem = test::damped_chain(6, 3);
  const auto weights = [](int n) { return scheme_weights(HatScheme::galerkin, 0.5 * n, 0.2); };
  const PencilLoads loads = pencil_loads(problem, kHarmonics, weights);
  const Eigen::MatrixXd columns(loads.columns);
  EXPECT_EQ(Eigen::MatrixXd(contact_directions(problem)), columns.leftCols(3));
  const Eigen::MatrixXd f = columns.rightCols(columns.cols() - 3);
  for (int n = 0; n <= kHarmonics; ++n) {
    const Eigen::VectorXcd exact = weights(n).load * load_coefficient(problem, n);
    const Eigen::VectorXcd& weight = loads.weight[static_cast<std::size_t>(n)];
    EXPECT_EQ(weight.size() == 0, exact.isZero(0.0)) << "harmonic " << n;
    if (weight.size() == 0) continue;
    EXPECT_LE((f * weight - exact).norm(), 1e-15);
  }
}

TEST(HarmonicPencils, RefuseAShiftedStructureAtRest) {
  const Problem problem = test::damped_chain(4);
  const auto weights = [](int n) { return exact_weights(1.0 * n); };
  const PencilLoads loads = pencil_loads(problem, 1, weights);
  EXPECT_THROW(harmonic_pencils({0.0, 0.0}, 1.0, 1, weights, loads), SingularStiffness);
  EXPECT_NO_THROW(harmonic_pencils({0.0, 0.0}, 0.0, 1, weights, loads));
}

TEST(DistanceFromSingular, IsTheLeastModulusAlongTheSpectrum) {
  const Eigen::Vector3d theta(0.1, 0.8, 2.5);
  for (const Complex mu : {Complex(-1.0, 0.3), Complex(2.0, 0.1), Complex(0.0, 1.0), Complex(0.0, 0.0)}) {
    const HarmonicPencil pencil{.kappa = {1.2, 0.05}, .mu = mu, .load = {}};
    double least = std::abs(pencil.kappa);
    for (int k = 0; k <= 100000; ++k) least = std::min(least, std::abs(pencil.kappa + mu * (2.5e-5 * k)));
    const double distance = distance_from_singular(pencil, theta);
    EXPECT_NEAR(distance, least, 1e-4 * least);
    EXPECT_LE(distance, least * (1.0 + 1e-14));
  }
}

TEST(DistanceFromSingular, WithoutDampingLooksAtTheEigenvaluesAlone) {
  const Eigen::Vector3d theta(0.1, 0.8, 2.5);
  const HarmonicPencil undamped{.kappa = 1.0, .mu = -1.0, .load = {}};  // singular at theta = 1
  EXPECT_NEAR(distance_from_singular(undamped, theta), 0.2, 1e-15);
}

constexpr int kHarmonics = 6;
constexpr double kTolerance = 1e-8;

HarmonicWeights weights(int n) { return exact_weights(0.2 * n); }

/// Largest error of the projected receptances, relative to the exact ones.
double projected_error(const BlockLanczos& space, const std::vector<HarmonicPencil>& pencils,
                       const ContactReceptance& exact) {
  const Eigen::MatrixXcd t = space.projected_mass().cast<std::complex<double>>();
  const Eigen::MatrixXcd r = space.projected_start().leftCols(2).cast<std::complex<double>>();
  double largest = 0.0;
  for (std::size_t n = 0; n < pencils.size(); ++n) {
    Eigen::MatrixXcd z = pencils[n].mu * t;
    z.diagonal().array() += pencils[n].kappa;
    const Eigen::MatrixXcd projected = r.transpose() * ComplexLuFactors(z).solve(r);
    const Eigen::MatrixXcd& c = exact.receptance[n];
    largest = std::max(largest, (projected - c).norm() / c.norm());
  }
  return largest;
}

TEST(PencilElimination, EndsWhereTheProjectionSufficesForEveryHarmonicAndNotMuchLater) {
  const Problem problem = test::damped_chain(120);
  const PencilLoads loads = pencil_loads(problem, kHarmonics, weights);
  const auto pencils = harmonic_pencils({0.05, 0.01}, 0.0, kHarmonics, weights, loads);
  const ContactReceptance exact = factorised_receptance(problem, kHarmonics, weights, true);
  BlockLanczos space(problem.stiffness(), problem.mass(), loads.columns);
  ASSERT_TRUE(space.definite());
  const Eigen::VectorXd theta = symmetric_eigenvalues(space.projected_mass());
  PencilElimination elimination(space, pencils, problem.contact_count());
  int growths = 0;
  while (!elimination.advance(kTolerance, theta)) {
    ASSERT_FALSE(space.exhausted());
    space.grow();
    elimination.take_newest_block();
    ++growths;
  }
  EXPECT_GT(growths, 2);
  EXPECT_LT(projected_error(space, pencils, exact), kTolerance);
  EXPECT_LT(space.size(), 60);  // of 120
}

TEST(PencilModes, HaveNoBoundWhereALoadIsNotANumber) {
  const Problem problem = test::damped_chain(30);
  const PencilLoads loads = pencil_loads(problem, kHarmonics, weights);
  auto pencils = harmonic_pencils({0.05, 0.01}, 0.0, kHarmonics, weights, loads);
  BlockLanczos space(problem.stiffness(), problem.mass(), loads.columns);
  const PencilModes modes(space, problem.contact_count());
  const auto loaded =
      std::find_if(pencils.begin(), pencils.end(), [](const HarmonicPencil& p) { return p.load.size() > 0; });
  ASSERT_NE(loaded, pencils.end());
  EXPECT_TRUE(std::isfinite(modes.relative_error(*loaded).all));
  loaded->load.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(std::isinf(modes.relative_error(*loaded).all));
  EXPECT_TRUE(std::isinf(modes.relative_error(*loaded).outside));
}

// kappa + mu theta of an eigenvalue is its last bit.
TEST(PencilModes, HaveNoInverseWhereAnUndampedVectorResonatesToRounding) {
  const Problem problem = test::damped_chain(30);
  BlockLanczos space(problem.stiffness(), problem.mass(), pencil_loads(problem, 1, weights).columns);
  const PencilModes modes(space, problem.contact_count());
  const double lowest = modes.theta()[0], highest = modes.theta()[modes.theta().size() - 1];
  const auto pencil = [](double kappa) { return HarmonicPencil{.kappa = kappa, .mu = -1.0, .load = {}}; };
  const HarmonicPencil resonant = pencil(std::nextafter(lowest, 2.0 * lowest));
  EXPECT_FALSE(modes.inverse_of(resonant));
  EXPECT_TRUE(std::isinf(modes.relative_error(resonant).all));
  EXPECT_TRUE(modes.inverse_of(pencil(2.0 * highest)));
}

TEST(StartColumns, AreTheContactsAndTheHarmonicsOwnLoad) {
  const Eigen::MatrixXd rows = Eigen::MatrixXd::Random(4, 5);
  HarmonicPencil pencil;
  EXPECT_EQ(start_columns(pencil, rows, 2), rows.leftCols(2).cast<std::complex<double>>());
  pencil.load = Eigen::VectorXcd::Random(3);
  const Eigen::MatrixXcd columns = start_columns(pencil, rows, 2);
  ASSERT_EQ(columns.cols(), 3);
  EXPECT_LE((columns.col(2) - rows.rightCols(3) * pencil.load).norm(), 1e-15);
}

}  // namespace
}  // namespace signorini::harmonic_pencil_test
