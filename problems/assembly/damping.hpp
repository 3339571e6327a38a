#pragma once
// Damping matrices made from mass and stiffness: Rayleigh's, and the one with given ratios per mode.

#include <variant>
#include <vector>

#include "problems/matrix_properties.hpp"

namespace signorini {

/// D = sum over modes of 2 zeta_i w_i M phi_i phi_i^T M, phi_i^T M phi_i = 1, K phi_i = w_i^2 M phi_i.
struct ModalDamping {
  std::vector<double>
      ratios;  ///< zeta_i >= 0 [-], modes by rising frequency; the last one holds for all further
};

/// alpha, beta >= 0 in ProportionalDamping.
using DampingModel = std::variant<ProportionalDamping, ModalDamping>;

/// Largest number of coordinates for modal damping: it takes all modes, by dense arrays. A full D of so many
/// has 48 MB, and they take some ten seconds.
inline constexpr int kMostModalCoordinates = 2000;

/// D, Nd x Nd [N s/m], symmetric positive semi-definite. M and K are symmetric positive semi-definite without
/// a common null vector. Modes without mass (and what rounding cannot tell from them: more than about 1e7
/// times the lowest frequency) are not damped by ModalDamping; nor are rigid-body motions, whose w is 0.
/// \throws std::invalid_argument beyond kMostModalCoordinates, or if the eigenvalue problem breaks down
SparseMatrix damping_matrix(const DampingModel& model, const SparseMatrix& mass,
                            const SparseMatrix& stiffness);

}  // namespace signorini
