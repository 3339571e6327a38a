#include <gtest/gtest.h>

#include "harness/report/sections/sections.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

using Row = std::vector<std::string>;

Row texts_of(const std::vector<Cell>& row) {
  Row texts;
  for (const Cell& cell : row) texts.push_back(cell.text);
  return texts;
}

TEST(SceneSections, GiveTheCheapestRunThatReachesEachError) {
  const std::vector<Record> records{test::good_record("s", "m", "n=1", 0.05, 1e-3),
                                    test::good_record("s", "m", "n=2", 5e-4, 1e-2),
                                    test::good_record("s", "m", "n=3", 5e-3, 0.5)};
  const Section section = scene_sections(Evaluation(records)).front();
  EXPECT_EQ(section.kind, SectionKind::scenes);
  ASSERT_EQ(section.table.rows.size(), 1U);
  // To 1e-1, 1e-2, 1e-3, 1e-6 and 1e-9: n=3 is accurate enough for 1e-2, but slower than n=2.
  EXPECT_EQ(texts_of(section.table.rows[0]),
            (Row{"s", "m", "e = 1", "3 of 3", "1 ms", "10 ms", "10 ms", "not reached", "not reached"}));
  EXPECT_EQ(section.table.rows[0][5].record, 1U) << "n=2";
}

TEST(SceneSections, CreditNoTimeWhereThereIsNone) {
  std::vector<Record> records{test::good_record("s", "m", "n=1", 0.05, 1.0)};
  records[0].seconds.reset();
  EXPECT_EQ(texts_of(scene_sections(Evaluation(records)).front().table.rows[0])[4], "not timed");
}

TEST(OtherLawSections, ShowWhatIsRankedAgainstNobody) {
  std::vector<Record> records{test::good_record("s", "a", "n=1", 0.05, 1.0),
                              test::good_record("s", "b", "n=1", 0.05, 1.0)};
  records[1].law_matches_scene = false;
  records[1].law = Penalty{{1e3}};
  const Evaluation evaluation(records);
  const Section own = scene_sections(evaluation).front(), other = other_law_sections(evaluation).front();
  ASSERT_EQ(own.table.rows.size(), 1U);
  EXPECT_EQ(own.table.rows[0][1].text, "a");
  ASSERT_EQ(other.table.rows.size(), 1U);
  EXPECT_EQ(other.table.rows[0][1].text, "b");
  EXPECT_EQ(other.table.rows[0][2].text, "k = 1000 N/m");
}

}  // namespace
}  // namespace signorini
