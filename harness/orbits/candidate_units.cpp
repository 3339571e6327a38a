#include "harness/orbits/candidate_units.hpp"

#include <algorithm>

#include "harness/orbits/answer_starts.hpp"
#include "harness/orbits/random_states.hpp"

namespace signorini {

std::vector<CandidateUnit> candidate_units(const Problem& problem, int order, int starts, unsigned seed,
                                           std::span<const MethodEntry> catalogue) {
  // Random states of one process: small enough that a crash or a time limit costs little.
  constexpr int kStatesPerUnit = 8;
  std::vector<CandidateUnit> units;
  if (order == 1) units.push_back(from_rest(problem));
  for (CandidateUnit& unit : cold_starts(problem, order, catalogue)) units.push_back(std::move(unit));
  units.push_back(coarse_grids(problem, order));
  for (int first = 0; first < starts; first += kStatesPerUnit)
    units.push_back(random_states(problem, order, first, std::min(starts, first + kStatesPerUnit), seed));
  return units;
}

}  // namespace signorini
