#include "harness/table.hpp"

#include <algorithm>
#include <cstring>

namespace signorini {

namespace {

std::string escaped(const std::string& cell) {
  std::string text;
  for (const char c : cell) {
    if (c == '|') text += '\\';
    text += c == '\n' ? ' ' : c;
  }
  return text;
}

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char c : cell) {
    if (c == '"') text += '"';
    text += c;
  }
  return text + "\"";
}

/// Header and rows as they are printed.
using Words = std::vector<std::vector<std::string>>;

Words escaped_words(const Table& table) {
  Words words(1);
  for (const std::string& title : table.header) words.front().push_back(escaped(title));
  for (const auto& row : table.rows) {
    words.emplace_back();
    for (const Cell& cell : row) words.back().push_back(escaped(cell.text));
  }
  return words;
}

/// Cells padded to the widths; a rule of three dashes at least below the header.
std::string pipe_table(const Words& words, const std::vector<std::size_t>& widths) {
  std::string text;
  for (std::size_t r = 0; r < words.size(); ++r) {
    for (std::size_t c = 0; c < widths.size(); ++c) {
      const std::string& word = words[r][c];
      text += "| " + word + std::string(std::max(widths[c], characters(word)) - characters(word) + 1, ' ');
    }
    text += "|\n";
    if (r > 0) continue;
    for (const std::size_t w : widths) text += "|" + std::string(w == 0 ? 3 : w + 2, '-');
    text += "|\n";
  }
  return text;
}

}  // namespace

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

bool Table::is_numeric(std::size_t column) const {
  return std::ranges::any_of(rows, [&](const auto& row) { return row[column].value.has_value(); });
}

std::string to_markdown(const Table& table) {
  const Words words = escaped_words(table);
  std::vector<std::size_t> widths(table.header.size(), 3);
  for (const auto& row : words) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], characters(row[c]));
  }
  return pipe_table(words, widths);
}

std::string to_narrow_markdown(const Table& table) {
  return pipe_table(escaped_words(table), std::vector<std::size_t>(table.header.size(), 0));
}

std::string csv_line(const std::vector<Cell>& row) {
  std::string text;
  for (std::size_t c = 0; c < row.size(); ++c) text += (c == 0 ? "" : ",") + quoted(row[c].text);
  return text + "\n";
}

std::string to_csv(const Table& table) {
  std::string text = csv_line({table.header.begin(), table.header.end()});
  for (const std::vector<Cell>& row : table.rows) text += csv_line(row);
  return text;
}

bool natural_less(const std::string& a, const std::string& b) { return strverscmp(a.c_str(), b.c_str()) < 0; }

}  // namespace signorini
