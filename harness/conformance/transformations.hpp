#pragma once
// Problems that are equivalent to a given one, and the map from its answers to theirs.

#include <memory>

#include "methods/solution.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// f and g times `factor`: x and lambda scale by the same factor under every law, because the contact
/// conditions are a cone.
Problem with_load_scaled(Problem problem, double factor);

/// M, D, K, f and the stiffness of a spring stop times `factor`: lambda scales by it, x is the same.
Problem with_structure_scaled(Problem problem, double factor);

/// Another unit of time, M s^2, D s, omega / s with s = `factor`: x and lambda are the same functions of t /
/// T.
Problem with_time_scaled(Problem problem, double factor);

/// f(t - shift): the answer is x(t - shift).
Problem with_load_delayed(Problem problem, double shift);

/// Coordinates in reverse order: x and lambda at the contacts are the same.
Problem with_coordinates_reversed(const Problem& problem);

/// The displacements u_0 (Nd) of a new origin of u that lies `distance` before each stop along its normal: of
/// contacts whose normals are not orthogonal, the first one, and the others by what that makes of them [m].
Eigen::VectorXd origin_before_stops(const Problem& problem, double distance);

/// The origin of u at -u_0: gaps g + W^T u_0 and the static load K u_0 beside the scene's own. The answer is
/// x + W^T u_0, lambda is the same.
Problem with_origin_moved(Problem problem, const Eigen::VectorXd& u_0);

/// All stops at `gap`. If the linear response stays within it, it is the answer.
Problem with_stops_at(Problem problem, double gap);

/// From the answer of a problem to that of an equivalent one: (x, lambda)(t) -> (a x + x_0, b lambda)((t - d)
/// / s).
struct MotionMap {
  double displacement = 1.0;    ///< a [-]
  double force = 1.0;           ///< b [-]
  double time = 1.0;            ///< factor of the period [-]
  int delay = 0;                ///< d in steps of T / grid
  int grid = 1;                 ///< steps in a period
  Eigen::VectorXd origin = {};  ///< x_0, Nc [m]; empty: 0

  /// The inverse map.
  [[nodiscard]] MotionMap inverse() const;
};

/// The image of a motion under a map, without interpolation at any number of samples.
class MappedMotion final : public Trajectory {
 public:
  MappedMotion(std::shared_ptr<const Trajectory> motion, const MotionMap& map)
      : motion_(std::move(motion)), map_(map) {}

  [[nodiscard]] int contact_count() const override { return motion_->contact_count(); }
  [[nodiscard]] double period() const override { return motion_->period() * map_.time; }
  [[nodiscard]] Samples sample(int count) const override;
  [[nodiscard]] std::vector<Impulse> impulses() const override;
  [[nodiscard]] std::optional<int> bandwidth() const override { return motion_->bandwidth(); }

 private:
  std::shared_ptr<const Trajectory> motion_;
  MotionMap map_;
};

}  // namespace signorini
