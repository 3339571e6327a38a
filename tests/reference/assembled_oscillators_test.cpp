// Several one-mass oscillators in one scene: each must move as if alone, whatever the rest does.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <random>

#include "methods/event_driven/event_driven.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/linear_algebra/orthogonal.hpp"
#include "problems/validation.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::assembled_oscillators_test {
namespace {

using test::ImpactOscillator;
using test::SingleImpactOrbit;
using test::solve;

constexpr int kOscillators = 3, kFree = 4;
constexpr double kFrequency = 2.2;

// One stable oscillator three times, in other units of force and length each.
std::array<ImpactOscillator, kOscillators> oscillators(double restitution) {
  return {{{.frequency = kFrequency, .gap = 0.2, .restitution = restitution},
           {.mass = 2.0,
            .damping = 0.2,
            .stiffness = 2.0,
            .load = 3.0,
            .frequency = kFrequency,
            .gap = 0.3,
            .restitution = restitution},
           {.mass = 0.5,
            .damping = 0.05,
            .stiffness = 0.5,
            .load = 0.35,
            .frequency = kFrequency,
            .gap = 0.14,
            .restitution = restitution}}};
}

/// The three side by side, numbered backwards, behind `kFree` coordinates without contact whose axes are
/// turned at random.
Problem assembly(double restitution) {
  constexpr int kAll = kOscillators + kFree;
  std::mt19937 random(7);
  std::normal_distribution<double> draw;
  Eigen::MatrixXd A(kFree, kFree);
  for (Eigen::Index i = 0; i < A.size(); ++i) A.data()[i] = draw(random);
  const Eigen::MatrixXd Q = householder_basis(A);
  const Eigen::VectorXd spring = Eigen::Vector4d(1.0, 3.0, 9.0, 20.0);
  Eigen::MatrixXd M = Eigen::MatrixXd::Identity(kAll, kAll), D = M, K = M;
  D.topLeftCorner(kFree, kFree) = 0.1 * Eigen::MatrixXd::Identity(kFree, kFree);
  K.topLeftCorner(kFree, kFree) = Q * spring.asDiagonal() * Q.transpose();
  Problem problem;
  problem.name = "assembled-oscillators";
  problem.frequency = kFrequency;
  problem.force = {{.dof = 0, .harmonic = 1, .cos = 1.0, .sin = 0.5}};
  for (int i = 0; i < kOscillators; ++i) {
    const ImpactOscillator one = oscillators(restitution)[static_cast<std::size_t>(i)];
    const int dof = kAll - 1 - i;
    M(dof, dof) = one.mass;
    D(dof, dof) = one.damping;
    K(dof, dof) = one.stiffness;
    problem.force.push_back({.dof = dof, .harmonic = 1, .cos = one.load, .sin = 0.0});
    problem.contacts.push_back({.normal = {{dof, 1.0}}, .gap = one.gap});
  }
  problem.edit_structure([&](Structure& s) {
    s.mass = M.sparseView();
    s.damping = D.sparseView();
    s.stiffness = K.sparseView();
  });
  problem.set_law(Restitution{restitution});
  return problem;
}

void expect_closed_forms(const Trajectory& found, double restitution, double tolerance) {
  for (int i = 0; i < kOscillators; ++i) {
    const auto orbits = test::single_impact_orbits(oscillators(restitution)[static_cast<std::size_t>(i)]);
    ASSERT_FALSE(orbits.empty()) << "oscillator " << i;
    EXPECT_LT(test::relative_error(
                  found, [&](double t) { return orbits.front().x(t); }, i),
              tolerance)
        << "oscillator " << i << ", e " << restitution;
  }
}

TEST(AssembledOscillators, MoveAsTheClosedFormsSayInTimeDomainMethods) {
  for (const double restitution : {0.5, 0.8}) {
    const Problem problem = assembly(restitution);
    ASSERT_NO_THROW(validate(problem));
    for (const Integrator flow : {Integrator::cvode, Integrator::modal}) {
      const Solution marched = solve<EventDriven>(problem, {.tolerance = 1e-10, .flow = flow});
      ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
      expect_closed_forms(*marched.trajectory, restitution, 1e-8);
    }
    const Solution exact = solve<ExactOrbitMethod>(problem, {});
    ASSERT_EQ(exact.verdict, Verdict::converged) << exact.message;
    expect_closed_forms(*exact.trajectory, restitution, 1e-11);
  }
}

// The same truncation of each alone: one discrete solution, to the tolerance of the solver.
TEST(AssembledOscillators, HaveTheDiscreteSolutionsOfEachAlone) {
  const Problem whole = assembly(1.0);
  const auto compare = [&](const Solution& together, const auto& solve_one, const char* name) {
    ASSERT_EQ(together.verdict, Verdict::converged) << name << ": " << together.message;
    const Samples found = together.trajectory->sample(512);
    for (int i = 0; i < kOscillators; ++i) {
      const Solution alone = solve_one(test::to_problem(oscillators(1.0)[static_cast<std::size_t>(i)]));
      ASSERT_EQ(alone.verdict, Verdict::converged) << name << ": " << alone.message;
      const Samples expected = alone.trajectory->sample(512);
      EXPECT_LT((found.x.col(i) - expected.x.col(0)).norm() / expected.x.norm(), 1e-7)
          << name << ", oscillator " << i;
    }
  };
  const FourierLipschitz::Options fourier{.common = {.harmonics = 20}, .c = 200.0};
  compare(
      solve<FourierLipschitz>(whole, fourier),
      [&](const Problem& one) { return solve<FourierLipschitz>(one, fourier); }, "fourier-lipschitz");
  const PenaltyHbm::Options penalty{.common = {.harmonics = 20}, .penalty = Scaled{200.0, true}};
  compare(
      solve<PenaltyHbm>(whole, penalty), [&](const Problem& one) { return solve<PenaltyHbm>(one, penalty); },
      "penalty-hbm");
}

}  // namespace
}  // namespace signorini::assembled_oscillators_test
