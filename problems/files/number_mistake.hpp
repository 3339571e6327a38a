#pragma once
// Common mistakes in numbers.

#include <string>
#include <string_view>

namespace signorini {

/// What a text that is no number most likely suffers from, "; a decimal comma ..." to end a message with;
/// empty for none of the common mistakes: a decimal comma, a minus sign of a text processor.
std::string number_mistake(std::string_view text);

/// number_mistake of a line of TOML, behind = where it is a comma: between brackets a comma parts numbers.
std::string toml_number_mistake(std::string_view line);

}  // namespace signorini
