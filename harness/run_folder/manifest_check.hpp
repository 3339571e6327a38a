#pragma once
// What the manifest of a run's folder may hold. It is sent around with its records: nothing in it may reach a
// terminal, a page or a path as more than the text or the number that it is.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace signorini {

/// The manifest in a file that anybody may have written. What it holds is what `run`, `merge` and `sweep`
/// write: names, counts, limits and switches of the right type and range, every text at most kLongestText
/// long and without control characters, names of methods and suites as the program gives them, at most 32
/// levels; any of it may be missing. \throws UsageError, one line, for anything else, and for a file of more
/// than 16 MiB
nlohmann::ordered_json read_manifest(const std::filesystem::path& file);

/// read_manifest of a text; `name` stands for the file in messages.
nlohmann::ordered_json parse_manifest(const std::string& text, const std::string& name);

}  // namespace signorini
