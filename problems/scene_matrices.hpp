#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace signorini {

/// The Matrix Market files that a scene's system is read from: mass, damping, stiffness; empty for other
/// kinds of system. Arguments as of parse_scene, which must accept them.
std::vector<std::filesystem::path> matrix_files(std::string_view text, const std::string& name,
                                                std::string_view level = {});

}  // namespace signorini
