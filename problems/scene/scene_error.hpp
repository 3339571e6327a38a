#pragma once
// The error of a scene file that cannot be used.

#include <stdexcept>

namespace signorini {

/// A scene file that cannot be used. what() is the one line for the user,
/// `FILE:LINE: field = value (what is required)`; the line is absent where none applies.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace signorini
