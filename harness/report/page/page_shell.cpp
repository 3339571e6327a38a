#include "harness/report/page/page_shell.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "harness/files.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// What a manifest says of the run, as a definition list.
std::string facts_of(const Json& manifest) {
  std::string facts;
  const auto add = [&](const char* name, const char* pointer) {
    const Json::json_pointer place{pointer};
    if (!manifest.contains(place)) return;
    const Json& value = manifest[place];
    facts += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", html_escaped(name),
                         html_escaped(value.is_string() ? value.get<std::string>() : json_text(value)));
  };
  add("suite", "/suite");
  add("date", "/date");
  add("commit", "/build/commit");
  add("compiler", "/build/compiler");
  add("flags", "/build/flags");
  add("processor", "/machine/cpu");
  add("processors", "/machine/processors");
  add("time limit [s]", "/limits/timeout_s");
  return facts.empty() ? "<p>The run has no manifest.</p>\n" : "<dl>" + facts + "</dl>\n";
}

std::string head_of(const std::string& title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; base-uri 'none'; "
      "form-action 'none'; img-src data:; style-src 'unsafe-inline'; script-src {} {}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<link rel=\"icon\" href=\"data:,\">\n"
      "<title>{} - signorini</title>\n<style>\n{}</style></head>\n",
      script_source(kChartLibrary), script_source(kPageScript), html_escaped(title), kPageStyle);
}

constexpr const char* kPageEnd = R"(</main>
<dialog id="record" aria-labelledby="record-title"><h2 id="record-title"></h2><p id="record-facts"></p>
<pre tabindex="0" aria-label="The record as it is kept"></pre><button type="button">Close</button></dialog>
<div id="hint" aria-hidden="true" hidden></div>
)";

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

std::string whole_page(const PageText& text, const Json& data) {
  return head_of(text.title) + "<body>\n<a class=\"skip\" href=\"#main\">Skip to the content</a>\n" +
         text.contents +
         fmt::format(
             "<main id=\"main\" tabindex=\"-1\">\n<header><p class=\"brand\">signorini</p><h1>{}</h1>\n"
             "<p>{}</p></header>\n<noscript><p class=\"note\">Figures and records need JavaScript here; all "
             "tables are complete without it. The records are in the .jsonl file beside this "
             "page.</p></noscript>\n",
             html_escaped(text.title), text.summary) +
         text.main + kPageEnd +
         fmt::format(
             "<script type=\"application/octet-stream\" id=\"data\">{}</script>\n"
             "<script>{}</script>\n<script>{}</script>\n</body></html>\n",
             packed(json_line(data)), kChartLibrary, kPageScript);
}

std::string printed(const Json& record) {
  std::string text = "{\n";
  for (const auto& [key, value] : record.items())
    text += fmt::format("  \"{}\": {},\n", key, json_line(value));
  text.erase(text.size() - 2, 1);  // the last comma
  return text + "}";
}

std::string about_section(const Json& manifest, const std::string& more) {
  return "<section id=\"about\"><h2>How this run was made</h2>\n" + facts_of(manifest) + more +
         "</section>\n";
}

std::string contents_of(const std::string& parts) {
  return "<nav aria-label=\"Contents\"><details open><summary>Contents</summary>\n" + parts +
         "</details></nav>\n";
}

std::string list_part(const std::string& title, const std::string& items) {
  if (items.empty()) return "";
  return (title.empty() ? "" : fmt::format("<h2>{}</h2>\n", html_escaped(title))) + "<ul>\n" + items +
         "</ul>\n";
}

std::string item(const std::string& target, const std::string& title, const char* kind) {
  return fmt::format("<li class=\"{}\"><a href=\"#{}\">{}</a></li>\n", kind, html_escaped(target),
                     html_escaped(title));
}

std::string section_items(const std::vector<const Section*>& sections) {
  std::string text, matter;
  for (const Section* section : sections) {
    const std::size_t colon = section->title.find(": ");
    const std::string first = section->title.substr(0, colon);
    if (colon == std::string::npos) {
      text += item(section->id, section->title);
      continue;
    }
    if (first != matter) text += fmt::format("<li class=\"matter\">{}</li>\n", html_escaped(first));
    matter = first;
    text += item(section->id, section->title.substr(colon + 2), "contest");
  }
  return text;
}

std::string chart(const std::string& kind, const std::string& of, const std::string& title,
                  const std::string& caption) {
  return fmt::format(
      "<figure class=\"chart {0}\" data-kind=\"{0}\" data-of=\"{1}\" "
      "data-title=\"{2}\"><figcaption>{3}</figcaption></figure>\n",
      kind, html_escaped(of), html_escaped(title), html_escaped(caption));
}

std::string base64(std::string_view bytes) {
  constexpr std::size_t kIn = 3, kOut = 4;
  std::string text(kOut * ((bytes.size() + kIn - 1) / kIn) + 1, '\0');  // and a closing zero
  const int length =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                      reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

std::string packed(std::string_view text) {
  uLongf size = compressBound(static_cast<uLong>(text.size()));
  std::string bytes(size, '\0');
  const int status =
      compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                static_cast<uLong>(text.size()), Z_BEST_COMPRESSION);
  if (status != Z_OK) throw std::runtime_error(fmt::format("zlib: {}", zError(status)));
  bytes.resize(size);
  return base64(bytes);
}

std::string script_source(std::string_view script) {
  const std::string digits = sha256(script);
  std::string digest;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    digest += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return fmt::format("'sha256-{}'", base64(digest));
}

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
