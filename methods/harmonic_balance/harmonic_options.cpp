#include "methods/harmonic_balance/harmonic_options.hpp"

#include <fmt/format.h>

#include "problems/problem.hpp"

namespace signorini {

namespace {

// Of plain forms, in units of the contact's static stiffness: where Newton's method starts from the motion
// without forces, and where pivoting needs no start (docs/decisions/0055-constants-of-plain-forms.md).
constexpr double kConstantOfNewton = 1.0, kPenaltyOfNewton = 100.0, kConstantOfPivots = 1e5;

}  // namespace

Quadrature HarmonicOptions::contact_integral() const {
  return quadrature.value_or(plain ? Quadrature::sampled : Quadrature::exact);
}

std::optional<int> HarmonicOptions::fixed_samples(int harmonics) const {
  return plain ? samples.value_or(kSampledPerHarmonic * harmonics) : samples;
}

std::optional<double> HarmonicOptions::lipschitz_constant(const std::optional<double>& asked,
                                                          bool by_pivots) const {
  return plain ? asked.value_or(by_pivots ? kConstantOfPivots : kConstantOfNewton) : asked;
}

StopPenalty HarmonicOptions::penalty(const std::optional<Scaled>& asked, bool by_pivots) const {
  StopPenalty penalty{.asked = asked};
  if (plain) penalty.rigid = Scaled{by_pivots ? kConstantOfPivots : kPenaltyOfNewton, true};
  return penalty;
}

int HarmonicOptions::first_harmonics(const Problem& problem) const {
  if (harmonics) return *harmonics;
  const int needed = load_bandwidth(problem);
  int first = kDefaultHarmonics;
  while (first < needed && first < kMostHarmonics) first *= 2;
  return first;
}

bool HarmonicOptions::grid_is_open(int harmonics) const {
  return max_iterations == 0 && contact_integral() == Quadrature::exact && !fixed_samples(harmonics);
}

void validate(const HarmonicOptions& options) {
  const int harmonics = options.harmonics.value_or(kDefaultHarmonics);
  require_option(harmonics >= 1 && harmonics <= 100000, "harmonics", options.harmonics,
                 "must be from 1 to 100000, or auto");
  require_option(!options.samples || *options.samples >= 2 * harmonics + 1, "samples", options.samples,
                 "must be at least 2 * harmonics + 1, or auto");
  require_option(!options.samples || *options.samples <= 10000000, "samples", options.samples,
                 "must be at most 10000000");
  require_option(options.continuation == Continuation::none || options.plain, "continuation",
                 options.continuation, "must be none unless plain = true");
  require_option(options.tolerance > 0.0 && options.tolerance <= 1e-2, "tolerance", options.tolerance,
                 "must be in (0, 1e-2]");
  require_option(options.max_iterations >= 0, "max_iterations", options.max_iterations, "must be 0 or more");
}

void validate_constant(const std::optional<double>& c) {
  require_option(!c || *c > 0.0, "c", c, "must be positive, or auto");
}

Support supports_harmonics(const Problem& problem, const HarmonicOptions& options) {
  const int harmonics = options.first_harmonics(problem);
  const int needed = load_bandwidth(problem);
  if (options.samples && *options.samples < 2 * harmonics + 1) {
    return {
        false,
        fmt::format("the load reaches harmonic {} of the motion's base frequency: samples = {} are too few",
                    needed, *options.samples)};
  }
  if (needed <= harmonics) return {};
  return {false,
          fmt::format("the load reaches harmonic {} of the motion's base frequency, beyond harmonics = {}",
                      needed, harmonics)};
}

}  // namespace signorini
