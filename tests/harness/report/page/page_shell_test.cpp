#include "harness/report/page/page_shell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace signorini::page_shell_test {
namespace {

TEST(Base64, IsThatOfTheStandard) {
  // RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Packed, IsTheStreamOfZlibWithoutAByteOfTheText) {
  // Written by Python: base64.b64encode(zlib.compress(b"</script>" * 3, 9)).
  EXPECT_EQ(packed("</script></script></script>"), "eNqz0S9OLsosKLGzwWAAAIXCCbs=");
}

TEST(Packed, MakesTextThatRepeatsItselfShort) {
  const std::string text(100000, 'a');
  EXPECT_LT(packed(text).size(), text.size() / 100);
}

TEST(ScriptSource, NamesAScriptByItsDigest) {
  // openssl dgst -sha256 -binary | base64 of the same text.
  EXPECT_EQ(script_source("alert('Hello, world.');"),
            "'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='");
}
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
}  // namespace signorini::page_shell_test
