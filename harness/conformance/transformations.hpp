#pragma once
// Problems equivalent to a given one, and what becomes of the answer.

#include <memory>

#include "methods/solution.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// f and g times `factor`: x and lambda scale with them, whatever the law (the contact conditions are a
/// cone).
Problem with_load_scaled(Problem problem, double factor);

/// M, D, K, f and a spring stop times `factor`: lambda scales, x stays.
Problem with_structure_scaled(Problem problem, double factor);

/// Time measured in a unit `factor` times smaller: M s^2, D s, omega / s. x and lambda stay over t / T.
Problem with_time_scaled(Problem problem, double factor);

/// f(t - shift): the answer comes `shift` later.
Problem with_load_delayed(Problem problem, double shift);

/// Coordinates numbered backwards: nothing changes at the contacts.
Problem with_coordinates_reversed(const Problem& problem);

/// Stops at `gap`, where the motion does not come if it stays within less: the linear structure is left.
Problem with_stops_at(Problem problem, double gap);

/// What an equivalent problem does to a motion: factors on x, on forces and on the unit of time, and a delay
/// by whole steps of the period's `grid` parts.
struct MotionMap {
  double displacement = 1.0;
  double force = 1.0;
  double time = 1.0;
  int delay = 0;
  int grid = 1;

  /// The map that undoes this one.
  [[nodiscard]] MotionMap inverse() const;
};

/// A motion seen through a map; exact at any number of samples.
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
