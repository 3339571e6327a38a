#pragma once
// The same orbit seen from another phase of its period, and over its least period.

#include <Eigen/Core>
#include <optional>

#include "methods/continuation/arc_length.hpp"
#include "methods/orbit/family/extended_equations.hpp"

namespace signorini {

/// The same orbit with the section at `phase` after the old one, in [0, 2 pi n), no event's.
/// \param equations  evaluated at the orbit
SequencedOrbit with_section(const SequencedOrbit& orbit, const ExtendedEquations& equations, double phase);

/// The orbit with the section in the middle of its longest time between two events.
std::optional<SequencedOrbit> with_quiet_section(OrbitFamily& family, const SequencedOrbit& orbit);

/// The orbit of the smallest period, to 1e-7 of the units, that `orbit` is a repetition of.
/// \param equations  evaluated at the orbit
SequencedOrbit of_least_period(const SequencedOrbit& orbit, const ExtendedEquations& equations);

/// Whether a curve passes an orbit of its own sequence between two of its points: where it has the parameter
/// of the orbit it has its state, at the same phase of any of its n forcing periods, to 1e-6 in CurveUnits.
/// False where the numbers of events differ.
/// The equations are left there.
bool passes(ExtendedEquations& equations, const Eigen::VectorXd& from, const Eigen::VectorXd& to,
            const SequencedOrbit& orbit);

/// y(T / 2) - y_0 in CurveUnits where the equations are evaluated, 2 Nd: on both sides of a doubling it has
/// opposite signs, for there the doubled orbit becomes itself, half a period later. Empty where half of the
/// sequence is none.
Eigen::VectorXd half_way(const ExtendedEquations& equations);

/// Where on a step, at whose end the equations are evaluated, a branch of doubled orbits meets those of half
/// the period: its length, 0 where it does and the equations are too nearly singular there to be solved,
/// empty where it does not.
///
/// \param begin  half_way at the beginning of the step
std::optional<double> half_period_on_step(ExtendedEquations& equations, const CurveStep& step,
                                          const Eigen::VectorXd& begin);

}  // namespace signorini
