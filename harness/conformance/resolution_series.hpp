#pragma once
// How a method converges along a series of resolutions: the steps of the ladder that it declares, coarse to
// fine.

#include <optional>
#include <string>
#include <vector>

#include "harness/conformance/check_result.hpp"
#include "harness/plan/plan.hpp"
#include "harness/records/record.hpp"

namespace signorini {

/// The observed order must reach this share of the declared one: errors of a few coarse steps scatter [-].
inline constexpr double kOrderShare = 0.75;
/// Where no order is declared, the largest ratio of the last error to the first [-].
inline constexpr double kErrorRatio = 0.5;

/// One step of a series.
struct ResolutionStep {
  double size =
      1.0;  ///< h: the number that the settings vary, or its inverse if that grows along the ladder [-]
  double error = 0.0;  ///< relative error of the answer [-]
};

/// Steps of a ladder that differ in one number only, coarse to fine.
struct ResolutionSeries {
  std::string words = {};                ///< the settings that are not numbers, "flow=modal"
  std::vector<std::size_t> places = {};  ///< indices into the ladder
  std::vector<double> sizes = {};        ///< h of each place [-]
};

/// The series of a ladder, in the order of their first steps. If several numbers vary in a series, its sizes
/// are 1, 1/2, 1/3, ..., from which no order can be concluded.
std::vector<ResolutionSeries> resolution_series(const std::vector<Settings>& ladder);

/// Order p of error ~ h^p, from the first and the last step; empty for less than two sizes or a zero error.
std::optional<double> observed_order(const std::vector<ResolutionStep>& steps);

/// Passes if the last error is at most `floor`; or if the observed order is at least kOrderShare of the
/// declared one; or, without a declared order, if the last error is at most kErrorRatio of the first. Not
/// applicable to a single step above the floor.
CheckResult check_error_decay(const std::vector<ResolutionStep>& steps, std::optional<double> order,
                              double floor);

/// The records of one method on one scene, one for each step of its ladder, with the statuses and
/// certificates that a run of the benchmark gives.
struct LadderRecords {
  const MethodEntry& entry;
  std::vector<Settings> ladder;
  std::vector<Record> records;  ///< as many as `ladder`, or none
};

/// Every step to which the method applies converges.
CheckResult check_convergence(const LadderRecords& ladder);
/// No answer that is called converged is refuted: by its certificate, by an unsound trajectory, or by a
/// crash.
CheckResult check_certificate(const LadderRecords& ladder);
/// The error of x against the certified orbit of the law that the method declares decays with the declared
/// order.
CheckResult check_order(const LadderRecords& ladder);

}  // namespace signorini
