#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace signorini {

/// SHA-256 of the bytes, 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

/// SHA-256 of a file's bytes. \throws UsageError if it cannot be read
std::string sha256_of_file(const std::filesystem::path& path);

/// All bytes of a file. \throws UsageError if it cannot be read
std::string read_file(const std::filesystem::path& path);

}  // namespace signorini
