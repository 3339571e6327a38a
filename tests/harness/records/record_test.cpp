#include "harness/records/record.hpp"

#include <gtest/gtest.h>

#include <set>

namespace signorini::record_test {
namespace {

TEST(Record, HasANameForEveryStatusAndCertificate) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(Status::invalid_output); ++i)
    names.insert(status_name(static_cast<Status>(i)));
  EXPECT_EQ(names.size(), EnumNames<Status>::values.size());
  EXPECT_EQ(status_name(Status::not_applicable), "not-applicable");
  EXPECT_EQ(status_name(Status::invalid_output), "invalid-output");
  EXPECT_EQ(EnumNames<CertificateStatus>::values.size(), 3U);
  EXPECT_EQ(EnumNames<CertificateStatus>::values.back(), "certified");
}

TEST(ResolutionOf, IsTheMethodWithItsSettings) {
  EXPECT_EQ(resolution_of({.scene = "s", .method = "m", .settings = {{"a", "1"}, {"b", "x"}}}), "m[a=1,b=x]");
  EXPECT_EQ(resolution_of({.method = "m"}), "m");
}

TEST(CountRepeat, CountsSolvesWhoseAnswerHasTheSameDigest) {
  Record record{.answer = "0123"};
  EXPECT_FALSE(record.repeats.has_value());
  count_repeat("0123", record);
  count_repeat("0124", record);
  EXPECT_EQ(record.repeats->solves, 2);
  EXPECT_EQ(record.repeats->identical, 1);
}

TEST(LevelError, IsTheLargestOfMotionWorstContactAndForce) {
  Record record;
  EXPECT_EQ(level_error(record), std::nullopt);
  record.errors.u_l2 = 0.02;
  EXPECT_EQ(level_error(record), 0.02) << "a scene without contact";
  record.errors.x_l2 = 0.01;
  record.errors.force_l2 = 0.3;
  EXPECT_EQ(level_error(record), 0.01) << "a record of an earlier version";
  record.errors.x_worst = 0.03;
  record.errors.force = 0.04;
  EXPECT_EQ(level_error(record), 0.04);
  record.law = Penalty{.stiffness = {1.0}};
  EXPECT_EQ(level_error(record), 0.3);
  record.errors.x_worst = 0.4;
  EXPECT_EQ(level_error(record), 0.4);
}

TEST(MeasurableError, IsTenErrorBarsOfTheOrbit) {
  Record record;
  EXPECT_EQ(measurable_error(record), 0.0);
  record.certificate.error_bar = 1e-12;
  EXPECT_DOUBLE_EQ(measurable_error(record), 1e-11);
  record.certificate.return_distance = 3e-11;
  EXPECT_DOUBLE_EQ(measurable_error(record), 3e-11);
  record.certificate.return_distance = 3e-12;
  EXPECT_DOUBLE_EQ(measurable_error(record), 1e-11);
}

// x_{k+1} = mu x_k: a state that is off by d comes back off by mu d, a distance (1 - mu) d away.
TEST(MeasurableError, CountsAReturnByHowSlowlyAnErrorShowsInIt) {
  Record record;
  const double off = 1e-8, mu = 0.999;
  record.certificate.return_distance = (1.0 - mu) * off;
  record.certificate.floquet = {{mu, 0.0}, {-0.5, 0.0}};
  EXPECT_NEAR(measurable_error(record), off, 1e-6 * off);
  record.certificate.floquet = {{-0.5, 0.0}, {-2.0, 0.0}};
  EXPECT_DOUBLE_EQ(measurable_error(record), (1.0 - mu) * off) << "no error shows less than itself";
}

TEST(AsRepresented, KeepsTheLawAndItsConstant) {
  EXPECT_EQ(std::get<Restitution>(as_represented(Restitution{0.3})).e, 0.3);
  EXPECT_TRUE(std::holds_alternative<Massless>(as_represented(Massless{})));
}

TEST(LawText, NamesEveryLaw) {
  EXPECT_EQ(law_text(Restitution{0.8}), "e = 0.8");
  EXPECT_EQ(law_text(Penalty{{1e6, 1e6}}), "k = 1e+06 N/m");
  EXPECT_EQ(law_text(Penalty{{1.0, 2.0}}), "k = 1, 2 N/m");
  EXPECT_EQ(law_text(Massless{}), "massless");
  EXPECT_EQ(law_text(MixedLaws{{Restitution{0.7}, Spring{2e4}, Massless{}}}),
            "mixed: e = 0.7; k = 20000 N/m; massless");
  EXPECT_EQ(law_text(Undetermined{}), "undetermined");
  EXPECT_EQ(law_text(std::monostate{}), "no contact");
}

TEST(LawRemark, NamesTheLawOfAMethodWhereTheSceneHasAnother) {
  Record record;
  EXPECT_EQ(law_remark(record), "") << "not known";
  record.law = Restitution{1.0};
  record.law_matches_scene = true;
  EXPECT_EQ(law_remark(record), "");
  record.law_matches_scene = false;
  EXPECT_EQ(law_remark(record), "e = 1");
}

}  // namespace
}  // namespace signorini::record_test
