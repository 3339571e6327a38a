#pragma once
// What happens at the stops of a motion that need not be periodic: means over time, each with its error.

#include <cstddef>
#include <optional>
#include <vector>

#include "harness/statistics.hpp"
#include "methods/flow/flow_record.hpp"

namespace signorini {

/// Of one contact. An impact is an impulse or, at a compliant stop, a contact from closing to opening.
struct StopStatistics {
  Estimate x_mean = {};  ///< [m]
  Estimate x_rms = {};   ///< about the mean [m]
  double x_min = 0.0;    ///< [m]
  double x_max = 0.0;    ///< [m]
  /// Root mean square and largest value of the force [N]; empty where impacts have no width.
  std::optional<Estimate> force_rms = {}, force_peak = {};
  Estimate impulse_per_second = {};  ///< of the force and of impulses, >= 0 [N]
  Estimate impacts_per_second = {};  ///< [1/s]
  /// Mean impulse of an impact and its standard deviation from one to the next [N s]; empty without impacts.
  std::optional<double> impulse_mean = {}, impulse_deviation = {};
  /// That the motion gives to the contact point [W]; empty where that is not known to be what the stop takes.
  std::optional<Estimate> power = {};
};

/// Adds up what happens at the stops, period by period. Integrals between events are exact to the order of
/// `two_point_integral`.
class StopSums {
 public:
  explicit StopSums(int contacts) : stops_(static_cast<std::size_t>(contacts)) {}

  /// One more period. \param record  of it, with nodes. \param duration  of the period [s]
  void take(const FlowRecord& record, double duration);
  /// Of all periods so far, at least one, by batch means.
  [[nodiscard]] std::vector<StopStatistics> statistics() const;

 private:
  struct Stop {
    std::vector<double> x, x_square, force_square, impulse, impacts, power;  // means of each period
    std::vector<double> force_peak, x_min, x_max;                            // extremes of each period
    std::vector<double> impulses;      // of impacts that have no width [N s]
    std::vector<double> contacts;      // integrals of force from closing to opening [N s]
    std::optional<double> in_contact;  // the integral so far of one that lasts
  };

  static void take_intervals(const FlowRecord& record, int contact, double duration, Stop& stop);
  static void take_impulses(const FlowRecord& record, int contact, double duration, Stop& stop);

  std::vector<Stop> stops_;
};

}  // namespace signorini
