#pragma once
// Phases of contact, read off where a contact force acts or from listed events, and stops that stand
// elsewhere during them.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "methods/solution.hpp"

namespace signorini {

/// A stop that stands `distance` nearer at one instant, and comes nearer at `speed`:
/// x <= g - distance - speed (t - time), t and time as shares of the period, -before <= t - time <= after. At
/// other times it stands in its place.
struct StopShift {
  double time = 0.0;      ///< middle of the contact that this is for, in [0, 1) [-]
  double width = 0.0;     ///< duration of that contact [-]
  double distance = 0.0;  ///< [m]
  double speed = 0.0;     ///< [m] per period
  double before = std::numeric_limits<double>::infinity();  ///< how long before `time` it stands there [-]
  double after = std::numeric_limits<double>::infinity();   ///< how long after [-]

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

/// The shift of one contact's stop that counts at `t`, a share of the period; none for an empty list, or
/// where the stop stands in its place.
inline StopShift shift_at(const std::vector<StopShift>& shifts, double t) {
  StopShift nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const StopShift& shift : shifts) {
    const double away = std::max(0.0, std::abs(shift.since(t)) - 0.5 * shift.width);
    if (away >= least) continue;
    least = away;
    nearest = shift;
  }
  const double since = nearest.since(t);
  if (since < -nearest.before || since > nearest.after) return {};
  return nearest;
}

/// A time during which a contact pushes, in shares of the period: from `begin` in [0, 1) to `end` in
/// (begin, begin + 1].
struct ContactInterval {
  double begin = 0.0;  ///< [-]
  double end = 0.0;    ///< [-]
};

/// The phases of one contact whose pushing intervals are known: intervals that follow each other after a
/// break shorter than `resolution`, which no series of that resolution tells from none, are one phase, across
/// the end of the period too (its intervals there lie beyond 1). One phase alone is not joined to itself.
///
/// \param pushing     intervals of one period, ascending and disjoint
/// \param resolution  shortest break that separates two phases, share of the period [-]
/// \return            phases ascending, each its intervals, at least one
std::vector<std::vector<ContactInterval>> contact_phases(const std::vector<ContactInterval>& pushing,
                                                         double resolution);

/// A phase of contact on equidistant samples of one period: first, first + 1, ..., cyclically.
struct SampledPhase {
  int first = 0;   ///< in [0, count)
  int length = 0;  ///< samples, bridged breaks included; in [1, count]
};

/// The phases of a sampled contact force, ordered by their first sample: where -force > threshold, breaks of
/// fewer than `resolution` samples bridged. A contact without any longer break pushes throughout: first = 0,
/// length = count.
///
/// \param force       samples of one period, negative in contact [N]
/// \param threshold   forces of no larger magnitude are ripple, >= 0 [N]
/// \param resolution  fewest samples without force that separate two phases, >= 1
std::vector<SampledPhase> contact_phases(const Eigen::Ref<const Eigen::VectorXd>& force, double threshold,
                                         int resolution);

/// A contact that is listed from its closing to its opening.
struct ListedContact {
  std::size_t opening = 0;  ///< index of its event
  int contact = 0;          ///< in [0, Nc)
  double begin = 0.0;       ///< [s], in [0, period)
  double end = 0.0;         ///< [s], begin < end < begin + period
};

/// The contacts that events ordered in time list; openings without a closing before them are left out.
std::vector<ListedContact> listed_contacts(const std::vector<ContactEvent>& events, double period);

}  // namespace signorini
