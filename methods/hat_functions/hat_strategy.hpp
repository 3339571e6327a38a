#pragma once
// What is tried, in which order, to solve the complementarity problem of one grid of hat functions.

#include "methods/complementarity/hat_form.hpp"
#include "methods/hat_functions/hat_settings.hpp"
#include "methods/method.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// The complementarity problem of a scene on one grid.
struct HatProblem {
  const Problem& scene;         ///< whose period is discretised
  const NodalStops& stops;      ///< of the scene
  const HatForm& form;          ///< of the scene on the grid
  const HatSettings& settings;  ///< the grid, and the solver asked for
};

/// Solves it by the solver asked for; with `automatic` by the first of these attempts that succeeds:
///
///   1. permanent contact: w = 0 at all nodes, one linear solve;
///   2. pivoting from the guess, then cold, then with other covering vectors where a path ends on a ray
///      (`solve_lcp`), as long as the path is short, 4 pivots per unknown;
///   3. where the path is long (chatter: as many solutions as bounces): marching in time from rest until the
///      nodes in contact repeat, and Newton's method from there;
///   4. pivoting to the end, 100 pivots per unknown.
///
/// An answer on one grid may still be wrong by its numerical dissipation: `refined_hat_contact` compares
/// grids.
/// \return z in units of the form; pivots summed over the attempts
LcpResult solve_hat_problem(const HatProblem& problem, const Start& start);

}  // namespace signorini
