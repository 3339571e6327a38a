#pragma once
// A method that is an executable: it reads a problem as JSON and prints its answer as JSON.

#include <filesystem>

#include "methods/catalogue.hpp"

namespace signorini {

/// The catalogue entry of a description. \throws SceneError, UsageError
MethodEntry load_command_method(const std::filesystem::path& file);

}  // namespace signorini
