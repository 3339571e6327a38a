#pragma once
// Branches and steps of a response as JSON, and back.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "harness/records/record_json.hpp"
#include "harness/sweep/frequency_response.hpp"
#include "methods/curve.hpp"

namespace signorini {

/// {"omega", "order", "amplitude", "x_max", "impacts", "stable", "stability", "multipliers"}; amplitude and
/// x_max have an entry per contact; `stable` is null where the multipliers do not tell; a multiplier is
/// [re, im]. It has "value" too where the parameter is not the frequency, "energy" where no load drives the
/// motion, "damping_ratio" at a phase resonance, "second" on a curve over two numbers, and "motion", x_j by
/// instants, where that was asked for.
nlohmann::ordered_json to_json(const SolutionPoint& point);

/// {"method", "sequence", "points", "special", "began", "ended"}, points as above. A special point is a point
/// with "kind", "after", the number of points before it, and "text". `by_steps` is there where it is true,
/// `other_law` unless it is empty.
nlohmann::ordered_json to_json(const Branch& branch, const std::string& method,
                               const std::string& other_law = {});

/// A step of a method: "method" and the keys of to_json(step).
nlohmann::ordered_json to_json(const SweepPoint& step, const std::string& method,
                               const std::string& other_law = {});

/// The branch that to_json wrote, of a file that anybody may have written: a number that was not finite is
/// NaN. \throws BadRecord unless counts are whole numbers in the range of what is counted, texts have no
/// control characters, and names are known
Branch branch_from_json(const nlohmann::ordered_json& json);

/// The step that to_json wrote, but for its motion and its time, likewise. \throws BadRecord
SweepPoint step_from_json(const nlohmann::ordered_json& json);

}  // namespace signorini
