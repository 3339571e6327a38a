#pragma once
// How a method of harmonic balance solves a scene: the list of its attempts.

#include <memory>

#include "methods/harmonic_balance/harmonic_setup.hpp"
#include "methods/method.hpp"

namespace signorini {

/// A solution of the projected equations, its impacts as the series has them: restitution 1 on rigid stops
/// (docs/theory.md, section 3). Each attempt is asked only where those before it gave nothing; the message
/// says which one found it. Always gives an answer or the best iterate, its work apart: that is added to
/// `work`.
Solution solve_series(const HarmonicSetup& setup, const Start& start, Work& work);

/// A scene prepared for a method of harmonic balance, with the harmonics that the options ask for. Where
/// these and all that depends on them are left to the method, harmonics are doubled, up to 640, until two
/// answers agree within 5 % (refined_until_agreed): one that no other number of harmonics confirms is not
/// claimed. The answer with H harmonics is that of `harmonics` = H.
///
/// Every answer that is claimed solves the projected equations of the method to its tolerance; the message
/// says how it was found. `problem` must outlive the result.
/// \param method_for  called once, with the problem to be solved: each stop of `problem` stands in it once
/// \throws std::runtime_error if the structure cannot be factorised
std::unique_ptr<PreparedMethod> prepare_harmonic_balance(const Problem& problem,
                                                         const HarmonicOptions& options,
                                                         const HarmonicMethodFor& method_for);

}  // namespace signorini
