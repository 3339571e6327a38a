#pragma once
// Reads a command line and runs the command that it names; how --help and the manual present the commands.

#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness/arguments/arguments.hpp"

namespace signorini {

/// A line that cannot be read; what() is one line for the user, with what may have been meant.
class BadArguments : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A program with commands; they are added to `program()` before the line is read.
class ArgumentParser {
 public:
  /// \param version  the text that --version prints
  ArgumentParser(const std::string& name, const std::string& description,
                 std::function<std::string()> version);
  ~ArgumentParser();
  ArgumentParser(const ArgumentParser&) = delete;
  ArgumentParser& operator=(const ArgumentParser&) = delete;

  [[nodiscard]] Command program() const;

  /// Done when a line has been read, before its command runs.
  void before_run(std::function<void()> prepare);

  /// Reads the words after the program's name and runs the command; --help and --version print their text
  /// instead. \throws BadArguments; and what the command throws
  void run(std::vector<std::string> words);

 private:
  std::unique_ptr<CLI::App> app_;
};

// How --help and the manual present the commands: in groups, each with an example.

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

// The command line described for shells and for man, from what CLI11 knows of it: it cannot go stale.

/// A script for bash that completes commands, options and names, file names elsewhere.
std::string bash_completion(const Command& program);

/// The same for zsh, with descriptions.
std::string zsh_completion(const Command& program);

/// A page for man, section 1: every command with its options, examples, exit codes, files, environment.
std::string man_page(const Command& program);

}  // namespace signorini
