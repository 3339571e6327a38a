#pragma once
// Reads a command line and runs the command that it names.

#include <functional>
#include <memory>
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

}  // namespace signorini
