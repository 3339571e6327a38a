#include "harness/schematic/svg.hpp"

#include <fmt/format.h>

#include <array>

namespace signorini {

namespace {

// 96 pixels per inch.
constexpr double kPixels = 96.0 / 2.54;

// The contact and load colours are those of the figures (Okabe and Ito), lighter on dark paper.
constexpr std::string_view kStyle = R"(<style>
svg{--paper:#fff;--structure:#1f2328;--body:#dde7ef;--contact:#c04f00;--load:#0067a3;--note:#57606a}
@media (prefers-color-scheme:dark){svg{--paper:#0d1117;--structure:#d7dee6;--body:#2b3a48;--contact:#ff9d57;--load:#6cb6ff;--note:#9aa4af}}
.sheet{fill:var(--paper)}
path{fill:none;stroke-linecap:round;stroke-linejoin:round}
path.structure{stroke:var(--structure)}path.contact{stroke:var(--contact)}path.load{stroke:var(--load)}path.note{stroke:var(--note)}
path.body{fill:var(--body)}path.paper{fill:var(--paper)}
path.structure.ink{fill:var(--structure)}path.contact.ink{fill:var(--contact)}path.load.ink{fill:var(--load)}
text{font-family:Helvetica,Arial,'Liberation Sans',sans-serif;stroke:none}
text.structure{fill:var(--structure)}text.contact{fill:var(--contact)}text.load{fill:var(--load)}text.note{fill:var(--note)}
</style>
)";

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
                     xml_text(label.words));
}

}  // namespace

std::string xml_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      default:
        escaped += static_cast<unsigned char>(c) < 0x20U ? ' ' : c;
    }
  }
  return escaped;
}

std::string svg_of(const Drawing& drawing) {
  const Sheet sheet{extent(drawing)};
  const Place size = kPixels * (sheet.box.size() + Place::Constant(2.0 * kDrawingMargin));
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" font-size=\"{2:.1f}\" role=\"img\">\n<title>{3}</title>\n",
      size.x(), size.y(), kPixels * kTextSize, xml_text(drawing.title));
  svg += kStyle;
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
