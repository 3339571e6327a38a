// Robustness of cold starts on a seeded population of one-mass scenes (tests/support/population.hpp).

#include "tests/support/population.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <complex>
#include <numbers>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "methods/kernels/trajectories.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "tests/support/accuracy.hpp"

namespace signorini {
namespace {

constexpr int kScenes = 200;
constexpr std::array kRestitutions{0.0, 0.5, 0.8, 1.0};

std::vector<Problem> scenes(bool cycle_restitution) {
  std::vector<Problem> all;
  for (auto oscillator : test::contact_population(kScenes)) {
    if (cycle_restitution) oscillator.restitution = kRestitutions[all.size() % kRestitutions.size()];
    all.push_back(test::to_problem(oscillator));
  }
  return all;
}

struct Tally {
  int converged = 0;
  long steps = 0;  // pivots, or iterations where there are none
  long most_steps = 0;
};

/// Largest violation of the method's own contact conditions on its grid, seen through the trajectory alone.
using Check = double (*)(const Problem&, const Trajectory&, int samples);

template <class M>
Tally run(const std::string& what, const std::vector<Problem>& problems, const typename M::Options& options,
          Check check, int samples) {
  Tally tally;
  for (const Problem& problem : problems) {
    const Solution solution = test::solve<M>(problem, options);
    const long steps = solution.work.pivots.value_or(solution.work.iterations.value_or(0));
    tally.steps += steps;
    tally.most_steps = std::max(tally.most_steps, steps);
    if (solution.verdict != Verdict::converged) continue;
    ++tally.converged;
    if (check != nullptr) {
      EXPECT_LE(check(problem, *solution.trajectory, samples), 1e-8)
          << what << ", gap " << problem.contacts[0].gap;
    }
  }
  fmt::print("{:44} {:3} of {} converged, steps mean {:.0f}, most {}\n", what, tally.converged,
             problems.size(), static_cast<double>(tally.steps) / static_cast<double>(problems.size()),
             tally.most_steps);
  testing::Test::RecordProperty(what, tally.converged);
  return tally;
}

/// lambda + P max(0, y) = 0 on the grid: the projection of the sampled force is the force's own series.
double projected_violation(const Problem&, const Trajectory& trajectory, int samples) {
  const auto& data = dynamic_cast<const FourierTrajectory&>(trajectory).data();
  const Eigen::VectorXd force = trajectory.sample(samples).force.col(0);
  double worst = 0.0;
  for (Eigen::Index n = 0; n < data.lambda.rows(); ++n) {
    std::complex<double> sum = 0.0;
    for (int i = 0; i < samples; ++i) {
      const double phase = -2.0 * std::numbers::pi * static_cast<double>(n) * i / samples;
      sum += force[i] * std::polar(1.0 / samples, phase);
    }
    worst = std::max(worst, std::abs(sum - data.lambda(n, 0)));
  }
  const double scale = data.lambda.cwiseAbs().maxCoeff();
  return scale > 0.0 ? worst / scale : worst;
}

/// w = g - (x_+ + e x_-)/(1+e) >= 0 and lambda w = 0 at the nodes, relative to the amplitude.
double nodal_violation(const Problem& problem, const Trajectory& trajectory, int samples) {
  const Samples motion = trajectory.sample(samples);
  const double e = std::get<Restitution>(problem.law).e;
  const double amplitude = motion.x.cwiseAbs().maxCoeff();
  const double largest = std::max(1e-300, -motion.force.minCoeff());
  double worst = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double after = motion.x((i + 1) % samples, 0);
    const double before = motion.x((i + samples - 1) % samples, 0);
    const double room = problem.contacts[0].gap - (after + e * before) / (1.0 + e);
    worst = std::max({worst, -room / amplitude, std::abs(room * motion.force(i, 0)) / (amplitude * largest)});
  }
  return worst;
}

TEST(Population, FourierLipschitzConvergesOnEverySceneByPivoting) {
  const auto problems = scenes(false);
  FourierLipschitz::Options options{.harmonics = 10,
                                    .samples = 320,
                                    .quadrature = Quadrature::sampled,
                                    .solver = ComplementaritySolver::pivoting};
  const Tally pivoting = run<FourierLipschitz>("fourier-lipschitz, pivoting, H=10 N=320", problems, options,
                                               projected_violation, 320);
  EXPECT_EQ(pivoting.converged, kScenes);
  options.solver = ComplementaritySolver::newton;
  const Tally newton = run<FourierLipschitz>("fourier-lipschitz, newton, H=10 N=320", problems, options,
                                             projected_violation, 320);
  EXPECT_LT(newton.converged, pivoting.converged);
}

TEST(Population, HatLcpConvergesOnNinetyNinePercentForEveryRestitution) {
  const auto problems = scenes(true);
  const Tally tally =
      run<HatLcp>("hat-lcp, auto, N=256, e in {0,.5,.8,1}", problems, {.samples = 256}, nodal_violation, 256);
  EXPECT_GE(tally.converged, kScenes * 99 / 100);
  const Tally newton =
      run<HatLcp>("hat-lcp, newton, N=256, e in {0,.5,.8,1}", problems,
                  {.samples = 256, .solver = ComplementaritySolver::newton}, nodal_violation, 256);
  EXPECT_LT(newton.converged, tally.converged);
}

TEST(Population, PenaltyHbmConvergesOnEveryScene) {
  const Tally tally =
      run<PenaltyHbm>("penalty-hbm, auto, H=10", scenes(false), {.harmonics = 10}, nullptr, 0);
  EXPECT_EQ(tally.converged, kScenes);
}

TEST(Population, AftHbmConvergesOnNinetyEightPercent) {
  const auto problems = scenes(false);
  AftHbm::Options options{.harmonics = 10, .samples = 320, .quadrature = Quadrature::sampled};
  const Tally tally =
      run<AftHbm>("aft-hbm, homotopy, H=10 N=320", problems, options, projected_violation, 320);
  EXPECT_GE(tally.converged, kScenes * 98 / 100);
  options.homotopy = false;
  const Tally newton = run<AftHbm>("aft-hbm, Newton alone, H=10 N=320", problems, options, nullptr, 320);
  EXPECT_LT(newton.converged, tally.converged);
}

}  // namespace
}  // namespace signorini
