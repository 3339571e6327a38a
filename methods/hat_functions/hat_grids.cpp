#include "methods/hat_functions/hat_grids.hpp"

namespace signorini {

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

}  // namespace signorini
