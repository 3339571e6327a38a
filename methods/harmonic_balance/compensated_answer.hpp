#pragma once
// Answers of harmonic balance whose impacts satisfy the law of impact with all harmonics, and the same scene
// on hat functions, as another place to start from and as a witness.

#include <optional>
#include <string>

#include "methods/harmonic_balance/harmonic_setup.hpp"

namespace signorini {

/// The end of a compensation of a series.
struct CompensatedSeries {
  std::optional<Solution> answer = {};  ///< compensated, or the series itself where it has no impact
  bool exact = false;                   ///< the exactly projected equations have a solution near the series
};

/// Compensates the impacts of a converged series (compensate_impacts), within the limit on steps of the
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

/// Whether the motion on hat functions confirms a series, or which answer it leads to instead.
struct HatAgreement {
  bool asked = false;                   ///< a grid of hat functions carries the harmonics
  std::optional<Solution> answer = {};  ///< with compensated impacts, from the motion on a grid
  /// Distance of the series from the motion on the finest grid; empty where one of them is missing, or the
  /// time was up before it was found [-].
  std::optional<double> distance = {};
};

/// Solves the scene on the hat-function grids of the setup, from coarse to fine, until the motion on one of
/// them leads to an answer with compensated impacts. Their work is added to `work`. Not asked where the setup
/// has no grids.
HatAgreement compare_with_hat_functions(HarmonicSetup& setup, const Solution& series, const Start& start,
                                        Work& work);

/// A series whose impacts are not compensated, with the verdict that it deserves: claimed if its contact
/// integral is exact (`exact`) and the motion on hat functions is at most `nearest` away, or none was to be
/// asked.
Solution claim_if_borne_out(Solution series, bool exact, const HatAgreement& agreement, double nearest);

}  // namespace signorini
