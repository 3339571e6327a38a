#include "harness/report/evaluation/outcome.hpp"

#include <gtest/gtest.h>

#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

TEST(CertifiedError, IsThatOfXOrOfUAndNeverBelowTenErrorBars) {
  Record record = test::good_record("s", "m", "n=1", 1e-15, 1.0);
  record.certificate.error_bar = 1e-12;
  EXPECT_EQ(recorded_error(record), 1e-15);
  EXPECT_DOUBLE_EQ(certified_error(record).value(), 1e-11);
  record.errors = {.u_l2 = 0.5};
  EXPECT_EQ(certified_error(record), 0.5);
  record.status = Status::inaccurate;
  EXPECT_EQ(bounded_error(record), 0.5);
  EXPECT_FALSE(certified_error(record).has_value());
  record.errors = {};
  EXPECT_FALSE(bounded_error(record).has_value());
}

TEST(OutcomeCounts, HoldEveryCaseOnce) {
  OutcomeCounts counts;
  int answers = 0;
  for (const Record& record : test::records_of_every_status()) {
    counts.add(record);
    answers += claim_of(record) ? 1 : 0;
  }
  EXPECT_EQ(answers, counts.claims());
  EXPECT_EQ(counts.cases, 10);
  EXPECT_EQ(counts.not_applicable, 1);
  EXPECT_EQ(counts.failed, 6);
  EXPECT_EQ(counts.refuted, 1);
  EXPECT_EQ(counts.unproven, 1);
  EXPECT_EQ(counts.certified, 1);
  EXPECT_EQ(counts.same_orbit + counts.other_orbit, 1);
  EXPECT_EQ(counts.converged(), 2);
  EXPECT_EQ(counts.claims(), 3);
  EXPECT_EQ(counts.applicable(), 9);
}

}  // namespace
}  // namespace signorini
