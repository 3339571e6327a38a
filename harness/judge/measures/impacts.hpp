#pragma once
// Contact as seen from outside: when each contact pushed, how hard, and the speeds on either side.

#include <optional>
#include <vector>

#include "harness/judge/measures/motion.hpp"

namespace signorini {

/// A time during which one contact pushes without a break longer than the motion can resolve.
struct ContactPhase {
  int contact = 0;
  double begin = 0.0;    ///< [s], in [0, period)
  double end = 0.0;      ///< [s], >= begin; may reach past the period
  double impulse = 0.0;  ///< integral of the force, impulses included, <= 0 [N s]
  bool listed = false;   ///< an impulse that the method lists, of no duration
  bool timed = false;    ///< a phase of force whose ends the method lists
  /// Longer than an impact can appear at the motion's resolution: contact that lasts.
  bool lasting = false;
  /// Just outside [m/s]; empty where another event is too near.
  std::optional<double> speed_before = {}, speed_after = {};
};

/// Time over which the representation spreads an impulse: period / (2 H), H its `resolved_harmonics`, one
/// grid step if it resolves everything [s].
double time_resolution(const Motion& motion);

/// Beside each of the motion's impulses: the speeds that the motion knows, else those extrapolated from up to
/// six samples between it and the impulse or event next to it, to the sixth order of the step; empty where
/// fewer than two samples lie between.
std::vector<SpeedsBeside> speeds_beside_impulses(const Motion& motion);

/// All phases of one period, ordered by begin. A force that acts over several times this resolution, or over
/// ever so short a time in a motion that lists its impulses, is lasting contact. Speeds beside an impulse
/// that is listed are `speeds_beside_impulses`; beside a phase of force they are means over one ripple of the
/// representation (two resolutions).
std::vector<ContactPhase> contact_phases(const Motion& motion);

/// Largest share of the period during which one contact pushes with a force, impulses aside [-].
double contact_ratio(const Motion& motion);

}  // namespace signorini
