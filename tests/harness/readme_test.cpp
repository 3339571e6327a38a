// The README shows what is committed in results/quick, digit by digit.

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace signorini {
namespace {

std::string read(const std::string& name) {
  std::ifstream file(std::string(SIGNORINI_TEST_DATA) + "/../../" + name);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The rows of a Markdown table's text, blanks and rules left out.
std::set<std::string> rows_of(const std::string& text) {
  std::set<std::string> rows;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("|", 0) != 0 || line.find("---") != std::string::npos) continue;
    std::erase(line, ' ');
    rows.insert(line);
  }
  return rows;
}

TEST(Readme, ShowsRowsOfTheCommittedTableOnly) {
  const std::string readme = read("README.md");
  const auto begin = readme.find("<!-- quick-table -->");
  const auto end = readme.find("<!-- /quick-table -->");
  ASSERT_NE(begin, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  const std::set<std::string> shown = rows_of(readme.substr(begin, end - begin));
  const std::set<std::string> committed = rows_of(read("results/quick/table.md"));
  EXPECT_GE(shown.size(), 20U);
  for (const std::string& row : shown) EXPECT_TRUE(committed.contains(row)) << row;
}

}  // namespace
}  // namespace signorini
