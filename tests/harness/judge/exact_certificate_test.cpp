#include "harness/judge/exact_certificate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "harness/judge/certificate.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

constexpr auto kNoDeadline = std::chrono::steady_clock::time_point::max();
const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.8};

std::shared_ptr<const Trajectory> coarse_answer(const Problem& problem) {
  return test::solve<HatLcp>(problem, {.samples = 64}).trajectory;
}

/// The contact-free motion times a factor.
std::shared_ptr<const Trajectory> scaled(double factor) {
  Problem problem = test::one_mass();
  problem.force.front().cos = factor;
  return test::free_motion(problem);
}

Judgement certified(const std::shared_ptr<const Trajectory>& answer, const Reference& reference,
                    const OrbitTools& tools, std::chrono::steady_clock::time_point deadline) {
  const Problem problem = test::one_mass();
  return certify(problem, answer, sample_motion(problem, *answer), reference, tools, deadline);
}

OrbitPolisher polishes_to(double factor, double error_bar) {
  return [=](const PolishRequest&) {
    CheckedOrbit orbit{.orbit = scaled(factor)};
    orbit.error_bar = error_bar;
    orbit.source = "exact orbit";
    return orbit;
  };
}

OrbitSolver fails() {
  return [](const Problem&, const OrbitRequest&) { return Solution{.message = "no"}; };
}

TEST(ExactOrbits, PolishACoarseAnswerToTheClosedFormOrbitWithItsMultipliers) {
  const Problem problem = test::to_problem(kStop);
  const auto closed = test::single_impact_orbits(kStop).front();
  const CheckedOrbit orbit = exact_orbits()({.problem = problem, .answer = *coarse_answer(problem)});
  ASSERT_NE(orbit.orbit, nullptr) << orbit.reason;
  EXPECT_LE(orbit.error_bar, 1e-11);
  EXPECT_LE(test::relative_error(*orbit.orbit, [&](double t) { return closed.x(t); }), 1e-11);
  ASSERT_EQ(orbit.events.size(), 1U);
  EXPECT_EQ(orbit.events[0].kind, "impact");
  EXPECT_NEAR(orbit.events[0].time, closed.impact_time, 1e-11);
  EXPECT_NEAR(orbit.events[0].value.value(), -closed.impulse, 1e-11);
  ASSERT_EQ(orbit.floquet.value().size(), 2U);
  std::complex<double> sum = 0.0, product = 1.0;
  for (const auto& [re, im] : *orbit.floquet) {
    sum += std::complex<double>(re, im);
    product *= std::complex<double>(re, im);
  }
  EXPECT_NEAR(sum.real(), closed.trace, 1e-10);
  EXPECT_NEAR(product.real(), closed.determinant, 1e-10);
  EXPECT_EQ(orbit.stable, closed.stable());
  EXPECT_LE(orbit.return_distance.value(), 1e-9);
}

TEST(ExactOrbits, AreNotFollowedAgainWhereOneWithTheirEventsIsConfirmed) {
  const Problem problem = test::to_problem(kStop);
  const std::shared_ptr<const Trajectory> answer = coarse_answer(problem);
  const CheckedOrbit orbit = exact_orbits()({.problem = problem, .answer = *answer});
  ASSERT_NE(orbit.orbit, nullptr) << orbit.reason;
  constexpr double kKnown = 0.125;  // no distance that CVODE would return at
  std::vector<Certificate> confirmed{
      {.error_bar = orbit.error_bar, .events = orbit.events, .return_distance = kKnown}};
  const PolishRequest again{.problem = problem, .answer = *answer, .confirmed = confirmed};
  EXPECT_EQ(exact_orbits()(again).return_distance, kKnown);
  confirmed.front().events.front().time += 1e-6;  // another orbit, however near
  EXPECT_LE(exact_orbits()(again).return_distance.value(), 1e-9);
}

TEST(ExactOrbits, LeaveTheStabilityOpenOnTheUnitCircle) {
  test::ImpactOscillator undamped = kStop;
  undamped.damping = 0.0;
  undamped.restitution = 1.0;
  const Problem problem = test::to_problem(undamped);
  const CheckedOrbit orbit = exact_orbits()({.problem = problem, .answer = *coarse_answer(problem)});
  ASSERT_NE(orbit.orbit, nullptr) << orbit.reason;
  for (const auto& [re, im] : orbit.floquet.value()) EXPECT_NEAR(std::hypot(re, im), 1.0, 1e-9);
  EXPECT_FALSE(orbit.stable.has_value());
}

// A free mass that drifts touches nothing anywhere: its motions are a continuum, none of them an orbit by
// itself.
TEST(ExactOrbits, SayWhyAStructureHasNone) {
  Problem loose = test::to_problem(kStop);
  const auto answer = coarse_answer(loose);
  loose.edit_structure([&](Structure& s) {
    s.stiffness.coeffRef(0, 0) = 0.0;
    s.damping.coeffRef(0, 0) = 0.0;
  });
  const CheckedOrbit orbit = exact_orbits()({.problem = loose, .answer = *answer});
  EXPECT_EQ(orbit.orbit, nullptr);
  EXPECT_FALSE(orbit.reason.empty());
}

TEST(Certify, TakesThePolishedOrbitFirst) {
  const Reference none{.orbit = {}, .reason = "chaos"};
  const Judgement judgement = certified(scaled(1.1), none, {fails(), polishes_to(1.0, 1e-13)}, kNoDeadline);
  EXPECT_EQ(judgement.certificate.status, CertificateStatus::certified);
  EXPECT_EQ(judgement.certificate.source, "exact orbit");
  EXPECT_NEAR(judgement.certificate.distance.value(), 0.1, 1e-12);
}

TEST(Certify, RefusesAnOrbitThatIsNotKnownWellEnough) {
  const Reference none{.orbit = {}, .reason = "chaos"};
  const Judgement judgement = certified(scaled(1.0), none, {fails(), polishes_to(1.0, 1e-4)}, kNoDeadline);
  EXPECT_EQ(judgement.certificate.status, CertificateStatus::uncertified);
  EXPECT_NE(judgement.certificate.reason.find("known to 1.0e-04 only"), std::string::npos)
      << judgement.certificate.reason;
  EXPECT_FALSE(judgement.orbit);
}

TEST(ComputeReference, IsNoneWhereMarchingStoppedAwayFromTheExactOrbit) {
  const Reference settled =
      compute_reference(test::one_mass(), {test::free_orbits(), polishes_to(1.0, 1e-13)}, kNoDeadline);
  EXPECT_NE(settled.orbit, nullptr);
  EXPECT_EQ(settled.error_bar, 1e-13);
  const Reference early =
      compute_reference(test::one_mass(), {test::free_orbits(), polishes_to(1.001, 1e-13)}, kNoDeadline);
  EXPECT_EQ(early.orbit, nullptr);
  EXPECT_NE(early.reason.find("has not settled"), std::string::npos) << early.reason;
}

}  // namespace
}  // namespace signorini
