#pragma once
// Tables of text and numbers, and their Markdown and CSV.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace signorini {

/// One cell: its text, and the number or the record that the text stands for.
struct Cell {
  std::string text = {};
  std::optional<double> value = {};        ///< that the cell is sorted by; infinite where a number is missing
  std::optional<std::size_t> record = {};  ///< that the text comes from, by its place in the report

  Cell() = default;
  Cell(std::string words) : text(std::move(words)) {}  // NOLINT(google-explicit-constructor)
  Cell(const char* words) : text(words) {}             // NOLINT(google-explicit-constructor)
  Cell(std::string words, double number, std::optional<std::size_t> source = {})
      : text(std::move(words)), value(number), record(source) {}
};

/// A header and rows of cells.
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<Cell>> rows;  ///< each as long as the header

  /// Whether a column holds numbers (or nothing but numbers and reasons why there is none).
  [[nodiscard]] bool is_numeric(std::size_t column) const;
};

/// Characters of UTF-8, of which continuation bytes do not count.
std::size_t characters(std::string_view text);

/// Pipe table with aligned columns; a `|` inside a cell is escaped.
std::string to_markdown(const Table& table);

/// The same without blanks for alignment, as README files hold it.
std::string to_narrow_markdown(const Table& table);

/// A row of comma separated values with its break; quoted where RFC 4180 asks for it.
std::string csv_line(const std::vector<Cell>& row);

/// Comma separated values, header first; quoted where RFC 4180 asks for it.
std::string to_csv(const Table& table);

/// Compares text with runs of digits by their value: "n=9" comes before "n=10".
bool natural_less(const std::string& a, const std::string& b);

}  // namespace signorini
