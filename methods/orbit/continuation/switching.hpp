#pragma once
// Where a branch doubles or is crossed: the starts of those that leave it.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "methods/orbit/continuation/curve.hpp"

namespace signorini {

/// What tells orbits of a parametrised scene apart.
struct OrbitMark {
  double parameter = 0.0;  ///< in units of the curve [-]
  int order = 1;           ///< forcing periods [-]
  /// Kind and contact of each event, and its approach speed over V [-], sorted.
  std::vector<std::pair<int, double>> events = {};
  /// Kind and contact of each event in their order in time, from after the longest break between two, of
  /// several the one from which this list is least.
  std::vector<int> order_of_events = {};
  /// To 1e-6 in the parameter and 1e-4 in the speeds, or `loosely` to a hundred times that.
  [[nodiscard]] bool same(const OrbitMark& other, bool loosely = false) const;
};

/// Of the orbit at which the equations are evaluated.
OrbitMark mark_of(const ExtendedEquations& equations);

/// How far beside an orbit it is told what grows along a curve [CurveUnits]
inline constexpr double kBeside = 1e-6;
/// Speeds over V, and lengths of phases of contact [rad], below which these have just begun
inline constexpr double kNew = 1e-7;

/// A quantity of an orbit where the equations are evaluated.
using OrbitQuantity = std::function<double(const ExtendedEquations&)>;

/// A guard, NaN where it does not exist.
OrbitQuantity quantity_of(GuardKind kind, int index);

/// A start at `orbit` along the curve on the side where a quantity that vanishes there grows; empty where the
/// equations cannot be evaluated.
std::optional<CurveStart> start_where_grows(OrbitFamily& family, const SequencedOrbit& orbit,
                                            const OrbitQuantity& quantity, std::string origin);

/// A start at an orbit of a free motion with impacts of no speed, or phases of contact of no length, along
/// the way on which all of these grow alike: of symmetric motions more than one curve goes through it, as
/// each speed or length enters squared, so that [R_x; conditions] has a null space of more than one
/// dimension. Empty where it has none on which all grow, or the equations cannot be evaluated.
std::optional<CurveStart> start_growing(OrbitFamily& family, const SequencedOrbit& orbit, std::string origin);

/// The start with impacts of one instant, those that do not feel each other through the mass, in the order in
/// which they part along its tangent.
CurveStart in_order_along(OrbitFamily& family, CurveStart start);

/// The doubled orbit at an orbit with a multiplier -1, and the way to it: with M phi = -phi and the instants
/// following by dtheta = -(dh/dtheta)^-1 (dh/dy) phi, along (phi, dtheta, -dtheta, 0). The other way leads to
/// the same orbits, one period later. Impacts of one instant take the order in which they part on it.
std::optional<CurveStart> start_doubled(OrbitFamily& family, const SequencedOrbit& orbit);

/// At a branch point both ways along the other curve through it. Where impacts of one instant part along it,
/// each way is that of the order in which they do: what crosses the symmetric orbits of another order is
/// solved for with its equations.
///
/// \param across  its unit tangent
std::vector<CurveStart> start_crossing(OrbitFamily& family, const SequencedOrbit& orbit,
                                       const Eigen::VectorXd& across);

}  // namespace signorini
