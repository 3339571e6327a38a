#pragma once
// The two ways a command ends before it has begun.

#include <stdexcept>

namespace signorini {

/// Bad input or usage, exit code 2. what() is the one line for the user.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A filter that leaves nothing to do, exit code 3.
class NothingMatched : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace signorini
