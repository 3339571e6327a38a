#pragma once
// Errors of a command: the exceptions that end it with an exit code of their own, and the text of any other.

#include <fmt/core.h>

#include <stdexcept>
#include <string>

namespace signorini {

/// An error in one line.
class OneLineError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// What fmt::format makes of the text and what it has places for.
  template <class... Parts>
  requires(sizeof...(Parts) > 0) explicit OneLineError(fmt::format_string<Parts...> text, Parts&&... parts)
      : std::runtime_error(fmt::vformat(text, fmt::make_format_args(parts...))) {}
};

/// Bad input or usage, exit code 2. what() is the one line for the user.
class UsageError : public OneLineError {
 public:
  using OneLineError::OneLineError;
};

/// The machine is short of processes, descriptors or memory, by no fault of this program; exit code 2.
class MachineFull : public UsageError {
 public:
  using UsageError::UsageError;
};

/// A filter that leaves nothing to do, exit code 3.
class NothingMatched : public OneLineError {
 public:
  using OneLineError::OneLineError;
};

/// Message of the exception being handled, or its type where it is no std::exception. Types that plugins
/// define are named too. Precondition: called in a catch block.
std::string current_exception_text();

}  // namespace signorini
