#include "harness/judge/certificate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "harness/run_folder/record_store.hpp"
#include "tests/harness/judge/fake_orbits.hpp"
#include "tests/harness/stored_records.hpp"
#include "tests/support/data_folder.hpp"

namespace signorini::certificate_test {
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
  EXPECT_EQ(answer.certificate.expired, false);
}

TEST(Certify, SaysThatItsTimeWasUp) {
  const auto answer = test::scaled(1.001);
  const CertifiedAnswer late = certify(test::one_mass(), answer, sample_motion(test::one_mass(), *answer), {},
                                       test::fails("no time"), Deadline::min());
  EXPECT_EQ(late.certificate.status, CertificateStatus::uncertified);
  EXPECT_EQ(late.certificate.expired, true);
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

/// Polishes every answer to nothing, or to a motion that is not confirmed.
OrbitPolisher unconfirmed(std::shared_ptr<const Trajectory> candidate = {}) {
  return [=](const Problem&, const Trajectory&, std::span<const Certificate>, Deadline) {
    return CertifiedOrbit{.reason = "CVODE does not come back", .unconfirmed = candidate};
  };
}

// Claims 0.6 to 74 away from the only orbit found were left open because the other search had failed.
TEST(Certify, RefutesByDistanceWhicheverSearchFails) {
  const Reference none{.orbit = {}, .reason = "chaos"};
  const OrbitTools polished{test::fails(), test::polishes_to(1.0, 1e-13)},
      shot{test::finds(1.0, 1.0), unconfirmed()};
  for (const OrbitTools& tools : {polished, shot}) {
    const Certificate far = certified(test::scaled(1.6), none, tools).certificate;
    EXPECT_NE(far.refutation.find("0.6 away"), std::string::npos) << far.reason;
    EXPECT_NEAR(far.distance.value(), 0.6, 1e-12);
    EXPECT_EQ(certified(test::scaled(1.4), none, tools).certificate.refutation, "");
  }
}

TEST(Certify, DoesNotRefuteWhatIsNearAMotionThatIsNotConfirmed) {
  const Reference none{.orbit = {}, .reason = "chaos"};
  const OrbitTools tools{test::finds(1.0, 1.0), unconfirmed(test::scaled(3.0))};
  const Certificate open = certified(test::scaled(2.9), none, tools).certificate;
  EXPECT_EQ(open.status, CertificateStatus::uncertified);
  EXPECT_EQ(open.refutation, "");
  EXPECT_NE(open.reason.find("CVODE does not come back"), std::string::npos) << open.reason;
  EXPECT_NEAR(open.distance.value(), 0.1 / 3.0, 1e-12);
  EXPECT_NE(certified(test::scaled(5.0), none, tools).certificate.refutation, "");
}

// Three times the contact-free motion, without a contact force, is the response to no force that it shows.
TEST(Certify, RefutesWhatIsOffItsOwnEquationsWhereNoOrbitIsFound) {
  const Reference none{.orbit = {}, .reason = "chaos"};
  const OrbitTools tools{test::fails("diverged"), unconfirmed()};
  const Certificate wrong = certified(test::scaled(3.0), none, tools).certificate;
  EXPECT_NE(wrong.refutation.find("response to its own contact force"), std::string::npos) << wrong.reason;
  EXPECT_EQ(certified(test::scaled(1.3), none, tools).certificate.refutation, "");
}

TEST(Certify, AsksLessOfAKnownOrbitThatIsFarAwayAndNothingOfOneNearBy) {
  const Reference known = compute_reference(test::one_mass(), test::finds(3.0, 3.0), Deadline::max());
  const OrbitTools tools{test::fails("diverged"), unconfirmed()};
  const Certificate far = certified(test::scaled(1.3), known, tools).certificate;
  EXPECT_NE(far.refutation.find("from the motion reached from rest"), std::string::npos) << far.reason;
  EXPECT_EQ(certified(test::scaled(1.0), known, tools).certificate.refutation, "")
      << "it solves its equations";
  EXPECT_EQ(certified(test::scaled(3.1), known, tools).certificate.refutation, "") << "a known orbit is near";
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

/// Whether an answer without the impulses of its orbit was certified.
bool lacks_its_impulses(const Record& record) {
  const auto hits = [](const OrbitEvent& event) { return event.kind != ContactEvent::Kind::open; };
  const bool orbit_hits = std::ranges::any_of(record.certificate.events, hits);
  const bool touches =
      record.physics.contact_ratio.value_or(0.0) > 0.0 || !record.physics.effective_restitution.empty();
  constexpr double kFactorOfTwo = 1.02;  // |2 J - J| / |J|, and contacts that hardly press
  // Impacts too slow for a ratio of speeds leave no other trace than their impulse: without them it is 1.
  const double off = record.errors.impulse.value_or(touches ? 0.0 : 1.0);
  return orbit_hits && off > (touches ? kFactorOfTwo : 0.5);
}

// The rule holds of every record in results/, and each was judged by it.
/// The status after the verdict of an answer with these physics, on which the certificate is silent.
Status verdict_on(const Physics& physics, const RepresentedLaw& law = Massless{}) {
  Record record;
  record.status = Status::converged;
  record.certificate.status = CertificateStatus::uncertified;
  record.law = law;
  record.physics = physics;
  apply_verdict(record);
  return record.status;
}

TEST(ApplyVerdict, RefutesWhatBreaksTheLawOfContactByHalfTheAmplitude) {
  EXPECT_EQ(verdict_on({}), Status::converged) << "nothing was measured";
  EXPECT_EQ(verdict_on({.penetration = 0.1, .complementarity = 0.1}), Status::converged);
  EXPECT_EQ(verdict_on({.penetration = 0.6, .complementarity = 0.1}), Status::inaccurate);
  EXPECT_EQ(verdict_on({.penetration = 0.0, .complementarity = 230.0}), Status::inaccurate)
      << "a stop that pushes from afar";
  EXPECT_EQ(verdict_on({.penetration = 0.6, .complementarity = 0.1}, Penalty{.stiffness = {1.0}}),
            Status::converged)
      << "a spring yields";
  EXPECT_EQ(verdict_on({.complementarity = 0.6}, Penalty{.stiffness = {1.0}}), Status::inaccurate);
}

TEST(CommittedRecords, AreNotCertifiedByMotionsWithoutTheImpulsesOfTheirOrbits) {
  constexpr int kAsksForImpulses = 2;  // the rule that did first
  for (const auto& folder : std::filesystem::directory_iterator(test::data_folder() / "../../results")) {
    const std::filesystem::path file = folder.path() / "records.jsonl";
    if (!std::filesystem::exists(file)) continue;
    for (const Record& record : read_records(file)) {
      if (record.certificate.status != CertificateStatus::certified) continue;
      EXPECT_GE(record.certificate.rule.value_or(1), kAsksForImpulses) << file << ": " << record.case_id;
      EXPECT_FALSE(lacks_its_impulses(record)) << file << ": " << record.case_id;
    }
  }
}

TEST(CommittedRecords, WouldBeFoundOutWithoutImpulses) {
  Record record;
  record.certificate.events = {
      {.time = 0.5, .contact = 0, .kind = ContactEvent::Kind::impact, .value = -1.0}};
  record.errors.impulse = 1.0;
  EXPECT_TRUE(lacks_its_impulses(record));
  record.physics.effective_restitution = {1.0};
  EXPECT_FALSE(lacks_its_impulses(record)) << "twice the impulse is allowed";
  record.errors.impulse = 1.1;
  EXPECT_TRUE(lacks_its_impulses(record));
  record.physics.effective_restitution.clear();
  record.errors.impulse = 1e-9;
  EXPECT_FALSE(lacks_its_impulses(record)) << "slow impacts, all of them";
  record.errors.impulse.reset();
  EXPECT_TRUE(lacks_its_impulses(record));
  record.certificate.events.clear();
  EXPECT_FALSE(lacks_its_impulses(record));
}

}  // namespace
}  // namespace signorini::certificate_test
