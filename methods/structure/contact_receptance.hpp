#pragma once
// What the contacts of a linear structure see of it in the frequency domain.

#include <Eigen/Core>
#include <vector>

namespace signorini {

/// The structure as its contacts see it: x_n = free_n + C_n lambda_n for each harmonic n of the base
/// frequency of the motion looked for, n = 0..H.
struct ContactReceptance {
  double period = 1.0;                       ///< of the motion looked for [s]
  std::vector<Eigen::MatrixXcd> receptance;  ///< C_n = W^T Z_n^{-1} W, Nc x Nc, n = 0..H [m/N]
  Eigen::MatrixXcd free_response;            ///< free_n = W^T Z_n^{-1} f_n, (H+1) x Nc [m]

  /// H, the highest harmonic kept.
  [[nodiscard]] int harmonics() const { return static_cast<int>(receptance.size()) - 1; }
  /// Nc.
  [[nodiscard]] int contacts() const { return static_cast<int>(free_response.cols()); }
};

}  // namespace signorini
