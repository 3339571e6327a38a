#include "harness/scaffold/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/failure.hpp"

namespace signorini {

namespace {

constexpr std::size_t kLongest = 60;

bool is_small(char letter) { return letter >= 'a' && letter <= 'z'; }
bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

bool is_kebab(std::string_view name) {
  if (name.empty() || name.size() > kLongest || !is_small(name.front()) || name.back() == '-') return false;
  if (name.find("--") != std::string_view::npos) return false;
  return std::all_of(name.begin(), name.end(),
                     [](char letter) { return is_small(letter) || is_digit(letter) || letter == '-'; });
}

}  // namespace

Spellings spellings_of(std::string_view name) {
  if (!is_kebab(name)) {
    throw UsageError(
        fmt::format("name = {} (must be lower-kebab-case such as my-method, beginning with a letter, at most "
                    "{} characters)",
                    name, kLongest));
  }
  Spellings spellings{.name = std::string(name), .folder = std::string(name), .type = {}};
  std::replace(spellings.folder.begin(), spellings.folder.end(), '-', '_');
  bool begins = true;
  for (const char letter : name) {
    if (letter != '-')
      spellings.type += begins && is_small(letter) ? static_cast<char>(letter - 'a' + 'A') : letter;
    begins = letter == '-';
  }
  return spellings;
}

}  // namespace signorini
