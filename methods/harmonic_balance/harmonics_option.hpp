#pragma once
// How many harmonics a method of harmonic balance keeps where that is left to it.

#include <memory>
#include <optional>
#include <utility>

#include "methods/complementarity/projected_law.hpp"
#include "methods/method.hpp"
#include "methods/resolutions.hpp"
#include "methods/solvers/complementarity_solver.hpp"

namespace signorini {

/// Harmonics beyond which none are tried unasked.
constexpr int kMostHarmonics = 160;

/// H asked for; else 20, doubled until the load's harmonics are kept, at most 160.
inline int first_harmonics(const std::optional<int>& asked, const Problem& problem) {
  if (asked) return *asked;
  const int needed = load_bandwidth(problem);
  int harmonics = kDefaultHarmonics;
  while (harmonics < needed && harmonics < kMostHarmonics) harmonics *= 2;
  return harmonics;
}

/// Whether the way to the solution is left to the method.
template <class Options>
bool solver_is_left_open(const Options& options) {
  if constexpr (requires { options.solver; }) return options.solver == ComplementaritySolver::automatic;
  if constexpr (requires { options.homotopy; }) return options.homotopy.value_or(true);
  return true;
}

/// Whether more harmonics may be tried: their number is left to the method, as is all that depends on it.
template <class Options>
bool refines_harmonics(const Options& options) {
  return solver_is_left_open(options) && !options.harmonics && !options.samples && !options.plain &&
         options.max_iterations == 0 && quadrature_of(options) == Quadrature::exact;
}

/// The scene prepared by `with` for the harmonics that the options ask for, or for twice as many where so
/// many do not converge.
template <class Options>
std::unique_ptr<PreparedMethod> prepare_harmonics(const Options& options, const Problem& problem,
                                                  AtResolution with) {
  const int first = first_harmonics(options.harmonics, problem);
  if (!refines_harmonics(options)) return with(first);
  return refined_until_converged({rising_resolutions(first, 2, kMostHarmonics), std::move(with)}, "H");
}

}  // namespace signorini
