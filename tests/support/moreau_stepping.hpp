#pragma once
// Moreau-Jean time stepping of inelastic contact (e = 0): an independent scheme, first order in the step.

#include <Eigen/Core>
#include <vector>

#include "problems/problem.hpp"

namespace signorini::test {

/// Marches from rest with `steps` steps per forcing period,
///
///     M (v_{k+1} - v_k) = h (f - K u - D v)(midpoint) + W p,   u_{k+1} = u_k + h (v_k + v_{k+1}) / 2,
///
/// contacts whose predicted u_k + h/2 v_k touches getting the impulses p <= 0 with W^T v_{k+1} <= 0
/// complementary (solved by trying all sets). No event is located; sticking follows from p.
/// \return x of the contacts over the last of `periods` periods, steps x Nc
Eigen::MatrixXd moreau_steady_state(const Problem& problem, int steps, int periods);

}  // namespace signorini::test
