#include "harness/report/document/figure.hpp"

#include <gtest/gtest.h>

#include <set>

namespace signorini {
namespace {

TEST(LineStyle, TellsConfigurationsApartByColourAndByMark) {
  std::set<std::string> lines, marks;
  for (std::size_t c = 0; c < 6; ++c) {
    lines.insert(line_style(c).line);
    marks.insert(line_style(c).mark);
    EXPECT_NE(line_style(c).filled, line_style(c).hollow);
  }
  EXPECT_EQ(lines.size(), 6U);
  EXPECT_EQ(marks.size(), 6U);
}

TEST(LineStyle, GivesAMarkAnotherColourWhenMarksComeRoundAgain) {
  EXPECT_EQ(line_style(0).mark, line_style(6).mark);
  EXPECT_NE(line_style(0).filled, line_style(6).filled);
}

TEST(KeyPanel, HasOneEntryPerLineAndPlotsNothing) {
  const std::string script = key_panel({{"lc 1", "a"}, {"lc 2", "b[n=1]"}}, 0.25, 3);
  EXPECT_NE(script.find("set tmargin at screen 0.25\n"), std::string::npos) << script;
  EXPECT_NE(script.find("maxcols 3 "), std::string::npos) << script;
  EXPECT_NE(script.find("plot 2 notitle, \\\n  keyentry with linespoints lc 1 title 'a', \\\n"
                        "  keyentry with linespoints lc 2 title 'b[n=1]'\n"),
            std::string::npos)
      << script;
}

}  // namespace
}  // namespace signorini
