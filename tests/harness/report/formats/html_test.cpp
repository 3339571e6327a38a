#include "harness/report/formats/html.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini {
namespace {

TEST(HtmlTable, CarriesTheValuesThatItSortsBy) {
  const Table table{{"method", "time"}, {{"a", Cell("1 ms", 1e-3, 4U)}, {"<b>", Cell("none", INFINITY)}}};
  const std::string text = html_table(table);
  EXPECT_NE(text.find("<td class=\"n\" data-v=\"0.001\"><a href=\"#record-5\">1 ms</a></td>"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("<td class=\"n\">none</td>"), std::string::npos) << text;
  EXPECT_EQ(text.find("<b>"), std::string::npos);
}

TEST(HtmlEscaped, SpellsOutWhatHtmlTakesForItsOwn) {
  EXPECT_EQ(html_escaped("<a href=\"x\">&amp;</a>"), "&lt;a href=&quot;x&quot;&gt;&amp;amp;&lt;/a&gt;");
  EXPECT_EQ(html_escaped("≠"), "≠");
}

TEST(HtmlText, SetsWhatStandsBetweenBackquotesAsCode) {
  EXPECT_EQ(html_text("say `a<b` twice: `c`"), "say <code>a&lt;b</code> twice: <code>c</code>");
}

TEST(HtmlTable, LinksScenesAndMethods) {
  const std::string text = html_table({{"scene", "method"}, {{"s", "m[n=1]"}}});
  EXPECT_NE(text.find("<td><a href=\"#scene-s\">s</a></td>"), std::string::npos) << text;
  EXPECT_NE(text.find("data-filter=\"m[n=1]\""), std::string::npos) << text;
}

TEST(HtmlFigure, HoldsTheDrawingItself) {
  const Figure figure{.name = "f", .caption = "a < b", .width = 2.54, .height = 5.08};
  const std::string text = html_figure(figure, "<svg/>");
  EXPECT_NE(text.find("base64,PHN2Zy8+\""), std::string::npos) << text;  // RFC 4648
  EXPECT_NE(text.find("width=\"96\" height=\"192\""), std::string::npos) << text;
  EXPECT_NE(text.find("<figcaption>a &lt; b</figcaption>"), std::string::npos) << text;
}

}  // namespace
}  // namespace signorini
