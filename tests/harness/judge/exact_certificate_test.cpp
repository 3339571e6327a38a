#include "harness/judge/exact_certificate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "harness/judge/certificate.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/hat_lcp/hat_lcp.hpp"
#include "methods/linear_flow/linear_flow.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/methods/orbit/symmetric_scenes.hpp"
#include "tests/support/accuracy.hpp"
#include "tests/support/exact_scenes.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::exact_certificate_test {
namespace {

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.8};

std::shared_ptr<const Trajectory> coarse_answer(const Problem& problem) {
  return test::solve<HatLcp>(problem, {.samples = 64}).trajectory;
}

TEST(ExactOrbits, PolishACoarseAnswerToTheClosedFormOrbitWithItsMultipliers) {
  const Problem problem = test::to_problem(kStop);
  const auto closed = test::single_impact_orbits(kStop).front();
  const CertifiedOrbit orbit = exact_orbits()(problem, *coarse_answer(problem), {}, Deadline::max());
  ASSERT_NE(orbit.motion, nullptr) << orbit.reason;
  EXPECT_LE(orbit.error_bar, 1e-11);
  EXPECT_LE(test::relative_error(*orbit.motion, [&](double t) { return closed.x(t); }), 1e-11);
  ASSERT_EQ(orbit.events.size(), 1U);
  EXPECT_EQ(orbit.events[0].kind, ContactEvent::Kind::impact);
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

// Seven periods of the load, two multipliers, one of 3.2e4: CVODE comes back to 1e-6 only, which is 3e-11 of
// the orbit. Whatever instant the load, and with it the answer, begins at, the judgement is the same.
TEST(Certificates, OfAnUnstableOrbitAreTheSameFromEveryPhase) {
  Problem problem = test::to_problem({.damping = 0.02, .frequency = 7.1, .gap = 0.01, .restitution = 0.9});
  problem.subharmonic = 7;
  const ForceTerm load = problem.force.front();
  for (const double phase : {0.0, 0.9, 2.5, 4.4}) {
    problem.force.front().cos = load.cos * std::cos(phase) - load.sin * std::sin(phase);
    problem.force.front().sin = load.cos * std::sin(phase) + load.sin * std::cos(phase);
    const auto answer = test::solve<HatLcp>(problem, {.samples = 4096}).trajectory;
    ASSERT_NE(answer, nullptr);
    const SampledAnswer sampled = sample_answer(problem, *answer);
    const Certificate certificate =
        certify(problem, answer, sampled.motion, {}, orbit_tools(), Deadline::after(60.0)).certificate;
    EXPECT_EQ(certificate.status, CertificateStatus::certified) << phase << ": " << certificate.reason;
    EXPECT_EQ(certificate.order, 7) << phase;
  }
}

/// The status of an answer after certificate and verdict.
Record judged(const Problem& problem, std::shared_ptr<const Trajectory> answer) {
  const SampledAnswer sampled = sample_answer(problem, *answer);
  Record record;
  record.status = Status::converged;
  record.law = as_represented(problem.law());
  record.certificate =
      certify(problem, answer, sampled.motion, {}, orbit_tools(), Deadline::after(60.0)).certificate;
  apply_verdict(record);
  return record;
}

// Standing still, the linear motion through the stop, and that with seven tenths of the true impulses: on
// springs the first two were left open, because only one of two searches led to an orbit.
TEST(Verdicts, OnGrossLiesAreRefutations) {
  const double w = kStop.frequency, re = 1.0 - w * w, im = kStop.damping * w, size = re * re + im * im;
  const auto x = [=](double t) { return (re * std::cos(w * t) + im * std::sin(w * t)) / size; };
  const auto v = [=](double t) { return w * (im * std::cos(w * t) - re * std::sin(w * t)) / size; };
  const auto nothing = [](double) { return 0.0; };
  const Problem rigid = test::to_problem(kStop);
  const double period = rigid.period();
  const auto still = std::make_shared<test::FormulaMotion>(period, nothing, nothing);
  const auto linear = std::make_shared<test::FormulaMotion>(period, x, v);
  const auto closed = test::single_impact_orbits(kStop).front();
  const auto pushed = std::make_shared<test::FormulaMotion>(
      period, x, v, nothing, std::vector<Impulse>{{0, closed.impact_time, -0.7 * closed.impulse}});
  std::vector<std::pair<Problem, std::shared_ptr<const Trajectory>>> lies{
      {rigid, still}, {rigid, linear}, {rigid, pushed}};
  for (const double stiffness : {5.0, 100.0, 1e4}) {
    Problem spring = rigid;
    spring.set_law(Penalty{.stiffness = {stiffness}});
    lies.insert(lies.end(), {{spring, still}, {spring, linear}});
  }
  for (const auto& [problem, lie] : lies) {
    const Record record = judged(problem, lie);
    EXPECT_EQ(record.status, Status::inaccurate) << record.certificate.reason;
    EXPECT_EQ(record.certificate.status, CertificateStatus::uncertified);
  }
}

TEST(ExactOrbits, AreNotFollowedAgainWhereOneWithTheirEventsIsConfirmed) {
  const Problem problem = test::to_problem(kStop);
  const std::shared_ptr<const Trajectory> answer = coarse_answer(problem);
  const CertifiedOrbit orbit = exact_orbits()(problem, *answer, {}, Deadline::max());
  ASSERT_NE(orbit.motion, nullptr) << orbit.reason;
  constexpr double kKnown = 0.125;  // no distance that CVODE would return at
  std::vector<Certificate> confirmed{
      {.error_bar = orbit.error_bar, .events = orbit.events, .return_distance = kKnown}};
  const auto again = [&] { return exact_orbits()(problem, *answer, confirmed, Deadline::max()); };
  EXPECT_EQ(again().return_distance, kKnown);
  confirmed.front().events.front().time += 1e-6;  // another orbit, however near
  EXPECT_LE(again().return_distance.value(), 1e-9);
}

TEST(ExactOrbits, LeaveTheStabilityOpenOnTheUnitCircle) {
  test::ImpactOscillator undamped = kStop;
  undamped.damping = 0.0;
  undamped.restitution = 1.0;
  const Problem problem = test::to_problem(undamped);
  const CertifiedOrbit orbit = exact_orbits()(problem, *coarse_answer(problem), {}, Deadline::max());
  ASSERT_NE(orbit.motion, nullptr) << orbit.reason;
  for (const auto& [re, im] : orbit.floquet.value()) EXPECT_NEAR(std::hypot(re, im), 1.0, 1e-9);
  EXPECT_FALSE(orbit.stable.has_value());
}

// A free mass that drifts touches nothing anywhere: its motions are a continuum, none of them an orbit by
// itself.
// Two copies of an oscillator: both impacts are listed, and the multipliers are those of either.
TEST(ExactOrbits, ListImpactsOfOneInstantOneByOne) {
  const Problem problem = test::twins({});
  const CertifiedOrbit orbit = exact_orbits()(problem, *coarse_answer(problem), {}, Deadline::max());
  ASSERT_NE(orbit.motion, nullptr) << orbit.reason;
  ASSERT_EQ(orbit.events.size(), 2U);
  EXPECT_EQ(orbit.events[0].contact + orbit.events[1].contact, 1);
  for (const OrbitEvent& event : orbit.events) EXPECT_NEAR(event.value.value(), -0.7998435577597911, 1e-10);
  EXPECT_EQ(orbit.stable, true);
  EXPECT_EQ(orbit.undefined, "");
  for (const auto& [re, im] : orbit.floquet.value()) EXPECT_NEAR(re, 0.07134665, 1e-7);
}

TEST(ExactOrbits, SayThatMultipliersDependOnTheOrderOfImpacts) {
  const Problem problem = test::bar(0.4, 0.4, 0.1, 0.8);
  const CertifiedOrbit orbit =
      exact_orbits()(problem, *test::solve<ExactOrbitMethod>(problem, {}).trajectory, {}, Deadline::max());
  ASSERT_NE(orbit.motion, nullptr) << orbit.reason;
  EXPECT_EQ(orbit.events.size(), 2U);
  EXPECT_FALSE(orbit.stable);
  EXPECT_EQ(orbit.stability, "undefined");
  EXPECT_EQ(orbit.undefined, "depends on the order of simultaneous impacts");
  EXPECT_TRUE(orbit.orders.empty());
}

// A mass that is pressed onto its stop throughout, wherever the origin is.
TEST(ExactOrbits, AreTheSameWhereverTheOriginIs) {
  for (const double gap : {0.0, 0.2, -0.2, 7.0}) {
    const Problem problem = test::to_problem({.damping = 0.1,
                                              .load = 0.5,
                                              .frequency = 1.3,
                                              .gap = gap,
                                              .restitution = 0.5,
                                              .static_load = 2.0 + gap});
    const CertifiedOrbit orbit = exact_orbits()(problem, *coarse_answer(problem), {}, Deadline::max());
    ASSERT_NE(orbit.motion, nullptr) << orbit.reason;
    EXPECT_LE(orbit.error_bar, 1e-12) << gap;
    EXPECT_EQ(orbit.stable, true) << gap;
  }
}

TEST(ExactOrbits, SayWhyAStructureHasNone) {
  Problem loose = test::to_problem(kStop);
  const auto answer = coarse_answer(loose);
  loose.edit_structure([&](Structure& s) {
    s.stiffness.coeffRef(0, 0) = 0.0;
    s.damping.coeffRef(0, 0) = 0.0;
  });
  const CertifiedOrbit orbit = exact_orbits()(loose, *answer, {}, Deadline::max());
  EXPECT_EQ(orbit.motion, nullptr);
  EXPECT_FALSE(orbit.reason.empty());
}

// A bar that no closed form of all coordinates takes: the orbit reached from rest, and the one that a coarse
// answer of another method leads to, are the same within both bars.
TEST(ReducedOrbits, AreTheJudgesOfLargeStructures) {
  const Problem bar = test::massless_bar({.alpha = 0.2, .beta = 0.005}, kMostInDenseFlow + 20);
  const CertifiedOrbit from_rest = reduced_orbits()(bar, Deadline::max());
  ASSERT_NE(from_rest.motion, nullptr) << from_rest.reason;
  EXPECT_LE(from_rest.error_bar, 1e-7);
  EXPECT_EQ(from_rest.stable, true);
  EXPECT_FALSE(from_rest.return_distance.has_value());
  EXPECT_NE(from_rest.source.find("corrected"), std::string::npos) << from_rest.source;
  const Reference reference = compute_reference(bar, orbit_tools(), Deadline::max());
  ASSERT_NE(reference.orbit, nullptr) << reference.reason;
  EXPECT_LE(reference.error_bar, kLargeReferenceErrorBar);
  const auto answer = test::solve<HatLcp>(bar, {.samples = 256}).trajectory;
  ASSERT_NE(answer, nullptr);
  const CertifiedAnswer judged =
      certify(bar, answer, sample_motion(bar, *answer), reference, orbit_tools(), Deadline::max());
  EXPECT_EQ(judged.certificate.status, CertificateStatus::certified) << judged.certificate.reason;
  EXPECT_EQ(judged.certificate.same_orbit, true);
  EXPECT_EQ(judged.certificate.orbit, reference.fingerprint);
  EXPECT_LT(judged.certificate.distance.value(), 0.05);
  EXPECT_EQ(judged.certificate.events.size(), from_rest.events.size());
}

// Contacts with mass and an impact law are others in a reduced structure: no certificate, and why.
TEST(ReducedOrbits, SayWhyAStructureHasNone) {
  const Problem chain = test::stopped_chain(kMostInDenseFlow + 1, 0.5, 1);
  const CertifiedOrbit orbit = reduced_orbits()(chain, Deadline::max());
  EXPECT_EQ(orbit.motion, nullptr);
  EXPECT_EQ(orbit.reason, "a contact with mass and an impact law is another one in a reduced structure");
}

}  // namespace
}  // namespace signorini::exact_certificate_test
