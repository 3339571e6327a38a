#pragma once
// Problems equivalent to a given one, and what becomes of the answer.

#include <memory>

#include "methods/solution.hpp"
#include "problems/problem.hpp"

namespace signorini::test {

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

/// A motion moved in time by a whole number of steps of the period's `grid` parts.
class DelayedTrajectory final : public Trajectory {
 public:
  DelayedTrajectory(std::shared_ptr<const Trajectory> motion, int steps, int grid)
      : motion_(std::move(motion)), steps_(steps), grid_(grid) {}

  [[nodiscard]] int contact_count() const override { return motion_->contact_count(); }
  [[nodiscard]] double period() const override { return motion_->period(); }
  /// `count` must be a multiple of the grid, or divide into it with the steps.
  [[nodiscard]] Samples sample(int count) const override;
  [[nodiscard]] std::vector<Impulse> impulses() const override;
  [[nodiscard]] std::optional<int> bandwidth() const override { return motion_->bandwidth(); }

 private:
  std::shared_ptr<const Trajectory> motion_;
  int steps_;
  int grid_;
};

}  // namespace signorini::test
