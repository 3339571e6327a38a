#include "harness/schematic/drawing.hpp"

#include <gtest/gtest.h>

namespace signorini::drawing_test {
namespace {

TEST(Extent, OfADrawingHoldsLinesAndTexts) {
  Drawing drawing;
  EXPECT_EQ(extent(drawing).size(), Place(0.0, 0.0));
  drawing.add("line").strokes.push_back({.places = {{-1.0, 2.0}, {3.0, -4.0}}});
  EXPECT_EQ(extent(drawing).low, Place(-1.0, -4.0));
  EXPECT_EQ(extent(drawing).high, Place(3.0, 2.0));
  drawing.add("text").labels.push_back(
      {.place = {3.0, 0.0}, .words = "to the right", .anchor = Anchor::start});
  EXPECT_GT(extent(drawing).high.x(), 4.5);
  EXPECT_EQ(extent(drawing).low, Place(-1.0, -4.0));
}

TEST(Extent, OfALabelFollowsItsAnchorAndCountsCharactersNotBytes) {
  const auto box = [](const char* words, Anchor anchor) {
    return extent(Label{.place = {0.0, 0.0}, .words = words, .anchor = anchor});
  };
  EXPECT_EQ(box("abcd", Anchor::start).low.x(), 0.0);
  EXPECT_EQ(box("abcd", Anchor::end).high.x(), 0.0);
  EXPECT_DOUBLE_EQ(box("abcd", Anchor::middle).low.x(), -box("abcd", Anchor::middle).high.x());
  EXPECT_EQ(box("ω…⁻³", Anchor::start).high.x(), box("abcd", Anchor::start).high.x());
}
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
}  // namespace signorini::drawing_test
