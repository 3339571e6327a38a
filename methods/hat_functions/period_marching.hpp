#pragma once
// The hat discretisation stepped in time: finds the active set where the path of pivots is too long.

#include <Eigen/Core>

#include "methods/complementarity/forms.hpp"
#include "methods/discretisation/symbols.hpp"
#include "methods/method.hpp"

namespace signorini {

/// Steps the same three-term recurrence that the periodic problem closes into a ring,
///
///     A_+ u_{k+1} + A_0 u_k + A_- u_{k-1} = f_k + W lambda_k,
///     w_k = (1 + e) g - x_{k+1} - e x_{k-1} - compliance lambda_k >= 0,  lambda_k <= 0,  lambda_k w_k = 0,
///
/// e being 0 where the stops impose none,
/// from rest until two successive periods press at the same nodes, and returns -lambda at the nodes of
/// the last one, N Nc [N]. Complete chatter, where pivoting meets as many solutions as there are bounces,
/// forgets its past within a period or two here.
/// Empty if `periods` do not suffice, the steps grow without bound, or the budget is spent.
/// \param samples  N nodes per period
Eigen::VectorXd march_to_period(const Problem& problem, HatScheme scheme, int samples,
                                const NodalStops& stops, int periods, const Start& start);

}  // namespace signorini
