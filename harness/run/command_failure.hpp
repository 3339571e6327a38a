#pragma once
// How the process of a command method failed, as a status of its record.

#include <optional>
#include <stdexcept>
#include <string>

#include "harness/records/record.hpp"

namespace signorini {

/// Thrown by the solve of a method that runs a command which crashed or printed no answer.
class CommandFailure : public std::runtime_error {
 public:
  CommandFailure(Status record_status, const std::string& message, std::optional<int> ending_signal = {})
      : std::runtime_error(message), status(record_status), signal(ending_signal) {}
  Status status;
  std::optional<int> signal;  ///< that ended the crashed process
};

}  // namespace signorini
