#pragma once
// The error of a scene that cannot be computed.

#include <stdexcept>
#include <string>
#include <utility>

namespace signorini {

/// A scene that cannot be computed: names the field, the value found and what is required.
/// `field` is the scene-file path of the culprit ("system.mass", "contact[1].gap").
class InvalidProblem : public std::invalid_argument {
 public:
  /// what() reads `field_path = value (required)`.
  InvalidProblem(std::string field_path, const std::string& value, const std::string& required)
      : std::invalid_argument(field_path + " = " + value + " (" + required + ")"),
        field(std::move(field_path)),
        found(value),
        requirement(required) {}

  std::string field;        ///< path of the offending field, as in the scene file
  std::string found;        ///< the value found, printed
  std::string requirement;  ///< what is required instead
};

}  // namespace signorini
