#pragma once
// Responses of known shape and length, in a metric of window 1 and amplitude 1.

#include <cmath>
#include <numbers>

#include "harness/responses/response_curve.hpp"

namespace signorini::test {

/// One contact that moves as level + size cos(2 pi t / T) + half cos(pi t / T), the latter with the period of
/// two forcing periods.
inline ResponsePoint moving(double frequency, double size, int order = 1, double half = 0.0,
                            double level = 0.0) {
  ResponsePoint point{
      .frequency = frequency, .order = order, .motion = Eigen::MatrixXd(order * kComparedPhases, 1)};
  for (int i = 0; i < order * kComparedPhases; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kComparedPhases;
    point.motion(i, 0) = level + size * std::cos(turn) + half * std::cos(0.5 * turn);
  }
  return point;
}

/// A branch along which the frequency runs from `from` to `to` and the motion stays: of length |to - from|.
inline ResponseBranch level_branch(double from, double to, int points, double size = 1.0,
                                   bool by_arc_length = true) {
  ResponseBranch branch{.by_arc_length = by_arc_length};
  for (int i = 0; i < points; ++i)
    branch.points.push_back(moving(from + (to - from) * i / (points - 1), size));
  return branch;
}

}  // namespace signorini::test
