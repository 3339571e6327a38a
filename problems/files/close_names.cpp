#include "problems/files/close_names.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace signorini {

namespace {

constexpr std::size_t kMostSuggestions = 3;
/// A word that is longer is no slip of the fingers, and is not worth the time.
constexpr std::size_t kLongestCompared = 200;

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::vector<std::string> close_names(std::string_view word, std::span<const std::string> known) {
  if (word.empty() || word.size() > kLongestCompared) return {};
  const std::size_t farthest = std::max<std::size_t>(2, word.size() / 4);
  std::vector<std::pair<std::size_t, std::string>> close;
  for (const std::string& name : known) {
    const std::size_t distance = edit_distance(word, name);
    // As many edits as letters make any word of any other.
    if (distance <= farthest && distance < word.size()) close.emplace_back(distance, name);
  }
  std::ranges::sort(close);
  std::vector<std::string> names;
  for (auto& [distance, name] : close) {
    if (names.size() < kMostSuggestions) names.push_back(std::move(name));
  }
  return names;
}

std::string suggestion(std::string_view word, std::span<const std::string> known) {
  std::string text;
  for (const std::string& name : close_names(word, known))
    text += (text.empty() ? "; did you mean " : ", ") + name;
  return text.empty() ? text : text + "?";
}

}  // namespace signorini
