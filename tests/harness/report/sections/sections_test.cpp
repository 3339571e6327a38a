#include "harness/report/sections/sections.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/harness/sample_records.hpp"

namespace signorini::sections_test {
namespace {

TEST(SectionsOf, ComeInTheOrderOfTheDocumentation) {
  std::vector<std::string> ids;
  for (const Section& section : sections_of(Evaluation(test::records_of_two_methods())))
    ids.push_back(section.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"summary", "outcomes", "speed", "time-to-error-1", "means-1",
                                           "distribution-1", "work-1", "scenes", "cases"}));
}

TEST(SectionsOf, OfOneSceneCompareNothingOverScenes) {
  std::vector<Record> records = test::records_of_two_methods();
  std::erase_if(records, [](const Record& record) { return record.scene != "s1"; });
  std::vector<std::string> ids;
  for (const Section& section : sections_of(Evaluation(records))) ids.push_back(section.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"summary", "outcomes", "speed", "scenes", "cases"}));
}

TEST(SectionsOf, HaveRowsAsLongAsTheirHeaderAndNamesOfTheirOwn) {
  std::vector<Record> records = test::records_of_a_run();
  records.push_back(test::good_record("scene-b", "method-d", "n=1", 0.1, 1.0));
  std::set<std::string> ids;
  for (const Section& section : sections_of(Evaluation(records))) {
    EXPECT_TRUE(ids.insert(section.id).second) << section.id;
    EXPECT_EQ(section.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string::npos)
        << section.id;
    EXPECT_FALSE(section.table.rows.empty()) << section.id;
    for (const auto& row : section.table.rows)
      EXPECT_EQ(row.size(), section.table.header.size()) << section.id;
  }
  EXPECT_TRUE(ids.contains("otherwise"));
  EXPECT_TRUE(ids.contains("other-laws"));
}

}  // namespace
}  // namespace signorini::sections_test
