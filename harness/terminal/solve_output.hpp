#pragma once
// What `solve` prints: the motion, then what the harness says of it. Lines of at most 80 columns, but for
// names, reasons and --verbose.

#include <string>

#include "harness/records/record.hpp"

namespace signorini {

/// How much of it.
struct SolveOutput {
  bool verbose = false;  ///< every contact, impact, phase and count, and the method's own message
  bool colour = false;   ///< with escape sequences of a terminal
};

/// What the method found: status and stability, law, period; displacements, impacts, phases of contact,
/// harmonics. Of many contacts, impacts and phases the first few: contacts by their impulse, the others in
/// time. Harmonics of the contact with the largest impulse and of the coordinates that were asked for.
std::string answer_text(const Record& record, const SolveOutput& output);

/// What the harness says of it: the orbit behind it, its multipliers, errors, physics, time.
std::string judgement_text(const Record& record, const SolveOutput& output);

}  // namespace signorini
