#include "harness/responses/response_record.hpp"

#include <gtest/gtest.h>

#include "harness/records/json_fields.hpp"
#include "tests/harness/responses/drawn_responses.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::response_record_test {
namespace {

ResponseRecord whole_record() {
  ResponseRecord record{.case_id = "s/m",
                        .key = "k",
                        .scene = "s",
                        .method = "m",
                        .by_steps = true,
                        .from = 1.0,
                        .to = 2.0,
                        .orders = 2,
                        .status = Status::converged,
                        .message = "fine",
                        .seconds = 0.25,
                        .points = 3};
  CurveComparison comparison{.close = {.covered = 0.5, .covered_stable = 0.75, .false_share = 0.125},
                             .exact_length = 2.0,
                             .length = 1.5,
                             .right_length = 1.25};
  comparison.points = {{.exact = {SpecialKind::fold, 1.5, 2}, .frequency = 1.51}};
  comparison.invented = {{SpecialKind::neimark_sacker, 1.75, 1}};
  record.comparison = comparison;
  record.located = {{SpecialKind::fold, 1.51, 2, 0.5}};
  record.open_ends = {"the time is up"};
  record.branches = {{.frequency = {1.0, 2.0}, .amplitude = {0.5, 0.25}, .stable = {1, -1}}};
  return record;
}

TEST(ResponseRecord, ComesBackFromItsLine) {
  const std::string line = response_line(whole_record());
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(response_line(response_from_line(line)), line);
  const ResponseRecord back = response_from_line(line);
  EXPECT_EQ(back.comparison->points[0].frequency, 1.51);
  EXPECT_EQ(back.located[0].amplitude, 0.5);
  EXPECT_FALSE(back.comparison->invented[0].amplitude.has_value());
  EXPECT_EQ(back.comparison->invented[0].kind, SpecialKind::neimark_sacker);
  EXPECT_EQ(back.branches[0].stable, (std::vector<int>{1, -1}));
}

TEST(ResponseRecord, RefusesALineThatIsNone) {
  EXPECT_THROW(response_from_line("{"), BadRecord);
  EXPECT_THROW(response_from_line("{\"case\":\"s/m\"}"), BadRecord);
  EXPECT_THROW(response_from_line("[]"), BadRecord);
}

TEST(ReadResponses, ReadsWhatWasWrittenAndNothingWhereThereIsNone) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(read_responses(folder.path()).empty());
  write_responses(folder.path(), {whole_record(), whole_record()});
  EXPECT_EQ(read_responses(folder.path()).size(), 2U);
}

TEST(ResponseRecord, HoldsNoControlCharactersAndNoOtherNames) {
  ResponseRecord record = whole_record();
  record.message = "x\x1b[2Jy";
  EXPECT_THROW(response_from_line(response_line(record)), BadRecord);
  record = whole_record();
  record.scene = "../s";
  EXPECT_THROW(response_from_line(response_line(record)), BadRecord);
}

TEST(ReadResponses, LeaveOutALineThatIsNone) {
  const test::TemporaryFolder folder;
  static_cast<void>(folder.write(kResponsesFile, "{\n" + response_line(whole_record()) + "\nnonsense\n"));
  EXPECT_EQ(read_responses(folder.path()).size(), 1U);
}

TEST(Drawn, HoldsFrequencyAmplitudeAndStabilityOfEachPoint) {
  ResponseCurve curve{.branches = {test::level_branch(1.0, 2.0, 3, 1.5)}};
  curve.branches[0].points[0].stable = true;
  curve.branches[0].points[1].stable = false;
  const std::vector<DrawnBranch> branches = drawn(curve);
  ASSERT_EQ(branches.size(), 1U);
  EXPECT_EQ(branches[0].frequency, (std::vector<double>{1.0, 1.5, 2.0}));
  EXPECT_NEAR(branches[0].amplitude[0], 1.5, 1e-12);
  EXPECT_EQ(branches[0].stable, (std::vector<int>{1, 0, -1}));
}

}  // namespace
}  // namespace signorini::response_record_test
