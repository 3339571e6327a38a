#include "harness/schematic/svg.hpp"

#include <gtest/gtest.h>

namespace signorini::svg_test {
namespace {

TEST(SvgOf, HasAGroupForEachPartAndTextsThatAreNoMarkup) {
  Drawing drawing{.title = "a <b> & c"};
  drawing.add("spring").strokes.push_back({.places = {{0.0, 0.0}, {1.0, 0.0}}, .dashed = true});
  drawing.add("gap").labels.push_back({.words = "g < 1 & \"x\"", .ink = Ink::contact});
  const std::string svg = svg_of(drawing);
  EXPECT_NE(svg.find("<title>a &lt;b&gt; &amp; c</title>"), std::string::npos) << svg;
  EXPECT_NE(svg.find("<g class=\"spring\">\n<path class=\"structure\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("stroke-dasharray"), std::string::npos);
  EXPECT_NE(svg.find(">g &lt; 1 &amp; &quot;x&quot;</text>"), std::string::npos) << svg;
  EXPECT_EQ(svg, svg_of(drawing));
}

// librsvg, CairoSVG and Inkscape draw what is coloured by a custom property as one black rectangle.
TEST(SvgOf, ColoursByPlainRulesOnLightAndOnDarkPaper) {
  const std::string svg = svg_of(Drawing{});
  EXPECT_EQ(svg.find("var("), std::string::npos) << svg;
  EXPECT_EQ(svg.find("{--"), std::string::npos) << svg;
  const std::size_t dark = svg.find("@media (prefers-color-scheme:dark)");
  EXPECT_LT(svg.find(".sheet,path.paper{fill:#fff}"), dark) << svg;
  EXPECT_NE(svg.find(".sheet,path.paper{fill:#0d1117}", dark), std::string::npos) << svg;
}

TEST(SvgOf, TurnsTheDrawingSoThatUpIsUp) {
  Drawing drawing;
  drawing.add("line").strokes.push_back({.places = {{0.0, 0.0}, {0.0, 2.54}}});
  // 96 pixels per 2.54 cm, and a margin of 0.4 cm.
  EXPECT_NE(svg_of(drawing).find("d=\"M15.1 111.1L15.1 15.1\""), std::string::npos) << svg_of(drawing);
  EXPECT_NE(svg_of(drawing).find("viewBox=\"0 0 30 126\""), std::string::npos) << svg_of(drawing);
}

}  // namespace
}  // namespace signorini::svg_test
