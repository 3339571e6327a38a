#pragma once
// How far an answer is off the equations of its own scene.

#include "harness/judge/measures/motion.hpp"
#include "methods/reduction/kept_space.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// What an answer near an orbit cannot be off by; see `equation_defect`.
struct EquationDefect {
  double motion = 0.0;       ///< of the equation of motion, relative to the size of x [-]
  double penetration = 0.0;  ///< of the stops, in amplitudes [-]
};

/// What is left of two defects of an answer after what its coarseness may explain:
///
/// - motion: |x - r(lambda)| less a tenth of |r(lambda) - r(0)| and of |r(0) - mean r(0)|, over |x - mean x|,
///   root mean squares over time and contacts, r(lambda) the structure's periodic response to its load and
///   lambda. The tenth stands for the error of the force, which a resonance magnifies.
/// - penetration: the largest x - g, of a spring less -lambda / k, beyond twice what x moves by in the
///   answer's resolution in time (that of its bandwidth or nodes, at most a twentieth of the forcing period),
///   over the amplitude.
///
/// The size of x and its amplitude are at least Motion::least. A defect that the structure has no unique
/// response for, or no scale, is 0.
/// \param answer  with its `least`
/// \param spaces  of large structures, for their responses
EquationDefect equation_defect(const Problem& problem, const Motion& answer, KeptSpace& spaces);

}  // namespace signorini
