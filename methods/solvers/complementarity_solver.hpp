#pragma once
// The solver shared by the complementarity methods: pivoting with restarts, or plain Newton.

#include <array>
#include <chrono>
#include <string_view>

#include "methods/options.hpp"
#include "methods/solvers/lcp.hpp"

namespace signorini {

/// How a complementarity problem is solved.
enum class ComplementaritySolver {
  automatic,  ///< pivoting, restarted with other covering vectors where the path fails
  pivoting,   ///< pivoting, one path
  newton,     ///< semi-smooth Newton with a line search, the source paper's solver
};

/// The values of the option `solver`.
template <>
struct EnumNames<ComplementaritySolver> {
  /// In the order of the enumerators.
  static constexpr std::array<std::string_view, 3> values{"auto", "pivoting", "newton"};
};

/// What a solve may do, and when it must end.
struct SolverSettings {
  ComplementaritySolver solver = ComplementaritySolver::automatic;  ///< which of them
  double tolerance = 1e-10;                                         ///< on LcpResult::residual [-]
  int max_iterations = 0;  ///< pivots or Newton iterations; 0: the solver's own limit
  /// The end of the time budget.
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
  double cover_amplitude = 0.0;  ///< of a wave on the first covering vector (smooth_cover), in [0, 1) [-]
  double cover_phase = 0.0;      ///< [rad]
};

/// Solves the problem as the settings ask, from `guess` (z of a nearby problem) or cold when that is empty.
/// `automatic` makes these attempts, in this order, until one succeeds:
///
///   1. without a guess: permanent contact, w = 0 everywhere, one linear solve;
///   2. pivoting from the guess, if there is one; then cold;
///   3. where a path ends on a ray or at a singular block: cold with four other covering vectors.
///
/// `pivoting` makes the second alone, `newton` none of them. Counts of work are summed over attempts.
LcpResult solve_lcp(const Lcp& lcp, const SolverSettings& settings, const Eigen::VectorXd& guess = {});

}  // namespace signorini
