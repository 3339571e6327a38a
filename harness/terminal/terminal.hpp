#pragma once
// What a terminal allows, and how its user calls this program.

#include <string>

namespace signorini {

/// Whether an open file is a terminal. \param descriptor  STDOUT_FILENO, say
bool is_terminal(int descriptor);

/// Whether text for an open file may be coloured: it is a terminal that knows colours (TERM is set, and not
/// to "dumb"), and NO_COLOR is unset or empty (no-color.org).
bool takes_colour(int descriptor);

/// The program as it can be typed in the current folder: "signorini" where that is what PATH leads to, else
/// the shorter of its paths, from here and from the root.
std::string typed_program();

/// A refusal of the forms `key = value (...; known: A, B)` and `key = value (... one of A, B)`, with those of
/// the list that the key, or the value, may have meant; any other text as it is.
std::string with_hint(const std::string& refusal);

}  // namespace signorini
