#pragma once
// All branches of a method of harmonic balance that hang together with its answers at both ends.

#include <functional>
#include <memory>
#include <utility>

#include "methods/curve_method.hpp"
#include "methods/harmonic_balance/continuation/series_tracer.hpp"
#include "methods/harmonic_balance/harmonic_options.hpp"
#include "methods/method.hpp"

namespace signorini {

/// A method of harmonic balance as its curves need it.
struct SeriesMethod {
  HarmonicOptions options;
  LawAt law_at;
  /// The method itself for a scene at one frequency, its impacts not closed.
  std::function<std::unique_ptr<PreparedMethod>(const Problem&)> prepare;
};

/// Follows, from both ends into the interval, the contact-free motion where nothing touches and the method's
/// own answer; then what leaves these branches: motions of twice the period at doublings, the
/// crossing branch at branch points, and at the grazing of a contact-free motion those of more periods that
/// press once (grazing_branch), up to the largest order. What lies on a branch already followed is left out.
///
/// Impacts stay as the series has them: the curves are those of the method with `compensate=false`, whose
/// folds and doublings are off by O(1/H). Motions of k periods have k times the harmonics.
BranchDiagram series_diagram(const Problem& problem, double from, double to, const SeriesMethod& method,
                             const CurveLimits& limits);

/// series_diagram of a method of harmonic balance with these options, impacts not closed.
/// \tparam Method  with HarmonicOptions as `Options::common`
/// \throws InvalidOption  if the impacts of a restitution below 1 were asked to be closed: curves have e = 1
template <class Method>
BranchDiagram projected_diagram(typename Method::Options options, LawAt law_at, const Problem& problem,
                                double from, double to, const CurveLimits& limits) {
  const bool asked = options.common.restitution == ClosedRestitution::scene;
  require_option(!asked || options.common.closed_restitution(problem).value_or(1.0) == 1.0, "restitution",
                 options.common.restitution, "must be none or auto: curves are those of restitution 1");
  options.common.compensate = false;
  options.common.restitution = ClosedRestitution::none;
  const auto prepare = [method = Method(options)](const Problem& scene) { return method.prepare(scene); };
  return series_diagram(problem, from, to,
                        {.options = options.common, .law_at = std::move(law_at), .prepare = prepare}, limits);
}

}  // namespace signorini
