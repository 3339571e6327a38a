#pragma once
// The instants of events as they follow from the state at the section.

#include <Eigen/Core>
#include <optional>

#include "methods/orbit/family/sequenced_orbit.hpp"

namespace signorini {

/// The phases at which the events of a sequence follow one another from the state of x, m [rad]: each is the
/// zero of its own equation (x_j = g_j, or lambda_j = 0 of an opening) next to where the shift of the one
/// before puts it, or, of a flight between two impacts that is short, next to 2 v / a after the last.
///
/// Between the last impacts of a chatter flights are shorter than the error of any step that moves all
/// unknowns at once.
///
/// \param model  at the parameter of x
/// \param orbit  its sequence, with the restitution of the model
/// \param x      unknowns of SequencedOrbit
/// \return empty where an event is not found, farther than 0.2 rad away, or not after the one before
/// \throws std::runtime_error if a flow cannot be formed
std::optional<Eigen::VectorXd> event_instants(OrbitModel& model, const SequencedOrbit& orbit,
                                              const CurveUnits& units, const Eigen::VectorXd& x);

}  // namespace signorini
