#pragma once
// DIR/manifest.json: the build, the machine and the limits that records come from.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "harness/plan/schedule.hpp"
#include "harness/plan/suite.hpp"

namespace signorini {

/// Build, machine, date, limits and command line. What the system does not tell is absent.
nlohmann::ordered_json make_manifest(const Suite& suite, const Limits& limits, const Schedule& schedule,
                                     const std::vector<std::string>& command_line);

/// Governor of the first processor's clock, as the system's files below `root` say; empty where they do not.
std::string clock_governor(const std::filesystem::path& root = "/");

}  // namespace signorini
