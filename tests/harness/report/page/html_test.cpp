#include "harness/report/page/html.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::html_test {
namespace {

TEST(HtmlTable, CarriesTheValuesThatItSortsBy) {
  const Table table{
      {"method", "time"},
      {{"a", Cell("1 us", 1e-6, 4U)}, {"<b>", Cell("3 of 8", INFINITY)}, {"c", Cell("none", INFINITY)}}};
  const std::string text = html_table(table, "a < b");
  EXPECT_NE(text.find("<td class=\"n\" data-v=\"1e-06\"><a href=\"#record-5\">1 µs</a></td>"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("<td class=\"n\">3 of 8</td>"), std::string::npos) << text;
  EXPECT_NE(text.find("<td class=\"n\">–<span class=\"unseen\">none</span></td>"), std::string::npos) << text;
  EXPECT_NE(text.find("<caption class=\"unseen\">a &lt; b</caption>"), std::string::npos) << text;
  EXPECT_EQ(text.find("<b>"), std::string::npos);
}

TEST(HtmlTable, LeavesOutColumnsThatSayNothing) {
  const Table table{{"method", "pivots", "iterations", "status"},
                    {{"a", Cell("not counted", INFINITY), Cell("0 of 8", INFINITY), "ok"},
                     {"b", "-", Cell("-", INFINITY), "ok"}}};
  EXPECT_TRUE(says_nothing(table, 1));
  EXPECT_FALSE(says_nothing(table, 2));  // 0 of 8 is a finding
  EXPECT_FALSE(says_nothing(table, 3));  // so are words, even the same ones
  const std::string text = html_table(table, "t");
  EXPECT_EQ(text.find("pivots"), std::string::npos) << text;
  EXPECT_EQ(text.find("not counted"), std::string::npos) << text;
  EXPECT_NE(text.find("iterations"), std::string::npos) << text;
}

TEST(HtmlEscaped, SpellsOutWhatHtmlTakesForItsOwn) {
  EXPECT_EQ(html_escaped("<a href=\"x\">&amp;</a>"), "&lt;a href=&quot;x&quot;&gt;&amp;amp;&lt;/a&gt;");
  EXPECT_EQ(html_escaped("≠"), "≠");
}

TEST(HtmlText, SetsWhatStandsBetweenBackquotesAsCode) {
  EXPECT_EQ(html_text("say `a<b` twice: `c`"), "say <code>a&lt;b</code> twice: <code>c</code>");
}

TEST(HtmlTable, LinksScenesAndMethods) {
  const std::string text = html_table({{"scene", "method"}, {{"s", "m[n=1]"}}}, "t");
  EXPECT_NE(text.find("<th scope=\"row\"><a href=\"#scene-s\">s</a></th>"), std::string::npos) << text;
  EXPECT_NE(text.find("<a href=\"#cases\" data-filter>m<wbr>[n=1]</a>"), std::string::npos) << text;
}

}  // namespace
}  // namespace signorini::html_test
