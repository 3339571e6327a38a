#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <sstream>

#include "harness/failure.hpp"
#include "harness/report/document/lines.hpp"
#include "harness/report/formats/formats.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

constexpr std::size_t kLineLength = 110;

std::string wrapped(const std::string& text) { return joined(wrapped_lines(text, kLineLength), "\n") + "\n"; }

/// The table that a marker's words ask for; of a section without one the text, line by line as it is.
std::string table_for(const std::string& words, std::span<const Section> sections) {
  std::istringstream stream(words);
  std::string id, first_cell;
  stream >> id >> first_cell;
  const auto found = std::find_if(sections.begin(), sections.end(),
                                  [&](const Section& section) { return section.id == id; });
  if (found == sections.end()) {
    std::vector<std::string> known;
    for (const Section& section : sections) known.push_back(section.id);
    throw UsageError(fmt::format("table = {} (must be one of {})", id, joined(known, ", ")));
  }
  if (found->table.header.empty()) return "```\n" + found->text + "```\n";
  Table table = found->table;
  if (!first_cell.empty()) {
    std::erase_if(table.rows, [&](const auto& row) { return row.front().text != first_cell; });
    if (table.rows.empty())
      throw NothingMatched(fmt::format("table = {} {} (must name the first cell of a row)", id, first_cell));
  }
  for (auto& row : table.rows)
    for (Cell& cell : row) cell.text = with_unit_signs(cell.text);
  return to_narrow_markdown(table);
}

// A table, as far as it has room.
std::string shortened(const Table& table, std::size_t most) {
  std::string whole = to_markdown(table);
  const std::size_t rows = table.rows.size();
  if (whole.size() <= most || rows < 2) return whole;
  // Lines are of the same length, heads and rows alike.
  const auto shown = std::max<std::size_t>(1, rows * most / whole.size());
  const auto begin = table.rows.begin();
  return to_markdown({table.header, {begin, begin + static_cast<std::ptrdiff_t>(shown)}}) +
         fmt::format("\n{} of {} rows; `signorini report --format whole` writes all.\n", shown, rows);
}

}  // namespace

std::string markdown_report(std::span<const Section> sections, std::size_t most) {
  std::string text;
  for (const Section& section : sections) {
    text += fmt::format("{}## {}\n\n", text.empty() ? "" : "\n", section.title);
    if (!section.text.empty()) text += wrapped(section.text) + "\n";
    if (!section.table.header.empty()) text += shortened(section.table, most);
    if (!section.note.empty()) text += "\n" + wrapped(section.note);
  }
  return text;
}

std::string with_tables(const std::string& document, const std::string& run,
                        std::span<const Section> sections) {
  constexpr std::string_view kEnd = "<!-- /table -->";
  const std::string begin = "<!-- table " + run + "/";
  if (document.find(begin) == std::string::npos)
    throw NothingMatched(fmt::format("table = none (must be asked for by a line {}SECTION -->)", begin));
  std::string text;
  std::size_t done = 0;
  for (std::size_t at = document.find(begin); at != std::string::npos; at = document.find(begin, done)) {
    const std::size_t words = at + begin.size();
    const std::size_t closed = document.find(" -->\n", words);
    const std::size_t end = document.find(kEnd, words);
    if (closed == std::string::npos || end == std::string::npos || end < closed)
      throw UsageError(fmt::format("{} (must be closed by a line {})",
                                   document.substr(at, document.find('\n', at) - at), kEnd));
    text += document.substr(done, closed + 5 - done) + "\n" +
            table_for(document.substr(words, closed - words), sections) + "\n";
    done = end;
  }
  return text + document.substr(done);
}

}  // namespace signorini
