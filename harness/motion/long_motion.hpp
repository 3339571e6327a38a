#pragma once
// What a machine does in the long run from a given state.

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "harness/motion/stop_statistics.hpp"
#include "harness/statistics.hpp"
#include "methods/deadline.hpp"
#include "methods/flow/flow.hpp"
#include "methods/options.hpp"
#include "methods/solution.hpp"

namespace signorini {

/// How a motion ends.
enum class LongRun {
  periodic,        ///< it settles to a stable periodic motion
  quasi_periodic,  ///< the largest Lyapunov exponent is 0, and deviations stay small: a torus
  irregular,       ///< the largest Lyapunov exponent is positive: chaos
  at_rest,         ///< nothing moves any more
  unbounded,       ///< it grows without end
  undecided        ///< followed for too short a time
};

/// The names, as JSON has them.
template <>
struct EnumNames<LongRun> {
  /// In order.
  static constexpr std::array<std::string_view, 6> values{"periodic", "quasi-periodic", "irregular",
                                                          "at rest",  "unbounded",      "undecided"};
};
inline std::string_view name_of(LongRun verdict) {  ///< by EnumNames
  return EnumNames<LongRun>::values[static_cast<std::size_t>(verdict)];
}

/// How long a motion is followed.
struct LongMotionOptions {
  int transient = 2000;  ///< forcing periods in which it may settle, at most; >= 1 [-]
  int periods = 4000;    ///< forcing periods over which what does not settle is measured, at most; >= 1 [-]
  int max_order = 32;    ///< highest order of a periodic motion that is looked for at first [-]
  int exponents = 4;     ///< Lyapunov exponents, at most; >= 1 [-]
};

/// The verdict on a motion, and its measures.
struct LongMotion {
  LongRun verdict = LongRun::undecided;
  std::string reason = {};  ///< why it is undecided or unbounded, one clause
  int order = 0;            ///< forcing periods per period; 0 unless periodic
  long settled_after = 0;   ///< forcing periods until it was periodic [-]
  long measured = 0;        ///< forcing periods of exponents and statistics [-]
  /// One period of a periodic motion; null of others.
  std::shared_ptr<const Trajectory> trajectory = {};
  std::vector<Estimate> lyapunov = {};  ///< exponents, largest first [1/s]
  std::vector<StopStatistics> stops = {};
  /// x [m] and x' [m/s] of each contact, one after the other, at the beginning of each period measured.
  std::vector<std::vector<double>> section = {};
};

/// Follows the flow of a scene in closed form from `start` until it settles (`march`), or over
/// `options.transient` periods and then `options.periods` more, in which small deviations and the stops are
/// measured. What settles then, as after a chaotic transient, is looked for again where small deviations
/// fade or the last periods nearly repeat, up to twice `options.max_order`. Of a motion that does not
/// settle the largest Lyapunov exponent decides: irregular where it is above 0 by more than its error and a
/// deviation grows by e^20, quasi-periodic where it is not below 0 by more than its error of at most 0.005
/// per period, no deviation grows by more than e^6 and the slowest mode has faded to e^-3, else undecided.
/// Unbounded is what has grown from one part of the transient to the next, each twice as long, beyond ten
/// scales of the motion, on a structure with a mode that no damper reaches; elsewhere such growth is a
/// transient, and undecided.
///
/// \param deadline  ends it, as an interrupt does, with what is measured until then: two fifths of its time
/// are left for settling, and from 30 periods measured on the verdict is given by the same rules, with the
/// wider error of fewer periods
LongMotion follow_long_motion(const ContactDynamics& dynamics, const FlowState& start,
                              const LongMotionOptions& options, const Deadline& deadline);

/// The motion from a state over its first periods. \throws FlowError, also where it is interrupted
std::shared_ptr<const Trajectory> first_periods(const ContactDynamics& dynamics, const FlowState& start,
                                                int periods);

}  // namespace signorini
