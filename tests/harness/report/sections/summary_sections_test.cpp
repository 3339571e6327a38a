#include <gtest/gtest.h>

#include "harness/report/sections/sections.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

using Row = std::vector<std::string>;

/// The row of a section's table that begins with this cell.
Row row_of(const Section& section, const std::string& first) {
  Row texts;
  for (const auto& row : section.table.rows) {
    if (row.front().text != first) continue;
    for (const Cell& cell : row) texts.push_back(cell.text);
  }
  return texts;
}

TEST(SummarySections, CountEveryStatusOnce) {
  std::vector<Record> records;
  for (int i = 0; i < 5; ++i)
    records.push_back(test::good_record("s" + std::to_string(i), "m", "n=1", 0.1, 1.0 + i));
  records[1].status = Status::not_applicable;
  records[2].certificate.same_orbit = false;
  records[3].status = Status::inaccurate;
  records[4].status = Status::crashed;
  // method, cases, not applicable, converged, inaccurate, failed, certified, same, other, median of {1, 3,
  // inf, inf}
  EXPECT_EQ(row_of(summary_sections(Evaluation(records)).front(), "m"),
            (Row{"m", "5", "1", "2 of 4", "1", "1", "2", "1", "1", "half or more failed"}));
  records[3].status = Status::converged;
  EXPECT_EQ(row_of(summary_sections(Evaluation(records)).front(), "m").back(), "3.5 s")
      << "the middle of 1, 3, 4 and infinity";
}

TEST(SummarySections, SayWhyThereIsNoTime) {
  std::vector<Record> records{test::good_record("s", "m", "n=1", 0.1, 1.0)};
  const auto time = [&] { return row_of(summary_sections(Evaluation(records)).front(), "m").back(); };
  records[0].seconds.reset();
  EXPECT_EQ(time(), "not timed");
  records[0].status = Status::timeout;
  EXPECT_EQ(time(), "all failed");
  records[0].status = Status::not_applicable;
  EXPECT_EQ(time(), "no applicable case");
}

TEST(SpeedSections, CompareEachResolutionWithTheBaselineOnTheSameScene) {
  std::vector<Record> records;
  for (const double seconds : {1.0, 10.0, 100.0}) {
    const std::string scene = "s" + std::to_string(static_cast<int>(seconds));
    records.push_back(test::good_record(scene, "event-driven", "flow=cvode,tolerance=1e-6", 1e-6, seconds));
    records.push_back(test::good_record(scene, "m", "n=1", 0.1, 0.5 * seconds));
  }
  EXPECT_EQ(row_of(speed_sections(Evaluation(records)).front(), "m[n=1]"),
            (Row{"m[n=1]", "3 of 3", "1.0e-01", "5 s", "0.5"}));
}

TEST(SpeedSections, MeasureNothingWithoutABaseline) {
  const std::vector<Record> records{test::good_record("s", "m", "n=1", 0.1, 1.0)};
  EXPECT_EQ(row_of(speed_sections(Evaluation(records)).front(), "m[n=1]").back(), "not measured");
}

}  // namespace
}  // namespace signorini
