#pragma once
// The linear structure in the frequency domain, reduced to its contacts [shi2015, section 5].

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "methods/discretisation/symbols.hpp"

namespace signorini {

/// The weights that a discretisation gives harmonic n = 0..H.
using WeightsOfHarmonic = std::function<HarmonicWeights(int)>;

/// How receptances are found: by dense or sparse factorisation of each Z_n, or by projection
/// (`reduced_receptance`).
enum class ReceptanceMethod { automatic, dense, direct, reduced };

/// How receptances were found, and with which error.
struct ReceptanceReport {
  ReceptanceMethod method = ReceptanceMethod::dense;  ///< never automatic
  int basis = 0;                                      ///< coordinates of the projection, 0 without one [-]
  std::optional<double> error = {};  ///< of C_n by projection, relative to |C_n|_F, the worst n [-]
  bool bound = false;                ///< true if `error` is a bound, false if it is an estimate
};

/// The structure as its contacts see it: x_n = free_n + C_n lambda_n for each harmonic n of the base
/// frequency of the motion looked for, n = 0..H.
struct ContactReceptance {
  double period = 1.0;                       ///< of the motion looked for [s]
  std::vector<Eigen::MatrixXcd> receptance;  ///< C_n = W^T Z_n^{-1} W, Nc x Nc, n = 0..H [m/N]
  Eigen::MatrixXcd free_response;            ///< free_n = W^T Z_n^{-1} f_n, (H+1) x Nc [m]
  ReceptanceReport report = {};              ///< how they were found

  /// H, the highest harmonic kept.
  [[nodiscard]] int harmonics() const { return static_cast<int>(receptance.size()) - 1; }
  /// Nc.
  [[nodiscard]] int contacts() const { return static_cast<int>(free_response.cols()); }
};

/// x_n = free_n + C_n lambda_n, n = 0..H: the motion at the contacts under their forces, (H+1) x Nc [m].
/// \param lambda  coefficients of the contact forces, n = 0..H at least, Nc columns [N]
Eigen::MatrixXcd contact_motion(const ContactReceptance& receptance, const Eigen::MatrixXcd& lambda);

}  // namespace signorini
