#pragma once
// The discrete problem of hat-lcp under backward differences of second order, solved by marching.

#include <memory>

#include "methods/method.hpp"
#include "methods/structure/contact_reduction.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// The reduction that `marched_contact` steps: with twelve powers of contacts and loads, at least 120
/// vectors, where few contacts act (ReductionBasis), else the lowest 150. Empty where the scene cannot be
/// marched: an impact law (`march_obstacle`), or what `reduce_to_contacts` does not take.
std::shared_ptr<const ContactReduction> marched_reduction(const Problem& problem);

/// The scene on N nodes under HatScheme::bdf2, ready to be solved by `march_to_periodic_motion`: the problem
/// that `hat_contact` poses as one of complementarity over the whole period, in the coordinates of the
/// reduction. Its cost is linear in N and does not grow with the time that contacts stay closed.
/// \param samples    N >= 4
/// \param tolerance  of the period's return, relative in units of energy [-]
/// \param reduction  of the problem, not null
std::unique_ptr<PreparedMethod> marched_contact(const Problem& problem, int samples, double tolerance,
                                                std::shared_ptr<const ContactReduction> reduction);

}  // namespace signorini
