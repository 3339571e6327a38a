#include "harness/judge/certificate.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/harness/fake_method.hpp"

namespace signorini {
namespace {

using test::FormulaMotion;

constexpr auto kNoDeadline = std::chrono::steady_clock::time_point::max();

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

/// Finds one motion at 1e-11, another at 1e-12.
OrbitSolver finds(double factor, double tight_factor) {
  return [=](const Problem&, const OrbitRequest& request) {
    return Solution{.verdict = Verdict::converged,
                    .message = {},
                    .trajectory = scaled(request.tolerance > 5e-12 ? factor : tight_factor)};
  };
}

OrbitSolver fails(const std::string& why) {
  return [=](const Problem&, const OrbitRequest&) { return Solution{.message = why}; };
}

TEST(FindOrbit, TakesTheDifferenceOfTwoTolerancesAsErrorBar) {
  const CheckedOrbit orbit = find_orbit(test::one_mass(), finds(1.0, 1.0 + 1e-10), {.shooting = true}, 1e-9);
  ASSERT_NE(orbit.orbit, nullptr);
  EXPECT_NEAR(orbit.error_bar, 1e-10, 1e-13);
}

TEST(FindOrbit, RefusesAnOrbitThatTwoTolerancesSeeDifferently) {
  const CheckedOrbit orbit = find_orbit(test::one_mass(), finds(1.0, 1.001), {.shooting = true}, 1e-9);
  EXPECT_EQ(orbit.orbit, nullptr);
  EXPECT_NE(orbit.reason.find("two tolerances"), std::string::npos);
}

TEST(FindOrbit, MarchesAgainWhereShootingFailsAtTheTighterTolerance) {
  int marched = 0;
  const OrbitSolver solver = [&](const Problem& problem, const OrbitRequest& request) {
    if (request.shooting) return Solution{.message = "no"};
    ++marched;
    return test::free_orbits()(problem, request);
  };
  EXPECT_NE(find_orbit(test::one_mass(), solver, {.shooting = false}, 1e-9).orbit, nullptr);
  EXPECT_EQ(marched, 2);
  EXPECT_EQ(find_orbit(test::one_mass(), solver, {.shooting = true}, 1e-9).orbit, nullptr);
}

TEST(Certify, MeasuresTheDistanceToTheOrbitNearby) {
  const Reference reference = compute_reference(test::one_mass(), finds(1.0, 1.0), kNoDeadline);
  const Judgement judgement = certified(scaled(1.1), reference, finds(1.0, 1.0), kNoDeadline);
  const Certificate& certificate = judgement.certificate;
  EXPECT_EQ(certificate.status, CertificateStatus::certified);
  EXPECT_NEAR(certificate.distance.value(), 0.1, 1e-12);
  EXPECT_EQ(certificate.same_orbit, true);
  EXPECT_EQ(certificate.orbit, reference.fingerprint);
  EXPECT_EQ(certificate.reference, reference.fingerprint);
  EXPECT_TRUE(judgement.orbit);
}

TEST(Certify, TellsAnotherOrbitFromTheReference) {
  const Reference reference = compute_reference(test::one_mass(), finds(1.0, 1.0), kNoDeadline);
  const Judgement judgement = certified(scaled(3.1), reference, finds(3.0, 3.0), kNoDeadline);
  EXPECT_EQ(judgement.certificate.status, CertificateStatus::certified);
  EXPECT_EQ(judgement.certificate.same_orbit, false);
  EXPECT_NE(judgement.certificate.orbit, reference.fingerprint);
}

TEST(Certify, DoesNotCertifyByAnOrbitFarAway) {
  const Judgement judgement =
      certified(scaled(3.0), {.orbit = {}, .reason = "chaos"}, finds(1.0, 1.0), kNoDeadline);
  EXPECT_EQ(judgement.certificate.status, CertificateStatus::uncertified);
  EXPECT_NEAR(judgement.certificate.distance.value(), 2.0, 1e-12);
  EXPECT_EQ(judgement.certificate.reference_reason, "chaos");
  EXPECT_FALSE(judgement.orbit);
}

TEST(Certify, FallsBackOnTheReferenceNearby) {
  const Reference reference = compute_reference(test::one_mass(), finds(1.0, 1.0), kNoDeadline);
  const Judgement near = certified(scaled(1.2), reference, fails("diverged"), kNoDeadline);
  EXPECT_EQ(near.certificate.status, CertificateStatus::certified);
  EXPECT_EQ(near.certificate.source, "the motion reached from rest");
  const Judgement far = certified(scaled(2.0), reference, fails("diverged"), kNoDeadline);
  EXPECT_EQ(far.certificate.status, CertificateStatus::uncertified);
  EXPECT_EQ(far.certificate.reason, "diverged");
}

TEST(ComputeReference, SaysWhyThereIsNone) {
  const Reference reference = compute_reference(test::one_mass(), fails("chaos"), kNoDeadline);
  EXPECT_EQ(reference.orbit, nullptr);
  EXPECT_EQ(reference.reason, "chaos");
  EXPECT_EQ(compute_reference(test::one_mass(), finds(1.0, 1.1), kNoDeadline).orbit, nullptr);
}

TEST(ReferenceJson, ComesBackAsItWent) {
  const Reference reference = compute_reference(test::one_mass(), finds(1.0, 1.0 + 1e-12), kNoDeadline);
  const Reference back = reference_from_json(nlohmann::ordered_json::parse(to_json(reference).dump()));
  EXPECT_EQ(back.orbit->data().samples.x, reference.orbit->data().samples.x);
  EXPECT_EQ(back.error_bar, reference.error_bar);
  EXPECT_EQ(back.fingerprint, reference.fingerprint);
  Reference none;
  none.reason = "chaos";
  EXPECT_EQ(reference_from_json(to_json(none)).reason, "chaos");
  EXPECT_THROW(reference_from_json(nlohmann::ordered_json::object()), BadRecord);
}

TEST(UnderLaw, ReplacesTheLawUnlessItIsUndetermined) {
  const Problem problem = test::one_mass(1.0, 0.5);
  EXPECT_EQ(std::get<Restitution>(under_law(problem, Restitution{1.0}).law).e, 1.0);
  EXPECT_EQ(std::get<Restitution>(under_law(problem, Undetermined{}).law).e, 0.5);
  EXPECT_TRUE(std::holds_alternative<Penalty>(under_law(problem, Penalty{{3.0}}).law));
}

TEST(EventDrivenOrbits, FindTheContactFreeMotionAtBothTolerances) {
  // The stop is 10 m away: the orbit is the linear response, known in closed form.
  const Problem problem = test::one_mass();
  const Reference reference = compute_reference(problem, event_driven_orbits(), kNoDeadline);
  ASSERT_NE(reference.orbit, nullptr) << reference.reason;
  EXPECT_LE(reference.error_bar, 1e-9);
  const Motion found = sample_motion(problem, *reference.orbit);
  EXPECT_LT(distance(found, sample_motion(problem, *test::free_motion(problem))).x_l2.value(), 1e-9);
}

}  // namespace
}  // namespace signorini
