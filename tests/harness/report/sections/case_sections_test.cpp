#include "harness/report/sections/case_sections.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

TEST(CaseSections, HaveARowForEveryRecordWithTheValuesThatItIsSortedBy) {
  const Evaluation evaluation(test::records_of_a_run());
  const Section section = case_sections(evaluation).front();
  EXPECT_EQ(section.kind, SectionKind::cases);
  ASSERT_EQ(section.table.rows.size(), evaluation.records().size());
  for (std::size_t i = 0; i < section.table.rows.size(); ++i) {
    const std::vector<Cell>& row = section.table.rows[i];
    ASSERT_EQ(row.size(), section.table.header.size());
    EXPECT_EQ(row[0].text + "/" + row[2].text, evaluation.records()[i].case_id);
    EXPECT_EQ(row[5].record, i) << "the error leads to its record";
  }
}

TEST(CaseSections, SortWhatIsMissingBehindEveryNumber) {
  Record record = test::good_record("s", "m", "n=1", 0.125, 0.5);
  const auto value = [&](std::size_t column) {
    return case_sections(Evaluation({record})).front().table.rows.front()[column].value.value();
  };
  EXPECT_EQ(value(5), 0.125);
  EXPECT_EQ(value(8), 0.5);
  record.status = Status::inaccurate;
  record.errors = {};
  EXPECT_TRUE(std::isinf(value(5)));
  EXPECT_TRUE(std::isinf(value(8))) << "a wrong answer has no time";
}

TEST(RemarkSections, SayWhyARunDidNotConvergeOrIsNotCertified) {
  const Section section = remark_sections(Evaluation(test::records_of_every_status())).front();
  EXPECT_EQ(section.kind, SectionKind::remarks);
  ASSERT_EQ(section.table.rows.size(), 9U) << "all but the one that is certified";
  for (const auto& row : section.table.rows) {
    const std::string& status = row[1].text;
    const std::string expected = status == "uncertified"  ? "Newton's method failed"
                                 : status == "inaccurate" ? "penetrates the stop"
                                                          : "because of " + status;
    EXPECT_EQ(row[2].text, expected);
  }
}

}  // namespace
}  // namespace signorini
