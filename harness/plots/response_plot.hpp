#pragma once
// Frequency responses as `sweep --plot` draws them.

#include <string>
#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/figures/column.hpp"
#include "harness/sweep/attractors.hpp"
#include "harness/sweep/branch_response.hpp"

namespace signorini {

/// What is drawn over the parameter.
enum class ResponseOrdinate {
  amplitude,      ///< half of largest less least displacement
  once_a_period,  ///< the displacement at t = 0 of every forcing period: a bifurcation diagram; of points
                  ///< that keep their motion (CurveLimits::phases)
};

/// Amplitude over the parameter of the branches, of the contact that moves most: a colour per method; stable
/// parts solid, unstable ones dashed, those of unknown stability thin, steps of the frequency as marks;
/// special points marked by their kind.
/// \param attractors  drawn over them as points, by what each is \param parameter  of the attractors
Figure response_plot(const std::string& scene, const std::vector<MethodResponse>& responses,
                     ResponseOrdinate ordinate = ResponseOrdinate::amplitude, Column column = Column::own,
                     const std::vector<AttractorsAt>& attractors = {}, const std::string& parameter = {});

}  // namespace signorini
