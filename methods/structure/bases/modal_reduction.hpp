#pragma once
// All modes of a structure that its damping does not couple, as a reduction that leaves nothing out.

#include "methods/structure/bases/reduced_structure.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Coordinates up to which all modes of any structure are found at once: a second's work.
inline constexpr int kMostModal = 400;

/// Whether all who look at a structure share its modes (`uncoupled_modes`): more than kMostModal coordinates,
/// kMostModalCoordinates at most, under a full damping matrix.
bool has_shared_modes(const Problem& problem);

/// The modes phi_k of a scene on its coordinates with mass, theta_k K phi_k = M phi_k, omega_k^2 = 1 /
/// theta_k, and C_m that of the massless coordinates alone (CondensedStructure): the whole structure, without
/// loss. In this form of the eigenvalue problem the lowest modes are the accurate ones. One dense problem,
/// O(Nd^3). Beyond kMostModal coordinates the modes are those of `uncoupled_modes`, and one whose 1 / omega^2
/// is below Nd eps of the largest moves statically, as one without mass: damping ratios leave it undamped
/// (`damping_matrix`).
///
/// An obstacle: what `condense` refuses; more than kMostModal coordinates, or kMostModalCoordinates where the
/// damping is a full matrix; matrices that are not symmetric or not definite; damping that couples modes, a
/// term d_jk above 1e-9 sqrt(d_jj d_kk) and 1e-14 of the largest, its rounding [caughey1965]; neither
/// contacts nor loads.
ContactReduction modal_reduction(const Problem& problem);

}  // namespace signorini
