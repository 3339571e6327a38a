#include <gtest/gtest.h>

#include "harness/report/sections/sections.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::ablation_sections_test {
namespace {

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
}  // namespace signorini::ablation_sections_test
