#pragma once
// The free motions of a damped structure as a sum of exponentials.

#include <optional>

#include "methods/linear_flow/modes/energy_form.hpp"
#include "methods/linear_flow/modes/weak_coupling.hpp"

namespace signorini {

/// The modes. Where damping couples no undamped modes, each of these is an oscillator by itself, in closed
/// form: K~ phi_k = l_k phi_k, mu^2 + d_k mu + l_k = 0, d_k = phi_k^T D~ phi_k. So they are taken where the
/// coupling is within the rounding of D (in norm, 2 epsilon times the largest d_k) and K~ is symmetric and
/// definite, its l_k within a factor of 9e3 / Nr. Of more than 12 coordinates damping may couple the undamped
/// modes weakly, each by at most a quarter of another: they are repeated upon until nothing changes. All
/// others are found in the coordinates of the energy (EnergyForm with `rate`), with long double for up to 12
/// coordinates. None where they are ill-conditioned
/// (critical damping, a rigid-body motion: three digits would cancel between them, four of more than 12
/// coordinates) or M or K~ + rate^2 is not definite.
std::optional<ComplexModes> complex_modes(const MassForm& form, double rate);

}  // namespace signorini
