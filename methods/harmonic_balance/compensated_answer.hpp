#pragma once
// Answers of harmonic balance whose impacts satisfy the law of impact with all harmonics.

#include <optional>
#include <string>

#include "methods/harmonic_balance/harmonic_setup.hpp"

namespace signorini {

/// The end of a compensation of a series.
struct CompensatedSeries {
  std::optional<Solution> answer = {};  ///< compensated, or the series itself where it has no impact
  bool exact = false;                   ///< the exactly projected equations have a solution near the series
};

/// Compensates the impacts of a converged series (ImpactCompensation), within the limit on steps of the
/// setup. `setup` must have a compensation. Counts what it takes in `work`.
CompensatedSeries compensate_series(const HarmonicSetup& setup, const Solution& series, const Start& start,
                                    Work& work);

/// The compensated answer near a guess that is one itself, under the stiffer law at once; empty if there is
/// none.
std::optional<Solution> compensated_from_guess(const HarmonicSetup& setup, const Start& start, Work& work);

/// The answer that a motion found by other means leads to, its impacts compensated if it has any; empty if
/// there is none.
///
/// \param how  the motion was found, for the message
std::optional<Solution> compensated_from_motion(const HarmonicSetup& setup, const Trajectory& motion,
                                                const std::string& how, const Start& start, Work& work);

}  // namespace signorini
