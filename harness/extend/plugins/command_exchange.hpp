#pragma once
// The JSON that a command method reads and prints: docs/plugins.md has every key.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "methods/method.hpp"

namespace signorini {

/// Problem and options, all that is known before a solve.
nlohmann::ordered_json command_request(const Problem& problem, const std::vector<OptionEcho>& options);

/// The text for stdin: the request, with the motion to start from and the seconds until the deadline.
std::string command_input(nlohmann::ordered_json request, const Start& start);

/// The answer printed. \param period  of the motion looked for, where the answer names none [s]
/// \throws CommandFailure (Status::invalid_output) for what is no answer; whether sizes and period fit the
/// scene
///         is judged later, as for every method
Solution read_command_answer(const std::string& output, double period);

}  // namespace signorini
