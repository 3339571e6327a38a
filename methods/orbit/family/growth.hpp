#pragma once
// Where events begin on free motions: the way on which they grow.

#include <Eigen/Core>
#include <optional>

#include "methods/orbit/family/orbit_family.hpp"
#include "methods/orbit/family/sequenced_orbit.hpp"

namespace signorini {

/// The unit tangent of the curve at an orbit of a free motion with impacts of no speed, or phases of contact
/// of no length, along which all of these grow alike: of symmetric motions more than one curve goes through
/// it, as each speed or length enters squared, so that [R_x; conditions] has a null space of more than one
/// dimension. Empty where it has none on which all grow, or the equations cannot be evaluated.
std::optional<Eigen::VectorXd> way_of_growth(OrbitFamily& family, const SequencedOrbit& orbit);

}  // namespace signorini
