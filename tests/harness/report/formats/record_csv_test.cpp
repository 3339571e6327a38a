#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "harness/report/formats/formats.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini::record_csv_test {
namespace {

TEST(CsvReport, HasAReasonInEveryRowThatIsNotCertifiedAndNoFootnoteInTheOthers) {
  std::istringstream stream(test::csv_text(Evaluation(test::records_of_every_status())));
  std::string header;
  std::getline(stream, header);
  EXPECT_EQ(header.rfind("case,scene,", 0), 0U);
  EXPECT_EQ(header.substr(header.rfind(',') + 1), "reason");
  int rows = 0, whole = 0;
  for (std::string line; std::getline(stream, line); ++rows) {
    const bool certified =
        line.find(",converged,") != std::string::npos && line.find(",certified,") != std::string::npos;
    if (certified) ++whole;
    EXPECT_EQ(line.back() == ',', certified) << line;
    EXPECT_EQ(line.find("nan"), std::string::npos);
  }
  EXPECT_EQ(rows, 10);
  EXPECT_GT(whole, 0);
}

TEST(MeasuresCsv, HasOneRowPerSceneAndConfiguration) {
  std::vector<Record> records{test::good_record("s", "m", "n=1", 0.05, 0.5),
                              test::good_record("s", "m", "n=2", 0.005, 1.0)};
  EXPECT_EQ(test::measures_text(Evaluation(records)),
            "scene,method,law,standing,runs,solved,seconds_to_1e-01,seconds_to_1e-02,seconds_to_1e-03,"
            "seconds_to_1e-06,seconds_to_1e-09\n"
            "s,m,e = 1,competes,2,2,5.000000000e-01,1.000000000e+00,inf,inf,inf\n");
}

/// Titles and cells of the single row of a report on this record.
std::pair<std::vector<std::string>, std::vector<std::string>> columns_of(const Record& record) {
  std::istringstream lines(test::csv_text(Evaluation({record})));
  std::pair<std::vector<std::string>, std::vector<std::string>> columns;
  for (std::vector<std::string>* cells : {&columns.first, &columns.second}) {
    std::string line;
    std::getline(lines, line);
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells->push_back(cell);
  }
  return columns;
}

TEST(CsvReport, ShowsEveryColumnOfARecordThatHasEveryField) {
  Record record = test::full_record();
  record.certificate.return_distance = 1e-9;
  const auto [titles, cells] = columns_of(record);
  ASSERT_EQ(titles.size(), 43U);
  ASSERT_EQ(cells.size(), titles.size());
  for (std::size_t i = 0; i < cells.size(); ++i) EXPECT_FALSE(cells[i].empty()) << titles[i];
}

TEST(CsvReport, HasTheValueOfTheFieldUnderItsTitle) {
  const auto [titles, cells] = columns_of(test::full_record());
  const auto cell = [&, &titles = titles, &cells = cells](const std::string& title) {
    const auto found = std::find(titles.begin(), titles.end(), title);
    return found == titles.end() ? "no column" : cells[static_cast<std::size_t>(found - titles.begin())];
  };
  EXPECT_EQ(cell("case"), "scene-a/method-a[n=1]");
  EXPECT_EQ(cell("resolution"), "method-a[n=1]");
  EXPECT_EQ(cell("law"), "e = 1");
  EXPECT_EQ(cell("law_matches_scene"), "true");
  EXPECT_EQ(cell("status"), "converged");
  EXPECT_EQ(cell("x_l2"), "1.250000000e-01");
  EXPECT_EQ(cell("force_l2"), "5.500000000e-01");
  EXPECT_EQ(cell("problem"), "fedcba9876543210");
  EXPECT_EQ(cell("x_l2_scene"), "6.000000000e-01");
  EXPECT_EQ(cell("contact_ratio"), "4.000000000e-01");
  EXPECT_EQ(cell("seconds_median"), "5.000000000e-01");
  EXPECT_EQ(cell("pivots"), "3");
  EXPECT_EQ(cell("peak_memory_bytes"), "6");
  EXPECT_EQ(cell("certificate"), "certified");
  EXPECT_EQ(cell("orbit"), "0a1b2c3d");
  EXPECT_EQ(cell("stable"), "true");
}

}  // namespace
}  // namespace signorini::record_csv_test
