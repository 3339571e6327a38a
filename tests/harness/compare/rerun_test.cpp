#include "harness/compare/rerun.hpp"

#include <gtest/gtest.h>

namespace signorini::rerun_test {
namespace {

Record sample() {
  Record record{.case_id = "scene/method[n=1]", .status = Status::converged};
  record.certificate.status = CertificateStatus::certified;
  record.certificate.error_bar = 1e-12;
  record.errors.x_l2 = 1e-3;
  return record;
}

TEST(CompareRecords, FindsNoDifferenceInTheSameAccuracyAtAnySpeed) {
  Record now = sample();
  now.seconds = Seconds{.median = 1e3};
  now.errors.x_l2 = 1e-3 * kErrorFactor * 0.99;
  EXPECT_TRUE(compare_records(sample(), now).empty());
}

TEST(CompareRecords, ReportsAnErrorBeyondTheFactorEitherWay) {
  for (const double factor : {kErrorFactor * 1.01, 1.0 / (kErrorFactor * 1.01)}) {
    Record now = sample();
    now.errors.x_l2 = 1e-3 * factor;
    ASSERT_EQ(compare_records(sample(), now).size(), 1U);
    EXPECT_NE(compare_records(sample(), now).front().find("error of x 1.00e-03 became"), std::string::npos);
  }
}

TEST(CompareRecords, IgnoresErrorsBelowTenErrorBars) {
  Record kept = sample(), now = sample();
  kept.errors.x_l2 = 1e-13;
  now.errors.x_l2 = 9e-12;
  EXPECT_TRUE(compare_records(kept, now).empty());
  now.errors.x_l2 = 2e-11;
  EXPECT_EQ(compare_records(kept, now).size(), 1U);
}

TEST(CompareRecords, ReportsAnotherStatusUnlessATimeLimitDecidedIt) {
  Record now = sample();
  now.status = Status::inaccurate;
  now.message = "penetrates";
  EXPECT_EQ(compare_records(sample(), now).front(),
            "scene/method[n=1]: converged became inaccurate: penetrates");
  now.status = Status::timeout;
  EXPECT_TRUE(compare_records(sample(), now).empty());
  now = sample();
  now.certificate.status = CertificateStatus::uncertified;
  now.certificate.expired = false;
  EXPECT_EQ(compare_records(sample(), now).size(), 1U);
  now.certificate.expired = true;
  EXPECT_TRUE(compare_records(sample(), now).empty());
}

// Nobody excuses a certificate that does not come out by saying that there was no time for it.
TEST(CompareRecords, ReportsACertificateThatIsLostWhateverItsRecordSaysOfTime) {
  Record kept = sample(), now = sample();
  kept.certificate.expired = true;
  now.status = Status::inaccurate;
  now.certificate.status = CertificateStatus::uncertified;
  EXPECT_EQ(compare_records(kept, now).size(), 1U);
}

TEST(CompareRecords, ReportsALostCertificateAndALostError) {
  Record now = sample();
  now.certificate.status = CertificateStatus::uncertified;
  now.certificate.reason = "grazing";
  EXPECT_EQ(compare_records(sample(), now).front(),
            "scene/method[n=1]: certificate certified became uncertified: grazing");
  now = sample();
  now.errors.x_l2.reset();
  EXPECT_EQ(compare_records(sample(), now).size(), 1U);
}

}  // namespace
}  // namespace signorini::rerun_test
