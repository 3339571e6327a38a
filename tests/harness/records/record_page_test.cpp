// docs/records.md has every field of a record, and no other.

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include "harness/files.hpp"
#include "harness/records/record_json.hpp"
#include "tests/support/data_folder.hpp"

namespace signorini::record_page_test {
namespace {

using Names = std::set<std::string>;

/// Names of the fields of a struct; a name that is there twice is a failure.
template <class Struct>
Names names_of(const Struct& object) {
  Names names;
  visit_fields(object, [&](const Field& field, const auto&) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name << " is visited twice";
  });
  return names;
}

/// The text between a heading of docs/records.md and the next; the first heading's is the page's own.
std::string part_of_the_page(const std::string& heading) {
  const std::filesystem::path page = test::data_folder() / "../../docs/records.md";
  const std::string text = read_file(page);
  const std::size_t begin = text.find(heading + "\n");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find("\n## ", begin) - begin);
}

/// Words between backquotes.
Names quoted_in(const std::string& text) {
  Names names;
  for (std::size_t at = text.find('`'); at != std::string::npos;) {
    const std::size_t end = text.find('`', at + 1);
    if (end == std::string::npos) break;
    names.insert(text.substr(at + 1, end - at - 1));
    at = text.find('`', end + 1);
  }
  return names;
}

/// Rows of the tables whose first column is headed `key`: what is quoted in that column, and the whole row.
std::vector<std::pair<Names, std::string>> rows_of(const std::string& part) {
  std::vector<std::pair<Names, std::string>> rows;
  std::istringstream lines(part);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("| key |")) inside = true;
    if (!line.starts_with("|")) inside = false;
    const Names keys = inside ? quoted_in(line.substr(0, line.find('|', 1))) : Names{};
    if (!keys.empty()) rows.emplace_back(keys, line);
  }
  return rows;
}

Names keys_of(const std::string& part) {
  Names all;
  for (const auto& [keys, row] : rows_of(part)) all.insert(keys.begin(), keys.end());
  return all;
}

std::string row_of(const std::string& part, const std::string& key) {
  for (const auto& [keys, row] : rows_of(part)) {
    if (keys.contains(key)) return row;
  }
  return {};
}

TEST(RecordFields, HaveARowEachInTheDocumentation) {
  Names names = names_of(Record{});
  names.insert("schema");  // of the file, not of the record
  EXPECT_EQ(keys_of(part_of_the_page("# Records")), names);
  EXPECT_EQ(keys_of(part_of_the_page("## Certificate")), names_of(Certificate{}));
  EXPECT_EQ(keys_of(part_of_the_page("## Errors")), names_of(Errors{}));
  EXPECT_EQ(keys_of(part_of_the_page("## Physics")), names_of(Physics{}));
}

/// Every field of the struct is quoted in the text.
template <class Struct>
void expect_quoted(const Struct& object, const std::string& text) {
  const Names quoted = quoted_in(text);
  for (const std::string& name : names_of(object)) EXPECT_TRUE(quoted.contains(name)) << name << ": " << text;
}

TEST(RecordFields, OfGroupsAreNamedInTheRowOrPartOfTheGroup) {
  const std::string page = part_of_the_page("# Records");
  expect_quoted(FamilyLevel{}, row_of(page, "family"));
  expect_quoted(WorkDone{}, row_of(page, "work"));
  expect_quoted(Repeats{}, row_of(page, "repeats"));
  expect_quoted(TrajectorySamples{}, row_of(page, "trajectory"));
  expect_quoted(Impulse{}, row_of(page, "trajectory"));
  expect_quoted(Seconds{}, part_of_the_page("## Seconds"));
  expect_quoted(OrbitEvent{}, row_of(part_of_the_page("## Certificate"), "events"));
  const std::string motion = part_of_the_page("## Motion");
  expect_quoted(MotionSummary{}, motion);
  expect_quoted(DisplacementSummary{}, motion);
  expect_quoted(Harmonic{}, motion);
  expect_quoted(ImpactSummary{}, motion);
  expect_quoted(PhaseSummary{}, motion);
  const std::string responses = part_of_the_page("## Responses");
  EXPECT_EQ(keys_of(responses), names_of(RecordedResponse{}));
  expect_quoted(CurveComparison{}, row_of(responses, "comparison"));
  expect_quoted(CurveShares{}, row_of(responses, "comparison"));
  expect_quoted(PointMatch{}, row_of(responses, "comparison"));
  expect_quoted(LocatedPoint{}, row_of(responses, "located"));
  expect_quoted(DrawnBranch{}, row_of(responses, "branches"));
  expect_quoted(Waveforms{}, part_of_the_page("## Waveforms"));
  expect_quoted(Waveform{}, part_of_the_page("## Waveforms"));
}

TEST(RecordFields, HaveTheirUnitInTheDocumentation) {
  const std::string page = part_of_the_page("# Records");
  const Record record;
  visit_fields(record, [&](const Field& field, const auto&) {
    if (field.unit.empty()) return;
    const std::string unit = "[" + std::string(field.unit) + "]";
    EXPECT_NE(row_of(page, field.name).find(unit), std::string::npos) << field.name << " " << unit;
  });
}

}  // namespace
}  // namespace signorini::record_page_test
