#pragma once
// What the attempts of a harmonic-balance solve work on.

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "methods/complementarity/projected_law.hpp"
#include "methods/harmonic_balance/grid_solver.hpp"
#include "methods/harmonic_balance/harmonic_options.hpp"
#include "methods/harmonic_balance/impact_compensation.hpp"
#include "methods/refinement.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// What one method adds to the common options: its cell of the cube of methods.
struct HarmonicMethod {
  LawAt law_at;                                   ///< the contact law as it imposes it
  std::shared_ptr<const GridSolver> grid_solver;  ///< what it does on a grid of samples
  bool constant_is_chosen = false;                ///< the user set the constant of the law
  bool solver_is_open = true;     ///< the way to the solution is left to the method, not set by an option
  bool newton_from_guess = true;  ///< whether a guess is given to project_exactly before any grid
};

/// How the equations of one scene are solved.
struct HarmonicSettings {
  std::optional<int> samples = {};            ///< N of the only grid; empty: see SampleLadder
  Quadrature quadrature = Quadrature::exact;  ///< of the contact integral
  double tolerance = 1e-10;                   ///< on relative residuals [-]
  long limit = 0;                             ///< on pivots and Newton steps in all; 0: none [-]
  bool without_grid = true;                   ///< solves of the exactly projected equations may replace grids
  bool newton_from_guess = true;              ///< as of HarmonicMethod
  double compensated_stiffness = 1.0;  ///< factor on the law's constant once impacts are compensated [-]
};

/// A scene prepared with H harmonics.
struct HarmonicSetup {
  ContactReceptance receptance;                         ///< n = 0..H
  Eigen::VectorXd gap;                                  ///< Nc [m]
  LawAt law_at;                                         ///< for fewer harmonics
  ProjectedLaw law;                                     ///< for H
  std::shared_ptr<const GridSolver> grid_solver;        ///< for the sampled equations
  HarmonicSettings settings = {};                       ///< how
  std::optional<ImpactCompensation> compensation = {};  ///< empty: impacts stay as the series has them
  std::optional<Resolutions> hat_grids = {};  ///< the same scene on hat functions; empty: not to be asked

  /// The equations of all attempts; refers to this setup.
  [[nodiscard]] ProjectedEquations equations() const { return {receptance, gap, law}; }
};

/// Sets a scene up with H harmonics; `problem` must outlive the result.
/// \throws std::runtime_error if the structure cannot be factorised
HarmonicSetup harmonic_setup(const Problem& problem, int harmonics, const HarmonicOptions& options,
                             const HarmonicMethod& method);

/// Pivots and Newton steps of a solve so far.
inline long steps_spent(const Work& work) { return work.pivots.value_or(0) + work.iterations.value_or(0); }

/// Adds Newton steps to the work of a solve.
inline void count_iterations(int steps, Work& work) { work.iterations = work.iterations.value_or(0) + steps; }

}  // namespace signorini
