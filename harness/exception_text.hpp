#pragma once

#include <string>

namespace signorini {

/// What the exception being handled says, or of what type it is where it is no std::exception; to be called
/// in a catch block only. Types of plugins have their names too.
std::string current_exception_text();

}  // namespace signorini
