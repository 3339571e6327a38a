#pragma once
// Answers of a method under check, compared.

#include <optional>

#include "harness/conformance/finding.hpp"
#include "harness/conformance/subject.hpp"
#include "harness/conformance/transformations.hpp"

namespace signorini {

/// Why a method has nothing to show on a scene, if so: it does not apply there.
std::optional<CheckResult> why_not(const Subject& subject);

/// The same, or it did not converge: that is judged elsewhere.
std::optional<CheckResult> why_no_answer(const Subject& subject);

/// Largest deviation of `after` from what `map` makes of `before`, in the scales of `before`: of x against
/// the largest displacement, of the force against the largest force or load, of the impulse per period and
/// contact likewise [-]. Both on Terms::grid.
double deviation(const Subject& subject, const Trajectory& before, const Trajectory& after,
                 const MotionMap& map);

/// Whether the method answers `problem`, which `map` makes of its scene, with what the map makes of its
/// answer. An answer that differs is accepted with a remark if, mapped back, it is a solution of the scene
/// itself: a solve that starts there stays there. `turns`: such whole parts of the period by which an answer
/// may come later still.
CheckResult compare_with(const Subject& subject, const Problem& problem, const MotionMap& map, int turns = 1);

}  // namespace signorini
