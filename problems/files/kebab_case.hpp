#pragma once
// How scenes, suites and methods are named.

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace signorini {

/// Longest name in lower-kebab-case.
inline constexpr std::size_t kLongestName = 64;

/// True if a name is in lower-kebab-case: letters a-z, digits and single dashes between them, at most
/// kLongestName in all.
inline bool is_lower_kebab_case(std::string_view name) {
  const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  return !name.empty() && name.size() <= kLongestName && std::all_of(name.begin(), name.end(), fits) &&
         name.front() != '-' && name.back() != '-' && name.find("--") == std::string_view::npos;
}

/// True if a name is that of a scene: in lower-kebab-case, and for one of a family followed by "@" and the
/// label of its level, a number, for one that is drawn by "@" and seed and number, "7-3".
inline bool is_scene_name(std::string_view name) {
  const std::size_t at = name.find('@');
  if (at == std::string_view::npos) return is_lower_kebab_case(name);
  const std::string_view level = name.substr(at + 1);
  const auto fits = [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == 'e'; };
  return is_lower_kebab_case(name.substr(0, at)) && !level.empty() && level.size() <= kLongestName &&
         std::all_of(level.begin(), level.end(), fits);
}

}  // namespace signorini
