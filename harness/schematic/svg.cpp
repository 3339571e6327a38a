#include "harness/schematic/svg.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

#include "harness/text/words.hpp"

namespace signorini {

namespace {

// 96 pixels per inch.
constexpr double kPixels = 96.0 / 2.54;

struct SheetColours {
  std::string_view paper, body, structure, contact, load, note;
};
// The contact and load colours are those of the figures (Okabe and Ito), lighter on dark paper.
constexpr SheetColours kDaySheet{"#fff", "#dde7ef", "#1f2328", "#c04f00", "#0067a3", "#57606a"};
constexpr SheetColours kNightSheet{"#0d1117", "#2b3a48", "#d7dee6", "#ff9d57", "#6cb6ff", "#9aa4af"};

std::string rules_of(const SheetColours& colours) {
  std::string rules =
      fmt::format(".sheet,path.paper{{fill:{}}}path.body{{fill:{}}}\n", colours.paper, colours.body);
  for (const auto& [ink, colour] :
       {std::pair{Ink::structure, colours.structure}, std::pair{Ink::contact, colours.contact},
        std::pair{Ink::load, colours.load}, std::pair{Ink::note, colours.note}})
    rules += fmt::format("path.{0}{{stroke:{1}}}path.{0}.ink,text.{0}{{fill:{1}}}\n", ink_name(ink), colour);
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
    return kPixels *
           Place(place.x() - box.low.x() + kDrawingMargin, box.high.y() - place.y() + kDrawingMargin);
  }
};

std::string path_of(const Stroke& stroke, const Sheet& sheet) {
  std::string d;
  for (const Place& place : stroke.places) {
    const Place at = sheet.pixels(place);
    d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? "M" : "L", at.x(), at.y());
  }
  return fmt::format(R"(<path class="{}{}{}" stroke-width="{:.2f}"{} d="{}{}"/>)", ink_name(stroke.ink),
                     stroke.fill == Fill::none ? "" : " ",
                     stroke.fill == Fill::none ? "" : fill_name(stroke.fill), kPixels * stroke.width,
                     stroke.dashed ? R"( stroke-dasharray="4 3")" : "", d, stroke.closed ? "Z" : "");
}

std::string text_of(const Label& label, const Sheet& sheet) {
  constexpr std::array kAnchors{"start", "middle", "end"};
  const Place at = sheet.pixels(label.place);
  return fmt::format(R"(<text class="{}" x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)",
                     ink_name(label.ink), at.x(), at.y(), kAnchors.at(static_cast<std::size_t>(label.anchor)),
                     html_escaped(label.words));
}

}  // namespace

std::string svg_of(const Drawing& drawing) {
  const Sheet sheet{extent(drawing)};
  const Place size = kPixels * (sheet.box.size() + Place::Constant(2.0 * kDrawingMargin));
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" font-size=\"{2:.1f}\" role=\"img\">\n<title>{3}</title>\n",
      size.x(), size.y(), kPixels * kTextSize, html_escaped(drawing.title));
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
