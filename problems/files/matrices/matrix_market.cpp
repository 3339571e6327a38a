#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include "problems/files/matrices/matrix_file.hpp"
#include "problems/files/text_lines.hpp"

namespace signorini {

namespace {

constexpr std::string_view kHeader =
    "must be %%MatrixMarket matrix, coordinate or array, real, double or integer, general, symmetric or "
    "skew-symmetric";
constexpr std::string_view kComplexHeader =
    "must be real: a motion in time has no complex stiffness; write the real part, and structural damping as "
    "a "
    "damping matrix or as modal";

class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : lines_(text, name) {}

  MatrixFile read() {
    read_header();
    read_size();
    for (std::int64_t i = 0; i < expected_; ++i) {
      if (!next_line())
        lines_.refuse("file", fmt::format("{} entries", i), fmt::format("must hold {}", expected_));
      coordinate_ ? read_coordinate_entry() : read_array_entry();
    }
    if (next_line())
      lines_.refuse("entry", fmt::format("must be absent: the file holds {} entries", expected_));
    return assemble_matrix(lines_, size_, std::move(entries_), symmetry_);
  }

 private:
  // The next line with something on it that is no comment.
  bool next_line() {
    while (lines_.next()) {
      if (lines_.words()[0][0] != '%') return true;
    }
    return false;
  }

  void read_header() {
    if (!lines_.next()) lines_.refuse("header", "missing", kHeader);
    std::string lower(lines_.line().substr(0, 200));
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::vector<std::string_view> header = words_of(lower);
    const auto one_of = [&](std::size_t i, std::initializer_list<std::string_view> known) {
      return std::ranges::find(known, header[i]) != known.end();
    };
    if (number_of<double>(header[0]) || header[0].find(',') != std::string_view::npos)
      lines_.refuse("header",
                    fmt::format("{}; a list of row, column and value lacks that line and one of rows, "
                                "columns and number of entries before it",
                                kHeader));
    if (header.size() == 5 && header[3] == "complex") lines_.refuse("header", kComplexHeader);
    if (header.size() != 5 || header[0] != "%%matrixmarket" || header[1] != "matrix" ||
        !one_of(2, {"coordinate", "array"}) ||
        !one_of(3, {"real", "double", "integer", "unsigned-integer"}) ||
        !one_of(4, {"general", "symmetric", "hermitian", "skew-symmetric"})) {
      lines_.refuse("header", kHeader);
    }
    coordinate_ = header[2] == "coordinate";
    integer_ = header[3].ends_with("integer");
    symmetry_ = header[4] == "general"          ? Symmetry::general
                : header[4] == "skew-symmetric" ? Symmetry::skew
                                                : Symmetry::symmetric;
    row_ = symmetry_ == Symmetry::skew ? 1 : 0;
  }

  void read_size() {
    const std::string_view required = coordinate_
                                          ? "must be rows, columns and number of entries, three numbers"
                                          : "must be rows and columns, two numbers";
    if (!next_line()) lines_.refuse("size", "missing", required);
    if (lines_.words().size() != (coordinate_ ? 3U : 2U)) lines_.refuse("size", required);
    std::vector<std::int64_t> numbers;
    for (const std::string_view word : lines_.words()) {
      const auto number = number_of<std::int64_t>(word);
      if (!number) lines_.refuse("size", required);
      numbers.push_back(*number);
    }
    size_ = matrix_size(lines_, numbers[0], numbers[1]);
    const std::int64_t n = size_;
    const std::int64_t whole = symmetry_ == Symmetry::general     ? n * n
                               : symmetry_ == Symmetry::symmetric ? n * (n + 1) / 2
                                                                  : n * (n - 1) / 2;
    expected_ = coordinate_ ? numbers[2] : whole;
    require_entry_count(lines_, expected_, size_, symmetry_);
  }

  double value_of(std::string_view word) const {
    if (integer_ && !number_of<std::int64_t>(word)) lines_.refuse("entry", "value must be a whole number");
    return matrix_value(lines_, word);
  }

  int index_of(std::string_view word, std::string_view what) const {
    const auto index = number_of<int>(word);
    if (!index || *index < 1 || *index > size_) {
      lines_.refuse("entry", fmt::format("{} must be in 1..{}", what, size_));
    }
    return *index - 1;
  }

  void read_coordinate_entry() {
    if (lines_.words().size() != 3) lines_.refuse("entry", "must be row, column and value");
    const int row = index_of(lines_.words()[0], "row");
    const int column = index_of(lines_.words()[1], "column");
    entries_.push_back(
        {.row = row, .column = column, .value = value_of(lines_.words()[2]), .line = lines_.number()});
  }

  // Column by column, of a symmetric matrix from the diagonal down, of a skew one from below it.
  void read_array_entry() {
    if (lines_.words().size() != 1) lines_.refuse("entry", "must be one value");
    entries_.push_back(
        {.row = row_, .column = column_, .value = value_of(lines_.words()[0]), .line = lines_.number()});
    if (++row_ < size_) return;
    ++column_;
    row_ = symmetry_ == Symmetry::general ? 0 : symmetry_ == Symmetry::symmetric ? column_ : column_ + 1;
  }

  TextLines lines_;
  bool coordinate_ = true;
  bool integer_ = false;
  Symmetry symmetry_ = Symmetry::general;
  int size_ = 0;
  std::int64_t expected_ = 0;  // entries in the file
  int row_ = 0;                // of the next array entry
  int column_ = 0;
  std::vector<MatrixEntry> entries_;
};

}  // namespace

MatrixFile read_matrix_market(std::string_view text, const std::string& name) {
  return Reader(text, name).read();
}

}  // namespace signorini
