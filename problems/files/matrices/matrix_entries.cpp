#include "problems/files/matrices/matrix_entries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "problems/files/toml_tree.hpp"

namespace signorini {

namespace {

std::pair<int, int> place_of(const MatrixEntry& entry) { return {entry.column, entry.row}; }

bool at_one_place(const MatrixEntry& a, const MatrixEntry& b) { return place_of(a) == place_of(b); }

// Most files are in this order already.
void sort_entries(std::vector<MatrixEntry>& entries) {
  const auto before = [](const MatrixEntry& a, const MatrixEntry& b) { return place_of(a) < place_of(b); };
  if (!std::ranges::is_sorted(entries, before)) std::ranges::stable_sort(entries, before);
}

// Into the lower triangle.
void fold(std::vector<MatrixEntry>& entries, double sign) {
  for (MatrixEntry& entry : entries) {
    if (entry.column <= entry.row) continue;
    std::swap(entry.row, entry.column);
    entry.value *= sign;
    entry.above = true;
  }
}

std::string place_text(const MatrixEntry& entry) {
  return fmt::format("row {}, column {}", entry.row + 1, entry.column + 1);
}

// Sums what stands at one place; how many entries that were.
void sum_repeated(const TextLines& lines, std::vector<MatrixEntry>& entries,
                  std::vector<std::string>& notices) {
  std::size_t kept = 0, repeated = 0;
  std::string first;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i == 0 || !at_one_place(entries[kept - 1], entries[i])) {
      entries[kept++] = entries[i];
      continue;
    }
    MatrixEntry& sum = entries[kept - 1];
    if (sum.above != entries[i].above)
      lines.refuse("entry", place_text(sum),
                   fmt::format("must be in one triangle: the header says that the other follows from it, and "
                               "line {} has the other; where both are meant, the header says general",
                               sum.line),
                   entries[i].line);
    if (repeated++ == 0)
      first = fmt::format("{} (lines {} and {})", place_text(sum), sum.line, entries[i].line);
    sum.value += entries[i].value;
    if (!std::isfinite(sum.value))
      lines.refuse("entry", place_text(sum), "must have a finite sum", entries[i].line);
  }
  entries.resize(kept);
  if (repeated > 0)
    notices.push_back(
        fmt::format("{}: {} summed onto others at the same place, the first at {}", lines.name(),
                    repeated == 1 ? "an entry is" : fmt::format("{} entries are", repeated), first));
}

}  // namespace

double matrix_value(const TextLines& lines, std::string_view word) {
  std::optional<double> value = number_of<double>(word);
  if (!value) value = fortran_number(word);
  if (!value || !std::isfinite(*value))
    lines.refuse("entry", fmt::format("value must be a finite number{}", number_mistake(word)));
  return *value;
}

int matrix_size(const TextLines& lines, std::int64_t rows, std::int64_t columns) {
  if (rows < 1 || rows > kMostMatrixRows || columns != rows)
    lines.refuse("size", fmt::format("must be square, of 1..{} rows", kMostMatrixRows));
  return static_cast<int>(rows);
}

void require_entry_count(const TextLines& lines, std::int64_t entries, int size, Symmetry symmetry) {
  if (entries < 0) lines.refuse("size", "must promise 0 entries or more");
  if (entries > (symmetry == Symmetry::general ? kMostMatrixEntries : (kMostMatrixEntries + size) / 2))
    lines.refuse("size",
                 fmt::format("must make at most {} entries, both triangles of a symmetric matrix counted",
                             kMostMatrixEntries));
}

bool has_both_triangles(const std::vector<MatrixEntry>& entries) {
  std::vector<MatrixEntry> folded = entries;
  fold(folded, 1.0);
  sort_entries(folded);
  return std::ranges::adjacent_find(folded, [](const MatrixEntry& a, const MatrixEntry& b) {
           return at_one_place(a, b) && a.above != b.above;
         }) != folded.end();
}

MatrixFile assemble_matrix(const TextLines& lines, int size, std::vector<MatrixEntry> entries,
                           Symmetry symmetry) {
  MatrixFile file;
  if (symmetry != Symmetry::general) fold(entries, symmetry == Symmetry::skew ? -1.0 : 1.0);
  sort_entries(entries);
  sum_repeated(lines, entries, file.notices);
  SparseMatrix given(size, size);
  given.reserve(std::ssize(entries));
  auto entry = entries.begin();
  for (int column = 0; column < size; ++column) {
    given.startVec(column);
    for (; entry != entries.end() && entry->column == column; ++entry) {
      if (entry->value == 0.0) continue;
      if (symmetry == Symmetry::skew && entry->row == column)
        lines.refuse("entry", place_text(*entry), "must be 0: the header says skew-symmetric", entry->line);
      given.insertBackByOuterInner(column, entry->row) = entry->value;
    }
  }
  given.finalize();
  entries = {};
  if (symmetry == Symmetry::symmetric)
    file.matrix = given.selfadjointView<Eigen::Lower>();
  else if (symmetry == Symmetry::skew)
    file.matrix = given - SparseMatrix(given.transpose());
  else
    file.matrix.swap(given);
  return file;
}

}  // namespace signorini
