#pragma once
// How --help and the manual present the commands: in groups, each with an example.

#include <span>

#include "harness/arguments/arguments.hpp"

namespace signorini {

/// One line to type, and what it does.
struct CommandExample {
  const char* command;  ///< "solve", "submit slurm"
  const char* line;     ///< the whole line
  const char* does;     ///< in a few words
};

/// At least one of every command, in the order of the groups.
std::span<const CommandExample> command_examples();

/// Puts the commands into their groups (Use, Judge, Extend, Cluster), and has every --help printed in lines
/// of 80 columns, with the examples of its command; that of the program says of each command the first
/// sentence.
void guide_commands(const Command& program);

/// A command with those that it belongs to, "signorini submit slurm".
std::string full_name(const Command& command);

}  // namespace signorini
