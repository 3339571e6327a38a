#pragma once
// The equations of an orbit at which a test function vanishes, with two parameters among the unknowns.

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "methods/orbit/continuation/orbit_branch.hpp"
#include "methods/orbit/family/survey.hpp"

namespace signorini {

/// What a guard is where the equations are evaluated; empty where it does not exist.
std::optional<double> guard_value(const ExtendedEquations& at, const OrbitGuard& guard);

/// The families at values of the second number, all in the units of the first of them.
class OrbitPlane {
 public:
  /// \param plane  kept by the caller
  explicit OrbitPlane(const ScenePlane& plane);

  [[nodiscard]] const ScenePlane& scene() const { return plane_; }  ///< as given
  [[nodiscard]] double unit() const { return unit_; }               ///< Q: a third of its interval
  /// That at a value. Its last few are kept. \throws std::runtime_error
  std::shared_ptr<OrbitFamily> family(double second);

 private:
  const ScenePlane& plane_;
  double unit_;
  CurveUnits units_;
  std::list<std::pair<double, std::shared_ptr<OrbitFamily>>> recent_;  // latest first
};

/// In the unknowns (x, q / Q), x those of SequencedOrbit, q the second parameter, n + 2 of them:
///
///     R(x, q) = 0 (ExtendedEquations),    psi(x, q) / |psi'| = 0,
///
/// psi a test function (BifurcationTests) or a guard (OrbitSurvey). The last row of the Jacobian has psi's
/// derivatives in three directions, by central differences: the two along the surface R = 0, |psi'| there,
/// and the shortest step to it, -R_x^+ R. A step of Newton's method is a sum of these, so that no other is
/// asked.
class SpecialEquations {
 public:
  /// \param plane      kept by the caller
  /// \param guard      whose zero is kept; empty: the zero is that of the test function of `kind`
  /// \param reference  tangent of the orbit's curve over the first parameter, by which a fold is told
  SpecialEquations(OrbitPlane& plane, SequencedOrbit orbit, SpecialKind kind, std::optional<OrbitGuard> guard,
                   Eigen::VectorXd reference);

  [[nodiscard]] Eigen::Index size() const { return orbit_.x.size(); }  ///< n + 1
  /// False where R is not defined, there is no scene, or psi does not exist.
  bool evaluate(const Eigen::VectorXd& x);
  [[nodiscard]] const Eigen::VectorXd& residual() const { return here_.residual; }  ///< n + 1
  const Eigen::MatrixXd& jacobian();                                                ///< (n + 1) x (n + 2)
  [[nodiscard]] double noise() const { return here_.equations->noise(); }           ///< of R

  /// Takes |psi'| where it is evaluated; false where psi has no derivative along the surface.
  bool rescale();
  /// Takes the tangent where it is evaluated as the reference.
  void take_reference();

  [[nodiscard]] const Eigen::VectorXd& x() const { return here_.x; }               ///< of the last evaluation
  [[nodiscard]] ExtendedEquations& orbits() { return *here_.equations; }           ///< there
  [[nodiscard]] double second() const { return here_.x[size()] * plane_.unit(); }  ///< q there
  [[nodiscard]] const std::optional<OrbitGuard>& guard() const { return guard_; }  ///< as given
  [[nodiscard]] const Eigen::VectorXd& reference() const { return reference_; }    ///< as taken

 private:
  // What is known of one place.
  struct Evaluation {
    Eigen::VectorXd x, residual = {};
    std::shared_ptr<OrbitFamily> family = {};
    std::unique_ptr<ExtendedEquations> equations = {};
  };
  // Empty where there is none.
  [[nodiscard]] std::optional<Evaluation> evaluated(const Eigen::VectorXd& x, bool derivatives) const;
  std::optional<double> condition(ExtendedEquations& at) const;
  [[nodiscard]] bool needs_derivatives() const { return guard_ || kind_ != SpecialKind::phase_resonance; }
  void differentiate();

  OrbitPlane& plane_;
  SequencedOrbit orbit_;
  SpecialKind kind_;
  std::optional<OrbitGuard> guard_;
  Eigen::VectorXd reference_;
  double scale_ = 1.0, slope_ = 0.0;  // the latter |psi'| over the former
  Evaluation here_;
  Eigen::MatrixXd jacobian_;
};

}  // namespace signorini
