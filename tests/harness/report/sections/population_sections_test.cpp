// Shares and rates of scenes that are drawn, with their intervals.

#include <gtest/gtest.h>

#include "harness/report/sections/sections.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::population_sections_test {
namespace {

Record drawn(int number) {
  Record record = test::good_record("mass@7-" + std::to_string(number), "hat-lcp", "samples=64", 0.1, 1.0);
  record.instance =
      SceneInstance{.scene = "mass", .seed = 7, .number = number, .values = {{"contact[0].gap", 0.2}}};
  return record;
}

TEST(PopulationSections, GiveSharesWithTheirIntervals) {
  std::vector<Record> records;
  for (int number = 1; number <= 10; ++number) records.push_back(drawn(number));
  records.back().status = Status::inaccurate;
  records.back().certificate.status = CertificateStatus::uncertified;
  records.push_back(test::good_record("sdof-stop", "hat-lcp", "samples=64", 0.1, 1.0));  // of the catalogue
  const Evaluation evaluation(records);
  const Section section = population_sections(evaluation).front();
  EXPECT_EQ(section.title, "10 scenes drawn at random");
  ASSERT_EQ(section.table.rows.size(), 1U);
  EXPECT_EQ(section.table.rows[0][1].text, "9 of 10 (59.6 to 98.2 %)");
  EXPECT_EQ(section.table.rows[0][2].text, "10");
  EXPECT_EQ(section.table.rows[0][3].text, "1 of 10 (17.9 to 404)");
}

TEST(PopulationSections, AreNotThereWhereNothingIsDrawn) {
  const std::vector<Record> records{test::good_record("sdof-stop", "hat-lcp", "samples=64", 0.1, 1.0)};
  EXPECT_TRUE(population_sections(Evaluation(records)).empty());
}

}  // namespace
}  // namespace signorini::population_sections_test
