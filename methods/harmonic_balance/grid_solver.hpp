#pragma once
// What a method of harmonic balance does on one grid of samples.

#include <Eigen/Core>
#include <optional>
#include <string>

#include "methods/complementarity/projected_law.hpp"
#include "methods/method.hpp"

namespace signorini {

/// The end of one solve on a grid.
struct GridSolution {
  bool solved = false;                   ///< to the method's tolerance
  bool finer_may_help = true;            ///< whether more samples could repair a failure
  Eigen::MatrixXcd lambda = {};          ///< solution or best iterate, n = 0..H, (H+1) x Nc [N]
  double residual = 0.0;                 ///< of the sampled equations, relative [-]
  std::optional<double> condition = {};  ///< estimate for the last linear system; empty: none solved [-]
  std::string message = {};              ///< how it ended, a few words
};

/// Solves the projected equations with the contact integral on N samples. This is the cell of the methods'
/// cube in which they differ: pivoting or Newton on the complementarity problem (fourier-lipschitz,
/// penalty-hbm), Newton-Krylov in the frequency domain (aft-hbm). Immutable.
class GridSolver {
 public:
  virtual ~GridSolver() = default;
  /// \param samples   N
  /// \param previous  lambda solved on the grid before, (H+1) x Nc [N]; empty on the first
  /// \param work      of the whole solve so far; counts are added to it
  [[nodiscard]] virtual GridSolution solve(const ProjectedEquations& equations, int samples,
                                           const Eigen::MatrixXcd& previous, const Start& start,
                                           Work& work) const = 0;
  /// The counts that the method reports of every solve, those without a grid included.
  [[nodiscard]] virtual Work initial_counts() const { return {}; }
};

}  // namespace signorini
