#pragma once
// Points of a curve of harmonic balance from which another one leaves.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "methods/harmonic_balance/continuation/series_curve.hpp"

namespace signorini {

/// Where a curve begins and where it goes.
struct SeriesStart {
  int multiple = 1;         ///< of the period of the scene's order
  Eigen::VectorXd x;        ///< on the curve, unknowns of SeriesCurve
  Eigen::VectorXd tangent;  ///< the first step is taken along it
  std::string origin;       ///< why there, one clause
  /// The start is a motion of a smaller period, and the curve is to leave it.
  bool leaves_repetition = false;
  /// Where the start is a branch point of a curve that is followed, and the curve is to leave that: its
  /// tangent.
  Eigen::VectorXd crossed = {};

  [[nodiscard]] int periods() const { return multiple; }  ///< of the scene's order
  /// Whether another curve goes through the start, which is to be left.
  [[nodiscard]] bool leaves_another() const { return leaves_repetition || crossed.size() > 0; }
};

/// The unknowns of the same motion, begun a share of its period later. \param harmonics  H of the unknowns
Eigen::VectorXd begun_later(const Eigen::VectorXd& x, int harmonics, double share);

/// How near two points of unknowns count as one, in their units: 1e-7, or 1e-3 of the force where that is
/// less, as where contacts begin.
double rounding_of(const Eigen::VectorXd& x);

/// The harmonics of the unknowns x that a motion of 1 / p of the period does not have, those that p does not
/// divide: zero exactly where the motion repeats. \param p  a divisor of the curve's multiple
Eigen::VectorXd unrepeated_part(const Eigen::VectorXd& x, const SeriesCurve& curve, int p);

/// The motions of twice the period that begin where doubled_jacobian is singular, at which the curve is
/// evaluated: along its null vector. One direction: the other is the same motion, a period later.
SeriesStart doubled_branch(const SeriesCurve& curve);

/// The two starts of a branch that leaves a curve at a branch point, where the curve is evaluated: along a
/// direction and against it. \param crossed  tangent of the curve that is left
std::vector<SeriesStart> both_ways(const SeriesCurve& curve, const Eigen::VectorXd& direction,
                                   const Eigen::VectorXd& crossed);

/// The branch that crosses the curve where it is evaluated, both ways: along the null vector of R_x that is
/// normal to `tangent`.
std::vector<SeriesStart> crossing_branches(const SeriesCurve& curve, const Eigen::VectorXd& tangent);

/// The motions of `multiple` periods that press once in that time, where the contact-free motion of one
/// period grazes: on from a small force in one passage, of 1e-4 to 3e-3 of the unknowns' units and either
/// sign. Empty where the equations have none there. \param x  unknowns at the grazing, on the curve of one
/// period
std::optional<SeriesStart> grazing_branch(const SeriesFamily& family, const Eigen::VectorXd& x, int multiple);

}  // namespace signorini
