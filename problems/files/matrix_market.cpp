#include "problems/files/matrix_market.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "problems/files/text_lines.hpp"
#include "problems/files/toml_tree.hpp"

namespace signorini {

namespace {

constexpr std::string_view kHeader =
    "must be %%MatrixMarket matrix, coordinate or array, real or integer, general or symmetric";
constexpr std::size_t kReservedAtMost = std::size_t{1} << 20U;  // entries; the file may promise anything

struct Entry {
  int row = 0;
  int column = 0;
  double value = 0.0;
  int line = 0;
};

class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : lines_(text, name) {}

  SparseMatrix read() {
    read_header();
    read_size();
    entries_.reserve(std::min(static_cast<std::size_t>(expected_), kReservedAtMost));
    for (std::int64_t i = 0; i < expected_; ++i) {
      if (!next_line())
        lines_.refuse("file", fmt::format("{} entries", i), fmt::format("must hold {}", expected_));
      coordinate_ ? read_coordinate_entry() : read_array_entry();
    }
    if (next_line())
      lines_.refuse("entry", fmt::format("must be absent: the file holds {} entries", expected_));
    return assemble();
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
    const auto is = [&](std::size_t i, std::string_view one, std::string_view other) {
      return header[i] == one || header[i] == other;
    };
    if (header.size() != 5 || header[0] != "%%matrixmarket" || header[1] != "matrix" ||
        !is(2, "coordinate", "array") || !is(3, "real", "integer") || !is(4, "general", "symmetric")) {
      lines_.refuse("header", kHeader);
    }
    coordinate_ = header[2] == "coordinate";
    integer_ = header[3] == "integer";
    symmetric_ = header[4] == "symmetric";
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
    if (numbers[0] < 1 || numbers[0] > kMostMatrixRows || numbers[1] != numbers[0]) {
      lines_.refuse("size", fmt::format("must be square, of 1..{} rows", kMostMatrixRows));
    }
    size_ = static_cast<int>(numbers[0]);
    const std::int64_t n = numbers[0];
    const std::int64_t most = symmetric_ ? n * (n + 1) / 2 : n * n;
    expected_ = coordinate_ ? numbers[2] : most;
    if (expected_ < 0 || expected_ > most) {
      lines_.refuse("size", fmt::format("must promise 0..{} entries", most));
    }
    if (expected_ > (symmetric_ ? (kMostMatrixEntries + n) / 2 : kMostMatrixEntries)) {
      lines_.refuse("size",
                    fmt::format("must make at most {} entries, both triangles of a symmetric matrix counted",
                                kMostMatrixEntries));
    }
  }

  double value_of(std::string_view word) const {
    if (integer_ && !number_of<std::int64_t>(word)) lines_.refuse("entry", "value must be a whole number");
    const auto value = number_of<double>(word);
    if (!value || !std::isfinite(*value)) lines_.refuse("entry", "value must be a finite number");
    return *value;
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
    if (symmetric_ && column > row) {
      lines_.refuse("entry", "must be on or below the diagonal: the matrix is symmetric");
    }
    entries_.push_back(
        {.row = row, .column = column, .value = value_of(lines_.words()[2]), .line = lines_.number()});
  }

  // Column by column, of a symmetric matrix from the diagonal down.
  void read_array_entry() {
    if (lines_.words().size() != 1) lines_.refuse("entry", "must be one value");
    entries_.push_back(
        {.row = row_, .column = column_, .value = value_of(lines_.words()[0]), .line = lines_.number()});
    if (++row_ < size_) return;
    ++column_;
    row_ = symmetric_ ? column_ : 0;
  }

  // Most files are in this order already.
  void sort_entries() {
    const auto before = [](const Entry& a, const Entry& b) { return place(a) < place(b); };
    if (!std::is_sorted(entries_.begin(), entries_.end(), before))
      std::stable_sort(entries_.begin(), entries_.end(), before);
  }

  static std::pair<int, int> place(const Entry& entry) { return {entry.column, entry.row}; }

  void refuse_repetition() const {
    const auto twin = std::adjacent_find(entries_.begin(), entries_.end(),
                                         [](const Entry& a, const Entry& b) { return place(a) == place(b); });
    if (twin == entries_.end()) return;
    lines_.refuse("entry", fmt::format("row {}, column {}", twin->row + 1, twin->column + 1),
                  fmt::format("must be given once; it stands in line {} already", twin->line),
                  std::next(twin)->line);
  }

  SparseMatrix assemble() {
    sort_entries();
    refuse_repetition();
    SparseMatrix given(size_, size_);
    given.reserve(std::ssize(entries_));
    auto entry = entries_.begin();
    for (int column = 0; column < size_; ++column) {
      given.startVec(column);
      for (; entry != entries_.end() && entry->column == column; ++entry) {
        if (entry->value != 0.0) given.insertBackByOuterInner(column, entry->row) = entry->value;
      }
    }
    given.finalize();
    if (!symmetric_) return given;
    entries_ = {};
    return given.selfadjointView<Eigen::Lower>();
  }

  TextLines lines_;
  bool coordinate_ = true;
  bool integer_ = false;
  bool symmetric_ = false;
  int size_ = 0;
  std::int64_t expected_ = 0;  // entries in the file
  int row_ = 0;                // of the next array entry
  int column_ = 0;
  std::vector<Entry> entries_;
};

}  // namespace

SparseMatrix read_matrix_market(std::string_view text, const std::string& name) {
  return Reader(text, name).read();
}

}  // namespace signorini
