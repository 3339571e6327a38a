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

/// Nodes times contacts that a grid of hat functions beside a solve may have.
inline constexpr int kMostHatUnknowns = 8192;

/// What one method adds to the common options: its cell of the cube of methods.
struct HarmonicMethod {
  LawAt law_at;                                   ///< the contact law as it imposes it
  std::shared_ptr<const GridSolver> grid_solver;  ///< what it does on a grid of samples
  bool constant_is_chosen = false;                ///< the user set the constant of the law
  bool solver_is_open = true;     ///< the way to the solution is left to the method, not set by an option
  bool newton_from_guess = true;  ///< whether a guess is given to project_exactly before any grid
  bool on_grids_only = false;     ///< no attempt without a grid comes before its grid solver
};

/// A scene prepared with H harmonics.
struct HarmonicSetup {
  ContactReceptance receptance;  ///< n = 0..H
  Eigen::VectorXd gap;           ///< Nc [m]
  HarmonicMethod method;         ///< law, solver on a grid, what is left open
  HarmonicOptions options;       ///< as of the method
  ProjectedLaw law;              ///< for H
  /// With which impacts are compensated; empty: they stay as the series has them.
  std::optional<PeriodicGreenFunction> compensation = {};
  /// The restitution to close impacts at; empty: they are not closed, and the law represented is e = 1.
  std::optional<double> restitution = {};
  /// The same scene on hat functions with the restitution represented; empty: not to be asked, or too many
  /// contacts.
  std::optional<Resolutions> hat_grids = {};
  /// The scene, for a continuation in frequency; null where the receptance is not that of a scene.
  const Problem* problem = nullptr;

  /// The equations of all attempts; refers to this setup.
  [[nodiscard]] ProjectedEquations equations() const { return {receptance, gap, law}; }
  /// Whether solves of the exactly projected equations may replace grids.
  [[nodiscard]] bool without_grid() const {
    return method.solver_is_open && !method.on_grids_only && options.grid_is_open(receptance.harmonics());
  }
  /// Factor on the law's constant once impacts are compensated: the harder the law, the nearer the force is
  /// to an impulse, and the error to that of truncation alone (docs/decisions/0011). A constant that the user
  /// chose stays [-].
  [[nodiscard]] double compensated_stiffness() const { return method.constant_is_chosen ? 1.0 : 8.0; }
};

/// Sets a scene up with H harmonics; `problem` must outlive the result.
/// \throws std::runtime_error if the structure cannot be factorised
HarmonicSetup harmonic_setup(const Problem& problem, int harmonics, const HarmonicOptions& options,
                             const HarmonicMethod& method);

}  // namespace signorini
