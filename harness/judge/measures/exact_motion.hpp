#pragma once
// What a motion with states knows beyond samples at its contacts.

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "methods/solution.hpp"
#include "problems/problem.hpp"

namespace signorini {

class IntegratedTrajectory;

/// x' of a contact just before and just after an impulse [m/s]; empty where it is not known.
struct SpeedsBeside {
  std::optional<double> before = {}, after = {};
};

/// Whether force and motion are one solution of the equation of motion between events (Motion::integrated).
bool is_integrated(const Trajectory& motion);

/// A motion that keeps its states (IntegratedTrajectory) in the scene's own coordinates: of all those that
/// have mass, and those without that a contact has for its own, as the faces of damped stops.
class ExactMotion {
 public:
  /// Empty where the motion keeps no states, or those of a reduced structure.
  /// \param motion  kept by the caller
  static std::optional<ExactMotion> of(const Problem& problem, const Trajectory& motion);

  /// Of the contacts, just beside each of the motion's impulses, to rounding; empty where a contact that
  /// takes one moves a coordinate without mass [m/s].
  [[nodiscard]] std::vector<SpeedsBeside> speeds_beside_impulses() const;
  /// Fourier coefficients n = 0..count of force and impulses, (count+1) x Nc [N]; empty where the motion is
  /// no sum of modes between its events.
  [[nodiscard]] Eigen::MatrixXcd force_coefficients(int count) const;
  /// Whether this coordinate has mass, or is the displacement of some contact but for a factor.
  [[nodiscard]] bool knows(int dof) const { return place_of(dof) >= 0 || contact_on(dof) >= 0; }
  /// u and u' of coordinates that it knows at `count` equidistant instants from t = 0, right-sided, each
  /// count x dofs [m], [m/s].
  struct Coordinates {
    Eigen::MatrixXd u, v;
  };
  [[nodiscard]] Coordinates coordinates(std::span<const int> dofs, int count) const;

 private:
  ExactMotion(const Problem& problem, const IntegratedTrajectory& motion);
  /// Its place among those with mass; -1: it has none.
  [[nodiscard]] Eigen::Index place_of(int dof) const;
  /// The contact on this coordinate alone; -1: there is none.
  [[nodiscard]] Eigen::Index contact_on(int dof) const;

  const IntegratedTrajectory* motion_;
  std::vector<Contact> contacts_;
  std::vector<int> kept_;  // coordinates with mass, ascending
};

}  // namespace signorini
