#pragma once
// Folds, doublings, Neimark-Sacker points and grazings of exact orbits as curves over two parameters.

#include <string>
#include <vector>

#include "methods/orbit/bifurcation_curves/special_equations.hpp"
#include "methods/orbit/continuation/branch.hpp"

namespace signorini {

/// Limits of a curve. Lengths are in CurveUnits, that of the second parameter being a third of its interval.
struct BifurcationCurveOptions {
  double first_step = 0.01;
  double largest_step = 0.15;
  double smallest_step = 1e-7;  ///< below, the curve ends
  int max_points = 1000;
  Expired expired = {};  ///< true ends it
};

/// A curve of special points of one kind and one sequence of events.
struct BifurcationCurve {
  SpecialKind kind = SpecialKind::fold;
  std::string sequence = {};             ///< as of a Branch
  std::string began = {}, ended = {};    ///< why there, one clause each
  std::vector<BranchPoint> points = {};  ///< `parameter` is the first number
  std::vector<double> second = {};       ///< the second number at each point
};

/// Whether curves of a kind of special points can be followed: not of branch points, which two parameters do
/// not move along a curve but break up.
bool has_curve(SpecialKind kind);

/// The curve through a special point of a diagram at plane.from, towards plane.to, by pseudo-arclength in all
/// unknowns of the orbit and both parameters (SpecialEquations).
///
/// Ends at either end of either interval, or where another guard vanishes, located, for the sequence of
/// events changes there.
BifurcationCurve trace_bifurcation_curve(const ScenePlane& plane, const SpecialPoint& start,
                                         const BifurcationCurveOptions& options);

/// One curve for each special point of a kind in a diagram at plane.from; one for points of several branches
/// that are one motion, and one for two that a curve joins. \throws std::invalid_argument unless
/// has_curve(kind)
std::vector<BifurcationCurve> bifurcation_curves(const ScenePlane& plane, const BranchDiagram& diagram,
                                                 SpecialKind kind, const BifurcationCurveOptions& options);

}  // namespace signorini
