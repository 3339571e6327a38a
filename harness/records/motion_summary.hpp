#pragma once
// What a motion does, in figures: extremes, harmonics, impacts, phases of contact.

#include <optional>
#include <string>
#include <vector>

namespace signorini {

/// One harmonic of a displacement, amplitude * cos(frequency t + phase).
struct Harmonic {
  double frequency = 0.0;  ///< [rad/s], > 0
  double amplitude = 0.0;  ///< [m], >= 0
  double phase = 0.0;      ///< [rad], in (-pi, pi]; t = 0 is the time origin of the forcing terms
};

/// One displacement over a period.
struct DisplacementSummary {
  std::optional<int> dof = {};           ///< of the coordinate; absent for that of a contact
  double mean = 0.0;                     ///< [m]
  double min = 0.0, max = 0.0;           ///< [m]
  double amplitude = 0.0;                ///< (max - min) / 2 [m]
  std::vector<Harmonic> harmonics = {};  ///< the first of the motion's period
};

/// An exchange of momentum too short for the motion to resolve.
struct ImpactSummary {
  int contact = 0;
  double time = 0.0;                        ///< [s]
  std::optional<double> speed_before = {};  ///< x' [m/s]; absent where another event is too near
  std::optional<double> speed_after = {};   ///< x' [m/s]; likewise
  double impulse = 0.0;                     ///< on the structure along the contact coordinate, <= 0 [N s]
};

/// A time during which a contact pushes.
struct PhaseSummary {
  int contact = 0;
  double begin = 0.0;    ///< [s], in [0, period)
  double end = 0.0;      ///< [s], may reach past the period
  double impulse = 0.0;  ///< integral of the force, <= 0 [N s]
};

/// A motion over its period.
struct MotionSummary {
  std::vector<DisplacementSummary> x = {};        ///< per contact
  std::vector<DisplacementSummary> u = {};        ///< of the coordinates asked for
  std::string no_u = {};                          ///< why `u` is empty though coordinates were asked for
  std::vector<ImpactSummary> impacts = {};        ///< in time order
  std::vector<PhaseSummary> contact_phases = {};  ///< in time order
};

}  // namespace signorini
