#include "harness/schematic/drawing.hpp"

#include <fmt/format.h>

#include <limits>

#include "harness/table.hpp"
#include "harness/text/words.hpp"

namespace signorini {

Part& Drawing::add(std::string kind) {
  parts.push_back({.kind = std::move(kind)});
  return parts.back();
}

Box extent(const Label& label) {
  constexpr double kWidth = 0.6, kDescent = 0.3;  // of a letter, in text sizes
  const double width = kWidth * kTextSize * static_cast<double>(characters(label.words));
  const double share = label.anchor == Anchor::start ? 0.0 : label.anchor == Anchor::middle ? 0.5 : 1.0;
  const Place low = label.place - Place(share * width, kDescent * kTextSize);
  return {low, low + Place(width, (1.0 + kDescent) * kTextSize)};
}

Box extent(const Drawing& drawing) {
  Box box{Place::Constant(std::numeric_limits<double>::infinity()),
          Place::Constant(-std::numeric_limits<double>::infinity())};
  const auto stretch = [&box](const Place& place) {
    box.low = box.low.cwiseMin(place);
    box.high = box.high.cwiseMax(place);
  };
  for (const Part& part : drawing.parts) {
    for (const Stroke& stroke : part.strokes)
      for (const Place& place : stroke.places) stretch(place);
    for (const Label& label : part.labels) {
      const Box own = extent(label);
      stretch(own.low);
      stretch(own.high);
    }
  }
  return box.low.x() <= box.high.x() ? box : Box();
}

namespace {

constexpr std::array kInks{"structure", "contact", "load", "note"};
const char* name_of(Ink ink) { return kInks.at(static_cast<std::size_t>(ink)); }

// Lighter than by day.
constexpr SheetColours kNightSheet{{"#d7dee6", "#ff9d57", "#6cb6ff", "#9aa4af"}, "#2b3a48", "#0d1117"};

std::string rules_of(const SheetColours& colours) {
  std::string rules =
      fmt::format(".sheet,path.paper{{fill:{}}}path.body{{fill:{}}}\n", colours.paper, colours.body);
  for (std::size_t i = 0; i < kInks.size(); ++i)
    rules +=
        fmt::format("path.{0}{{stroke:{1}}}path.{0}.ink,text.{0}{{fill:{1}}}\n", kInks[i], colours.ink[i]);
  return rules;
}

/// Rules with plain colours, and again for dark paper: Inkscape, librsvg and CairoSVG know no custom
/// properties of CSS.
std::string style_element() {
  return "<style>\npath{fill:none;stroke-linecap:round;stroke-linejoin:round}\n"
         "text{font-family:Helvetica,Arial,'Liberation Sans',sans-serif;stroke:none}\n" +
         rules_of(kDaySheet) + "@media (prefers-color-scheme:dark){\n" + rules_of(kNightSheet) +
         "}\n</style>\n";
}

/// From the paper of the drawing to the pixels of the document.
struct Sheet {
  Box box;
  [[nodiscard]] Place pixels(const Place& place) const {
    return kPixelsPerCentimetre *
           Place(place.x() - box.low.x() + kDrawingMargin, box.high.y() - place.y() + kDrawingMargin);
  }
};

std::string path_of(const Stroke& stroke, const Sheet& sheet) {
  constexpr std::array kFills{"", " body", " paper", " ink"};
  std::string d;
  for (const Place& place : stroke.places) {
    const Place at = sheet.pixels(place);
    d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? "M" : "L", at.x(), at.y());
  }
  return fmt::format(R"(<path class="{}{}" stroke-width="{:.2f}"{} d="{}{}"/>)", name_of(stroke.ink),
                     kFills.at(static_cast<std::size_t>(stroke.fill)), kPixelsPerCentimetre * stroke.width,
                     stroke.dashed ? R"( stroke-dasharray="4 3")" : "", d, stroke.closed ? "Z" : "");
}

std::string text_of(const Label& label, const Sheet& sheet) {
  constexpr std::array kAnchors{"start", "middle", "end"};
  const Place at = sheet.pixels(label.place);
  return fmt::format(R"(<text class="{}" x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)",
                     name_of(label.ink), at.x(), at.y(), kAnchors.at(static_cast<std::size_t>(label.anchor)),
                     html_escaped(label.words));
}

}  // namespace

std::string svg_of(const Drawing& drawing) {
  const Sheet sheet{extent(drawing)};
  const Place size = kPixelsPerCentimetre * (sheet.box.size() + Place::Constant(2.0 * kDrawingMargin));
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" font-size=\"{2:.1f}\" role=\"img\">\n<title>{3}</title>\n",
      size.x(), size.y(), kPixelsPerCentimetre * kTextSize, html_escaped(drawing.title));
  svg += style_element();
  svg += fmt::format("<rect class=\"sheet\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", size.x(), size.y());
  for (const Part& part : drawing.parts) {
    svg += fmt::format("<g class=\"{}\">", part.kind);
    for (const Stroke& stroke : part.strokes) svg += "\n" + path_of(stroke, sheet);
    for (const Label& label : part.labels) svg += "\n" + text_of(label, sheet);
    svg += "\n</g>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace signorini
