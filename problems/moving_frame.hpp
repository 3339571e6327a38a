#pragma once
// Scenes whose stops or whose base move, told in the frame that moves with them: there stops and base rest,
// and the motion of the frame is a load.

#include <Eigen/Core>
#include <vector>

#include "problems/problem.hpp"

namespace signorini {

/// Most loads, harmonics times coordinates, that a motion or the samples of a load may make.
inline constexpr double kMostLoads = 1e7;

/// One harmonic of the motion of the stop of a contact, x_j <= g_j + cos * cos(h omega t) + sin * sin(h omega
/// t).
struct StopTerm {
  int contact = 0;   ///< whose stop moves
  int harmonic = 1;  ///< h >= 1, of omega [-]
  double cos = 0.0;  ///< [m]
  double sin = 0.0;  ///< [m]
};

/// One harmonic of the motion of the base of a structure.
struct BaseTerm {
  int harmonic = 1;           ///< h >= 0, of omega [-]
  double cos = 0.0;           ///< [m], or [m/s^2] of an acceleration
  double sin = 0.0;           ///< likewise
  bool acceleration = false;  ///< what `cos` and `sin` are of
};

/// Tells a scene with stops at g + gamma(t) in a frame in which they stand at g. With r(t) on the coordinates
/// that contacts touch, W^T r = gamma for all contacts at once, resting ones included, and of least norm, u =
/// v + r gives
///
///     M v'' + D v' + K v = f - M r'' - D r' - K r + W lambda,    W^T v <= g,
///
/// the same equations with another load: exact for every stop and law, Newton's law among them, which acts on
/// the velocity relative to the stop, W^T v'. Adds r to `frame` and its load to `force`, powers of omega
/// apart, so that another frequency of the scene is the same stop at that frequency.
///
/// \throws InvalidProblem where stops that share coordinates have no such r (two that approach each other),
/// where more than 4e6 pairs of such stops and coordinates hang together, or harmonics times coordinates are
/// more than
/// kMostLoads
void move_stops(Problem& problem, const std::vector<StopTerm>& terms);

/// Tells a scene whose base moves by b(t) in coordinates relative to the base: adds the load -M d b'', d the
/// displacement of the coordinates with a unit displacement of the base, Nd [-]. Springs and dampers join
/// coordinates to each other and to the base; stops move with the base.
void move_base(Problem& problem, const Eigen::VectorXd& direction, const std::vector<BaseTerm>& terms);

}  // namespace signorini
