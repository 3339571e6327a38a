#include "harness/judge/certificate.hpp"

#include <gtest/gtest.h>

#include "tests/harness/judge/fake_orbits.hpp"

namespace signorini {
namespace {

CertifiedAnswer certified(const std::shared_ptr<const Trajectory>& answer, const Reference& reference,
                          const OrbitTools& tools) {
  const Problem problem = test::one_mass();
  return certify(problem, answer, sample_motion(problem, *answer), reference, tools, Deadline::max());
}

TEST(Certify, MeasuresTheDistanceToTheOrbitNearby) {
  const Reference reference = compute_reference(test::one_mass(), test::finds(1.0, 1.0), Deadline::max());
  const CertifiedAnswer answer = certified(test::scaled(1.1), reference, test::finds(1.0, 1.0));
  const Certificate& certificate = answer.certificate;
  EXPECT_EQ(certificate.status, CertificateStatus::certified);
  EXPECT_NEAR(certificate.distance.value(), 0.1, 1e-12);
  EXPECT_EQ(certificate.same_orbit, true);
  EXPECT_EQ(certificate.orbit, reference.fingerprint);
  EXPECT_EQ(certificate.reference, reference.fingerprint);
  EXPECT_TRUE(answer.orbit);
}

TEST(Certify, TellsAnotherOrbitFromTheReference) {
  const Reference reference = compute_reference(test::one_mass(), test::finds(1.0, 1.0), Deadline::max());
  const CertifiedAnswer answer = certified(test::scaled(3.1), reference, test::finds(3.0, 3.0));
  EXPECT_EQ(answer.certificate.status, CertificateStatus::certified);
  EXPECT_EQ(answer.certificate.same_orbit, false);
  EXPECT_NE(answer.certificate.orbit, reference.fingerprint);
}

TEST(Certify, DoesNotCertifyByAnOrbitFarAway) {
  const CertifiedAnswer answer =
      certified(test::scaled(3.0), {.orbit = {}, .reason = "chaos"}, test::finds(1.0, 1.0));
  EXPECT_EQ(answer.certificate.status, CertificateStatus::uncertified);
  EXPECT_NEAR(answer.certificate.distance.value(), 2.0, 1e-12);
  EXPECT_EQ(answer.certificate.reference_reason, "chaos");
  EXPECT_FALSE(answer.orbit);
}

TEST(Certify, FallsBackOnTheReferenceNearby) {
  const Reference reference = compute_reference(test::one_mass(), test::finds(1.0, 1.0), Deadline::max());
  const CertifiedAnswer near = certified(test::scaled(1.2), reference, test::fails("diverged"));
  EXPECT_EQ(near.certificate.status, CertificateStatus::certified);
  EXPECT_EQ(near.certificate.source, "the motion reached from rest");
  const CertifiedAnswer far = certified(test::scaled(2.0), reference, test::fails("diverged"));
  EXPECT_EQ(far.certificate.status, CertificateStatus::uncertified);
  EXPECT_EQ(far.certificate.reason, "diverged");
}

TEST(Certify, TakesThePolishedOrbitFirst) {
  const Reference none{.orbit = {}, .reason = "chaos"};
  const CertifiedAnswer answer =
      certified(test::scaled(1.1), none, {test::fails(), test::polishes_to(1.0, 1e-13)});
  EXPECT_EQ(answer.certificate.status, CertificateStatus::certified);
  EXPECT_EQ(answer.certificate.source, "exact orbit");
  EXPECT_NEAR(answer.certificate.distance.value(), 0.1, 1e-12);
}

TEST(Certify, RefusesAnOrbitThatIsNotKnownWellEnough) {
  const Reference none{.orbit = {}, .reason = "chaos"};
  const CertifiedAnswer answer =
      certified(test::scaled(1.0), none, {test::fails(), test::polishes_to(1.0, 1e-4)});
  EXPECT_EQ(answer.certificate.status, CertificateStatus::uncertified);
  EXPECT_NE(answer.certificate.reason.find("known to 1.0e-04 only"), std::string::npos)
      << answer.certificate.reason;
  EXPECT_FALSE(answer.orbit);
}

}  // namespace
}  // namespace signorini
