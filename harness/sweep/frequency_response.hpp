#pragma once
// A frequency response: one solve after another, each from the answer before it.

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "harness/plan/plan.hpp"
#include "harness/records/record.hpp"
#include "harness/table.hpp"
#include "methods/deadline.hpp"

namespace signorini {

/// The frequencies of a sweep: those of the forcing, omega [rad/s].
struct SweepRange {
  double from = 1.0;
  double to = 2.0;  ///< above or below `from`
  int points = 50;  ///< >= 2, both ends included
  bool logarithmic = false;
  bool back = false;            ///< and the same points in reverse: where the two differ, motions coexist
  std::vector<double> at = {};  ///< these frequencies instead of `points` between both ends, if any
};

/// \throws UsageError unless a frequency is finite and positive \param name  of the option that gives it
void require_frequency(const char* name, double value);

/// \throws UsageError unless both ends, by the names of their options, are finite and different
void require_interval(const char* from_name, double from, const char* to_name, double to);

/// The frequencies in the order they are solved. \throws UsageError unless the ends are finite, positive and
/// different, and those of `at` positive and different too
std::vector<double> sweep_frequencies(const SweepRange& range);

/// A motion over its own period: x_j at equidistant instants from t = 0, per contact [m].
struct SweptMotion {
  double period = 0.0;  ///< [s]
  std::vector<std::vector<double>> x = {};
};

/// One point of a response; a quantity that does not exist there is absent.
struct SweepPoint {
  double frequency = 0.0;  ///< [rad/s]
  bool down = false;       ///< on a way of falling frequency
  Status status = Status::not_converged;
  std::string message = {};
  std::vector<double> x_max = {};          ///< largest x of each contact over the period [m]
  std::vector<double> amplitude = {};      ///< half of largest less least x of each contact [m]
  Measure contact_ratio = {};              ///< share of the period with contact [-]
  std::optional<bool> stable = {};         ///< of the certified orbit, if it was certified
  std::string undefined = {};              ///< why it has no multipliers
  Measure seconds = {};                    ///< processor time of set-up and solve [s]
  std::optional<SweptMotion> motion = {};  ///< of a point that was solved
};

struct SweepLimits {
  double timeout = 10.0;               ///< of one solve [s]
  int memory_mb = Limits{}.memory_mb;  ///< of one solve [MiB]
  bool certified = false;  ///< look for the orbit behind each answer: its stability, and whether it is one
  /// After which no solve begins.
  Deadline deadline = {};
};

/// Called with each point as soon as it is solved.
using TakePoint = std::function<void(const SweepPoint& point)>;

/// Solves scene after scene, in processes of their own unless what the method has set up serves several
/// (`Runner::run_series`). A solve starts from the last answer that was found, its time stretched to the new
/// period; where none was found, cold. Ends early after an interrupt, and at the deadline.
std::vector<SweepPoint> frequency_response(const Scene& scene, const MethodChoice& method,
                                           const SweepRange& range, const SweepLimits& limits,
                                           const TakePoint& take = {});

/// A number in a table; "-" where there is none.
Cell number_cell(const Measure& value, int digits = 10);
/// The largest over the contacts; "-" without contacts.
Cell largest_cell(const std::vector<double>& values, int digits = 10);
/// Whether the certified orbit of a point is stable: "stable", ..., "-" where that is not known.
Cell stability_cell(const SweepPoint& point);

/// One row per point in the order of the solves; `certified` adds the column of stability, and `other_law`,
/// unless it is empty, one with that law in each row. What is absent is "-".
Table response_table(const std::vector<SweepPoint>& points, bool certified,
                     const std::string& other_law = {});

/// Keys `frequency`, `way` ("up" or "down", as the frequency goes), `status`, `message`, `x_max`,
/// `amplitude`, `contact_ratio`, `stable`, `stability`, `stability_reason`; absent where a notion is.
nlohmann::ordered_json to_json(const SweepPoint& point);

}  // namespace signorini
