#pragma once
// DIR/manifest.json: what a run's records come from.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "harness/plan/suite.hpp"
#include "harness/run/rounds.hpp"

namespace signorini {

/// Build, machine, date, limits and command line. What cannot be found out is absent.
nlohmann::ordered_json make_manifest(const Suite& suite, const Limits& limits, const Turns& turns,
                                     const std::vector<std::string>& command_line);

}  // namespace signorini
