#pragma once
// All branches of a method of harmonic balance that hang together with its answers at both ends.

#include "methods/complementarity/projected_law.hpp"
#include "methods/curve.hpp"
#include "methods/harmonic_balance/harmonic_options.hpp"
#include "methods/method.hpp"

namespace signorini {

/// Follows, from both ends into the interval, the contact-free motion where nothing touches and the method's
/// own answer; then what leaves these branches: motions of twice the period at doublings, the
/// crossing branch at branch points, and at the grazing of a contact-free motion those of more periods that
/// press once (grazing_branch), up to the largest order. What lies on a branch already followed is left out.
///
/// Where the number of harmonics is left to the method, the curve has as many as its answers at both ends, at
/// most 40; a note says where these have more.
///
/// Impacts stay as the series has them: folds and doublings are off by O(1/H). Motions of k periods have k
/// times the harmonics.
///
/// \param scene    over the frequency of its load
/// \param method   itself, with these options
/// \param law_at   the contact law as it imposes it
BranchDiagram series_diagram(const ParametrisedScene& scene, const Method& method,
                             const HarmonicOptions& options, const LawAt& law_at, const CurveLimits& limits);

}  // namespace signorini
