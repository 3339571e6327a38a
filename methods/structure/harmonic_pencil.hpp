#pragma once
// Every harmonic's dynamic stiffness as a combination of the same two matrices, with its load.

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#include "methods/discretisation/symbols.hpp"
#include "methods/structure/bases/block_lanczos.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// One harmonic of a structure with D = alpha M + beta K: Z = kappa P + mu M with P = K + sigma M, and its
/// load F phi, F the columns of all loads.
struct HarmonicPencil {
  std::complex<double> kappa;  ///< [-]
  std::complex<double> mu;     ///< [1/s^2]
  Eigen::VectorXcd load;       ///< phi, one number per column of F; empty if the harmonic is not loaded [-]
};

/// What responses are asked for, at every harmonic.
struct PencilLoads {
  SparseMatrix columns;                  ///< [W, F], Nd x (Nc + m): contacts first
  std::vector<Eigen::VectorXcd> weight;  ///< phi of harmonics 0..H, empty where a harmonic has no load
};

/// F holds the real and imaginary parts of f_n, as far as they are not zero, n = 0..H: m <= 2 (H+1), and
/// real, so that one real Krylov space serves them all.
PencilLoads pencil_loads(const Problem& problem, int harmonics, const WeightsOfHarmonic& weights);

/// kappa = w_K + beta w_D, mu = w_M + alpha w_D - sigma kappa for the weights w of harmonics 0..H.
/// \param shift  sigma [1/s^2]
/// \throws SingularStiffness where sigma > 0, K being singular, and Z is a multiple of K
std::vector<HarmonicPencil> harmonic_pencils(const ProportionalDamping& damping, double shift, int harmonics,
                                             const WeightsOfHarmonic& weights, const PencilLoads& loads);

/// d_n of `reduced_receptance`, the least of |kappa + mu theta| between 0 and the largest of `theta`. Without
/// damping the straight line kappa + mu theta runs through the origin; then over the given theta alone.
/// \param theta  eigenvalues of the projected P^{-1} M [s^2]
/// \return [-]
double distance_from_singular(const HarmonicPencil& pencil, const Eigen::VectorXd& theta);

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

  /// Whether a pencil has not converged yet. \param n  its place among the pencils
  [[nodiscard]] bool is_open(std::size_t n) const { return !fronts_[n].converged; }

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

/// Every kappa + mu t diagonal in the eigenvectors U of t = V^T M V, and how far the projected responses are
/// from those of the whole pencil, by the bound of `reduced_receptance`.
class PencilModes {
 public:
  /// Of the space as it is. \param contacts  Nc, the first columns of the start
  PencilModes(const BlockLanczos& space, int contacts);

  /// Eigenvalues of t, rising, k [s^2].
  [[nodiscard]] const Eigen::VectorXd& theta() const { return theta_; }
  /// 1 / (kappa + mu theta), k; none where the projection is singular.
  [[nodiscard]] std::optional<Eigen::VectorXcd> inverse_of(const HarmonicPencil& pencil) const;
  /// C_n of an inverse, Nc x Nc.
  [[nodiscard]] Eigen::MatrixXcd receptance(const Eigen::VectorXcd& inverse) const;
  /// The contacts' response to the load of a pencil that has one, Nc.
  [[nodiscard]] Eigen::VectorXcd free_response(const HarmonicPencil& pencil,
                                               const Eigen::VectorXcd& inverse) const;

  /// rho_n^2 / (d_n scale), the larger of contacts and load; infinite where the projection is singular.
  struct Error {
    double all = 0.0;      ///< [-]
    double outside = 0.0;  ///< without what blocks left out: the part that further powers reduce [-]
  };
  /// That of one pencil.
  [[nodiscard]] Error relative_error(const HarmonicPencil& pencil) const;

 private:
  [[nodiscard]] Eigen::VectorXcd load_of(const HarmonicPencil& pencil) const;

  int contacts_;
  Eigen::VectorXd theta_;
  Eigen::MatrixXd rows_, contact_rows_, seen_;  // U^T V^T [W, F]; its part of W; that transposed
  Eigen::MatrixXd outside_;                     // of M times each mode, what lies outside the space
  Eigen::MatrixXd left_out_;                    // and what was left out as rounding
  Eigen::MatrixXd left_out_of_start_;
};

/// V^T W, and V^T f_n where the harmonic is loaded. \param rows  V^T [W, F] in any coordinates
Eigen::MatrixXcd start_columns(const HarmonicPencil& pencil, const Eigen::MatrixXd& rows, int contacts);

}  // namespace signorini
