#pragma once
// How --help and the manual present the commands: in groups, each with an example.

#include <span>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

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
void guide_commands(CLI::App& app);

/// The program with the commands of a command line, "signorini submit slurm".
std::string full_name(const CLI::App& command);

}  // namespace signorini
