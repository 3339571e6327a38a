// Methods from plugins beside ours, as reports print them.

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/report/sections/sections.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::rival_sections_test {
namespace {

TEST(RivalSections, TellTheRatioOfTimesWithItsRange) {
  std::vector<Record> records;
  for (const auto& [scene, seconds] : {std::pair("a", 2.0), std::pair("b", 200.0)}) {
    records.push_back(test::good_record(scene, "theirs", "n=1", 1e-3, seconds));
    records.back().plugin = "of somebody";
    records.back().work.counts.points = seconds > 10.0 ? 50 : 2;
    records.back().certificate.stable = true;
    records.push_back(test::good_record(scene, "ours", "n=1", 1e-8, 1.0));
  }
  const Evaluation evaluation(records);
  const Section section = rival_sections(evaluation).front();
  ASSERT_EQ(section.table.rows.size(), 1U);
  std::vector<std::string> texts;
  for (const Cell& cell : section.table.rows[0]) texts.push_back(cell.text);
  EXPECT_EQ(texts,
            (std::vector<std::string>{"theirs", "2 of 2", "2 stable", "20 (2 to 200)", "2 to 50",
                                      "2 (1 to 4)", "-", "0", "0 of 2", "-", "-", "-", "-", "-", "0"}));
  EXPECT_EQ(std::ranges::count(sections_of(evaluation), std::string("plugins"), &Section::id), 1);
}

TEST(RivalSections, AreInReportsWithPluginsAlone) {
  const Evaluation evaluation(test::records_of_two_methods());
  EXPECT_EQ(std::ranges::count(sections_of(evaluation), std::string("plugins"), &Section::id), 0);
}
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
}  // namespace signorini::rival_sections_test
