#include "harness/report/formats/html.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <regex>
#include <utility>

namespace signorini {

namespace {

std::string base64(const std::string& bytes) {
  constexpr std::size_t kIn = 3, kOut = 4;
  std::string text(kOut * ((bytes.size() + kIn - 1) / kIn) + 1, '\0');  // and a closing zero
  const int length =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                      reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

std::string linked(const std::string& target, const std::string& text) {
  return fmt::format("<a href=\"#{}\">{}</a>", html_escaped(target), text);
}

/// A title may be broken where a method's settings begin and where one ends.
std::string breakable(const std::string& title) {
  std::string text = html_escaped(title);
  boost::replace_all(text, "[", "<wbr>[");
  boost::replace_all(text, ",", ",<wbr>");
  return text;
}

std::string cell_text(const std::string& column, const Cell& cell) {
  const std::string text = html_escaped(cell.text);
  if (cell.record) return linked(record_anchor(*cell.record), text);
  if (column == "scene") return linked("scene-" + cell.text, text);
  if (column == "method") return fmt::format("<a href=\"#cases\" data-filter=\"{0}\">{0}</a>", text);
  return text;
}

}  // namespace

std::string html_escaped(std::string text) {
  // Control characters, which HTML forbids.
  std::ranges::replace_if(
      text, [](unsigned char c) { return (c < 0x20U && c != '\n' && c != '\t') || c == 0x7FU; }, ' ');
  // The ampersand first: the others are spelled with it.
  for (const auto& [plain, spelled] :
       {std::pair{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}})
    boost::replace_all(text, plain, spelled);
  return text;
}

std::string html_text(const std::string& text) {
  static const std::regex code("`([^`]*)`");
  return std::regex_replace(html_escaped(text), code, "<code>$1</code>");
}

std::string record_anchor(std::size_t place) { return fmt::format("record-{}", place + 1); }

std::string html_table(const Table& table) {
  std::string text = "<div class=\"table\"><table><thead><tr>";
  std::vector<std::string> classes;
  for (std::size_t c = 0; c < table.header.size(); ++c) {
    classes.emplace_back(table.is_numeric(c) ? " class=\"n\"" : "");
    text += fmt::format("<th scope=\"col\"{}>{}</th>", classes.back(), breakable(table.header[c]));
  }
  text += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string value = row[c].value && std::isfinite(*row[c].value)
                                    ? fmt::format(" data-v=\"{:.6g}\"", *row[c].value)
                                    : "";
      text += fmt::format("<td{}{}>{}</td>", classes[c], value, cell_text(table.header[c], row[c]));
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string html_figure(const Figure& figure, const std::string& svg) {
  return fmt::format(
      "<figure id=\"figure-{0}\"><img alt=\"{1}\" width=\"{2:.0f}\" height=\"{3:.0f}\" "
      "src=\"data:image/svg+xml;base64,{4}\"><figcaption>{1}</figcaption></figure>\n",
      html_escaped(figure.name), html_escaped(figure.caption), figure.width * kPixelsPerCentimetre,
      figure.height * kPixelsPerCentimetre, base64(svg));
}

}  // namespace signorini
