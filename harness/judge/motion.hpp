#pragma once
// Motions on the harness's common grid, and how far apart two of them are.

#include <optional>
#include <string>
#include <vector>

#include "methods/solution.hpp"
#include "methods/structure/periodic_response.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Instants per forcing period on which every measure is taken.
inline constexpr int kGrid = 8192;

/// Two motions of one orbit agree to this, relative to their norm; distinct orbits do not.
inline constexpr double kSameOrbit = 1e-6;

/// One period of a motion at kGrid instants per forcing period. An answer is sampled once; all that is
/// measured on it is taken from here.
struct Motion {
  int order = 1;              ///< period in forcing periods
  double forcing_period = 1;  ///< [s]
  Samples samples = {};       ///< (order * per_period) x Nc
  std::vector<Impulse> impulses = {};
  std::optional<int> bandwidth = {};         ///< as Trajectory::bandwidth
  Eigen::MatrixXcd force_coefficients = {};  ///< as Trajectory::force_coefficients [N]

  [[nodiscard]] double period() const { return order * forcing_period; }
  [[nodiscard]] int count() const { return static_cast<int>(samples.x.rows()); }
  [[nodiscard]] double step() const { return period() / count(); }
};

/// Samples a trajectory whose period is a whole multiple of the forcing period.
Motion sample_motion(const Problem& problem, const Trajectory& trajectory, int per_period = kGrid);

/// The motion of what a method returned, or why it is none.
struct SampledAnswer {
  std::string defect = {};  ///< why it cannot: see `trajectory_defect` and `samples_defect`; else empty
  Motion motion = {};       ///< on kGrid, unless there is a defect
};
/// Samples an answer of any method; nothing is taken for granted about it.
SampledAnswer sample_answer(const Problem& problem, const Trajectory& answer);

/// Every `step`-th instant of a motion; `step` divides their number per forcing period.
Motion thinned(const Motion& motion, int step);

/// The contact force in harmonics of the motion's period: up to its bandwidth where it has one, to
/// `max_harmonics` otherwise, never more but for harmonics of the load.
ForceSeries force_series(const Problem& problem, const Motion& motion, int max_harmonics);

/// Impulse per forcing period and contact: force integrated, impulses added, Nc [N s].
Eigen::VectorXd impulse_per_forcing_period(const Motion& motion);

/// Relative distances of motion a from motion b over their common period, b shifted by `shift` forcing
/// periods; empty where b's own norm is zero. Both must have the same grid per forcing period.
struct Distance {
  std::optional<double> x_l2 = {};         ///< |x_a - x_b| / |x_b|, root mean square over time and contacts
  std::optional<double> x_max = {};        ///< largest |x_a - x_b| / largest |x_b|
  std::optional<double> velocity_l2 = {};  ///< as x_l2, of x'
};
Distance distance(const Motion& a, const Motion& b, int shift = 0);

/// The shift of b by whole forcing periods, 0 <= shift < b.order, that brings it nearest to a in x_l2.
int best_shift(const Motion& a, const Motion& b);

/// Smallest order m that divides the motion's and after which x repeats to 1e-6 of its norm.
int least_order(const Motion& motion);

/// Half the difference of the largest and least x of a contact, the largest over contacts [m].
double amplitude(const Motion& motion);

}  // namespace signorini
