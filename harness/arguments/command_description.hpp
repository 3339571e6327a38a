#pragma once
// The command line described for shells and for man, from what CLI11 knows of it: it cannot go stale.

#include <string>

#include "harness/arguments/arguments.hpp"

namespace signorini {

/// A script for bash that completes commands, options and names, file names elsewhere.
std::string bash_completion(const Command& program);

/// The same for zsh, with descriptions.
std::string zsh_completion(const Command& program);

/// A page for man, section 1: every command with its options, examples, exit codes, files, environment.
std::string man_page(const Command& program);

}  // namespace signorini
