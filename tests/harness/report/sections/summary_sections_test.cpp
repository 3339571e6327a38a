#include <gtest/gtest.h>

#include "harness/report/sections/sections.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::summary_sections_test {
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

Row summary_of(const std::vector<Record>& records, const std::string& method) {
  return row_of(summary_sections(Evaluation(records)).front(), method);
}

TEST(SummarySections, AnswerWhatIsSolvedHowWellAndHowFast) {
  std::vector<Record> records;
  const double errors[] = {1e-4, 5e-3, 5e-2};
  for (int i = 0; i < 3; ++i) {
    const std::string scene = "s" + std::to_string(i);
    records.push_back(test::good_record(scene, "m", "n=1", 10.0 * errors[i], 1e-3));
    records.push_back(test::good_record(scene, "m", "n=2", errors[i], 1.0));
    records.back().errors.impulse = 2.0 * errors[i];
  }
  for (Record& record : records) record.certificate.stable = record.scene != "s1";
  // method, solved, stability, error of x, of impulse, to 1e-1, 1e-2, 1e-3, without contact, under another
  // law
  EXPECT_EQ(summary_of(records, "m"), (Row{"m", "3 of 3", "2 stable, 1 unstable", "5.0e-03", "1.0e-02",
                                           "3 of 3, 1 ms", "2 of 3, 1 s", "1 of 3", "-", "-"}));
}

TEST(SummarySections, CountWhatAMotionWithoutContactSolvesApart) {
  std::vector<Record> records;
  for (const char* scene : {"far-away", "s1", "s2"}) {
    records.push_back(test::good_record(scene, "m", "n=1", 1e-7, 1.0));
    records.push_back(test::good_record(scene, "lazy", "n=1", 1e-7, 1.0));
  }
  for (Record& record : records) {
    record.physics.contact_ratio = 0.0;
    record.certificate.events = {{.kind = ContactEvent::Kind::impact}};
    if (record.scene == "far-away") record.certificate.events.clear();
    if (record.method == "lazy" && record.scene != "far-away") record.status = Status::not_converged;
  }
  const auto lazy = [&] { return summary_of(records, "lazy"); };
  EXPECT_EQ(lazy()[1], "0 of 2");
  EXPECT_EQ(lazy()[8], "1 of 1");
  EXPECT_EQ(summary_of(records, "m")[1], "2 of 2");
  EXPECT_EQ(row_of(speed_sections(Evaluation(records)).front(), "lazy[n=1]")[1], "0 of 2");
  // Closed throughout has no event either, and is a motion with contact.
  for (Record& record : records) record.physics.contact_ratio = 1.0;
  EXPECT_EQ(lazy()[1], "1 of 3");
  EXPECT_EQ(lazy()[8], "-");
}

TEST(SummarySections, TakeAFailureForInfinite) {
  std::vector<Record> records{test::good_record("s1", "m", "n=1", 1e-4, 1.0),
                              test::good_record("s2", "m", "n=1", 1e-4, 1.0)};
  records[0].errors.impulse = 1e-3;
  records[1].status = Status::timeout;
  EXPECT_EQ(summary_of(records, "m"), (Row{"m", "1 of 2", "1 not determined", "half or more failed",
                                           "half or more failed", "1 of 2", "1 of 2", "1 of 2", "-", "-"}));
}

TEST(SummarySections, HoldTheScenesLawAndCountProblemsOnce) {
  std::vector<Record> records;
  for (const char* scene : {"e1", "e08", "e05", "e03"})
    records.push_back(test::good_record(scene, "m", "n=1", 1e-4, 1.0));
  for (std::size_t i = 1; i < 4; ++i) records[i].law_matches_scene = false;
  records[3].status = Status::timeout;
  EXPECT_EQ(summary_of(records, "m")[1], "1 of 1");
  EXPECT_EQ(summary_of(records, "m").back(), "2 of 3");
  records[0].problem = records[1].problem = "the same with e = 1";
  const Section section = summary_sections(Evaluation(records)).front();
  EXPECT_EQ(row_of(section, "m")[1], "1 of 1");
  EXPECT_EQ(row_of(section, "m").back(), "1 of 2");
  EXPECT_NE(section.note.find("1 duplicate was left out"), std::string::npos) << section.note;
}

TEST(SummarySections, SayWhereAMethodRepresentsNoSceneAndWhereNothingWasTimed) {
  std::vector<Record> records{test::good_record("s", "m", "n=1", 1e-4, 1.0)};
  records[0].seconds.reset();
  EXPECT_EQ(summary_of(records, "m"),
            (Row{"m", "1 of 1", "1 not determined", "1.0e-04", "-", "1 of 1", "1 of 1", "1 of 1", "-", "-"}))
      << "an old record without an error of the impulse";
  records[0].law_matches_scene = false;
  EXPECT_EQ(summary_of(records, "m"),
            (Row{"m", "none of its law", "-", "-", "-", "-", "-", "-", "-", "1 of 1"}));
}

TEST(OutcomeSections, CountEveryRunOnceAndEveryClaimInThreeWays) {
  std::vector<Record> records;
  for (int i = 0; i < 6; ++i)
    records.push_back(test::good_record("s" + std::to_string(i), "m", "n=1", 0.1, 1.0 + i));
  records[1].status = Status::not_applicable;
  records[2].certificate.same_orbit = false;
  records[3].status = Status::inaccurate;
  records[4].status = Status::crashed;
  records[5].certificate.status = CertificateStatus::uncertified;
  records[0].certificate.stable = true;
  records[2].certificate.stable = false;
  records[5].certificate.stable = false;  // of an orbit that is near, and certifies nothing
  // method, runs, not applicable, failed, says converged, certified, stable, unstable, unproven, refuted,
  // another
  EXPECT_EQ(row_of(outcome_sections(Evaluation(records)).front(), "m"),
            (Row{"m", "6", "1", "1", "4", "2", "1", "1", "1", "1", "1"}));
}

TEST(SpeedSections, CompareEachResolutionWithTheBaselineOnTheSameScene) {
  std::vector<Record> records;
  for (const double seconds : {1.0, 10.0, 100.0}) {
    const std::string scene = "s" + std::to_string(static_cast<int>(seconds));
    records.push_back(test::good_record(scene, "event-driven", "flow=cvode,tolerance=1e-6", 1e-6, seconds));
    records.push_back(test::good_record(scene, "m", "n=1", 0.1, 0.5 * seconds));
  }
  EXPECT_EQ(row_of(speed_sections(Evaluation(records)).front(), "m[n=1]"),
            (Row{"m[n=1]", "3 of 3", "3 not determined", "1.0e-01", "-", "5 s", "0.5", "-"}));
}

TEST(SpeedSections, MeasureNothingWithoutABaseline) {
  const std::vector<Record> records{test::good_record("s", "m", "n=1", 0.1, 1.0)};
  EXPECT_EQ(row_of(speed_sections(Evaluation(records)).front(), "m[n=1]")[6], "not measured");
}

TEST(SpeedSections, CountWhatDoesNotApplyAsUnsolved) {
  std::vector<Record> records{test::good_record("s", "m", "n=1", 0.1, 1.0),
                              test::good_record("t", "m", "n=1", 0.1, 1.0),
                              test::good_record("t", "m", "n=2", 0.1, 1.0)};
  records[1].status = Status::not_applicable;
  const auto row = [&] { return row_of(speed_sections(Evaluation(records)).front(), "m[n=1]"); };
  EXPECT_EQ(row()[1], "1 of 2");
  records[2].law_matches_scene = false;
  EXPECT_EQ(row()[1], "1 of 1");
  EXPECT_EQ(row().back(), "0 of 1") << "its other resolution tells that it would solve another law";
}

TEST(SpeedSections, HoldTheScenesLaw) {
  std::vector<Record> records{test::good_record("s", "m", "n=1", 0.1, 1.0),
                              test::good_record("t", "m", "n=1", 1e-6, 1e-3)};
  records[0].errors.impulse = 0.25;
  records[1].law_matches_scene = false;
  EXPECT_EQ(
      row_of(speed_sections(Evaluation(records)).front(), "m[n=1]"),
      (Row{"m[n=1]", "1 of 1", "1 not determined", "1.0e-01", "2.5e-01", "1 s", "not measured", "1 of 1"}));
}
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
}  // namespace signorini::summary_sections_test
