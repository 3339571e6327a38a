#include "harness/responses/exact_response.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/records/record_json.hpp"
#include "tests/harness/responses/drawn_responses.hpp"
#include "tests/harness/responses/sample_responses.hpp"
#include "tests/problems/temporary_folder.hpp"

namespace signorini::exact_response_test {
namespace {

/// A branch of motions of one period, one of two, and a step.
ResponseCurve curve() {
  ResponseCurve all{
      .branches = {test::level_branch(1.0, 2.0, 3, 1.5),
                   {.points = {test::moving(1.2, 1.0, 2, 0.5), test::moving(1.3, 1.0, 2, 0.25)}},
                   {.points = {test::moving(1.4, 2.0)}, .by_arc_length = false}}};
  all.branches[0].points[0].stable = true;
  all.branches[0].points[1].stable = false;
  return all;
}

Record record_of(const ResponseCurve& exact) {
  Record record = test::exact_response("s");
  record.scene_sha256 = "h";
  record.response->branches = drawn_with_motions(exact);
  return record;
}

void expect_same(const ResponseCurve& a, const ResponseCurve& b) {
  ASSERT_EQ(a.branches.size(), b.branches.size());
  for (std::size_t i = 0; i < a.branches.size(); ++i) {
    EXPECT_EQ(a.branches[i].by_arc_length, b.branches[i].by_arc_length);
    ASSERT_EQ(a.branches[i].points.size(), b.branches[i].points.size());
    for (std::size_t k = 0; k < a.branches[i].points.size(); ++k) {
      const ResponsePoint &p = a.branches[i].points[k], &q = b.branches[i].points[k];
      EXPECT_EQ(p.frequency, q.frequency);
      EXPECT_EQ(p.order, q.order);
      EXPECT_LE((p.motion - q.motion).cwiseAbs().maxCoeff(), 5e-4 * half_range(q.motion));
      EXPECT_EQ(p.stable, q.stable);
    }
  }
}

TEST(ExactResponse, KeepsItsMotionsToAShareOfTheirSizeAndLeavesTheRecordWithout) {
  const test::TemporaryFolder folder;
  Record record = record_of(curve());
  ExactResponse kept(folder.path());
  kept.take(record);
  expect_same(kept.curve(), curve());
  EXPECT_EQ(to_json(record).dump().find("motion"), std::string::npos);
  ExactResponse read(folder.path());
  ASSERT_TRUE(read.read("s", record.key));
  expect_same(read.curve(), curve());
}

TEST(ExactResponse, IsNotThatOfAnotherKeySceneOrADamagedFile) {
  const test::TemporaryFolder folder;
  Record record = record_of(curve());
  ExactResponse(folder.path()).take(record);
  ExactResponse read(folder.path());
  EXPECT_FALSE(read.read("s", "another key"));
  EXPECT_FALSE(read.read("t", record.key));
  static_cast<void>(folder.write("exact/s.json", "{\"schema\": 1, \"key\""));
  EXPECT_FALSE(read.read("s", record.key));
  EXPECT_TRUE(read.curve().branches.empty());
}

TEST(ExactResponse, NeedsNoFolder) {
  Record record = record_of(curve());
  ExactResponse kept;
  kept.take(record);
  EXPECT_EQ(kept.curve().branches.size(), 3U);
  EXPECT_FALSE(kept.read("s", record.key));
}

TEST(Drawn, HoldsFrequencyAmplitudeAndStabilityOfEachPoint) {
  const std::vector<DrawnBranch> branches = drawn(curve());
  ASSERT_EQ(branches.size(), 3U);
  EXPECT_EQ(branches[0].frequency, (std::vector<double>{1.0, 1.5, 2.0}));
  EXPECT_NEAR(branches[0].amplitude[0], 1.5, 1e-12);
  EXPECT_EQ(branches[0].stable, (std::vector<int>{1, 0, -1}));
  EXPECT_TRUE(branches[0].motion.empty());
}

}  // namespace
}  // namespace signorini::exact_response_test
