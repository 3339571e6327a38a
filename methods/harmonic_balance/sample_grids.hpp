#pragma once
// The projected equations on finer and finer grids of samples.

#include <optional>

#include "methods/harmonic_balance/harmonic_setup.hpp"

namespace signorini {

/// Harmonics for which the coarsest grid of samples is made, however few there are.
inline constexpr int kFewestOnGrid = 8;
/// Samples per harmonic on which an exact contact integral may start.
inline constexpr int kCoarseSampling = 8;

/// Samples per period as the harmonic-balance methods choose them: what the user fixed; else from 8 H up
/// where the exact contact integral follows and from 32 H up where it does not, doubled up to 128 H until
/// the solve converges and either its contact integral is exact or, from 32 H, the energy identity holds
/// to 1e-3.
class SampleLadder {
 public:
  /// \param fixed  what the user set
  SampleLadder(int harmonics, std::optional<int> fixed, Quadrature quadrature);
  /// N of the present rung.
  [[nodiscard]] int samples() const { return samples_; }
  /// Whether an answer is one: its contact integral exact, or sampled because that was asked for, or so well
  /// that the energy identity holds to 1e-3.
  ///
  /// \param net_work  net_work_ratio [-]
  [[nodiscard]] bool accepts(bool exact, double net_work) const;
  /// Doubles N where the outcome asks for it; false if it does not, or there is nothing left to try.
  bool refine(bool converged, bool exact, double net_work);

 private:
  Quadrature quadrature_;
  int samples_;
  int trusted_;
  int finest_;
};

/// Solves the sampled equations on the grids of SampleLadder by the method's own solver, and where the exact
/// contact integral is asked for, the exactly projected equations from there. Where these have no solution
/// nearby, because a contact is born or lost on the way, the sampled one stays and says so. Always gives an
/// answer or the best iterate, its work apart: that is added to `work`.
Solution solve_on_grids(const HarmonicSetup& setup, const Start& start, Work& work);

}  // namespace signorini
