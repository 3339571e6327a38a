#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "harness/report/sections/sections.hpp"
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

/// The text of a record's cell below this title.
std::string text_of(const Record& record, const std::string& title) {
  const Table table = case_sections(Evaluation({record})).front().table;
  const auto column = std::ranges::find(table.header, title) - table.header.begin();
  return table.rows.front().at(static_cast<std::size_t>(column)).text;
}

TEST(CaseSections, ShowNoTimeOfAnAnswerThatIsWrong) {
  Record record = test::good_record("s", "m", "n=1", 0.1, 0.5);
  EXPECT_EQ(text_of(record, "time median"), "500 ms");
  record.seconds->unstable = true;
  EXPECT_EQ(text_of(record, "time median"), "500 ms (unstable)");
  EXPECT_EQ(text_of(record, "time min"), "450 ms");
  record.status = Status::inaccurate;
  EXPECT_EQ(text_of(record, "time median"), "(inaccurate)");
  record.status = Status::converged;
  record.seconds.reset();
  EXPECT_EQ(text_of(record, "time median"), "not timed");
  record.not_timed = "not a Release build";
  EXPECT_EQ(text_of(record, "time median"), "not timed: not a Release build");
}

TEST(CaseSections, NameTheCountsThatThereAre) {
  Record record = test::good_record("s", "m", "n=1", 0.1, 0.5);
  EXPECT_EQ(text_of(record, "pivots, iterations"), "12 p");
  record.work.counts.iterations = 3;
  EXPECT_EQ(text_of(record, "pivots, iterations"), "12 p, 3 it");
  record.work.counts.pivots.reset();
  EXPECT_EQ(text_of(record, "pivots, iterations"), "3 it");
  record.work = {};
  EXPECT_EQ(text_of(record, "pivots, iterations"), "not counted");
  record.status = Status::timeout;
  EXPECT_EQ(text_of(record, "pivots, iterations"), "(timeout)");
}

}  // namespace
}  // namespace signorini
