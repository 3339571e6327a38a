// Free vibrations of a bar with a stop at its end: no load, no damping, no impact law.

#include "tests/reference/nonsmooth_bar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "methods/flow/event_trajectory.hpp"
#include "methods/flow/flow.hpp"
#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/harmonic_balance/strategy.hpp"
#include "problems/assembly/beam.hpp"
#include "problems/validation.hpp"
#include "tests/support/accuracy.hpp"

namespace signorini::nonsmooth_bar_test {
namespace {

using test::NonsmoothBar;

// No harmonic is near a resonance; ratios of small whole numbers are, and have further motions.
const double kIrrationalPeriod = 3.5 + std::numbers::sqrt2 / 10.0;

TEST(NonsmoothBar, ClosedFormMeetsTheConditionsOfContact) {
  constexpr int kInstants = 2000;
  constexpr double kStep = 1e-3;  // in space, at the end of the bar
  for (const double period : {3.15, 3.3, 3.5, 3.7, kIrrationalPeriod}) {
    const NonsmoothBar bar{.period = period};
    int closed = 0;
    for (int i = 0; i < kInstants; ++i) {
      const double t = period * (i + 0.5) / kInstants, u = bar.u(1.0, t);
      const double force = bar.force(t), from_centre = std::abs(std::remainder(t, period));
      EXPECT_LE(u, force < 0.0 ? bar.gap + 1e-14 : bar.gap);
      EXPECT_GE(u, force < 0.0 ? bar.gap - 1e-14 : -2.0 * bar.strain() - 1e-14);
      closed += force < 0.0 ? 1 : 0;
      EXPECT_NEAR(bar.u(0.0, t), 0.0, 1e-14);
      EXPECT_NEAR(bar.u(0.3, t + period), bar.u(0.3, t), 1e-13);
      // Fronts are at the end of the bar when the contact begins or ends, and half a period away from it.
      const bool front =
          std::abs(from_centre - 0.5 * bar.contact_duration()) < kStep || 0.5 * period - from_centre < kStep;
      if (front) continue;
      EXPECT_NEAR((u - bar.u(1.0 - kStep, t)) / kStep, force, 1e-11) << "t " << t;
    }
    EXPECT_NEAR(closed * period / kInstants, bar.contact_duration(), 2.0 * period / kInstants);
  }
}

// C_n = tan(n w) / (n w) for the tip.
ContactReceptance tip_receptance(const NonsmoothBar& bar, int harmonics) {
  ContactReceptance result{
      .period = bar.period, .receptance = {}, .free_response = Eigen::MatrixXcd::Zero(harmonics + 1, 1)};
  for (int n = 0; n <= harmonics; ++n) {
    const double k = 2.0 * std::numbers::pi * n / bar.period;
    result.receptance.emplace_back(Eigen::MatrixXcd::Constant(1, 1, n == 0 ? 1.0 : std::tan(k) / k));
  }
  return result;
}

// Energy at mid-contact, t = 0, of the bar under a tip force whose harmonics are real: the velocity is zero,
// the strain is sum_n lambda_n cos(n w x) / cos(n w).
double energy_at_mid_contact(const Eigen::MatrixXcd& lambda, double period) {
  constexpr int kPoints = 4000;
  double energy = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double x = (i + 0.5) / kPoints;
    double strain = 0.0;
    for (Eigen::Index n = 0; n < lambda.rows(); ++n) {
      const double k = 2.0 * std::numbers::pi * static_cast<double>(n) / period;
      strain += (n == 0 ? 1.0 : 2.0) * lambda(n, 0).real() * std::cos(k * x) / std::cos(k);
    }
    energy += 0.5 * strain * strain / kPoints;
  }
  return energy;
}

LawAt constant(double c) {
  return [c](const ContactReceptance&) {
    return ProjectedLaw{.constant = Eigen::VectorXd::Constant(1, c),
                        .multiplier_weight = Eigen::VectorXd::Ones(1)};
  };
}

HarmonicSetup setup_of(const NonsmoothBar& bar, int harmonics, const LawAt& law,
                       const SolverSettings& solver = {}) {
  const ContactReceptance receptance = tip_receptance(bar, harmonics);
  return {.receptance = receptance,
          .gap = Eigen::VectorXd::Constant(1, bar.gap),
          .method = {.law_at = law, .grid_solver = lcp_grid_solver(solver)},
          .options = {},
          .law = law(receptance)};
}

// Without a load rest is a solution too: the search starts from the motion, its force made wrong by `factor`.
Solution from_the_mode(const NonsmoothBar& bar, const HarmonicSetup& setup, double factor = 1.0) {
  const auto guess = std::make_shared<test::GivenMotion>(
      bar.period, [bar](double t) { return bar.u(1.0, t); },
      [bar, factor](double t) { return factor * bar.force(t); });
  Work work;
  return solve_series(setup, {.guess = guess}, work);
}

// Oracle 1e1: the energies of independent computations with c = 4 and 20 samples per harmonic, and how near
// they are to the bar's.
TEST(NonsmoothBar, HarmonicBalanceHasTheKnownEnergies) {
  const struct {
    double period;
    int harmonics;
    double known, bound;  // energy; relative distance to the exact one
  } cases[] = {{3.7, 20, 0.2592, 0.02}, {3.3, 20, 1.436, 0.04}, {3.15, 40, 5.66, 0.025}};
  for (const auto& [period, harmonics, known, bound] : cases) {
    const NonsmoothBar bar{.period = period};
    for (const double factor : {0.7, 1.0, 1.3}) {
      HarmonicSetup setup =
          setup_of(bar, harmonics, constant(4.0), {.solver = ComplementaritySolver::newton});
      setup.options = {.samples = 20 * harmonics, .quadrature = Quadrature::sampled};
      const Solution solution = from_the_mode(bar, std::move(setup), factor);
      ASSERT_EQ(solution.verdict, Verdict::converged) << "T " << period << ": " << solution.message;
      const double energy = energy_at_mid_contact(solution.trajectory->force_coefficients(), period);
      EXPECT_NEAR(energy, known, 1e-3 * known) << "T " << period;
      EXPECT_NEAR(energy, bar.energy(), bound * bar.energy()) << "T " << period;
    }
  }
}

// With the contact integral exact and c of the order of the highest dynamic stiffness the error is that of
// best approximation, H^-3/2 for a motion with kinks.
TEST(NonsmoothBar, HarmonicBalanceTendsToItAtTheRateOfItsKinks) {
  const NonsmoothBar bar{.period = kIrrationalPeriod};
  const auto law = [](const ContactReceptance& receptance) {
    return constant(4.0 * highest_dynamic_stiffness(receptance)[0])(receptance);
  };
  std::vector<double> steps, errors;
  for (const int harmonics : {10, 14, 20, 28, 40, 57, 80}) {
    const Solution solution = from_the_mode(bar, setup_of(bar, harmonics, law));
    ASSERT_EQ(solution.verdict, Verdict::converged) << harmonics << ": " << solution.message;
    steps.push_back(1.0 / harmonics);
    errors.push_back(test::relative_error(*solution.trajectory, [bar](double t) { return bar.u(1.0, t); }));
  }
  EXPECT_NEAR(test::observed_order(steps, errors), 1.5, 0.3);
  EXPECT_LT(errors.back(), 1e-3);
}

TEST(NonsmoothBar, RestIsWhatAColdStartFinds) {
  const NonsmoothBar bar;
  Work work;
  const Solution solution = solve_series(setup_of(bar, 20, constant(4.0)), {}, work);
  ASSERT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_EQ(solution.trajectory->force_coefficients().norm(), 0.0);
}

// The scene bar200-massless and its like, without damping and load.
Problem finite_element_bar(const NonsmoothBar& bar, int elements) {
  const int tip = elements - 1;
  const Structure structure =
      assemble(Bar{.elements = elements, .contact_mass = ContactMass::massless, .contacts = {tip}});
  Problem problem;
  problem.name = "nonsmooth-bar";
  problem.edit_structure([&](Structure& s) {
    s.mass = structure.mass;
    s.damping = SparseMatrix(elements, elements);
    s.stiffness = structure.stiffness;
  });
  problem.frequency = 2.0 * std::numbers::pi / bar.period;
  problem.contacts = {{.normal = {{tip, 1.0}}, .gap = bar.gap}};
  problem.set_law(Massless{});
  return problem;
}

double energy(const ContactDynamics& dynamics, const State& state) {
  return 0.5 * (state.u.dot(dynamics.structure().stiffness * state.u) +
                state.v.dot(dynamics.structure().mass * state.v));
}

struct Period {
  double approach_error = 0.0;  // of the tip before it meets the stop, L2 relative to the whole motion
  double error = 0.0;           // the same over the period
  double close = 0.0, open = 0.0;
  double impulse = 0.0;
  double energy_drift = 0.0;  // relative
};

// One period from rest in uniform compression, which finite elements represent exactly.
Period follow(const NonsmoothBar& bar, int elements) {
  const Problem problem = finite_element_bar(bar, elements);
  validate(problem);
  const ContactDynamics dynamics(problem);
  EventFlow flow(
      dynamics, 1e-9, [] { return false; }, Integrator::modal);
  const double rest = 0.5 * bar.period;
  State compressed{.u = Eigen::VectorXd(elements), .v = Eigen::VectorXd::Zero(elements)};
  for (int i = 0; i < elements; ++i) compressed.u[i] = bar.u((i + 1.0) / elements, rest);
  const FlowState start = flow.place(0.0, dynamics.with_mass(compressed));
  FlowState state = start;
  FlowRecord record;
  record.dense = true;
  flow.advance(state, bar.period, record);
  const EventTrajectory motion(bar.period, start, record.nodes, record.events);
  EXPECT_EQ(record.events.size(), 2U) << elements;
  const auto events = motion.events().value();
  Period result{.close = events.front().time, .open = events.back().time};
  constexpr int kInstants = 4000;
  const Samples samples = motion.sample(kInstants);
  double size = 0.0;
  for (int i = 0; i < kInstants; ++i) {
    const double t = bar.period * i / kInstants, exact = bar.u(1.0, rest + t);
    const double square = std::pow(samples.x(i, 0) - exact, 2);
    size += exact * exact;
    result.error += square;
    if (t < rest - 0.5 * bar.contact_duration()) result.approach_error += square;
  }
  result.error = std::sqrt(result.error / size);
  result.approach_error = std::sqrt(result.approach_error / size);
  result.impulse = -samples.force.col(0).mean() * bar.period;
  result.energy_drift = std::abs(energy(dynamics, state.state) / energy(dynamics, start.state) - 1.0);
  return result;
}

// Until the tip meets the stop linear elements follow its kinks at order 3/2. The front that ends the contact
// has been smeared by dispersion over a width of order h^2/3, short waves first: the contact ends that much
// too early, and this is the order of what follows.
TEST(NonsmoothBar, FiniteElementsFollowItThroughAPeriod) {
  const NonsmoothBar bar{.period = kIrrationalPeriod};
  const double half = 0.5 * bar.contact_duration(), close = 0.5 * bar.period - half;
  std::vector<double> steps, approach, whole;
  for (const int elements : {25, 50, 100, 200}) {
    SCOPED_TRACE(testing::Message() << elements << " elements");
    const Period found = follow(bar, elements);
    const double h = 1.0 / elements, front = std::pow(h, 2.0 / 3.0);
    steps.push_back(h);
    approach.push_back(found.approach_error);
    whole.push_back(found.error);
    EXPECT_NEAR(found.close, close, 0.05 * h);
    EXPECT_NEAR(found.open, close + 2.0 * half, 0.5 * front);
    EXPECT_NEAR(found.impulse, 4.0 * bar.strain() * half, bar.strain() * front);
    EXPECT_LT(found.energy_drift, 1e-8);
  }
  EXPECT_NEAR(test::observed_order(steps, approach), 1.5, 0.1);
  EXPECT_GT(test::observed_order(steps, whole), 0.55);
  EXPECT_LT(test::observed_order(steps, whole), 1.0);
  EXPECT_LT(whole.back(), 0.011);
  EXPECT_LT(approach.back(), 5e-4);
}

}  // namespace
}  // namespace signorini::nonsmooth_bar_test
