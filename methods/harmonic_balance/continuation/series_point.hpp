#pragma once
// What is told of a motion on a curve of harmonic balance: its extremes, its contacts, its stability.

#include <utility>

#include "methods/curve.hpp"
#include "methods/harmonic_balance/continuation/series_curve.hpp"

namespace signorini {

/// Least and largest value of y(t) = sum_{|n| <= H} y_n e^{2 pi i n t}, polished to rounding. \param y  n =
/// 0..H
std::pair<double, double> extremes_of(const Eigen::VectorXcd& y);

/// Coordinates of a structure up to which its multipliers are computed.
inline constexpr int kMostForMultipliers = 64;

/// The motion at which the curve is evaluated. `impacts` counts phases of contact, which a series of H
/// harmonics tells apart from 1 / H of the period on.
///
/// The multipliers are those of the motion under the method's own law, along the series' own contacts:
/// without contact, those of the structure; where the law is a spring (alpha < 1), of stiffness c / (1 -
/// alpha), those of the piecewise linear system whose spring is in place while the series presses. The
/// Lipschitz form of a rigid stop has no such system: its stability is unknown, as it is for structures of
/// more than kMostForMultipliers coordinates or with coordinates without mass.
SolutionPoint solution_point(const SeriesCurve& curve);

}  // namespace signorini
