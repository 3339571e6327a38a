// Several contacts that rest on their stops and never hit them: all that is measured is approximation.

#include "tests/reference/manufactured_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "methods/aft_hbm/aft_hbm.hpp"
#include "methods/event_driven/event_driven.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/fourier_lipschitz/fourier_lipschitz.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "methods/penalty_hbm/penalty_hbm.hpp"
#include "problems/validation.hpp"
#include "tests/support/accuracy.hpp"

namespace signorini::manufactured_contact_test {
namespace {

using test::ManufacturedChain;
using test::RestingContact;
using test::solve;

TEST(RestingContact, SeriesAndMotionAreOneAndMeetSignorinisConditions) {
  constexpr int kInstants = 4096;
  for (const RestingContact& contact : ManufacturedChain::contacts()) {
    for (const int power : {1, 2, 3, 4}) {
      for (const int n : {0, 1, 2, 7, 20}) {
        std::complex<double> x = 0.0, lambda = 0.0;
        for (int i = 0; i < kInstants; ++i) {
          const double turns = static_cast<double>(i) / kInstants;
          const auto factor = std::polar(1.0 / kInstants, -2.0 * std::numbers::pi * n * turns);
          x += factor * contact.x(turns, power);
          lambda += factor * contact.lambda(turns, power);
        }
        // The trapezoidal rule leaves the coefficients near n = 4096: at most a few times 4096^-2.
        EXPECT_LT(std::abs(contact.x_coefficient(n, power) - x), 1e-6) << "power " << power << ", n " << n;
        EXPECT_LT(std::abs(contact.lambda_coefficient(n, power) - lambda), 1e-6) << power << ", n " << n;
      }
    }
    for (int i = 0; i < kInstants; ++i) {
      const double turns = static_cast<double>(i) / kInstants;
      const double x = contact.x(turns, 3), lambda = contact.lambda(turns, 2);
      EXPECT_LE(x, contact.gap);
      EXPECT_LE(lambda, 0.0);
      EXPECT_EQ(lambda * (x - contact.gap), 0.0);
    }
  }
}

struct Errors {
  double x = 0.0;      // relative L2, all contacts together
  double force = 0.0;  // the same of lambda
};

Errors errors_of(const Trajectory& found, const ManufacturedChain& chain) {
  constexpr int kInstants = 8192;
  const std::vector<RestingContact> contacts = ManufacturedChain::contacts();
  const Samples samples = found.sample(kInstants);
  Eigen::MatrixXd x(kInstants, samples.x.cols()), force = x;
  for (Eigen::Index c = 0; c < x.cols(); ++c) {
    const RestingContact& contact = contacts[static_cast<std::size_t>(c)];
    for (int i = 0; i < kInstants; ++i) {
      const double turns = static_cast<double>(i) / kInstants;
      x(i, c) = contact.x(turns, chain.p);
      force(i, c) = contact.lambda(turns, chain.q);
    }
  }
  return {(samples.x - x).norm() / x.norm(), (samples.force - force).norm() / force.norm()};
}

/// Errors against steps, and their orders.
struct Convergence {
  std::vector<double> steps, x, force;

  void add(int level, const Solution& solution, const ManufacturedChain& chain) {
    ASSERT_EQ(solution.verdict, Verdict::converged) << "level " << level << ": " << solution.message;
    const Errors errors = errors_of(*solution.trajectory, chain);
    steps.push_back(1.0 / level);
    x.push_back(errors.x);
    force.push_back(errors.force);
  }
  [[nodiscard]] double x_order() const { return test::observed_order(steps, x); }
  [[nodiscard]] double force_order() const { return test::observed_order(steps, force); }
};

struct Smoothness {
  int p, q;
};

void PrintTo(const Smoothness& smoothness, std::ostream* out) {
  *out << "p = " << smoothness.p << ", q = " << smoothness.q;
}

// Loads are cut at what each method resolves: the coefficients left out fall as those of the motion do.
class ManufacturedContact : public testing::TestWithParam<Smoothness> {
 protected:
  const ManufacturedChain chain_{.p = GetParam().p, .q = GetParam().q};
  // Best approximation of the rougher one of motion and force, n^-(r+1), in L2. The two follow each other
  // through springs: without mass at the contacts their errors are of one order.
  const double rate_ = std::min(chain_.p, chain_.q) + 0.5;
};

INSTANTIATE_TEST_SUITE_P(Smoothness, ManufacturedContact,
                         testing::Values(Smoothness{2, 1}, Smoothness{4, 2}, Smoothness{3, 3}));

TEST_P(ManufacturedContact, IsApproachedByHarmonicBalanceAtTheRateOfItsSmoothness) {
  Convergence lipschitz, aft;
  for (const int harmonics : {10, 14, 20, 28, 40, 57}) {
    const Problem problem = chain_.problem(harmonics);
    ASSERT_NO_THROW(validate(problem));
    lipschitz.add(harmonics, solve<FourierLipschitz>(problem, {{.harmonics = harmonics}}), chain_);
    aft.add(harmonics, solve<AftHbm>(problem, {{.harmonics = harmonics}}), chain_);
  }
  for (const Convergence& found : {lipschitz, aft}) {
    EXPECT_NEAR(found.x_order(), rate_, 0.2);
    EXPECT_NEAR(found.force_order(), rate_, 0.2);
  }
}

// A stop of stiffness eps yields by |lambda| / eps: with eps ~ H^2 that is the error, of second order.
TEST_P(ManufacturedContact, IsApproachedByPenaltiesAsTheyStiffen) {
  Convergence penalty, aft;
  for (const int harmonics : {10, 14, 20, 28, 40}) {
    const Problem problem = chain_.problem(harmonics);
    const Scaled stiffness{0.05 * harmonics * harmonics, true};
    penalty.add(harmonics,
                solve<PenaltyHbm>(problem, {.common = {.harmonics = harmonics}, .penalty = stiffness}),
                chain_);
    aft.add(harmonics,
            solve<AftHbm>(problem, {.common = {.harmonics = harmonics},
                                    .law = AftHbm::ContactLaw::penalty,
                                    .penalty = stiffness}),
            chain_);
  }
  for (const Convergence& found : {penalty, aft}) {
    EXPECT_NEAR(found.x_order(), 2.0, 0.15);
    EXPECT_NEAR(found.force_order(), 2.0, 0.15);
  }
}

// Straight lines between nodes, rest known to a step where it begins and ends: second order, less where the
// force has a kink there.
TEST_P(ManufacturedContact, IsApproachedByHatFunctionsAtSecondOrder) {
  for (const HatLcp::Scheme scheme : {HatLcp::Scheme::galerkin, HatLcp::Scheme::nodal}) {
    Convergence found;
    for (const int samples : {64, 128, 256, 512}) {
      found.add(samples,
                solve<HatLcp>(chain_.problem(samples / 2 - 1), {.samples = samples, .scheme = scheme}),
                chain_);
    }
    EXPECT_GT(found.x_order(), chain_.q == 1 ? 1.7 : 1.9);
    EXPECT_LT(found.x_order(), 2.1);
    EXPECT_NEAR(found.force_order(), std::min(rate_, 2.0), 0.15);
  }
}

// Exact for the load they are given: what is left is the load that is missing.
TEST_P(ManufacturedContact, IsFollowedInTime) {
  Convergence exact;
  for (const int harmonics : {10, 20, 40, 80}) {
    const Problem problem = chain_.problem(harmonics);
    const Solution marched = solve<EventDriven>(problem, {.tolerance = 1e-8, .flow = Integrator::modal});
    const Solution orbit = solve<ExactOrbitMethod>(problem, {});
    ASSERT_EQ(marched.verdict, Verdict::converged) << marched.message;
    exact.add(harmonics, orbit, chain_);
    if (HasFatalFailure()) return;
    EXPECT_LT(test::relative_distance(*orbit.trajectory, *marched.trajectory), 1e-8);
    if (harmonics > 20) continue;
    const Solution integrated = solve<EventDriven>(problem, {.tolerance = 1e-8});
    ASSERT_EQ(integrated.verdict, Verdict::converged) << integrated.message;
    EXPECT_LT(test::relative_distance(*orbit.trajectory, *integrated.trajectory), 1e-7);
  }
  EXPECT_NEAR(exact.x_order(), rate_, 0.3);
  EXPECT_NEAR(exact.force_order(), rate_, 0.3);
}

// With mass at the contacts the structure leaves the motion open, and a restitution below one determines it:
// what little impacts there are end in rest. The load has to be continuous, p > 2: a truncated series
// overshoots at its jumps, where the contact forces begin and are small.
class ManufacturedContactWithMass : public testing::TestWithParam<Smoothness> {
 protected:
  ManufacturedChain chain_{.p = GetParam().p, .q = GetParam().q, .massless = false};
};

INSTANTIATE_TEST_SUITE_P(Smoothness, ManufacturedContactWithMass,
                         testing::Values(Smoothness{3, 1}, Smoothness{4, 2}, Smoothness{3, 3}));

TEST_P(ManufacturedContactWithMass, IsApproachedByHatFunctionsAtSecondOrder) {
  for (const double restitution : {0.0, 0.5}) {
    chain_.restitution = restitution;
    Convergence found;
    for (const int samples : {64, 128, 256, 512}) {
      const Problem problem = chain_.problem(samples / 2 - 1);
      ASSERT_NO_THROW(validate(problem));
      found.add(samples, solve<HatLcp>(problem, {.samples = samples}), chain_);
    }
    EXPECT_NEAR(found.x_order(), 2.0, 0.12) << "e = " << restitution;
  }
}

// The ripple of the truncated load lifts contacts where their forces begin and end, ever less.
TEST_P(ManufacturedContactWithMass, IsFollowedInTime) {
  Convergence marched, exact;
  for (const int harmonics : {10, 20, 40, 80}) {
    const Problem problem = chain_.problem(harmonics);
    marched.add(harmonics, solve<EventDriven>(problem, {.tolerance = 1e-8, .flow = Integrator::modal}),
                chain_);
    exact.add(harmonics, solve<ExactOrbitMethod>(problem, {}), chain_);
  }
  for (const Convergence& found : {marched, exact}) {
    EXPECT_GT(found.x_order(), 1.7);
    EXPECT_LT(found.x.back(), 5e-5);
  }
}

}  // namespace
}  // namespace signorini::manufactured_contact_test
