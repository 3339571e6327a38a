#pragma once
// Which cases state the same problem.

#include <string>

#include "methods/method.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Sixteen hexadecimal digits, equal where M, D, K, load, contacts, period and the law that is represented
/// are equal to the last bit, whatever the scene is called and whatever its own law is. The matrices enter by
/// their products with one fixed vector, so that a million coordinates cost milliseconds.
std::string problem_digest(const Problem& problem, const RepresentedLaw& law);

}  // namespace signorini
