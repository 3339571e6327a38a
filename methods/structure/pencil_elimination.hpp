#pragma once
// Whether a growing projection suffices for every harmonic, found as it grows.

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "methods/structure/block_lanczos.hpp"
#include "methods/structure/harmonic_pencil.hpp"

namespace signorini {

/// Block elimination of kappa + mu t, t = V^T M V block tridiagonal, for all harmonics at once: one block per
/// growth of the space. The residual of a projected response depends on its part in the newest block alone,
/// and that part is what forward elimination has at hand; so each step costs O(k^3) per harmonic for blocks
/// of k columns, where diagonalising t anew would cost the cube of its size. Rounding and what Lanczos'
/// method left out are not seen here: the bound itself is checked afterwards.
class PencilElimination {
 public:
  /// Begins with the first block of the space. \param contacts  Nc, the first columns of the start
  PencilElimination(const BlockLanczos& space, const std::vector<HarmonicPencil>& pencils, int contacts);

  /// Eliminates the newest block for every harmonic that has not converged: the estimate of rho_n^2 is above
  /// tolerance * d_n * scale. True if all have.
  /// \param theta  eigenvalues of a projected P^{-1} M, for d_n
  bool advance(double tolerance, const Eigen::VectorXd& theta);

  /// Takes up the block by which the space has grown.
  void take_newest_block();

 private:
  /// One harmonic's elimination.
  struct Front {
    Eigen::MatrixXcd pivot;           // the newest diagonal block after elimination of all before
    Eigen::MatrixXcd rest;            // its right-hand side, for each column of W and for the load, if any
    Eigen::MatrixXcd seen;            // W^T V (kappa + mu t)^{-1} V^T W so far
    std::complex<double> self = 0.0;  // the same of the load, transposed without conjugation
    bool converged = false;
  };

  void advance(Front& front, const HarmonicPencil& pencil, const Eigen::MatrixXcd& coupling,
               double least) const;

  const BlockLanczos& space_;
  const std::vector<HarmonicPencil>& pencils_;
  int contacts_;
  std::vector<Front> fronts_;
};

/// V^T W, and V^T f_n where the harmonic is loaded. \param rows  V^T [W, F] in any coordinates
Eigen::MatrixXcd start_columns(const HarmonicPencil& pencil, const Eigen::MatrixXd& rows, int contacts);

}  // namespace signorini
