#pragma once
// A response as a terminal shows it: where branches begin, change and end, instead of all their points.

#include <string>
#include <vector>

#include "harness/sweep/branch_response.hpp"

namespace signorini {

/// Of each method its branches, each with its number of points and their stability, its ends with their
/// reasons and its special points, with the parameter and the amplitude there; steps of the frequency, and
/// points at values asked for, as rows. In lines of 80 columns.
std::string sweep_text(const std::vector<MethodResponse>& responses);

/// Why a response is not all that was asked for, a line for each reason: "closed-hbm: 21 of 21 points
/// not-applicable: contacts of different laws", values asked for that no branch reaches, `incompleteness`,
/// and what is unfinished where there is no branch.
/// \param values  of the parameter asked for (points_at); empty: the whole interval
std::vector<std::string> shortcomings(const MethodResponse& response, const std::vector<double>& values);

}  // namespace signorini
