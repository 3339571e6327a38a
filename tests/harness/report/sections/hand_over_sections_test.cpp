// What the times of commands leave out, as reports print it.

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/report/sections/sections.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::hand_over_sections_test {
namespace {

TEST(HandOverSections, StandBesideTheOwnTime) {
  std::vector<Record> records{test::good_record("s", "command", "n=1", 1e-3, 2e-3),
                              test::good_record("s", "ours", "n=1", 1e-3, 1e-3)};
  records[0].seconds->exchange = 5e-4;
  const Section section = hand_over_sections(Evaluation(records)).front();
  ASSERT_EQ(section.table.rows.size(), 1U);
  std::vector<std::string> texts;
  for (const Cell& cell : section.table.rows[0]) texts.push_back(cell.text);
  EXPECT_EQ(texts, (std::vector<std::string>{"command", "1", "2 ms", "500 us", "0.25"}));
}

TEST(HandOverSections, AreInReportsOfCommandsAlone) {
  const auto has_one = [](const std::vector<Record>& records) {
    const Evaluation evaluation(records);
    return std::ranges::count(sections_of(evaluation), std::string("hand-over"), &Section::id);
  };
  std::vector<Record> records = test::records_of_two_methods();
  EXPECT_EQ(has_one(records), 0);
  records[0].seconds->exchange = 1.0;
  EXPECT_EQ(has_one(records), 1);
}

}  // namespace
}  // namespace signorini::hand_over_sections_test
