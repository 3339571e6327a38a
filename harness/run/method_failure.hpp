#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "harness/records/record.hpp"

namespace signorini {

/// A method whose answer comes from another process ended in a way that records have a word for.
class MethodFailure : public std::runtime_error {
 public:
  MethodFailure(Status record_status, const std::string& message, std::optional<int> ending_signal = {})
      : std::runtime_error(message), status(record_status), signal(ending_signal) {}
  Status status;
  std::optional<int> signal;  ///< that ended a crashed process
};

}  // namespace signorini
