#include "harness/extend/scaffold/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/failure.hpp"
#include "problems/scene/kebab_case.hpp"

namespace signorini {

namespace {

constexpr std::size_t kLongest = 60;

bool is_small(char letter) { return letter >= 'a' && letter <= 'z'; }

}  // namespace

Spellings spellings_of(std::string_view name) {
  if (!is_lower_kebab_case(name) || name.size() > kLongest || !is_small(name.front())) {
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
