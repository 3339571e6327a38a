// Cold starts on a random population of scenes: how often each solver converges, re-checked from outside.

#include "tests/support/population.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::population_test {
namespace {

using Complex = std::complex<double>;
using test::ImpactOscillator;

constexpr int kScenes = 200;
constexpr int kHarmonics = 10;
constexpr int kSamples = 320;  // 32 per harmonic
constexpr int kNodes = 256;
// Of a recomputed equation, relative to its largest term: the solvers stop at 1e-10.
constexpr double kRecheck = 1e-7;

Complex receptance(const ImpactOscillator& o, double w) { return 1.0 / Complex(1.0 - w * w, o.damping * w); }

std::vector<ImpactOscillator> population() { return test::contact_population(kScenes, 20150001); }

struct Tally {
  int converged = 0;
  int pivoted = 0;
  long pivots = 0;
  long most_pivots = 0;

  void add(const Solution& solution) {
    if (solution.verdict != Verdict::converged) return;
    ++converged;
    if (!solution.work.pivots) return;
    ++pivoted;
    pivots += *solution.work.pivots;
    most_pivots = std::max(most_pivots, *solution.work.pivots);
  }
  [[nodiscard]] double percent() const { return 100.0 * converged / kScenes; }
};

void publish(const std::string& what, const Tally& tally) {
  testing::Test::RecordProperty("converged_" + what, tally.converged);
  std::printf("%-34s %3d of %d converged", what.c_str(), tally.converged, kScenes);
  if (tally.pivoted > 0) {
    testing::Test::RecordProperty("most_pivots_" + what, std::to_string(tally.most_pivots));
    std::printf(", pivots mean %.0f, max %ld", static_cast<double>(tally.pivots) / tally.pivoted,
                tally.most_pivots);
  }
  std::printf("\n");
}

// x_n and lambda_n of N samples by direct sums, n = 0..H.
std::vector<Complex> harmonics_of(const Eigen::VectorXd& values) {
  std::vector<Complex> result(kHarmonics + 1);
  for (int n = 0; n <= kHarmonics; ++n) {
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const double turns = static_cast<double>(n * i % values.size()) / static_cast<double>(values.size());
      result[static_cast<std::size_t>(n)] +=
          values[i] / static_cast<double>(values.size()) * std::polar(1.0, -2.0 * std::numbers::pi * turns);
    }
  }
  return result;
}

// The projected contact law of one contact at every sample: -force = max(0, c room - P force), room = x - g,
// for one positive c, lambda_n the coefficients of P force; to kRecheck of `scale`.
void expect_projected_law(const Eigen::ArrayXd& room, const Eigen::ArrayXd& force,
                          const std::vector<Complex>& lambda_n, double scale) {
  Eigen::ArrayXd lambda = Eigen::ArrayXd::Constant(kSamples, lambda_n[0].real());
  for (int i = 0; i < kSamples; ++i) {
    for (int n = 1; n <= kHarmonics; ++n) {
      const double angle = 2.0 * std::numbers::pi * (n * i % kSamples) / kSamples;
      lambda[i] += 2.0 * (lambda_n[static_cast<std::size_t>(n)] * std::polar(1.0, angle)).real();
    }
  }
  // c from the pressing samples by least squares: c room = lambda - force there.
  const Eigen::ArrayXd pressing = (force < 0.0).cast<double>();
  ASSERT_GT(pressing.sum(), 0.0) << "touches nowhere";
  const double c = (pressing * room * (lambda - force)).sum() / (pressing * room.square()).sum();
  EXPECT_GT(c, 0.0);
  EXPECT_LE((force + (c * room - lambda).max(0.0)).abs().maxCoeff(), kRecheck * scale);
}

// Dynamic equilibrium of the harmonics kept, and the projected contact law.
void expect_fourier_solution(const ImpactOscillator& o, const Trajectory& trajectory) {
  const Samples samples = trajectory.sample(kSamples);
  const Eigen::VectorXd x = samples.x.col(0), force = samples.force.col(0);
  const double force_scale = std::max(1.0, force.cwiseAbs().maxCoeff());
  const auto x_n = harmonics_of(x), lambda_n = harmonics_of(force);
  for (int n = 0; n <= kHarmonics; ++n) {
    const auto i = static_cast<std::size_t>(n);
    const Complex load = lambda_n[i] + (n == 1 ? 0.5 : 0.0);
    EXPECT_LE(std::abs(x_n[i] / receptance(o, n * o.frequency) - load), kRecheck * force_scale)
        << "harmonic " << n;
  }
  expect_projected_law(x.array() - o.gap, force, lambda_n, force_scale);
}

// The Galerkin recurrence at every node, and complementarity of force and (x_{k+1} + e x_{k-1}) / (1 + e) <=
// g.
void expect_nodal_solution(const ImpactOscillator& o, const Trajectory& trajectory) {
  const Samples samples = trajectory.sample(kNodes);
  const double step = trajectory.period() / kNodes, e = o.restitution;
  const auto x = [&](int k) { return samples.x((k + kNodes) % kNodes, 0); };
  const auto load = [&](int k) { return std::cos(o.frequency * k * step); };
  const double x_scale = std::max(samples.x.cwiseAbs().maxCoeff(), std::abs(o.gap));
  const double force_scale = std::max(x_scale / (step * step), 1.0);
  for (int k = 0; k < kNodes; ++k) {
    const double force = samples.force(k, 0);
    const double inertia = (x(k + 1) - 2.0 * x(k) + x(k - 1)) / (step * step);
    const double drag = o.damping * (x(k + 1) - x(k - 1)) / (2.0 * step);
    const double spring = (x(k + 1) + 4.0 * x(k) + x(k - 1)) / 6.0;
    const double push = (load(k + 1) + 4.0 * load(k) + load(k - 1)) / 6.0;
    EXPECT_NEAR(inertia + drag + spring, push + force, kRecheck * force_scale) << "node " << k;
    const double room = o.gap - (x(k + 1) + e * x(k - 1)) / (1.0 + e);
    EXPECT_LE(force, 0.0);
    EXPECT_GE(room, -kRecheck * x_scale) << "node " << k;
    const bool presses = force < -kRecheck * force_scale;
    EXPECT_TRUE(!presses || std::abs(room) <= kRecheck * x_scale) << "node " << k;
  }
}

TEST(Population, PivotingSolvesFourierLipschitzEveryTime) {
  Tally pivoting;
  for (const ImpactOscillator& o : population()) {
    SCOPED_TRACE(testing::Message() << "d = " << o.damping << ", g = " << o.gap << ", w = " << o.frequency);
    const Solution solution = test::solve<FourierLipschitz>(
        test::to_problem(o),
        {.common = {.harmonics = kHarmonics, .samples = kSamples, .quadrature = Quadrature::sampled},
         .solver = ComplementaritySolver::pivoting});
    pivoting.add(solution);
    EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
    if (solution.verdict == Verdict::converged) expect_fourier_solution(o, *solution.trajectory);
  }
  publish("fourier-lipschitz[solver=pivoting]", pivoting);
  EXPECT_EQ(pivoting.converged, kScenes);
}

TEST(Population, HatLcpConvergesForEveryRestitution) {
  constexpr double kRestitutions[] = {0.0, 0.5, 0.8, 1.0};
  Tally tally;
  std::size_t index = 0;
  for (ImpactOscillator o : population()) {
    o.restitution = kRestitutions[index++ % std::size(kRestitutions)];
    SCOPED_TRACE(testing::Message() << "d = " << o.damping << ", g = " << o.gap << ", w = " << o.frequency
                                    << ", e = " << o.restitution);
    const Solution solution = test::solve<HatLcp>(test::to_problem(o), {.samples = kNodes});
    tally.add(solution);
    if (solution.verdict == Verdict::converged) expect_nodal_solution(o, *solution.trajectory);
  }
  publish("hat-lcp", tally);
  EXPECT_GE(tally.percent(), 99.0);
}

TEST(Population, TheGapHomotopyOfAftHbmConverges) {
  Tally homotopy;
  for (const ImpactOscillator& o : population()) {
    SCOPED_TRACE(testing::Message() << "d = " << o.damping << ", g = " << o.gap << ", w = " << o.frequency);
    const Solution solution = test::solve<AftHbm>(
        test::to_problem(o),
        {{.harmonics = kHarmonics, .samples = kSamples, .quadrature = Quadrature::sampled}});
    homotopy.add(solution);
    if (solution.verdict == Verdict::converged) expect_fourier_solution(o, *solution.trajectory);
  }
  publish("aft-hbm", homotopy);
  EXPECT_GE(homotopy.percent(), 98.0);
}

// Z x = f + W lambda at every harmonic kept, by dense solves and direct sums, and the projected contact law
// at every contact that touches.
void expect_fourier_solution(const Problem& problem, const Trajectory& trajectory) {
  const Samples samples = trajectory.sample(kSamples);
  const Eigen::MatrixXcd W = Eigen::MatrixXd(contact_directions(problem)).cast<Complex>();
  const Eigen::MatrixXcd M = Eigen::MatrixXd(problem.mass()).cast<Complex>();
  const Eigen::MatrixXcd D = Eigen::MatrixXd(problem.damping()).cast<Complex>();
  const Eigen::MatrixXcd K = Eigen::MatrixXd(problem.stiffness()).cast<Complex>();
  Eigen::MatrixXcd x_n(kHarmonics + 1, problem.contact_count()), lambda_n(x_n.rows(), x_n.cols());
  for (int c = 0; c < problem.contact_count(); ++c) {
    const auto x = harmonics_of(samples.x.col(c)), force = harmonics_of(samples.force.col(c));
    x_n.col(c) = Eigen::Map<const Eigen::VectorXcd>(x.data(), x_n.rows());
    lambda_n.col(c) = Eigen::Map<const Eigen::VectorXcd>(force.data(), x_n.rows());
  }
  const double x_scale = samples.x.cwiseAbs().maxCoeff();
  for (int n = 0; n <= kHarmonics; ++n) {
    const double w = n * problem.frequency;
    const Eigen::VectorXcd load =
        (n == 1 ? 0.5 : 0.0) * load_harmonic(problem, 1) + W * lambda_n.row(n).transpose();
    const Eigen::VectorXcd u = lu_solve(K - w * w * M + Complex(0.0, w) * D, load);
    EXPECT_LE((W.transpose() * u - x_n.row(n).transpose()).norm(), kRecheck * x_scale) << "harmonic " << n;
  }
  for (int c = 0; c < problem.contact_count(); ++c) {
    SCOPED_TRACE(testing::Message() << "contact " << c);
    const double gap = problem.contacts[static_cast<std::size_t>(c)].gap;
    const Eigen::ArrayXd force = samples.force.col(c), room = samples.x.col(c).array() - gap;
    if (force.minCoeff() < 0.0) {
      const std::vector<Complex> coefficients(lambda_n.col(c).begin(), lambda_n.col(c).end());
      expect_projected_law(room, force, coefficients, force.abs().maxCoeff());
    } else {
      EXPECT_LE(room.maxCoeff(), kRecheck * x_scale) << "open and penetrated";
    }
  }
}

TEST(BeamPopulation, PivotingConvergesOnEveryScene) {
  Tally tally;
  for (const Problem& beam : test::beam_population(kScenes)) {
    SCOPED_TRACE(testing::Message() << beam.contact_count() << " stops, w = " << beam.frequency);
    const Solution solution = test::solve<FourierLipschitz>(
        beam, {.common = {.harmonics = kHarmonics, .samples = kSamples, .quadrature = Quadrature::sampled},
               .solver = ComplementaritySolver::pivoting});
    tally.add(solution);
    ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
    expect_fourier_solution(beam, *solution.trajectory);
  }
  publish("fourier-lipschitz, beams", tally);
}

TEST(BeamPopulation, HatLcpConvergesForEveryRestitution) {
  Tally tally;
  for (const Problem& beam : test::beam_population(kScenes))
    tally.add(test::solve<HatLcp>(beam, {.samples = kNodes / 2}));
  publish("hat-lcp, beams", tally);
  EXPECT_GE(tally.percent(), 99.0);
}

TEST(BeamPopulation, TheExactContactIntegralIsFoundOrNotClaimed) {
  Tally tally;
  for (const Problem& beam : test::beam_population(kScenes)) {
    const Solution solution = test::solve<FourierLipschitz>(beam, {{.harmonics = 2 * kHarmonics}});
    tally.add(solution);
    // What is not claimed is a solution that hat functions do not bear out.
    const bool unlike = solution.message.find("away from the motion on hat functions") != std::string::npos;
    EXPECT_TRUE(solution.verdict == Verdict::converged || unlike)
        << beam.contact_count() << " stops: " << solution.message;
  }
  publish("fourier-lipschitz[harmonics=20], beams", tally);
  EXPECT_GE(tally.percent(), 99.0);
}

}  // namespace
}  // namespace signorini::population_test
