#pragma once
// What the attempts of a harmonic-balance solve work on.

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "methods/complementarity/projected_law.hpp"
#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/harmonic_balance/harmonic_options.hpp"
#include "methods/marching/periodic_march.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

struct HarmonicSetup;

/// A solve with some number of harmonics.
struct HarmonicSolve {
  Solution solution = {};          ///< the answer, or the best iterate, without its work
  bool harmonics_may_help = true;  ///< more of them, where this did not converge
};

/// Solves a scene with contacts that is set up; the effort is added to `work`.
using HarmonicSolver = std::function<HarmonicSolve(const Start& start, Work& work)>;

/// What one method adds to the common options: its cell of the cube of methods.
struct HarmonicMethod {
  LawAt law_at;                   ///< the contact law as it imposes it
  GridSolver grid_solver;         ///< what it does on a grid of samples
  bool solver_is_open = true;     ///< the way to the solution is left to the method, not set by an option
  bool newton_from_guess = true;  ///< whether a guess is given to project_exactly before any grid
  bool on_grids_only = false;  ///< its grid solver finds every answer; other attempts give it a start alone
  /// Harmonics times contacts from which the grid solver's own way to a start is longer than a march [-].
  int many_unknowns = 800;
  Work counts = {};  ///< that it reports of every solve, those without a grid included
  /// Of a method whose equations are more than the projected ones: what solves a scene, whose setup outlives
  /// it. Empty: solve_series.
  std::function<HarmonicSolver(const HarmonicSetup& setup)> solver_of = {};
};

/// What a method adds for a scene, whose contacts its law is made for; the problem outlives what is made.
using HarmonicMethodFor = std::function<HarmonicMethod(const Problem&)>;

/// A scene prepared with H harmonics.
struct HarmonicSetup {
  ContactReceptance receptance;  ///< n = 0..H
  Eigen::VectorXd gap;           ///< Nc [m]
  HarmonicMethod method;         ///< law, solver on a grid, what is left open
  HarmonicOptions options;       ///< as of the method
  ProjectedLaw law;              ///< for H
  /// The scene, for a continuation in frequency; null where the receptance is not that of a scene.
  const Problem* problem = nullptr;
  /// What contacts feel of the structure, to march to a start; empty where few unknowns of fewer than four
  /// contacts make the solver's own start cheap, a march does not represent the scene, or options leave no
  /// start open.
  std::optional<ContactReduction> marched = {};

  /// The equations of all attempts; refers to this setup.
  [[nodiscard]] ProjectedEquations equations() const { return {receptance, gap, law}; }
  /// Whether the options leave the way to a solution to the method.
  [[nodiscard]] bool way_is_open() const {
    return method.solver_is_open && options.grid_is_open(receptance.harmonics());
  }
  /// Whether solves of the exactly projected equations may replace grids.
  [[nodiscard]] bool without_grid() const { return way_is_open() && !method.on_grids_only; }
  /// Whether there are `HarmonicMethod::many_unknowns`.
  [[nodiscard]] bool has_many_unknowns() const {
    return receptance.harmonics() * receptance.contacts() >= method.many_unknowns;
  }
};

/// Sets a scene up with H harmonics; `problem` must outlive the result.
/// \throws std::runtime_error if the structure cannot be factorised
HarmonicSetup harmonic_setup(const Problem& problem, int harmonics, const HarmonicOptions& options,
                             const HarmonicMethod& method);

}  // namespace signorini
