#pragma once
// Families of curves for the tests of harmonic balance.

#include "methods/harmonic_balance/continuation/series_curve.hpp"

namespace signorini::test {

/// Of the Lipschitz or of the penalty form, from 1.5 to 4.5 rad/s.
inline SeriesFamily family_of(const Problem& problem, int harmonics, bool penalty = false) {
  SeriesFamily family{curve_family(problem, 1.5, 4.5)};
  family.harmonics = harmonics;
  family.samples = 16 * harmonics;
  family.law_at = [problem, penalty](const ContactReceptance& receptance) {
    return penalty ? penalty_law(problem, {}, receptance) : lipschitz_law(problem, {}, receptance);
  };
  return family;
}

}  // namespace signorini::test
