#pragma once
// Every harmonic's dynamic stiffness as a combination of the same two matrices, with its load.

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "methods/structure/contact_receptance.hpp"
#include "problems/problem.hpp"
#include "problems/proportional_damping.hpp"

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

/// How far a pencil is from being singular.
struct PencilDistance {
  double least = 0.0;      ///< min |kappa + mu theta| [-]
  bool everywhere = true;  ///< over all 0 <= theta <= top, not only over the eigenvalues given
};

/// d_n of `reduced_receptance`, the least of |kappa + mu theta| between 0 and the largest of `theta`. Without
/// damping the straight line kappa + mu theta runs through the origin; then over the given theta alone.
/// \param theta  eigenvalues of the projected P^{-1} M [s^2]
PencilDistance distance_from_singular(const HarmonicPencil& pencil, const Eigen::VectorXd& theta);

}  // namespace signorini
