#pragma once
// "Did you mean ...?" at the end of a refusal that lists what is known.

#include <string>

namespace signorini {

/// A refusal of the forms `key = value (...; known: A, B)` and `key = value (... one of A, B)`, with those of
/// the list that the key, or the value, may have meant; any other text as it is.
std::string with_hint(const std::string& refusal);

}  // namespace signorini
