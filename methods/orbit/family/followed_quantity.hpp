#pragma once
// What a curve of orbits is followed over: the parameter, or of free motions their energy.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/continuation/arc_length.hpp"
#include "methods/continuation/interval_gaps.hpp"
#include "methods/orbit/family/extended_equations.hpp"

namespace signorini {

/// 1/2 v^T M v + 1/2 u^T K u - f_0^T u and, of the springs of closed contacts, 1/2 lambda^T C lambda [J]:
/// what a free motion keeps.
double energy_of(const OrbitModel& model, const FlowState& at);

/// The parameter of a family, or the energy of its free motions, as a function of the unknowns of a curve,
/// with the interval in which it is followed.
class FollowedQuantity {
 public:
  /// \param family    kept by the caller
  /// \param energies  the interval of the energy [J]; empty: the parameter in that of its scene
  FollowedQuantity(const OrbitFamily& family, const std::optional<ParameterRange>& energies);

  /// Its value at x, where the equations have the sequence of the curve.
  [[nodiscard]] double at(const ExtendedEquations& equations, const Eigen::VectorXd& x) const;
  /// The first of several values, or the end of the interval, that lies between `begin` and where the
  /// equations are evaluated (`first_target`).
  [[nodiscard]] std::optional<StepTarget> target(const std::vector<double>& values,
                                                 const ExtendedEquations& equations,
                                                 const Eigen::VectorXd& begin) const;
  /// The length of a step, at whose end the equations are evaluated, at which it has a value; they are left
  /// there. Empty where it cannot be found.
  [[nodiscard]] std::optional<double> length_to(double value, ExtendedEquations& equations,
                                                const CurveStep& step) const;
  /// A step that would leave the interval of the parameter, shortened to its end: beyond there may be no
  /// scene, as of dampers below 0. \param length  of the step from `x` along `tangent`, and then that to the
  /// end, which lies in its plane \return the Newton steps; `equations` are left evaluated at the end. Empty
  /// where the step does not get there
  std::optional<int> land(ExtendedEquations& equations, const Eigen::VectorXd& x,
                          const Eigen::VectorXd& tangent, double& length) const;
  /// Whether it passes one of several values forth and back on such a step. \param tangent  at its end
  [[nodiscard]] bool turns(const std::vector<double>& values, const ExtendedEquations& equations,
                           const CurveStep& step, const Eigen::VectorXd& tangent) const;

 private:
  // Both quantities are at most quadratic: the difference is exact.
  [[nodiscard]] double rate(const ExtendedEquations& equations, const Eigen::VectorXd& x,
                            const Eigen::VectorXd& way) const;

  const OrbitFamily& family_;
  bool of_energy_;
  ParameterRange range_;
};

}  // namespace signorini
