// Methods that solve the same equations, as the records say so.

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/report/sections/sections.hpp"
#include "methods/catalogue.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::identity_sections_test {
namespace {

using Row = std::vector<std::string>;

/// A run of one of two methods that solve the same equations.
Record run(const std::string& scene, const std::string& method, long harmonics, double error) {
  Record record = test::good_record(scene, method, "harmonics=" + std::to_string(harmonics), error, 1.0);
  record.options = {{"harmonics", harmonics}, {method == "aft" ? "law" : "solver", std::string("auto")}};
  if (method == "aft") record.same_equations_as = "projected";
  return record;
}

Row row_of(const std::vector<Record>& records) {
  const Evaluation evaluation(records);
  const Section section = identity_sections(evaluation).front();
  Row texts;
  if (section.table.rows.empty()) return texts;
  for (const Cell& cell : section.table.rows.front()) texts.push_back(cell.text);
  return texts;
}

TEST(IdentitySections, MeasureHowFarApartEqualEquationsAre) {
  std::vector<Record> records;
  for (const char* scene : {"a", "b", "c"}) {
    records.push_back(run(scene, "aft", 10, 0.1));
    records.push_back(run(scene, "projected", 10, 0.1));
    records.push_back(run(scene, "projected", 40, 0.01));  // other equations
  }
  records[1].errors.x_l2 = 0.08;   // a: 0.02 of 0.1
  records[4].errors.x_l2 = 0.099;  // b
  EXPECT_EQ(row_of(records), (Row{"aft", "projected", "3", "0", "0", "1.0e-02", "2.0e-01"}));
  records[1].certificate.orbit = "another";
  records[3].status = Status::timeout;
  EXPECT_EQ(row_of(records), (Row{"aft", "projected", "3", "1", "1", "0.0e+00", "0.0e+00"}));
}

TEST(IdentitySections, HaveNoDifferenceWhereNothingIsSolved) {
  std::vector<Record> records{run("a", "aft", 10, 0.1), run("a", "projected", 10, 0.1)};
  for (Record& record : records) record.status = Status::not_converged;
  EXPECT_EQ(row_of(records), (Row{"aft", "projected", "1", "0", "0", "none to compare", "none to compare"}));
}

TEST(IdentitySections, KnowNothingThatTheRecordsDoNotSay) {
  std::vector<Record> records{run("a", "aft", 10, 0.1), run("a", "projected", 10, 0.1)};
  records[0].same_equations_as.clear();
  EXPECT_TRUE(row_of(records).empty());
}
TEST(LimitSections, AreThoseOfTheMethodsOfTheRunThatTheProgramKnows) {
  const std::vector<Record> records{test::good_record("s", "hat-lcp", "samples=64", 1e-2, 1.0),
                                    test::good_record("s", "hat-lcp", "samples=128", 1e-2, 1.0),
                                    test::good_record("s", "unknown", "n=1", 1e-2, 1.0)};
  const Table table = limit_sections(Evaluation(records)).front().table;
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0][0].text, "hat-lcp");
  EXPECT_EQ(table.rows[0][1].text, find_method("hat-lcp").laws);
  EXPECT_EQ(table.rows[0][2].text, find_method("hat-lcp").limits);
  EXPECT_NE(table.rows[0][2].text.find("First order"), std::string::npos);
}

TEST(LimitSections, AreStatedByEveryMethodOfTheProgram) {
  for (const MethodEntry& entry : method_catalogue()) {
    EXPECT_TRUE(entry.limits.ends_with('.')) << entry.name << ": " << entry.limits;
    EXPECT_LT(entry.limits.size(), 240U) << entry.name;
  }
}

}  // namespace
}  // namespace signorini::identity_sections_test
