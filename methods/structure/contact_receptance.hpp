#pragma once
// What the contacts of a linear structure see of it in the frequency domain.

#include <Eigen/Core>
#include <vector>

namespace signorini {

/// The structure as its contacts see it: x_n = free_n + C_n lambda_n for each harmonic n of the base
/// frequency of the motion looked for, n = 0..H.
///
/// A structure with rigid motions R, K R = 0, has no response to a mean load but one: where that is balanced,
/// R^T (f_0 + W lambda_0) = 0, its mean is x_0 = free_0 + C_0 lambda_0 + E a, E = W^T R, with any a [m
/// sqrt(kg)]: as many unknowns as equations. C_0 is then that of the held structure (`HeldStructure`).
struct ContactReceptance {
  double period = 1.0;                       ///< of the motion looked for [s]
  std::vector<Eigen::MatrixXcd> receptance;  ///< C_n = W^T Z_n^{-1} W, Nc x Nc, n = 0..H [m/N]
  Eigen::MatrixXcd free_response;            ///< free_n = W^T Z_n^{-1} f_n, (H+1) x Nc [m]
  Eigen::MatrixXd rigid = {};                ///< E, Nc x m of rank m; empty where none is felt [kg^-1/2]
  Eigen::VectorXd rigid_load = {};           ///< R^T f_0, m [N kg^-1/2]

  /// H, the highest harmonic kept.
  [[nodiscard]] int harmonics() const { return static_cast<int>(receptance.size()) - 1; }
  /// Nc.
  [[nodiscard]] int contacts() const { return static_cast<int>(free_response.cols()); }
  /// m, rigid motions that contacts feel.
  [[nodiscard]] Eigen::Index rigid_count() const { return rigid.cols(); }
};

}  // namespace signorini
