#pragma once
// The same scene on hat functions, as another place to start from and as a witness.

#include <optional>

#include "methods/harmonic_balance/harmonic_setup.hpp"

namespace signorini {

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
/// integral is exact (`exact`) and the motion on hat functions is near it, or none was to be asked.
Solution claim_if_borne_out(Solution series, bool exact, const HatAgreement& agreement);

}  // namespace signorini
