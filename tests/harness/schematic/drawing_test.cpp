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

}  // namespace
}  // namespace signorini::drawing_test
