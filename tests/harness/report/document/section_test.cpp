#include "harness/report/document/section.hpp"

#include <gtest/gtest.h>

namespace signorini::section_test {
namespace {

TEST(Rows, EndWhereATableIsFullAndSayWhereTheOthersAre) {
  Section section{.table = {{"number"}, {}}, .note = "A legend."};
  Rows rows(section, "all are in a file");
  std::size_t made = 0;
  const auto make = [&] { return std::vector<Cell>{std::to_string(made++)}; };
  for (std::size_t i = 0; i < kMostRows; ++i) rows.add(make);
  rows.close();
  EXPECT_EQ(section.note, "A legend.");
  for (int i = 0; i < 3; ++i) rows.add(make);
  rows.close();
  EXPECT_EQ(section.note, "These are the first 20000 of 20003 rows; all are in a file. A legend.");
  EXPECT_EQ(section.table.rows.size(), kMostRows);
  EXPECT_EQ(made, kMostRows) << "rows that find no room cost nothing";
}

}  // namespace
}  // namespace signorini::section_test
