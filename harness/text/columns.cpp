#include "harness/text/columns.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "harness/text/words.hpp"

namespace signorini {

namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t kBetween = 2;  // blanks from one column to the next

std::size_t widest(const Lines& lines) {
  std::size_t most = 0;
  for (const std::string& line : lines) most = std::max(most, characters(line));
  return most;
}

/// One column: its title and its cells, broken into lines of at most `width`.
struct Column {
  std::vector<std::string> words = {};  ///< the title first
  bool numeric = false;
  std::size_t width = 0, least = 0;  ///< least: of its longest word

  Column(const Table& table, std::size_t place) : numeric(table.is_numeric(place)) {
    words.push_back(table.header[place]);
    for (const auto& row : table.rows) words.push_back(row[place].text);
    for (const std::string& cell : words) {
      width = std::max(width, characters(cell));
      least = std::max(least, widest(wrapped_lines(cell, 1)));
    }
    if (numeric) least = width;
  }

  /// What fits stays as it is, blanks included.
  [[nodiscard]] Lines cell(std::size_t row) const {
    return characters(words[row]) <= width ? Lines{words[row]} : wrapped_lines(words[row], width);
  }

  [[nodiscard]] std::string padded(const std::string& word) const {
    const std::string blanks(width - std::min(width, characters(word)), ' ');
    return numeric ? blanks + word : word + blanks;
  }
};

std::size_t line_width(const std::vector<Column>& columns) {
  return std::accumulate(columns.begin(), columns.end(), kBetween * (columns.size() - 1),
                         [](std::size_t sum, const Column& column) { return sum + column.width; });
}

/// Narrows the widest columns, one character after the other, until a line fits or no column gives way.
void narrow(std::vector<Column>& columns, std::size_t most) {
  while (line_width(columns) > most) {
    const auto slack = [](const Column& column) { return column.width > column.least ? column.width : 0; };
    const auto column = std::ranges::max_element(columns, {}, slack);
    if (slack(*column) == 0) return;
    --column->width;
  }
}

std::string row_text(const std::vector<Column>& columns, std::size_t row) {
  std::vector<Lines> cells;
  std::size_t height = 0;
  for (const Column& column : columns) {
    cells.push_back(column.cell(row));
    height = std::max(height, cells.back().size());
  }
  std::string text;
  for (std::size_t i = 0; i < height; ++i) {
    std::string line;
    for (std::size_t c = 0; c < columns.size(); ++c)
      line += (c == 0 ? "" : std::string(kBetween, ' ')) +
              columns[c].padded(i < cells[c].size() ? cells[c][i] : "");
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace

std::string to_columns(const Table& table, std::size_t width) {
  std::vector<Column> columns;
  for (std::size_t c = 0; c < table.header.size(); ++c) columns.emplace_back(table, c);
  if (columns.empty()) return {};
  narrow(columns, width);
  std::string text;
  for (std::size_t row = 0; row <= table.rows.size(); ++row) text += row_text(columns, row);
  return text;
}

}  // namespace signorini
