#pragma once
// Whether two answers are the same to the last bit.

#include <string>

#include "methods/solution.hpp"

namespace signorini {

/// Sixteen hexadecimal digits of the SHA-256 of an answer's bytes: period, x, velocity and force at 64
/// instants, and impulses. Equal for answers that agree there bit by bit.
std::string answer_digest(const Trajectory& answer);

}  // namespace signorini
