#pragma once
// Folds, doublings, Neimark-Sacker points and grazings of exact orbits as curves over two parameters.

#include <string>
#include <vector>

#include "methods/orbit/bifurcation_curves/special_equations.hpp"
#include "methods/orbit/continuation/orbit_branch.hpp"

namespace signorini {

/// Whether curves of a kind of special points can be followed: not of branch points, which two parameters do
/// not move along a curve but break up.
bool has_curve(SpecialKind kind);

/// The curve through a special point of a diagram at plane.from, towards plane.to, by pseudo-arclength in all
/// unknowns of the orbit and both parameters (SpecialEquations). The unit of the second one is a third of its
/// interval.
///
/// Ends at either end of either interval, or where another guard vanishes, located, for the sequence of
/// events changes there.
/// \param orbit  of the special point
BifurcationCurve trace_bifurcation_curve(const ScenePlane& plane, const SpecialPoint& start,
                                         const OrbitGuess& orbit, const CurveLimits& limits);

/// One curve for each special point of a kind in a diagram at plane.from; one for points of several branches
/// that are one motion, and one for two that a curve joins. \throws std::invalid_argument unless
/// has_curve(kind)
std::vector<BifurcationCurve> bifurcation_curves(const ScenePlane& plane, const OrbitDiagram& diagram,
                                                 SpecialKind kind, const CurveLimits& limits);

}  // namespace signorini
