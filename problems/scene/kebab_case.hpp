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

}  // namespace signorini
