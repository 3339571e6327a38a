#include "harness/glob.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <cstdlib>

#include "problems/scene/scene_family.hpp"

namespace signorini {

namespace {

bool pieces_match(std::string_view filter, std::string_view name,
                  bool (*piece_matches)(std::string_view pattern, std::string_view text)) {
  const GlobPieces pieces = split_globs(filter);
  const auto matches = [&](const std::string& pattern) { return piece_matches(pattern, name); };
  return std::ranges::any_of(pieces.positive, matches) && std::ranges::none_of(pieces.negative, matches);
}

}  // namespace

bool glob_match(std::string_view pattern, std::string_view text) {
  // Brackets hold options in names of cases: to fnmatch they would be sets of characters.
  std::string shell_pattern;
  for (const char c : pattern) {
    if (c == '[' || c == '\\') shell_pattern += '\\';
    shell_pattern += c;
  }
  return fnmatch(shell_pattern.c_str(), std::string(text).c_str(), 0) == 0;
}

bool looks_like_path(std::string_view word) {
  return word.find('/') != std::string_view::npos || word.ends_with(".toml") ||
         word.find(".toml@") != std::string_view::npos;
}

GlobPieces split_globs(std::string_view filter) {
  GlobPieces pieces;
  std::string piece;
  bool negative = false;
  int depth = 0;
  const auto finish = [&] {
    if (!piece.empty()) (negative ? pieces.negative : pieces.positive).push_back(piece);
    piece.clear();
  };
  char before = ':';
  for (const char c : filter) {
    if (c == '[') ++depth;
    if (c == ']') --depth;
    if (depth == 0 && c == ':') {
      finish();
    } else if (depth == 0 && c == '-' && !negative &&
               (before == ':' || before == '*' || before == '?' || before == ']')) {
      finish();
      negative = true;
    } else {
      piece += c;
    }
    before = c;
  }
  finish();
  if (pieces.positive.empty()) pieces.positive.emplace_back("*");
  return pieces;
}

bool filter_matches(std::string_view filter, std::string_view name) {
  return pieces_match(filter, name, glob_match);
}

bool scene_glob_match(std::string_view pattern, std::string_view name) {
  const std::size_t level = pattern.find('@') + 1;
  if (level == 0) return glob_match(pattern, name);
  const std::string text(pattern.substr(level));
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') return glob_match(pattern, name);  // "grazing@*"
  return glob_match(std::string(pattern.substr(0, level)) + level_label(value), name);
}

bool scene_filter_matches(std::string_view filter, std::string_view name) {
  return pieces_match(filter, name, scene_glob_match);
}

}  // namespace signorini
