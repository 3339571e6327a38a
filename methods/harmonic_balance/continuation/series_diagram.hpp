#pragma once
// All branches of a method of harmonic balance that hang together with its answers at both ends.

#include <functional>
#include <memory>

#include "methods/curve.hpp"
#include "methods/harmonic_balance/continuation/series_tracer.hpp"
#include "methods/harmonic_balance/harmonic_options.hpp"
#include "methods/method.hpp"

namespace signorini {

/// A method of harmonic balance as its curves need it.
struct SeriesMethod {
  HarmonicOptions options;
  LawAt law_at;
  /// The method itself for a scene at one frequency.
  std::function<std::unique_ptr<PreparedMethod>(const Problem&)> prepare;
};

/// Follows, from both ends into the interval, the contact-free motion where nothing touches and the method's
/// own answer; then what leaves these branches: motions of twice the period at doublings, the
/// crossing branch at branch points, and at the grazing of a contact-free motion those of more periods that
/// press once (grazing_branch), up to the largest order. What lies on a branch already followed is left out.
///
/// Impacts stay as the series has them: folds and doublings are off by O(1/H). Motions of k periods have k
/// times the harmonics.
///
/// \param scene  over the frequency of its load
BranchDiagram series_diagram(const ParametrisedScene& scene, const SeriesMethod& method,
                             const CurveLimits& limits);

}  // namespace signorini
