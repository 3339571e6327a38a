#pragma once
// Independent event-driven steady states (tests/data/siconos) as scenes with their expected motion.

#include <string>
#include <vector>

#include "methods/solution.hpp"
#include "problems/problem.hpp"

namespace signorini::test {

/// One expected event; times in forcing periods from the start of a block of `order` of them.
struct ExpectedEvent {
  double phase = 0.0;
  int contact = 0;
  int type = 0;  ///< 0 impact, 1 start of sticking, 2 release
  double approach = 0.0, rebound = 0.0, impulse = 0.0;
};

struct SteadyStateCase {
  std::string name;
  Problem problem;
  int order = 1;
  std::vector<ExpectedEvent> events;
  std::vector<int> dofs;                     ///< coordinates recorded
  std::vector<std::vector<double>> samples;  ///< rows: phase, then displacement and velocity of each dof
};

/// The cases of one file of tests/data/siconos ("sdof", "chain", "bar").
std::vector<SteadyStateCase> steady_state_cases(const std::string& family);
SteadyStateCase steady_state_case(const std::string& family, const std::string& name);

/// Difference between a motion and the expected one, at the shift of whole forcing periods that fits best
/// (a motion of order p is known up to such a shift).
struct SteadyStateDifference {
  double x = 0.0;            ///< largest at the contacts recorded, relative to the largest displacement
  double impact_time = 0.0;  ///< largest, in forcing periods; impacts faster than `counted` only
  double impulse = 0.0;      ///< largest, relative to the largest impulse
  int expected_impacts = 0, found_impacts = 0;  ///< of that speed
};
SteadyStateDifference difference(const SteadyStateCase& expected, const Trajectory& found, double counted);

/// Dense matrices as a scene: rows of M, D, K.
using Rows = std::vector<std::vector<double>>;
SparseMatrix sparse(const Rows& rows);

}  // namespace signorini::test
