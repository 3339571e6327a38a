#pragma once
// What a motion knows whose equation was integrated, beyond what it shows at the contacts.

#include <Eigen/Core>
#include <optional>

#include "methods/solution.hpp"
#include "methods/structure/state.hpp"

namespace signorini {

/// A motion whose displacement and force are one solution of the equation of motion between events.
class IntegratedTrajectory : public Trajectory {
 public:
  /// Of the coordinates with mass, right-sided at impacts, at any time [s]; empty: states are not kept.
  [[nodiscard]] virtual std::optional<State> state(double /*time*/) const { return std::nullopt; }
  /// Fourier coefficients n = 0..count of force and impulses in closed form, (count+1) x Nc [N]; empty:
  /// unknown.
  [[nodiscard]] virtual Eigen::MatrixXcd force_spectrum(int /*count*/) const { return {}; }
};

}  // namespace signorini
