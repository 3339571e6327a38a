#include "harness/report/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <random>
#include <sstream>

#include "harness/files.hpp"
#include "harness/report/formats/formats.hpp"
#include "harness/report/sections/sections.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"
#include "tests/support/other_programs.hpp"

namespace signorini::report_test {
namespace {

namespace fs = std::filesystem;

/// Every file below a folder, by its path.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = read_file(entry.path());
  }
  return files;
}

TEST(WriteReport, IsByteIdenticalWhateverTheOrderOfTheRecords) {
  if (!test::gnuplot_draws()) GTEST_SKIP() << test::kNoGnuplot;
  std::vector<Record> records = test::records_of_a_run();
  const fs::path folder = test::fresh_folder("report");
  write_report(folder, Evaluation(records), kReportFormats);
  const auto before = contents(folder);
  EXPECT_TRUE(before.contains("table.md"));
  EXPECT_TRUE(before.contains("measures.csv"));
  EXPECT_TRUE(before.contains("tables/means-1.tex"));
  EXPECT_TRUE(before.contains("report.html"));
  for (const char* ending : {"gp", "dat", "svg", "pdf"})
    EXPECT_TRUE(before.contains(std::string("figures/scene-b-work-precision.") + ending));
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::mt19937 random(3);
  std::shuffle(records.begin(), records.end(), random);
  write_report(folder, Evaluation(records), kReportFormats);
  const auto after = contents(folder);
  ASSERT_EQ(after.size(), before.size());
  for (const auto& [name, text] : before) EXPECT_TRUE(after.at(name) == text) << name;
}

std::string markdown_of(const std::vector<Record>& records) {
  return markdown_report(sections_of(Evaluation(records)));
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> found;
  std::string cell;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '|' && line[i - 1] != '\\') {
      found.push_back(cell);
      cell.clear();
    } else {
      cell += line[i];
    }
  }
  return found;
}

/// The cells of the row that has this resolution, blanks trimmed, of the table with so many columns.
std::vector<std::string> row_of(const std::string& report, const std::string& resolution,
                                std::size_t columns = 16) {
  std::istringstream stream(report);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("|", 0) != 0 || line.find("[" + resolution + "]") == std::string::npos) continue;
    std::vector<std::string> row = cells(line);
    if (row.size() != columns) continue;
    for (std::string& cell : row) {
      cell.erase(0, cell.find_first_not_of(' '));
      cell.erase(cell.find_last_not_of(' ') + 1);
    }
    return row;
  }
  return {};
}

constexpr std::size_t kStatus = 4, kError = 5, kEnergy = 11, kMedian = 12, kFirst = 13, kWork = 14,
                      kOrbit = 15;

TEST(MarkdownReport, IsTheSameWhateverTheOrderOfTheRecords) {
  std::vector<Record> records = test::records_of_every_status();
  records.push_back(test::good_record("scene-b", "method-b", "n=10", 0.1, 1.0));
  records.push_back(test::good_record("scene-b", "method-b", "n=9", 0.1, 1.0));
  const std::string markdown = markdown_of(records);
  const std::string csv = test::csv_text(Evaluation(records));
  std::mt19937 random(7);
  for (int i = 0; i < 10; ++i) {
    std::shuffle(records.begin(), records.end(), random);
    EXPECT_EQ(markdown_of(records), markdown);
    EXPECT_EQ(test::csv_text(Evaluation(records)), csv);
  }
  EXPECT_LT(markdown.find("n=9]"), markdown.find("n=10]"));
}

TEST(MarkdownReport, HasNoEmptyCell) {
  std::istringstream stream(markdown_of(test::records_of_every_status()));
  int rows = 0;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("|", 0) != 0) continue;
    ++rows;
    for (const std::string& cell : cells(line))
      EXPECT_NE(cell.find_first_not_of(' '), std::string::npos) << line;
  }
  EXPECT_GE(rows, 10 + 5);
}

TEST(MarkdownReport, GivesNoErrorAndNoTimeToAnAnswerThatIsWrong) {
  const std::string report = markdown_of(test::records_of_every_status());
  for (const char* status : {"not-converged", "not-applicable", "timeout", "out-of-memory", "crashed",
                             "exception", "invalid-output"}) {
    const std::vector<std::string> row = row_of(report, "ends=" + std::string(status));
    ASSERT_EQ(row.size(), 16U) << status;
    EXPECT_EQ(row[kStatus], status);
    for (const std::size_t column : {kError, kEnergy, kMedian, kFirst, kWork, kOrbit}) {
      EXPECT_EQ(row[column], "(" + std::string(status) + ")");
    }
    EXPECT_NE(report.find("because of " + std::string(status)), std::string::npos);
  }
  // The fast liar.
  const std::vector<std::string> inaccurate = row_of(report, "n=3");
  EXPECT_EQ(inaccurate[kMedian], "(inaccurate)");
  EXPECT_EQ(inaccurate[kError], "uncertified");
}

TEST(MarkdownReport, SaysWhyAnAnswerIsUncertified) {
  const std::string report = markdown_of(test::records_of_every_status());
  EXPECT_EQ(row_of(report, "n=2")[kOrbit], "uncertified: Newton's method failed");
  EXPECT_EQ(row_of(report, "n=2")[kError], "uncertified");
  EXPECT_EQ(row_of(report, "n=1")[kOrbit], "same, stability not determined");
  EXPECT_EQ(row_of(report, "n=1")[kError], "1.2e-01");
}

TEST(MarkdownReport, MarksAnotherLawAndAnotherOrbit) {
  Record record = test::good_record("s", "m", "n=1", 0.1, 1.0);
  record.scene_law = Restitution{0.5};
  record.law_matches_scene = false;
  record.certificate.same_orbit = false;
  const std::vector<std::string> row = row_of(markdown_of({record}), "n=1");
  EXPECT_EQ(row[1], "e = 0.5");
  EXPECT_EQ(row[3], "e = 1 ≠ scene");
  EXPECT_EQ(row[kOrbit], "other (0a1b2c3d), stability not determined");
}

TEST(MarkdownReport, SaysWhichOrbitsAreUnstable) {
  Record record = test::good_record("s", "m", "n=1", 0.1, 1.0);
  record.certificate.stable = false;
  EXPECT_EQ(row_of(markdown_of({record}), "n=1")[kOrbit], "same, unstable");
}

TEST(MarkdownReport, SetsTimesBesideMarchingSceneByScene) {
  std::vector<Record> records;
  for (const double seconds : {1.0, 2.0, 4.0}) {
    const std::string scene = "s" + std::to_string(static_cast<int>(seconds));
    records.push_back(test::good_record(scene, "event-driven", "flow=cvode,tolerance=1e-6", 1e-6, seconds));
    records.push_back(test::good_record(scene, "m", "n=1", 0.1 * seconds, 0.25));
  }
  // Three ratios: 0.25, 0.125, 0.0625.
  for (Record& record : records) record.certificate.stable = true;
  EXPECT_EQ(
      row_of(markdown_of(records), "n=1", 8),
      (std::vector<std::string>{"m[n=1]", "3 of 3", "3 stable", "2.0e-01", "-", "250 ms", "0.12", "-"}));
  // A failure counts as infinite; two of three make the median so.
  records[1].status = Status::timeout;
  EXPECT_EQ(row_of(markdown_of(records), "n=1", 8)[6], "0.12");
  records[3].status = Status::timeout;
  EXPECT_EQ(
      row_of(markdown_of(records), "n=1", 8),
      (std::vector<std::string>{"m[n=1]", "1 of 3", "1 stable", "half or more failed", "half or more failed",
                                "half or more failed", "half or more failed", "-"}));
}

std::vector<std::string> summary_of(const std::vector<Record>& records, const std::string& method) {
  std::istringstream stream(markdown_of(records));
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("| " + method + " ", 0) != 0) continue;
    std::vector<std::string> row = cells(line);
    for (std::string& cell : row) {
      cell.erase(0, cell.find_first_not_of(' '));
      cell.erase(cell.find_last_not_of(' ') + 1);
    }
    return row;
  }
  return {};
}

TEST(MarkdownReport, DoesNotRewardFragilityByAveragingSurvivors) {
  // "fragile" solves 3 of 8 quickly, "robust" all 8 slowly.
  std::vector<Record> records;
  for (int i = 0; i < 8; ++i) {
    Record fragile = test::good_record("s" + std::to_string(i), "fragile", "n=1", 0.1, 1e-3);
    if (i >= 3) fragile.status = Status::timeout;
    records.push_back(fragile);
    records.push_back(test::good_record("s" + std::to_string(i), "robust", "n=1", 0.1, 2.0));
  }
  EXPECT_EQ(summary_of(records, "fragile")[5], "3 of 8");
  EXPECT_EQ(summary_of(records, "robust")[5], "8 of 8, 2 s");
}

}  // namespace
}  // namespace signorini::report_test
