#pragma once
// How a method of harmonic balance solves a scene: the list of its attempts.

#include <memory>

#include "methods/harmonic_balance/harmonic_setup.hpp"
#include "methods/method.hpp"

namespace signorini {

/// A scene prepared for a method of harmonic balance, with the harmonics that the options ask for. Where
/// these and all that depends on them are left to the method, harmonics are doubled, up to 160, until a solve
/// converges or more of them cannot help; the first number is prepared at once, the others anew in every
/// solve, whose part they are.
///
/// Every answer that is claimed solves the projected equations of the method to its tolerance, its impacts
/// closed (closed_answer.hpp) unless the options leave them as the series has them; the message says how it
/// was found. `problem` must outlive the result.
/// \param method_for  called once, with the problem to be solved: each stop of `problem` stands in it once
/// \throws std::runtime_error if the structure cannot be factorised
std::unique_ptr<PreparedMethod> prepare_harmonic_balance(const Problem& problem,
                                                         const HarmonicOptions& options,
                                                         const HarmonicMethodFor& method_for);

/// One solve with the harmonics of the setup alone: what the result of prepare_harmonic_balance does first.
Solution solve_by_harmonic_balance(HarmonicSetup& setup, const Start& start);

}  // namespace signorini
