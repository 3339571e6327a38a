#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace signorini {

/// What stands in one place of a table, and what stands behind it.
struct Cell {
  std::string text = {};
  std::optional<double> value = {};  ///< of a number: what it is sorted by, infinite where there is none
  std::optional<std::size_t> record =
      {};  ///< the record that the text comes from, by its place in the report

  Cell() = default;
  Cell(std::string words) : text(std::move(words)) {}  // NOLINT(google-explicit-constructor)
  Cell(const char* words) : text(words) {}             // NOLINT(google-explicit-constructor)
  Cell(std::string words, double number, std::optional<std::size_t> source = {})
      : text(std::move(words)), value(number), record(source) {}
};

struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<Cell>> rows;  ///< each as long as the header

  /// Whether a column holds numbers (or nothing but numbers and reasons why there is none).
  [[nodiscard]] bool is_numeric(std::size_t column) const;
};

/// Pipe table with aligned columns; a `|` inside a cell is escaped.
std::string to_markdown(const Table& table);

/// The same without blanks for alignment, as README files hold it.
std::string to_narrow_markdown(const Table& table);

/// Comma separated values, header first; quoted where RFC 4180 asks for it.
std::string to_csv(const Table& table);

/// Compares text with runs of digits by their value: "n=9" comes before "n=10".
bool natural_less(std::string_view a, std::string_view b);

}  // namespace signorini
