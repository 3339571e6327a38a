#pragma once
// A point of a curve of orbits, and the same orbit with another section, period or sequence of events.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "methods/orbit/family/orbit_family.hpp"
#include "methods/orbit/orbit_equations.hpp"

namespace signorini {

/// An orbit of `order` forcing periods through a sequence of events, at a value of the parameter:
///
///     x = (u_0 / X, v_0 / V, theta_1 .. theta_m, p / P),   theta_i = omega (t_i - t_0),
///
/// Ns + m + 1, in CurveUnits; u_0 with the parts xi_0 of contacts that relax, Ns = 2 Nd or 2 Nd + Nc. The
/// section t_0 is a fixed phase of the load, theta_0 = omega t_0.
struct SequencedOrbit {
  int order = 1;                           ///< n >= 1, forcing periods [-]
  double section = 0.0;                    ///< theta_0 in [0, 2 pi n) [rad]
  std::vector<bool> closed = {};           ///< Nc, at the section
  std::vector<SequenceEvent> events = {};  ///< m of them, in order; their times mean nothing
  Eigen::VectorXd x = {};                  ///< Ns + m + 1

  /// m.
  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(events.size()); }
  /// Ns.
  [[nodiscard]] Eigen::Index states() const { return x.size() - count() - 1; }
  /// Event i, from 0 to m - 1.
  [[nodiscard]] const SequenceEvent& event(Eigen::Index i) const {
    return events[static_cast<std::size_t>(i)];
  }
  /// p / P.
  [[nodiscard]] double parameter() const { return x[x.size() - 1]; }
  /// theta_i after the section [rad].
  [[nodiscard]] double phase(Eigen::Index i) const { return x[states() + i]; }
  /// How many events there are from the section to before a phase.
  [[nodiscard]] Eigen::Index passed(double phase) const {
    Eigen::Index i = 0;
    while (i < count() && this->phase(i) < phase) ++i;
    return i;
  }
  /// 2 pi n [rad].
  [[nodiscard]] double end() const { return kTwoPi * order; }
};

/// (u_0, v_0) of unknowns x.
State state_of(const Eigen::VectorXd& x, const ContactDynamics& dynamics, const CurveUnits& units);

/// Events of one contact nearer to each other than this happen at once: a phase of contact that begins or has
/// ended, one passage of a stop [rad]
inline constexpr double kAtOnce = 1e-6;
/// How far apart rounding puts events of several contacts that happen at one instant [rad]
inline constexpr double kSimultaneous = 1e-9;

/// An event with its phase after the section [rad].
using PlacedEvent = std::pair<double, SequenceEvent>;
/// Those of an orbit.
std::vector<PlacedEvent> placed_events(const SequencedOrbit& orbit);
/// The orbit with these events instead of its own, in the order of their phases.
SequencedOrbit with_events(const SequencedOrbit& orbit, std::vector<PlacedEvent> placed);

/// The state at phase 0 of the structure's periodic response to its load, no contact acting; empty where it
/// is not unique.
std::optional<State> contact_free_motion(OrbitModel& model);

/// The contact-free orbit at a value of the parameter; empty where it is not unique.
std::optional<SequencedOrbit> contact_free_orbit(OrbitFamily& family, double parameter);

/// A polished orbit of the model at `parameter` as a point of a curve.
SequencedOrbit sequenced(const OrbitFamily& family, const OrbitGuess& orbit, double period, double frequency,
                         double parameter);

/// The middle of the longest time between two events, after the section [rad]; 0 without events.
double quiet_phase(const SequencedOrbit& orbit);

/// From the section to the nearest event on either side, negative where one has passed it; 2 pi n without
/// events [rad].
double clearance_of_section(const SequencedOrbit& orbit);

/// The orbit with another event, before that at a position, whose phases are around that given. The contacts
/// closed after each event follow from closings and openings.
SequencedOrbit with_event(const SequencedOrbit& orbit, Eigen::Index position, PlacedEvent event);

/// The same orbit, passed `times` times.
SequencedOrbit repeated(const SequencedOrbit& orbit, int times);

/// The orbit with more events, each behind those of its phase. The contacts closed are those of the moment.
SequencedOrbit with_more(const SequencedOrbit& orbit, const std::vector<PlacedEvent>& more);

/// Whether a contact is closed before the events at a phase after the section.
bool closed_before(const SequencedOrbit& orbit, int contact, double phase);

/// The orbit with a closing and an opening, or the other way round where it is closed there, of a contact at
/// one phase after the section: a phase of contact, or a break of one, of length 0.
SequencedOrbit with_contact_phase(const SequencedOrbit& orbit, int contact, double phase);

/// The orbit with what begins where a contact touches its stop: an impact at a rigid one, else a phase of
/// contact of length 0, or a break of one.
SequencedOrbit with_touch(const SequencedOrbit& orbit, int contact, double phase,
                          const ContactDynamics& dynamics);

/// The orbit with the contacts closed after each event as closings and openings say.
SequencedOrbit with_modes(SequencedOrbit orbit);

/// The orbit without event i, which changes none of the closed contacts.
SequencedOrbit without_event(const SequencedOrbit& orbit, Eigen::Index i);

/// "order 2, events I0 C1 O1": impacts, closings and openings of contacts.
std::string describe_sequence(const SequencedOrbit& orbit);

}  // namespace signorini
