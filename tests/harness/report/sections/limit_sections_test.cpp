// What reports say of the limits of methods.

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/report/sections/sections.hpp"
#include "methods/catalogue.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::limit_sections_test {
namespace {

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
}  // namespace signorini::limit_sections_test
