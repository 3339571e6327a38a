#include "methods/hat_functions/hat_grids.hpp"

#include <cmath>

#include "methods/discretisation/trajectories.hpp"

namespace signorini {

namespace {

/// Whether the next grid is worth its cost. A pivot costs the square of the nodes in contact, and the next
/// grid has four times as many of both. Long contacts are expensive and rarely disputed.
bool cheap_on_the_next_grid(const Solution& solution) {
  constexpr double kGrowth = 64.0;
  constexpr double kOperations = 1e9;  // about a second
  const auto& motion = dynamic_cast<const NodalTrajectory&>(*solution.trajectory);
  const auto pressed = static_cast<double>((motion.nodal_force().array() < 0.0).count());
  return kGrowth * static_cast<double>(solution.work.pivots.value_or(0)) * pressed * pressed <= kOperations;
}

/// A motion smaller than this part of the static deflection is rounding [-].
constexpr double kAtRest = 1e-6;

/// Deflection of the softest contact under the load at its largest, held still [m].
double static_deflection(const Problem& problem) {
  double load = 0.0;
  for (const ForceTerm& term : problem.force) load += std::hypot(term.cos, term.sin);
  return load / contact_stiffness_scale(problem).minCoeff();
}

}  // namespace

int coarsest_hat_grid(const Problem& problem) {
  constexpr int kCoarsest = 256;
  constexpr int kPerOscillation = 16;
  const int needed = kPerOscillation * load_bandwidth(problem);
  int samples = kCoarsest;
  while (samples < needed && samples < kFinestHatGrid) samples *= 2;
  return samples;
}

Resolutions hat_grids(const Problem& problem, const HatSettings& settings,
                      std::optional<double> restitution) {
  constexpr int kFactor = 4;
  return {rising_resolutions(coarsest_hat_grid(problem), kFactor, kFinestHatGrid),
          [&problem, settings, restitution](int samples) {
            HatSettings grid = settings;
            grid.samples = samples;
            return hat_contact(problem, grid, restitution);
          }};
}

std::unique_ptr<PreparedMethod> refined_hat_contact(const Problem& problem, const HatSettings& settings,
                                                    std::optional<double> restitution) {
  return refined_until_agreed(hat_grids(problem, settings, restitution), "N", cheap_on_the_next_grid,
                              kAtRest * static_deflection(problem));
}

}  // namespace signorini
