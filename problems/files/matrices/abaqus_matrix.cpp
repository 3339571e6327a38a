#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "problems/files/matrices/matrix_file.hpp"

namespace signorini {

namespace {

constexpr std::string_view kAbaqusBetween = ", \t\r\v\f";
constexpr std::size_t kAbaqusWords = 5;

/// Calls visit(lines, row, column) for every entry.
template <class Visit>
void for_each_abaqus_entry(TextLines& lines, Visit visit) {
  using Limits = std::numeric_limits<int>;
  std::int64_t entries = 0;
  while (lines.next()) {
    if (lines.words()[0].starts_with('*')) continue;
    if (lines.words().size() != kAbaqusWords)
      lines.refuse("entry", "must be node, degree of freedom, node, degree of freedom and value");
    std::array<std::int64_t, kAbaqusWords - 1> at{};
    for (std::size_t i = 0; i < at.size(); ++i)
      at[i] = lines.whole(i, "entry", Limits::min() + 1, Limits::max());
    if (++entries > kMostMatrixEntries)
      lines.refuse("entry", fmt::format("must be one of at most {}", kMostMatrixEntries));
    visit(std::pair{at[0], at[1]}, std::pair{at[2], at[3]});
  }
}

}  // namespace

bool is_abaqus_entry(std::string_view line) {
  const std::vector<std::string_view> words = words_of(line, kAbaqusBetween);
  return std::ranges::count(line, ',') == kAbaqusWords - 1 && words.size() == kAbaqusWords &&
         std::all_of(words.begin(), words.end() - 1,
                     [](std::string_view word) { return number_of<std::int64_t>(word).has_value(); });
}

NodeDofs abaqus_coordinates(std::string_view text, const std::string& name) {
  TextLines lines(text, name, kAbaqusBetween);
  NodeDofs found;
  for_each_abaqus_entry(lines, [&](const auto& row, const auto& column) {
    found.insert(row);
    found.insert(column);
  });
  return found;
}

MatrixFile read_abaqus_matrix(std::string_view text, const std::string& name, const NodeDofs& all) {
  TextLines lines(text, name, kAbaqusBetween);
  const std::vector<std::pair<std::int64_t, std::int64_t>> places(all.begin(), all.end());
  const auto number_in_all = [&](const auto& place) {
    return static_cast<int>(std::ranges::lower_bound(places, place) - places.begin());
  };
  std::vector<MatrixEntry> entries;
  for_each_abaqus_entry(lines, [&](const auto& row, const auto& column) {
    entries.push_back({.row = number_in_all(row),
                       .column = number_in_all(column),
                       .value = matrix_value(lines, lines.words().back()),
                       .line = lines.number()});
  });
  const int size = matrix_size(lines, std::ssize(places), std::ssize(places));
  const Symmetry symmetry = has_both_triangles(entries) ? Symmetry::general : Symmetry::symmetric;
  MatrixFile file = assemble_matrix(lines, size, std::move(entries), symmetry);
  file.notices.push_back(fmt::format(
      "{}: Abaqus; coordinates by rising node and degree of freedom, 0 is node {}, degree {}, and {} node "
      "{}, "
      "degree {}; {}",
      name, places.front().first, places.front().second, size - 1, places.back().first, places.back().second,
      symmetry == Symmetry::symmetric ? "the other triangle follows from the one given"
                                      : "both triangles given"));
  return file;
}

}  // namespace signorini
