#pragma once
// DIR/manifest.json: what a run's records come from.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "harness/plan/suite.hpp"
#include "harness/run/rounds.hpp"

namespace signorini {

/// Build, machine, date, limits and command line. What cannot be found out is absent.
nlohmann::ordered_json make_manifest(const Suite& suite, const Limits& limits, const Turns& turns,
                                     const std::vector<std::string>& command_line);

/// Writes text to a file in one piece: a reader sees the old contents or the new.
/// \throws UsageError if the folder cannot be written
void write_whole(const std::filesystem::path& file, const std::string& text);

}  // namespace signorini
