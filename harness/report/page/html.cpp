#include "harness/report/page/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "harness/report/document/lines.hpp"

namespace signorini {

namespace {

std::string linked(const std::string& target, const std::string& text) {
  return fmt::format("<a href=\"#{}\">{}</a>", html_escaped(target), text);
}

/// Of a cell that has words in place of a number, such as "not reached"; not of "0 of 8".
bool is_missing(const Cell& cell) {
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  return cell.value && !std::isfinite(*cell.value) && std::ranges::none_of(cell.text, is_digit);
}

std::string cell_text(const std::string& column, const Cell& cell) {
  if (is_missing(cell) && !cell.record && cell.text != "-")
    return fmt::format("–<span class=\"unseen\">{}</span>", html_escaped(cell.text));
  const std::string text = html_escaped(with_unit_signs(cell.text));
  if (cell.record) return linked(record_anchor(*cell.record), text);
  if (column == "scene") return linked("scene-" + cell.text, text);
  if (column == "method") return link_to_cases(cell.text);
  return text;
}

/// One row; its first cell is its title.
std::string row_text(const Table& table, const std::vector<std::size_t>& columns,
                     const std::vector<Cell>& row) {
  std::string text = "<tr>";
  for (const std::size_t c : columns) {
    const std::string value =
        row[c].value && std::isfinite(*row[c].value) ? fmt::format(" data-v=\"{:.6g}\"", *row[c].value) : "";
    const char* const tag = c == 0 ? "th scope=\"row\"" : "td";
    text += fmt::format("<{}{}{}>{}</{}>", tag, table.is_numeric(c) ? " class=\"n\"" : "", value,
                        cell_text(table.header[c], row[c]), c == 0 ? "th" : "td");
  }
  return text + "</tr>\n";
}

}  // namespace

std::string link_to_cases(const std::string& name) {
  return fmt::format("<a href=\"#cases\" data-filter>{}</a>", breakable(name));
}

std::string html_text(const std::string& text) {
  const std::string plain = html_escaped(text);
  std::string marked;
  std::size_t from = 0;
  for (std::size_t open = plain.find('`'), close; open != std::string::npos; open = plain.find('`', from)) {
    close = plain.find('`', open + 1);
    if (close == std::string::npos) break;
    marked +=
        plain.substr(from, open - from) + "<code>" + plain.substr(open + 1, close - open - 1) + "</code>";
    from = close + 1;
  }
  return marked + plain.substr(from);
}

std::string breakable(const std::string& title) {
  std::string text = html_escaped(title);
  text = replaced(text, "[", "<wbr>[");
  text = replaced(text, ",", ",<wbr>");
  return text;
}

std::string record_anchor(std::size_t place) { return fmt::format("record-{}", place + 1); }

bool says_nothing(const Table& table, std::size_t column) {
  return column > 0 && std::ranges::all_of(table.rows, [&](const std::vector<Cell>& row) {
           const Cell& cell = row[column];
           return cell.text.empty() || cell.text == "-" || is_missing(cell);
         });
}

std::string html_table(const Table& table, const std::string& caption) {
  std::vector<std::size_t> columns;
  for (std::size_t c = 0; c < table.header.size(); ++c)
    if (!says_nothing(table, c)) columns.push_back(c);
  std::string text = fmt::format(
      "<div class=\"table\"><table><caption class=\"unseen\">{}</caption><thead><tr>", html_escaped(caption));
  for (const std::size_t c : columns) {
    text += fmt::format("<th scope=\"col\"{}>{}</th>", table.is_numeric(c) ? " class=\"n\"" : "",
                        breakable(table.header[c]));
  }
  text += "</tr></thead><tbody>\n";
  for (const std::vector<Cell>& row : table.rows) text += row_text(table, columns, row);
  return text + "</tbody></table></div>\n";
}

}  // namespace signorini
