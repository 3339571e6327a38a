// A bar with an exact solution in time and in frequency: no impact law is involved, no spring either.

#include "tests/reference/distortionless_bar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "methods/discretisation/trajectories.hpp"
#include "methods/event_driven/event_driven.hpp"
#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/harmonic_balance/strategy.hpp"
#include "problems/validation.hpp"
#include "tests/support/accuracy.hpp"

namespace signorini::distortionless_bar_test {
namespace {

using test::DistortionlessBar;
using test::solve;
using test::TipMotion;

constexpr double kImpulse = 1.6912;  // per period, known to 1e-4
constexpr int kFine = 16384;         // grid points per unit of time
constexpr int kPeriods = 60;         // e^{-0.1 * 300}: the start is forgotten

const TipMotion& exact_motion() {
  static const TipMotion motion = test::tip_motion({}, kFine, kPeriods);
  return motion;
}

TEST(DistortionlessBar, CharacteristicsGiveTheKnownMotion) {
  const TipMotion& motion = exact_motion();
  EXPECT_NEAR(motion.impulse, kImpulse, 2e-4);
  const auto at = [&](const std::vector<double>& values, double time) {
    return values[static_cast<std::size_t>(std::lround(time * kFine))];
  };
  EXPECT_NEAR(at(motion.u, 1.5), -0.71204, 1e-3);
  EXPECT_NEAR(at(motion.u, 3.0), -1.52247, 1e-3);
  EXPECT_NEAR(at(motion.u, 4.0), -0.73600, 1e-3);
  EXPECT_NEAR(at(motion.lambda, 0.0), -1.956, 2e-3);
  EXPECT_NEAR(at(motion.lambda, 4.8), -2.577, 2e-3);
}

Solution projected(int harmonics) {
  const auto law = [](const ContactReceptance& receptance) {
    return ProjectedLaw{.constant = 4.0 * highest_dynamic_stiffness(receptance),
                        .multiplier_weight = Eigen::VectorXd::Ones(1)};
  };
  const DistortionlessBar bar;
  const ContactReceptance receptance = test::tip_receptance(bar, harmonics);
  const HarmonicSetup setup{.receptance = receptance,
                            .gap = Eigen::VectorXd::Constant(1, bar.gap),
                            .method = {.law_at = law, .grid_solver = lcp_grid_solver({})},
                            .options = {},
                            .law = law(receptance)};
  Work work;
  return solve_series(setup, {}, work);
}

// Relative L2 distance of samples from a grid function of as many points.
double relative_l2(const Eigen::VectorXd& found, const std::vector<double>& exact) {
  const auto values = Eigen::VectorXd::Map(exact.data(), static_cast<Eigen::Index>(exact.size()));
  return (found - values).norm() / values.norm();
}

// Oracle 5: at the tip of a bar u has kinks and lambda jumps; the rates of best approximation are 3/2 and
// 1/2.
TEST(DistortionlessBar, ProjectedContactTendsToItAtTheRatesOfItsRegularity) {
  const TipMotion& exact = exact_motion();
  std::vector<double> step, u_errors, force_errors;
  for (const int harmonics : {10, 20, 40, 80, 160}) {
    const Solution solution = projected(harmonics);
    ASSERT_EQ(solution.verdict, Verdict::converged) << "H = " << harmonics << ": " << solution.message;
    const Samples samples = solution.trajectory->sample(static_cast<int>(exact.u.size()));
    step.push_back(1.0 / harmonics);
    u_errors.push_back(relative_l2(samples.x.col(0), exact.u));
    force_errors.push_back(relative_l2(samples.force.col(0), exact.lambda));
    const auto& data = dynamic_cast<const FourierTrajectory&>(*solution.trajectory).data();
    if (harmonics < 160) continue;
    EXPECT_NEAR(-data.period * data.lambda(0, 0).real(), kImpulse, 2e-3);
    const double known[] = {0.33704, 0.91862, 0.14621, 0.07905, 0.22366, 0.00555};
    EXPECT_NEAR(data.x(0, 0).real(), -known[0], 1e-3);
    for (Eigen::Index n = 1; n <= 5; ++n) EXPECT_NEAR(2.0 * std::abs(data.x(n, 0)), known[n], 1e-3);
  }
  EXPECT_NEAR(test::observed_order(step, u_errors), 1.5, 0.25);
  EXPECT_GT(test::observed_order(step, force_errors), 0.4);
  EXPECT_LT(test::observed_order(step, force_errors), 0.75);  // 1/2 sets in late: 0.54 from 10 to 640
}

TEST(DistortionlessBar, FiniteElementsWithAMasslessTipTendToIt) {
  const TipMotion& exact = exact_motion();
  std::vector<double> step, errors, impulses;
  for (const int elements : {10, 20, 40, 80}) {
    const Problem problem = test::finite_element_bar({}, elements);
    ASSERT_NO_THROW(validate(problem));
    const Solution solution = solve<EventDriven>(problem, {.tolerance = 1e-8, .flow = Integrator::modal});
    ASSERT_EQ(solution.verdict, Verdict::converged) << elements << ": " << solution.message;
    const Samples samples = solution.trajectory->sample(static_cast<int>(exact.u.size()));
    step.push_back(1.0 / elements);
    errors.push_back(relative_l2(samples.x.col(0), exact.u));
    impulses.push_back(-samples.force.col(0).mean() * exact.period);
  }
  EXPECT_GT(test::observed_order(step, errors), 0.8);
  EXPECT_NEAR(impulses.back(), kImpulse, 0.01);
}

}  // namespace
}  // namespace signorini::distortionless_bar_test
