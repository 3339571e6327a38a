#pragma once
// Folds, doublings, Neimark-Sacker points, phase resonances and grazings of exact orbits as curves over two
// parameters.

#include <string>
#include <vector>

#include "methods/orbit/bifurcation_curves/special_equations.hpp"
#include "methods/orbit/continuation/orbit_branch.hpp"

namespace signorini {

/// Whether curves of a kind of special points can be followed: not of branch points, which two parameters do
/// not move along a curve but break up.
bool has_curve(SpecialKind kind);

/// The curves through each special point of a kind in a diagram at plane.from, towards plane.to, by
/// pseudo-arclength in all unknowns of the orbit and both parameters (SpecialEquations); one for points of
/// several branches that are one motion, and one for two that a curve joins. Points have the second parameter
/// (SolutionPoint::second), whose unit is a third of its interval. `limits.take` is called with each curve.
///
/// A curve ends at either end of either interval, or where another guard vanishes, located, for the sequence
/// of events changes there. A phase resonance keeps its phase through that, the motion being continuous:
/// where the motions beyond are known (past_change, start_impacting, start_clear) another curve goes on with
/// them, and comes next in the list; where they are not, the reason is part of the end. \throws
/// std::invalid_argument unless has_curve(kind)
std::vector<Branch> bifurcation_curves(const ScenePlane& plane, const OrbitDiagram& diagram, SpecialKind kind,
                                       const CurveLimits& limits);

/// Why a diagram at plane.from has no special point of a kind to begin at, one clause. \throws
/// std::runtime_error where there is no flow
std::string why_none(const ScenePlane& plane, SpecialKind kind);

}  // namespace signorini
