#pragma once
// From rest to the motion that repeats, period by period: what a user of a time integrator does.

#include <algorithm>
#include <functional>
#include <memory>

#include "methods/method.hpp"
#include "simulation.hpp"

namespace siconos_rivals {

/// A method that can be asked where there is a law of impact, mass on every coordinate, and matrices small
/// enough to be dense, as Siconos' integrators for Lagrangian systems keep them.
class ImpactMethod : public signorini::Method {
 public:
  [[nodiscard]] signorini::Support supports(const signorini::Problem& problem) const final;
  [[nodiscard]] signorini::RepresentedLaw law(const signorini::Problem& problem) const final;
};

/// The scene's matrices, stops and load; `problem` must outlive it.
System system_of(const signorini::Problem& problem);

/// What one period of time integration leaves behind.
struct Period {
  State end;
  double displacement = 0.0, speed = 0.0;                   ///< largest of any coordinate [m] [m/s]
  std::shared_ptr<const signorini::Trajectory> trajectory;  ///< of the period

  /// Takes a state into the largest.
  void include(const State& state) {
    displacement = std::max(displacement, state.u.cwiseAbs().maxCoeff());
    speed = std::max(speed, state.v.cwiseAbs().maxCoeff());
  }
};

/// Integrates the next period. It may throw what Siconos throws.
using NextPeriod = std::function<Period()>;

/// A search from state to state, over one simulation after another.
class SteadyState {
 public:
  /// Up to so many periods in all, until the state repeats to `tolerance`, relative to the largest
  /// displacement and speed.
  SteadyState(State start, double tolerance, int most, const signorini::Start& limits);

  /// Where the search is, at the beginning of a period.
  [[nodiscard]] const State& state() const { return state_; }
  /// Whether the motion repeats, or the periods or the time are used up.
  [[nodiscard]] bool over() const;
  /// Asks for periods until the search is over, or the change over a period has not halved in `patience`.
  void follow(const NextPeriod& next, int patience);
  /// The last period and how it ended.
  [[nodiscard]] signorini::Solution solution() const;

 private:
  State state_;
  double tolerance_;
  int most_;
  const signorini::Start& limits_;
  int periods_ = 0;
  double change_;
  std::shared_ptr<const signorini::Trajectory> trajectory_;
};

/// A motion with its knots: between them cubics through displacement and velocity, lines of the force. Two
/// knots at one instant are the sides of an impact.
class KnottedTrajectory final : public signorini::Trajectory {
 public:
  struct Knot {
    double time = 0.0;            ///< [s], rising from 0 to the period
    Eigen::VectorXd x, v, force;  ///< Nc [m] [m/s] [N]
  };

  KnottedTrajectory(double period, std::vector<Knot> knots, std::vector<signorini::Impulse> impulses)
      : period_(period), knots_(std::move(knots)), impulses_(std::move(impulses)) {}

  [[nodiscard]] int contact_count() const override { return static_cast<int>(knots_.front().x.size()); }
  [[nodiscard]] double period() const override { return period_; }
  [[nodiscard]] signorini::Samples sample(int count) const override;
  [[nodiscard]] std::vector<signorini::Impulse> impulses() const override { return impulses_; }

 private:
  double period_;
  std::vector<Knot> knots_;
  std::vector<signorini::Impulse> impulses_;
};

}  // namespace siconos_rivals
