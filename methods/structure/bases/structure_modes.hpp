#pragma once
// All modes of a structure that its damping does not couple.

#include <Eigen/Core>
#include <memory>

#include "problems/problem.hpp"

namespace signorini {

/// Psi with Psi^T (K + s M) Psi = 1 on which M, D and K are diagonal at once, motions without mass included:
///
///     (w_M M + w_D D + w_K K)^-1 = Psi diag(1 / (w_M m_k + w_D d_k + w_K k_k)) Psi^T.
///
/// s is 0 where K is definite, else the mean of the squared frequencies. In this form of the eigenvalue
/// problem the lowest modes are the accurate ones, and statics are exact where s is 0.
struct StructureModes {
  Eigen::MatrixXd vectors;    ///< Psi, Nd x Nd
  Eigen::VectorXd mass;       ///< m_k >= 0, rising [s^2]
  Eigen::VectorXd damping;    ///< d_k >= 0 [s]
  Eigen::VectorXd stiffness;  ///< k_k = 1 - s m_k [-]
  double shift = 0.0;         ///< s [1/s^2]
};

/// The modes of a structure of any size, by one dense eigenvalue problem, O(Nd^3): 1,000 coordinates take a
/// second or two. The last ones made are kept for as long as their structure lives; threads may call it.
/// \return null where the matrices are not symmetric, K + s M is not definite, or the damping couples modes,
/// a term d_jk above 1e-9 sqrt(d_jj d_kk) and rounding [caughey1965]; in bending of slender beams, 250
/// elements and more, rounding itself couples them
std::shared_ptr<const StructureModes> uncoupled_modes(const Problem& problem);

/// Whether damping is so full a matrix, as that of damping ratios is, that no factor of Z_n is sparse.
bool has_full_damping(const Problem& problem);

}  // namespace signorini
