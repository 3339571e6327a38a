#pragma once
// Motions on the harness's common grid, and how far apart two of them are.

#include <optional>
#include <string>
#include <vector>

#include "harness/judge/measures/exact_motion.hpp"
#include "methods/reduction/contact_space.hpp"
#include "methods/solution.hpp"
#include "methods/structure/periodic_response.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Instants per forcing period on which every measure is taken.
inline constexpr int kGrid = 8192;

/// Harmonics in which forces and fields are compared, the most that any measure asks an exact orbit for.
inline constexpr int kMeasuredHarmonics = 512;

/// Two motions of one orbit agree to this, as `distance` measures x; distinct orbits do not.
inline constexpr double kSameOrbit = 1e-6;

/// Digits that round-off may have taken of a signal, relative to its largest value: what is less is nothing.
inline constexpr double kRoundOff = 1e-9;

/// One period of a motion at kGrid instants per forcing period. An answer is sampled once; all that is
/// measured on it is taken from here.
struct Motion {
  int order = 1;              ///< period in forcing periods
  double forcing_period = 1;  ///< [s]
  Samples samples = {};       ///< (order * per_period) x Nc
  std::vector<Impulse> impulses = {};
  std::optional<std::vector<ContactEvent>> events = {};  ///< as Trajectory::events
  std::optional<int> nodes = {};                         ///< as Trajectory::nodes
  std::optional<int> bandwidth = {};                     ///< as Trajectory::bandwidth
  /// Harmonics of the period in which x has all but 1e-4 of its size, no fewer than `harmonics_of_force`, of
  /// an answer with a bandwidth that is no grid; else 0: see resolved_harmonics.
  int shown = 0;
  /// As Trajectory::force_coefficients, and of exact orbits in closed form 512 per forcing period [N].
  Eigen::MatrixXcd force_coefficients = {};
  std::vector<SpeedsBeside> speeds = {};  ///< of exact orbits, beside each of `impulses`; else empty
  /// Between its events force and motion are one solution of the equation of motion: of exact orbits and of
  /// motions that are integrated from event to event.
  bool integrated = false;
  /// The unit of x where the orbit of an answer rests: see `least_size`; 0 in what is no answer [m].
  double least = 0.0;

  [[nodiscard]] double period() const { return order * forcing_period; }
  [[nodiscard]] int count() const { return static_cast<int>(samples.x.rows()); }
  [[nodiscard]] int per_period() const { return count() / order; }  ///< instants of a forcing period
  [[nodiscard]] double step() const { return period() / count(); }
};

/// Samples a trajectory whose period is a whole multiple of the forcing period.
Motion sample_motion(const Problem& problem, const Trajectory& trajectory, int per_period = kGrid);

/// The motion of what a method returned, or why it is none.
struct SampledAnswer {
  std::string defect = {};  ///< why it cannot: see `trajectory_defect` and `samples_defect`; else empty
  Motion motion = {};       ///< on kGrid, unless there is a defect
};
/// Samples an answer of any method; nothing is taken for granted about it. Its `least` is still 0.
SampledAnswer check_answer(const Problem& problem, const Trajectory& answer);

/// Motion::least of an answer [m]: a tenth of the size of the contact-free motion, or of the distance of its
/// mean from the stops where that is less. Where a loose structure has no such motion, or a constant one, the
/// motion without the mean of the load stands in, and where that is zero or resonates, how far the load would
/// press the contacts with their stiffness scale (of a loose mass m omega^2); without any load at the
/// contacts the largest gap. \param space  of this problem, for its motion without contact; null: none is
/// known
double least_size(const Problem& problem, const ContactSpace* space = nullptr);

/// Both.
SampledAnswer sample_answer(const Problem& problem, const Trajectory& answer);

/// The contact force in harmonics of the motion's period: as many as it resolves, at most `max_harmonics` but
/// for harmonics of the load.
ForceSeries force_series(const Problem& problem, const Motion& motion, int max_harmonics);

/// Harmonics of the period in which the samples of the force have all but half of their size, of an answer
/// with a bandwidth that is no grid and that tells the force by samples alone; else empty.
std::optional<int> harmonics_of_force(const Motion& motion);

/// Harmonics of the period that a motion resolves: its bandwidth, but no fewer than its x and the samples of
/// its force show (Motion::shown), so that saying less than is there buys nothing. Empty: all of them.
std::optional<int> resolved_harmonics(const Motion& motion);

/// Fourier coefficients n = 0..count of the contact force, impulses included, in harmonics of the motion's
/// period, (count+1) x Nc [N]; a series' own, zero beyond its bandwidth.
Eigen::MatrixXcd contact_force_spectrum(const Motion& motion, int count);

/// A contact that a motion lists from its closing to its opening.
struct ListedPush {
  double begin = 0.0;    ///< [s], in [0, period)
  double end = 0.0;      ///< [s], >= begin; may reach past the period
  double impulse = 0.0;  ///< integral of the force, impulses aside, <= 0 [N s]
};

/// The pushes of a contact where the motion lists them all and one is too short for samples of the force:
/// less than 256 steps, beyond which samples have 1e-5 of it. Empty elsewhere, and where a push of 16 steps
/// or more is not what the samples show to a tenth: an answer does not tell its force in two ways.
std::vector<ListedPush> short_pushes(const Motion& motion, int contact);

/// Impulse per forcing period and contact: force integrated, impulses added, Nc [N s]. Of a contact with
/// `short_pushes` the force is theirs.
Eigen::VectorXd impulse_per_forcing_period(const Motion& motion);

/// Distances of motion a from motion b over their common period, b shifted by `shift` forcing periods, in
/// units of the size of b: of x - mean(x), the mean taken per contact, so that nothing depends on where the
/// origin of x is. Where b rests, which is where its size is below 1e-8 of `least` or 1e-9 of the largest
/// |x|, its round-off, the unit of x is the larger of a.least and b.least, or that round-off. Empty where the
/// unit is zero. Both must have the same grid per forcing period.
struct Distance {
  std::optional<double> x_l2 = {};  ///< root mean squares over time and contacts
  /// The largest of a contact, in units of its own size, but at least 1 % of the unit of all; where b rests
  /// there, in the unit of all.
  std::optional<double> x_worst = {};
  std::optional<double> x_max = {};        ///< largest |x_a - x_b| over the largest |x_b - mean(x_b)|
  std::optional<double> velocity_l2 = {};  ///< as x_l2, of x'; where b rests 2 pi / T times the unit of x
  /// Of lambda, root mean squares, relative to that of lambda_b itself; empty where either has impulses.
  std::optional<double> force_l2 = {};
};
Distance distance(const Motion& a, const Motion& b, int shift = 0);

/// The shift of b by whole forcing periods, 0 <= shift < b.order, that brings it nearest to a in x_l2.
int best_shift(const Motion& a, const Motion& b);

/// Smallest order m that divides the motion's and after which x repeats to 1e-6 of its size.
int least_order(const Motion& motion);

/// Half the difference of the largest and least x of a contact, the largest over contacts [m].
double amplitude(const Motion& motion);

}  // namespace signorini
