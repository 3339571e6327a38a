#include "harness/terminal/terminal.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "harness/text/words.hpp"

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

}  // namespace signorini
