#include "harness/terminal/terminal.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <vector>

#include "harness/text/words.hpp"
#include "problems/files/close_names.hpp"

namespace signorini {

namespace {

namespace fs = std::filesystem;

/// Empty where it is unset.
std::string_view environment(const char* variable) {
  const char* const value = std::getenv(variable);
  return value == nullptr ? std::string_view() : value;
}

/// What a shell runs that is asked for "signorini"; empty where it finds none.
fs::path found_by_shell() {
  for (const std::string& folder : folders_of("PATH")) {
    const fs::path program = fs::path(folder) / "signorini";
    if (access(program.c_str(), X_OK) == 0) return program;
  }
  return {};
}

/// The words of "A, B, C)".
std::vector<std::string> listed_words(std::string_view list) {
  std::vector<std::string> words;
  list = list.substr(0, list.find_first_of(");"));
  while (!list.empty()) {
    const std::size_t comma = list.find(", ");
    words.emplace_back(list.substr(0, comma));
    list = comma == std::string_view::npos ? std::string_view() : list.substr(comma + 2);
  }
  return words;
}

/// The last word of "file.toml:3: system.kind".
std::string_view last_key(std::string_view text) {
  const std::size_t before = text.find_last_of(" .");
  return before == std::string_view::npos ? text : text.substr(before + 1);
}

}  // namespace

bool is_terminal(int descriptor) { return isatty(descriptor) == 1; }

bool takes_colour(int descriptor) {
  const std::string_view terminal = environment("TERM");
  return is_terminal(descriptor) && environment("NO_COLOR").empty() && !terminal.empty() &&
         terminal != "dumb";
}

std::string typed_program() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none), found = found_by_shell();
  if (program.empty() || (!found.empty() && fs::equivalent(found, program, none))) return "signorini";
  const fs::path from_here = fs::proximate(program, none);
  const std::string near = (from_here.has_parent_path() ? from_here : "." / from_here).string();
  return near.size() < program.string().size() ? near : program.string();
}

std::string with_hint(const std::string& refusal) {
  constexpr std::string_view kEquals = " = ", kKnown = "; known: ", kOneOf = "one of ";
  const std::size_t equals = refusal.find(kEquals), open = refusal.rfind(" (");
  if (equals == std::string::npos || open == std::string::npos || open < equals || !refusal.ends_with(')'))
    return refusal;
  const std::string_view all = refusal;
  const std::size_t value = equals + kEquals.size();
  std::string_view word = last_key(all.substr(0, equals));
  std::size_t list = refusal.find(kKnown, open);
  if (list != std::string::npos) {
    list += kKnown.size();
  } else if (list = refusal.find(kOneOf, open); list != std::string::npos) {
    list += kOneOf.size();
    word = all.substr(value, open - value);
  } else {
    return refusal;
  }
  return refusal.substr(0, refusal.size() - 1) + suggestion(word, listed_words(all.substr(list))) + ")";
}

}  // namespace signorini
