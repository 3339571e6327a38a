#pragma once
// A frequency response as a record keeps it: what was asked, how much of the exact response it holds, and its
// branches as they are drawn.

#include <optional>
#include <string>
#include <vector>

#include "harness/plan/suite.hpp"

namespace signorini {

enum class SpecialKind;  // of methods/curve.hpp, which records need not know

/// A point of a response that was located: a fold, a beginning of contact.
struct LocatedPoint {
  SpecialKind kind = {};                 ///< which
  double frequency = 0.0;                ///< [rad/s]
  int order = 1;                         ///< forcing periods per period
  std::optional<double> amplitude = {};  ///< largest of the contacts: half of largest less least x_j [m]
};

/// Shares of length at one tolerance.
struct CurveShares {
  double covered = 0.0;                       ///< of the exact response, within tolerance of the method's
  std::optional<double> covered_stable = {};  ///< the same of its stable part; absent where there is none
  double false_share = 0.0;                   ///< of the method's response, farther from the exact one
};

/// A point of the exact response and the method's own, which may be missing.
struct PointMatch {
  LocatedPoint exact;                    ///< where it is
  std::optional<double> frequency = {};  ///< at which the method located it [rad/s]
};

/// A method's response against the exact one.
struct CurveComparison {
  CurveShares close = {}, wide = {};        ///< at kCloseTolerance and kWideTolerance
  double exact_length = 0.0;                ///< of the exact response, in the metric [-]
  double length = 0.0;                      ///< of the method's
  double right_length = 0.0;                ///< of the method's, within kWideTolerance of the exact one
  std::vector<PointMatch> points = {};      ///< in the order of their frequencies
  std::vector<LocatedPoint> invented = {};  ///< located by the method and not there
};

/// x_j at equidistant instants of a period from t = 0, for each contact [m].
using KeptMotion = std::vector<std::vector<double>>;

/// A branch as it is drawn.
struct DrawnBranch {
  std::vector<double> frequency = {};  ///< [rad/s]
  std::vector<double> amplitude = {};  ///< largest of the contacts: half of largest less least x_j [m]
  std::vector<int> stable = {};        ///< 1 stable, 0 unstable, -1 unknown
  /// Of each point, in the file of an exact response alone, which others are measured against.
  std::vector<KeptMotion> motion = {};
  std::optional<bool> by_steps = {};  ///< there too, if so: points of steps, not joined by arc length
};

/// The response of a case.
struct RecordedResponse {
  ResponseQuestion question = {};                  ///< what was asked
  int points = 0;                                  ///< on all branches
  std::optional<CurveComparison> comparison = {};  ///< with the exact one; absent of that itself
  std::vector<LocatedPoint> located = {};          ///< folds and the like
  std::vector<std::string> open_ends = {};         ///< what was not followed to its end, and why
  std::vector<DrawnBranch> branches = {};
};

}  // namespace signorini
