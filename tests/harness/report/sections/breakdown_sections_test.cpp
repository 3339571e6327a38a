// Families in reports: the severest level solved.

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/report/sections/sections.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::breakdown_sections_test {
namespace {

constexpr double kLevels[] = {0.1, 1e-2, 1e-4, 1e-6};

Record at_level(int severity, const std::string& method, double error) {
  const FamilyLevel family{.family = "grazing",
                           .parameter = "excess [-]",
                           .level = kLevels[severity - 1],
                           .severity = severity,
                           .levels = 4};
  Record record = test::good_record("grazing@" + level_label(family.level), method, "n=10", error, 1.0);
  record.family = family;
  return record;
}

/// The cell of a method in the section of this id.
std::string cell_of(const std::vector<Record>& records, const std::string& id, const std::string& method) {
  const Evaluation evaluation(records);
  for (const Section& section : breakdown_sections(evaluation)) {
    if (section.id != id) continue;
    for (std::size_t i = 0; i < section.table.header.size(); ++i) {
      if (section.table.header[i] == method) return section.table.rows.at(0).at(i).text;
    }
  }
  return "no such cell";
}

TEST(Breakdown, NamesTheSeverestLevelSolvedWithAllEasierOnes) {
  const std::vector<Record> records{at_level(1, "m", 1e-4), at_level(2, "m", 1e-4), at_level(3, "m", 1e-2),
                                    at_level(4, "m", 1e-4)};
  EXPECT_EQ(cell_of(records, "breakdown-1e-01", "m"), "all");
  EXPECT_EQ(cell_of(records, "breakdown-1e-03", "m"), "0.01 (3 of 4)");
}

TEST(Breakdown, DoesNotCountWhatIsNotCertified) {
  std::vector<Record> records{at_level(1, "m", 1e-4), at_level(2, "m", 1e-4)};
  records[0].certificate.status = CertificateStatus::uncertified;
  EXPECT_EQ(cell_of(records, "breakdown-1e-01", "m"), "none (1 of 2)");
  records[0] = at_level(1, "m", 1e-4);
  records[0].status = Status::inaccurate;
  EXPECT_EQ(cell_of(records, "breakdown-1e-01", "m"), "none (1 of 2)");
}

TEST(Breakdown, CountsALevelThatAnyResolutionSolves) {
  std::vector<Record> records{at_level(1, "m", 0.5), at_level(1, "m", 1e-4)};
  records[1].case_id += "finer";
  EXPECT_EQ(cell_of(records, "breakdown-1e-03", "m"), "0.1");
}

TEST(Breakdown, CountsLevelsOfAnotherLawApartAndProblemsOnce) {
  std::vector<Record> records{at_level(1, "m", 1e-4), at_level(2, "m", 1e-4), at_level(3, "m", 1e-4),
                              at_level(4, "m", 0.5)};
  for (std::size_t i = 1; i < 4; ++i) records[i].law_matches_scene = false;
  EXPECT_EQ(cell_of(records, "breakdown-1e-03", "m"), "0.1, ≠ 2 of 3");
  records[0].law_matches_scene = false;
  EXPECT_EQ(cell_of(records, "breakdown-1e-03", "m"), "≠ 3 of 4");
  for (const std::size_t i : {0U, 1U, 2U}) records[i].problem = "the same";
  EXPECT_EQ(cell_of(records, "breakdown-1e-03", "m"), "≠ 1 of 2");
  records[0].law_matches_scene = true;
  records[3].problem = "the same";
  EXPECT_EQ(cell_of(records, "breakdown-1e-03", "m"), "0.1");
}

TEST(Breakdown, SaysWhereEveryLevelCountsElsewhere) {
  std::vector<Record> records{at_level(1, "m", 1e-4), test::good_record("e1", "m", "n=10", 1e-4, 1.0)};
  for (Record& record : records) record.problem = "the same";
  records[0].law_matches_scene = false;
  EXPECT_EQ(cell_of(records, "breakdown-1e-03", "m"), "≠ counted elsewhere");
}

TEST(Breakdown, NamesTheLargestConditionEstimateOfACertifiedAnswer) {
  std::vector<Record> records{at_level(1, "m", 1e-4), at_level(2, "m", 1e-4), at_level(3, "m", 1e-4)};
  EXPECT_EQ(cell_of(records, "condition", "m"), "none");
  records[0].condition = 2e3;
  records[1].condition = 1e2;
  records[2].condition = 1e15;
  records[2].certificate.status = CertificateStatus::uncertified;
  EXPECT_EQ(cell_of(records, "condition", "m"), "2e+03");
}

TEST(Breakdown, IsLeftOutWhereThereAreNoFamilies) {
  const Evaluation evaluation(test::records_of_every_status());
  EXPECT_TRUE(breakdown_sections(evaluation).empty());
}

}  // namespace
}  // namespace signorini::breakdown_sections_test
