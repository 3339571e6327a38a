#pragma once
// What closing impacts takes besides the equations of a scene with H harmonics.

#include <optional>
#include <string>

#include "methods/harmonic_balance/harmonic_setup.hpp"
#include "methods/refinement.hpp"
#include "methods/structure/receptance.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Nodes times contacts that a grid of hat functions beside a solve may have.
inline constexpr int kMostHatUnknowns = 8192;

/// How impacts are to be closed.
struct ClosureSettings {
  double restitution = 1.0;         ///< on rigid stops, 0 <= e <= 1 [-]
  bool constant_is_chosen = false;  ///< the user set the constant of the law
};

/// What closing impacts takes besides the equations (closed_answer.hpp).
struct ClosureSetup {
  double restitution = 1.0;  ///< to close impacts at, 0 <= e <= 1 [-]
  /// Factor on the law's constant that is tried first: the harder the law, the nearer the force is to an
  /// impulse, and the error to that of truncation alone (docs/decisions/0038). A constant that the user chose
  /// stays [-].
  double stiffness_factor = 1.0;
  /// C_n, n = 0..L, L > H, of the structure; empty where no contact answers like a mass beyond H.
  std::optional<ContactReceptance> response = {};
  /// The same scene on hat functions with that restitution, where impacts are looked for; empty without a
  /// response, or where the contacts are too many. Its scene must outlive it.
  std::optional<Resolutions> hat_grids = {};
  std::string obstacle = {};  ///< why the impacts are not closed, one sentence; empty where they may be
};

/// Nothing where there are no impacts to close: the stops are springs or have no mass behind them; or, at
/// restitution 1, no contact answers like a mass beyond H, for then the series is right as it is.
std::optional<ClosureSetup> closure_setup(const HarmonicSetup& setup, const ClosureSettings& settings);

}  // namespace signorini
