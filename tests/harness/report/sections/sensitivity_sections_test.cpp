// Tables of what should not matter: one option at a time, and solves repeated.

#include <gtest/gtest.h>

#include <tuple>

#include "harness/report/sections/sections.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::sensitivity_sections_test {
namespace {

using Rows = std::vector<std::vector<std::string>>;

Rows rows_of(const Section& section) {
  Rows rows;
  for (const auto& row : section.table.rows) {
    rows.emplace_back();
    for (const Cell& cell : row) rows.back().push_back(cell.text);
  }
  return rows;
}

Rows sensitivity(const std::vector<Record>& records) {
  const Evaluation evaluation(records);
  return rows_of(sensitivity_sections(evaluation).front());
}

TEST(Sensitivity, HasARowForEachValueOfWhatIsVaried) {
  std::vector<Record> records;
  for (const char* scene : {"a", "b", "c"}) {
    records.push_back(test::good_record(scene, "m", "h=40,c=0.1", 1e-2, 1.0));
    records.push_back(test::good_record(scene, "m", "h=40,c=1", 2e-3, 1.0));
    records.push_back(test::good_record(scene, "m", "h=40,c=1e3", 1e-3, 1.0));
  }
  records[4].status = Status::inaccurate;
  records[7].status = Status::not_applicable;
  records[1].certificate.same_orbit = false;
  EXPECT_EQ(sensitivity(records),
            (Rows{{"m[h=40]", "c", "0.1", "3 of 3", "3", "0", "1.0e-02", "1.0e-02", "0"},
                  {"m[h=40]", "c", "1", "1 of 2", "0", "1", "not solved", "not solved", "0"},
                  {"m[h=40]", "c", "1e3", "3 of 3", "3", "0", "1.0e-03", "1.0e-03", "0"}}));
}

TEST(Sensitivity, KeepsWhatIsSolvedUnderAnotherLawApart) {
  std::vector<Record> records;
  for (const char* c : {"1", "2", "3"}) {
    for (const char* scene : {"own", "other"})
      records.push_back(test::good_record(scene, "m", std::string("h=40,c=") + c, 1e-2, 1.0));
    records.back().law_matches_scene = false;
    records.back().errors.x_l2 = 0.05;
  }
  EXPECT_EQ(sensitivity(records)[0],
            (Rows::value_type{"m[h=40]", "c", "1", "1 of 1", "2", "0", "1.0e-02", "1.0e-02", "1"}));
}

TEST(Sensitivity, HasNumbersInRisingOrderHoweverTheyAreSpelt) {
  std::vector<Record> records;
  for (const char* value : {"10x", "1e3x", "100x"})
    records.push_back(test::good_record("a", "m", std::string("h=40,p=") + value, 1e-2, 1.0));
  for (const char* value : {"0.3", "1e-3", "0", "0.01"})
    records.push_back(test::good_record("a", "n", std::string("h=40,s=") + value, 1e-2, 1.0));
  std::vector<std::string> values;
  for (const auto& row : sensitivity(records)) values.push_back(row[2]);
  EXPECT_EQ(values, (std::vector<std::string>{"10x", "100x", "1e3x", "0", "1e-3", "0.01", "0.3"}));
}

TEST(Sensitivity, TakesNeitherResolutionsNorPairsForVariations) {
  std::vector<Record> records;
  for (const char* resolution : {"h=10", "h=20", "h=40", "h=10,c=1", "h=10,c=2"})
    records.push_back(test::good_record("a", "m", resolution, 1e-2, 1.0));
  EXPECT_EQ(sensitivity(records), Rows{});
}

TEST(Switches, TellWhatTheyBringToEachSceneAndInAll) {
  std::vector<Record> records;
  for (const auto& [scene, off, on] :
       {std::tuple{"a", 8e-2, 1e-2}, std::tuple{"b", 4e-2, 1e-3}, std::tuple{"c", 1e-1, 1e-3}}) {
    records.push_back(test::good_record(scene, "m", "h=40,w=false", off, 1.0));
    records.push_back(test::good_record(scene, "m", "h=40,w=true", on, 1.0));
  }
  records[5].certificate.orbit = "another";
  const Evaluation evaluation(records);
  const std::vector<Section> sections = switch_sections(evaluation);
  EXPECT_EQ(rows_of(sections[0]), (Rows{{"m[h=40]", "w", "3", "3", "3", "8", "24", "40"}}));
  EXPECT_EQ(rows_of(sections[1]), (Rows{{"a", "m[h=40]", "w", "8.0e-02", "1.0e-02", "8"},
                                        {"b", "m[h=40]", "w", "4.0e-02", "1.0e-03", "40"},
                                        {"c", "m[h=40]", "w", "1.0e-01", "1.0e-03", "none"}}));
}

TEST(Switches, NeedBothSidesOfTheSwitch) {
  const Evaluation evaluation({test::good_record("a", "m", "h=40,w=true", 1e-2, 1.0),
                               test::good_record("b", "m", "h=40,w=true", 1e-2, 1.0)});
  EXPECT_TRUE(switch_sections(evaluation).front().table.rows.empty());
}

TEST(Repeats, CountCasesWhoseEveryAnswerHadTheSameBits) {
  std::vector<Record> records;
  for (const char* scene : {"a", "b", "c"})
    records.push_back(test::good_record(scene, "m", "h=1", 1e-2, 1.0));
  records[0].repeats = Repeats{.solves = 5, .identical = 5};
  records[1].repeats = Repeats{.solves = 3, .identical = 2};
  const Evaluation evaluation(records);
  EXPECT_EQ(rows_of(repeat_sections(evaluation).front()), (Rows{{"m", "2", "8", "1 of 2"}}));
}
using Rows = std::vector<std::vector<std::string>>;

Rows ablation(const std::vector<Record>& records) {
  const Evaluation evaluation(records);
  const Sections sections = ablation_sections(evaluation);
  Rows rows;
  for (const auto& row : sections.front().table.rows) {
    rows.emplace_back();
    for (const Cell& cell : row) rows.back().push_back(cell.text);
  }
  return rows;
}

TEST(AblationSections, GoFromThePlainFormToTheDefaultAndCountWhatIsConvergedAndCertified) {
  std::vector<Record> records;
  for (const char* scene : {"a", "b", "c"}) {
    records.push_back(test::good_record(scene, "m", "h=40", 1e-3, 2.0));
    records.push_back(test::good_record(scene, "m", "h=40,compensate=false", 1e-2, 1.0));
    records.push_back(test::good_record(scene, "m", "h=40,plain=true", 0.1, 4.0));
    records.push_back(test::good_record(scene, "m", "h=40,plain=true,solver=pivoting", 0.05, 8.0));
  }
  records[2].status = Status::not_converged;  // a, plain
  records[6].status = Status::inaccurate;     // b, plain
  records[9].status = Status::not_applicable;
  records[4].certificate.stable = false;  // b, default
  EXPECT_EQ(ablation(records),
            (Rows{{"m[h=40,plain=true]", "3", "2", "1", "1", "1.0e-01", "0.01 (1)", "4 s"},
                  {"m[h=40,plain=true,solver=pivoting]", "3", "3", "3", "0", "5.0e-02", "0.02 (3)", "8 s"},
                  {"m[h=40,compensate=false]", "2", "2", "2", "0", "1.0e-02", "0.1 (2)", "1 s"},
                  {"m[h=40]", "3", "3", "3 (1 unstable)", "0", "1.0e-03", "·", "2 s"}}));
}

TEST(AblationSections, CompareEqualResolutionsOfMethodsThatHaveAPlainForm) {
  const std::vector<Record> records{test::good_record("a", "m", "h=10", 1e-3, 1.0),
                                    test::good_record("a", "m", "h=40", 1e-3, 1.0),
                                    test::good_record("a", "m", "h=40,plain=true", 1e-3, 1.0),
                                    test::good_record("a", "n", "h=40", 1e-3, 1.0),
                                    test::good_record("a", "o", "h=40,plain=true", 1e-3, 1.0)};
  const Rows rows = ablation(records);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].front(), "m[h=40,plain=true]");
  EXPECT_EQ(rows[1].front(), "m[h=40]");
}

TEST(AblationSections, LeaveOutSolvesThatStartFromAnOrbit) {
  EXPECT_EQ(ablation({test::good_record("a", "m", "h=40,start=0", 1e-3, 1.0),
                      test::good_record("a", "m", "h=40,plain=true,start=0", 1e-3, 1.0)}),
            Rows{});
}

TEST(AblationSections, CompareErrorsOnOneOrbitAlone) {
  std::vector<Record> records;
  for (const char* scene : {"a", "b"}) {
    records.push_back(test::good_record(scene, "m", "h=40", 1e-3, 1.0));
    records.push_back(test::good_record(scene, "m", "h=40,plain=true", 1e-2, 1.0));
  }
  records[2].certificate.orbit = "another";  // of b, ours
  EXPECT_EQ(ablation(records).front()[6], "0.1 (1)");
  records[0].certificate.orbit = "another";
  EXPECT_EQ(ablation(records).front()[6], "-");
}

TEST(AblationSections, PrintADashWhereNothingIsCertified) {
  std::vector<Record> records{test::good_record("a", "m", "h=40", 1e-3, 1.0),
                              test::good_record("a", "m", "h=40,plain=true", 1e-3, 1.0)};
  records[1].status = Status::timeout;
  EXPECT_EQ(ablation(records).front(),
            (std::vector<std::string>{"m[h=40,plain=true]", "1", "0", "0", "0", "-", "-", "-"}));
}

}  // namespace
}  // namespace signorini::sensitivity_sections_test
