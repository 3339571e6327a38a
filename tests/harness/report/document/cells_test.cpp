#include "harness/report/document/cells.hpp"

#include <gtest/gtest.h>

#include "tests/harness/sample_records.hpp"

namespace signorini::cells_test {
namespace {

TEST(ErrorText, BoundsAnErrorBelowTheErrorBarOfItsOrbit) {
  Record record = test::good_record("s", "m", "n=1", 3e-12, 1.0);
  record.certificate.error_bar = 1e-12;
  EXPECT_EQ(error_text(record), "<1.0e-11");
  record.errors.x_l2 = 3e-11;
  EXPECT_EQ(error_text(record), "3.0e-11");
  record.errors = {.u_l2 = 0.5};
  EXPECT_EQ(error_text(record), "5.0e-01 (u)");
  record.errors = {};
  EXPECT_EQ(error_text(record), "no scale");
}

TEST(TimeText, ChoosesTheUnit) {
  EXPECT_EQ(time_text(1.234e-5), "12.3 us");
  EXPECT_EQ(time_text(0.0123), "12.3 ms");
  EXPECT_EQ(time_text(12.34), "12.3 s");
}

TEST(OrbitText, CutsALongReasonBetweenCharacters) {
  Record record = test::good_record("s", "m", "n=1", 0.1, 0.5);
  record.certificate = {.status = CertificateStatus::uncertified,
                        .reason = std::string(59, 'x') + "≠ and more"};
  EXPECT_EQ(orbit_text(record), "uncertified: " + std::string(59, 'x') + "...");
  record.certificate.reason.clear();
  EXPECT_EQ(orbit_text(record), "uncertified: no reason given");
}

TEST(OrbitText, SaysWhyThereIsNoReference) {
  Record record = test::good_record("s", "m", "n=1", 0.1, 0.5);
  record.certificate.same_orbit.reset();
  record.certificate.reference_reason = "chaos";
  EXPECT_EQ(orbit_text(record), "0a1b2c3d, stability not determined (no reference: chaos)");
}

}  // namespace
}  // namespace signorini::cells_test
