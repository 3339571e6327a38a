#pragma once
// Several runs in one folder, each under its own name, to be reported on one page.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

namespace signorini {

/// Writes the records of runs into one folder, which reports then take for a run: of each the name of its
/// folder (Record::run) stands beside its methods. Errors, outcomes and certificates stay as they are. Times
/// stay of runs whose own are comparable and whose machine is that of the first. Those of another machine are
/// multiplied by times_factor where both have one; all others are left out. The manifest says of which
/// (`runs`).
/// \throws UsageError if a folder is no run, two have one name, or a scene differs between runs
void put_side_by_side(std::span<const std::filesystem::path> folders, const std::filesystem::path& out);

/// Of a manifest of runs side by side a sentence for each whose times are multiplied, or left out and why;
/// else empty.
std::string remarks_on_times(const nlohmann::ordered_json& manifest);

}  // namespace signorini
