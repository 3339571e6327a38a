#pragma once
// The three spellings of a new name.

#include <string>
#include <string_view>

namespace signorini {

/// "my-method", the name; "my_method", its folder and files; "MyMethod", its class.
struct Spellings {
  std::string name = {};
  std::string folder = {};
  std::string type = {};
};

/// \throws UsageError unless the name is in lower-kebab-case, begins with a letter and has at most 60
/// characters
Spellings spellings_of(std::string_view name);

}  // namespace signorini
