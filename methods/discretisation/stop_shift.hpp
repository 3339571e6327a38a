#pragma once
// Stops that stand elsewhere, or move, for a while.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace signorini {

/// A stop that stands `distance` nearer at one instant, and comes nearer at `speed`:
/// x <= g - distance - speed (t - time), t and time as shares of the period.
struct StopShift {
  double time = 0.0;      ///< middle of the contact that this is for, in [0, 1) [-]
  double width = 0.0;     ///< duration of that contact [-]
  double distance = 0.0;  ///< [m]
  double speed = 0.0;     ///< [m] per period

  /// t - time, in [-1/2, 1/2].
  [[nodiscard]] double since(double t) const {
    const double turn = t - time;
    return turn - std::round(turn);
  }
  /// Shift at t [m].
  [[nodiscard]] double at(double t) const { return distance + speed * since(t); }
};

/// Per contact, Nc lists or none at all. At any time the shift counts whose contact is nearest.
using StopShifts = std::vector<std::vector<StopShift>>;

/// The shift of one contact's stop that counts at `t`, a share of the period; none for an empty list.
inline StopShift shift_at(const std::vector<StopShift>& shifts, double t) {
  StopShift nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const StopShift& shift : shifts) {
    const double away = std::max(0.0, std::abs(shift.since(t)) - 0.5 * shift.width);
    if (away >= least) continue;
    least = away;
    nearest = shift;
  }
  return nearest;
}

}  // namespace signorini
