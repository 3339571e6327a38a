#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "harness/report/sections/sections.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::case_sections_test {
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
  EXPECT_EQ(texts_of(section.table.rows[0]), (Row{"s", "m", "e = 1", "3 of 3", "3 not determined", "1 ms",
                                                  "10 ms", "10 ms", "not reached", "not reached"}));
  EXPECT_EQ(section.table.rows[0][6].record, 1U) << "n=2";
}

TEST(SceneSections, CreditNoTimeWhereThereIsNone) {
  std::vector<Record> records{test::good_record("s", "m", "n=1", 0.05, 1.0)};
  records[0].seconds.reset();
  EXPECT_EQ(texts_of(scene_sections(Evaluation(records)).front().table.rows[0])[5], "not timed");
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

TEST(CaseSections, HaveARowForEveryRecordWithTheValuesThatItIsSortedBy) {
  const Evaluation evaluation(test::records_of_a_run());
  const Section section = case_sections(evaluation).front();
  EXPECT_EQ(section.kind, SectionKind::cases);
  ASSERT_EQ(section.table.rows.size(), evaluation.results().size());
  for (std::size_t i = 0; i < section.table.rows.size(); ++i) {
    const std::vector<Cell>& row = section.table.rows[i];
    ASSERT_EQ(row.size(), section.table.header.size());
    EXPECT_EQ(row[0].text + "/" + row[2].text, evaluation.results()[i].case_id);
    EXPECT_EQ(row[5].record, i) << "the error leads to its record";
  }
}

TEST(CaseSections, SortWhatIsMissingBehindEveryNumber) {
  Record record = test::good_record("s", "m", "n=1", 0.125, 0.5);
  const auto value = [&](std::size_t column) {
    return case_sections(Evaluation({record})).front().table.rows.front()[column].value.value();
  };
  EXPECT_EQ(value(5), 0.125);
  EXPECT_EQ(value(12), 0.5);
  record.status = Status::inaccurate;
  record.errors = {};
  EXPECT_TRUE(std::isinf(value(5)));
  EXPECT_TRUE(std::isinf(value(12))) << "a wrong answer has no time";
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
  EXPECT_EQ(text_of(record, "time"), "500 ms");
  record.seconds->unstable = true;
  EXPECT_EQ(text_of(record, "time"), "500 ms (unstable)");
  record.seconds->unsteady = true;
  EXPECT_EQ(text_of(record, "time"), "500 ms (unsteady)");
  record.seconds->load = 1.5;
  EXPECT_EQ(text_of(record, "time"), "500 ms (unsteady) (loaded)");
  EXPECT_EQ(text_of(record, "first"), "-") << "of an earlier version";
  record.seconds->first = 0.75;
  EXPECT_EQ(text_of(record, "first"), "750 ms");
  record.status = Status::inaccurate;
  EXPECT_EQ(text_of(record, "time"), "(inaccurate)");
  EXPECT_EQ(text_of(record, "first"), "(inaccurate)");
  record.status = Status::converged;
  record.seconds.reset();
  EXPECT_EQ(text_of(record, "time"), "not timed");
  record.not_timed = "not a Release build";
  EXPECT_EQ(text_of(record, "time"), "not timed: not a Release build");
}

TEST(CaseSections, SayWhetherTheMotionIsStableAndTouchesAnything) {
  Record record = test::good_record("s", "m", "n=1", 0.1, 0.5);
  EXPECT_EQ(text_of(record, "orbit"), "same, stability not determined");
  record.certificate.stable = true;
  EXPECT_EQ(text_of(record, "orbit"), "same, stable");
  record.physics.contact_ratio = 0.0;  // and no event
  EXPECT_EQ(text_of(record, "orbit"), "same, stable, without contact");
  record.certificate.stable = false;
  record.certificate.same_orbit.reset();
  record.certificate.reference_reason = "the time is up";
  record.physics.contact_ratio = 1.0;  // closed throughout
  EXPECT_EQ(text_of(record, "orbit"), "0a1b2c3d, unstable (no reference: the time is up)");
  record.work.counts = {.iterations = 3, .points = 186};
  EXPECT_EQ(text_of(record, "pivots, iterations"), "3 it, 186 points");
}

TEST(CaseSections, ShowTheForceBesideTheMotion) {
  Record record = test::good_record("s", "m", "n=1", 0.1, 0.5);
  for (const char* title :
       {"off the scene's motion", "error of force", "penetration", "complementarity", "restitution"})
    EXPECT_EQ(text_of(record, title), "-") << title << ": an old record has none";
  record.errors.x_l2_scene = 0.37;
  record.errors.impulse = 0.25;
  record.physics.penetration = 2e-3;
  record.physics.complementarity = 3e-4;
  EXPECT_EQ(text_of(record, "off the scene's motion"), "3.7e-01");
  EXPECT_EQ(text_of(record, "error of force"), "2.5e-01");
  EXPECT_EQ(text_of(record, "penetration"), "2.0e-03");
  EXPECT_EQ(text_of(record, "complementarity"), "3.0e-04");
  record.errors.force_l2 = 0.04;
  EXPECT_EQ(text_of(record, "error of force"), "4.0e-02 (L2)");
  record.status = Status::timeout;
  EXPECT_EQ(text_of(record, "error of force"), "(timeout)");
}

TEST(CaseSections, ShowTheRestitutionThatTheImpactsHave) {
  Record record = test::good_record("s", "m", "n=1", 0.1, 0.5);
  record.physics.effective_restitution = {0.5};
  EXPECT_EQ(text_of(record, "restitution"), "0.50");
  record.physics.effective_restitution = {0.81, 0.788, 0.8};
  EXPECT_EQ(text_of(record, "restitution"), "0.79 to 0.81");
  record.physics.effective_restitution.clear();
  EXPECT_EQ(text_of(record, "restitution"), "-") << "no impact";
  record.physics.effective_restitution = {1.0};
  record.scene_law = Penalty{{1e3}};
  EXPECT_EQ(text_of(record, "restitution"), "-") << "a spring has no law of impact";
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
}  // namespace signorini::case_sections_test
