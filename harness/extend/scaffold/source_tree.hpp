#pragma once
// The source tree that something new is added to.

#include <filesystem>
#include <optional>
#include <string>

namespace signorini {

/// The folder itself or the nearest above it that holds methods/catalogue.cpp; empty if there is none.
std::optional<std::filesystem::path> find_tree(const std::filesystem::path& folder);

/// The header of problems/, methods/ or harness/ that declares a class, struct or alias of that name, if any.
std::optional<std::filesystem::path> header_declaring(const std::filesystem::path& tree,
                                                      const std::string& type);

/// The text of methods/catalogue.cpp with a method's class `type` in methods/`folder`: the include, in its
/// alphabetical place, and the entry, at the end of the list: two lines more. \throws UsageError if it has no
/// list of entries
std::string with_entry(const std::string& catalogue, const std::string& folder, const std::string& type);

}  // namespace signorini
