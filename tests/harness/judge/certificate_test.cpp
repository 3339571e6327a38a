#include "harness/judge/certificate.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
  const CertifiedAnswer answer = certified(test::scaled(1.09), reference, test::finds(1.0, 1.0));
  const Certificate& certificate = answer.certificate;
  EXPECT_EQ(certificate.status, CertificateStatus::certified);
  EXPECT_NEAR(certificate.distance.value(), 0.09, 1e-12);
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

TEST(Certify, IsNotByAReferenceThatTheAnswerDoesNotLeadTo) {
  const Reference reference = compute_reference(test::one_mass(), test::finds(1.0, 1.0), Deadline::max());
  const CertifiedAnswer answer = certified(test::scaled(1.001), reference, test::fails("diverged"));
  EXPECT_EQ(answer.certificate.status, CertificateStatus::uncertified);
  EXPECT_EQ(answer.certificate.reason, "diverged");
  EXPECT_EQ(answer.certificate.refutation, "");
}

TEST(Certify, IsNotByAnOrbitThatIsOnlyNear) {
  const Reference none{.orbit = {}, .reason = "chaos"};
  const Certificate near = certified(test::scaled(1.2), none, test::finds(1.0, 1.0)).certificate;
  EXPECT_EQ(near.status, CertificateStatus::uncertified);
  EXPECT_NEAR(near.distance.value(), 0.2, 1e-12);
  EXPECT_NE(near.reason.find("near the orbit that it leads to"), std::string::npos) << near.reason;
  EXPECT_EQ(near.refutation, "");
  const Certificate far = certified(test::scaled(1.6), none, test::finds(1.0, 1.0)).certificate;
  EXPECT_EQ(far.status, CertificateStatus::uncertified);
  EXPECT_NE(far.refutation, "");
}

/// The contact-free motion of one mass, with a contact force that it does not have.
std::shared_ptr<const Trajectory> pushed(double impulse) {
  const auto free = test::free_motion(test::one_mass());
  const double period = free->period();
  const auto at = [free](double t) { return free->sample(1024).x(static_cast<int>(t * 1024), 0); };
  return std::make_shared<test::FormulaMotion>(
      period, [=](double t) { return at(std::fmod(t / period, 1.0)); }, [](double) { return 0.0; },
      [](double) { return 0.0; }, std::vector<Impulse>{{0, 0.1 * period, impulse}});
}

TEST(Certify, RefutesAContactForceThatTheOrbitDoesNotHave) {
  const Reference none{.orbit = {}, .reason = "chaos"};
  const Certificate certificate = certified(pushed(-1.0), none, test::finds(1.0, 1.0)).certificate;
  EXPECT_LT(certificate.distance.value(), 0.05) << "x alone would certify it";
  EXPECT_EQ(certificate.status, CertificateStatus::uncertified);
  EXPECT_NE(certificate.refutation.find("the orbit has none"), std::string::npos) << certificate.refutation;
}

TEST(Certify, TakesThePolishedOrbitFirst) {
  const Reference none{.orbit = {}, .reason = "chaos"};
  const CertifiedAnswer answer =
      certified(test::scaled(1.09), none, {test::fails(), test::polishes_to(1.0, 1e-13)});
  EXPECT_EQ(answer.certificate.status, CertificateStatus::certified);
  EXPECT_EQ(answer.certificate.source, "exact orbit");
  EXPECT_NEAR(answer.certificate.distance.value(), 0.09, 1e-12);
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
