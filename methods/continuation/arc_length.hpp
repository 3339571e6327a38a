#pragma once
// One step of pseudo-arclength continuation: tangent, corrector, step control, and a zero along the step.

#include <Eigen/Core>
#include <algorithm>
#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace signorini {

class LuFactors;

/// n equations R(x) = 0 in n + 1 unknowns, the parameter of the curve as the last one, in units in which
/// lengths along the curve mean something: the norm is Euclidean.
template <class Equations>
concept CurveEquations = requires(Equations& equations, const Eigen::VectorXd& x) {
  // n.
  { equations.size() } -> std::convertible_to<Eigen::Index>;
  // Takes x; false where R is not defined or not finite there.
  { equations.evaluate(x) } -> std::convertible_to<bool>;
  // R, n, where evaluated last.
  { equations.residual() } -> std::convertible_to<Eigen::VectorXd>;
  // [dR/dx], n x (n + 1), there.
  { equations.jacobian() } -> std::convertible_to<Eigen::MatrixXd>;
  // What rounding makes of R there.
  { equations.noise() } -> std::convertible_to<double>;
};

/// Equations of any kind as functions, which are compiled once: those of an object that the caller keeps.
/// Beside what all CurveEquations have, some
///
/// - hold conditions C (x - predicted) = 0 along a step, as they leave more than one direction free and one
/// of
///   them follows from the others for each, as of motions that may begin at any phase: `conditions()`, C,
///   k x (n + 1), k = 0 included;
/// - have unknowns that follow from the others so steeply that they are put in their places before each
///   evaluation of the corrector: `settle(x)`;
/// - have a residual that is cheaper alone: `evaluate_motion(x)` takes x as `evaluate` does, and the Jacobian
///   is then that of another point.
struct AnyEquations {
  template <CurveEquations Equations>
  requires(!std::same_as<const Equations, const AnyEquations>) AnyEquations(Equations& equations)
      : size([&] { return static_cast<Eigen::Index>(equations.size()); }),
        evaluate([&](const Eigen::VectorXd& x) { return equations.evaluate(x); }),
        residual([&]() -> Eigen::VectorXd { return equations.residual(); }),
        jacobian([&]() -> Eigen::MatrixXd { return equations.jacobian(); }),
        conditions([&] { return Eigen::MatrixXd(0, equations.size() + 1); }),
        noise([&] { return equations.noise(); }) {
    if constexpr (requires { equations.conditions(); })
      conditions = [&]() -> Eigen::MatrixXd { return equations.conditions(); };
    if constexpr (requires(Eigen::VectorXd x) { equations.settle(x); })
      settle = [&](Eigen::VectorXd& x) { equations.settle(x); };
    evaluate_residual = evaluate;
    if constexpr (requires(Eigen::VectorXd x) { equations.evaluate_motion(x); })
      evaluate_residual = [&](const Eigen::VectorXd& x) { return equations.evaluate_motion(x); };
  }

  std::function<Eigen::Index()> size;
  std::function<void(Eigen::VectorXd& x)> settle = [](Eigen::VectorXd&) {};
  std::function<bool(const Eigen::VectorXd& x)> evaluate;           ///< as the concept has it
  std::function<bool(const Eigen::VectorXd& x)> evaluate_residual;  ///< where they can, R alone
  std::function<Eigen::VectorXd()> residual;                        ///< R
  std::function<Eigen::MatrixXd()> jacobian;                        ///< [R_x]
  std::function<Eigen::MatrixXd()> conditions;                      ///< C, of no rows where they hold none
  std::function<double()> noise;                                    ///< of R
};

/// The matrix [R_x; row; C] of a step: n + 1 square, or higher where conditions are held.
Eigen::MatrixXd bordered_jacobian(const AnyEquations& equations, const Eigen::VectorXd& row);

/// The x of B x = (right; last; 0) for a matrix of bordered_jacobian: LU with pivoting, or least squares
/// where conditions are held, which solve all rows as these are consistent.
Eigen::VectorXd solve_bordered(const Eigen::MatrixXd& B, const Eigen::VectorXd& right, double last);

/// Factors of [R_x; row] where equations without conditions are evaluated, and what they tell of the curve.
class CurveFactors {
 public:
  /// \param row  the tangent of a point near
  CurveFactors(const AnyEquations& equations, const Eigen::VectorXd& row);

  /// As tangent_of, `row` the previous tangent.
  [[nodiscard]] std::optional<Eigen::VectorXd> tangent() const;
  /// The x of [R_x] x = right in the plane normal . x = 0; not finite where there is none.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right, const Eigen::VectorXd& normal) const;
  /// det [R_x; tangent^T] over the norms of its rows [-].
  [[nodiscard]] double relative_determinant() const;

 private:
  std::shared_ptr<const LuFactors> factors_;
  Eigen::VectorXd along_;  // [R_x] along = 0, row . along = 1
  double norms_;           // log of the product of those of the rows of [R_x]
};

/// When the corrector stops, and how it goes.
struct CorrectorLimits {
  int iterations = 7;        ///< Newton steps at most
  double tolerance = 2e-13;  ///< of R, relative to the largest unknown [-]
  /// Of a point near the one wanted: equations are solved by Broyden's method from its Jacobian, where the
  /// residual does not fall fast from that at the predicted point, and by Newton's where both fail. One or
  /// two Jacobians per point in place of three.
  const CurveFactors* near = nullptr;
};

/// Of points that are located.
inline constexpr CorrectorLimits kTight{.iterations = 14, .tolerance = 1e-14};

/// To the point of the curve in the plane tangent . (x - predicted) = 0, by full Newton steps on [R; plane]
/// with the Jacobian [R_x; tangent^T] and the conditions held, if any. Steps are not shortened: where
/// Newton's method fails the caller shortens the step along the curve.
///
/// Converged: |R| <= tolerance max(1, |x|), or no longer falling and either within a hundred times its noise
/// or after a step of less than 1e-10 max(1, |x|).
///
/// \return the Newton steps, three secant steps counted as one; `equations` are left evaluated at the point.
///         Empty where it fails.
std::optional<int> correct(const AnyEquations& equations, const Eigen::VectorXd& predicted,
                           const Eigen::VectorXd& tangent, const CorrectorLimits& limits = {});

/// The point of the curve nearby where the parameter is what it is in `predicted`.
std::optional<int> correct_at_parameter(const AnyEquations& equations, const Eigen::VectorXd& predicted);

/// The unit null vector of [R_x] where the equations are evaluated, on the side of `previous`; empty where
/// the bordered matrix is singular.
std::optional<Eigen::VectorXd> tangent_of(const AnyEquations& equations, const Eigen::VectorXd& previous);

/// The same without a predecessor: the right singular vector of the smallest singular value, of either sign.
Eigen::VectorXd first_tangent(const AnyEquations& equations);

/// The same of the sign that leads to larger parameters, or to smaller ones.
Eigen::VectorXd first_tangent(const AnyEquations& equations, bool larger);

/// How long steps along a curve are, and which are refused. Lengths are in the units of the unknowns.
struct StepRules {
  double first = 0.01;     ///< length of the first step
  double longest = 0.1;    ///< of any, times CurveLimits::step_share
  double shortest = 1e-6;  ///< below, the curve has broken
  double any_turn = 0.0;   ///< a step as short as this may turn by any angle
  double turned = 0.35;    ///< angle by which the tangent may turn [rad]
  double far = 2.0;        ///< how far Newton's method may lead, over the step's length [-]
  double moved = 0.1;      ///< part of a motion that may change [-]
  double small = 0.05;     ///< size of the least motion that counts there, over the unit of displacement [-]

  /// Whether a motion is too far from the one before to be its neighbour. \param least  size of the least
  /// motion that counts
  [[nodiscard]] bool moves_too_far(const auto& motion, const auto& before, double least) const {
    return (motion - before).norm() > moved * std::max(before.norm(), least);
  }
};
/// Of curves of a method's own equations.
inline constexpr StepRules kMethodSteps{};

/// The length of the next step after one that took so many Newton steps and turned by so much.
/// \param turn  angle between the tangents at both ends [rad]
double next_step(double length, int iterations, double turn, double largest);

/// The longest step where the unknowns have this size: `usual` up to a few units, beyond a share of the size,
/// so that a curve reaches any peak in steps that grow with it. Both in the units of the unknowns.
double longest_step(double usual, double size);

/// The size of the unknowns beyond which a curve is followed no further, in their units.
inline constexpr double kMostGrown = 1e6;
/// Why a curve ends there.
inline constexpr const char* kGrown = "the motion is more than a million times the unit of the curve";

/// A value of the parameter at which a step has to end.
struct StepTarget {
  double value = 0.0;
  bool leaves = false;  ///< it is an end of the interval, which the step leaves
};

/// What a step from one value of the parameter to another meets first of several values and the ends of an
/// interval; empty where it meets none. A value at which the step begins, to 1e-12 of the interval, does not
/// count.
std::optional<StepTarget> first_target(const std::vector<double>& values, double low, double high,
                                       double begin, double end);

/// One end of a step: the parameter, and its derivative by the length of the step.
struct ParameterAt {
  double value = 0.0, rate = 0.0;
};

/// Whether the parameter turns on a step so that one of several values is passed forth and back, which its
/// ends do not tell: beyond a value on whose one side both of them lie, or back over one at which the step
/// begins. The parameter on the step is taken as the cubic through both ends.
bool turns_past(const std::vector<double>& values, double low, double high, const ParameterAt& begin,
                const ParameterAt& end);

/// A point of a curve with its tangent, and the step from there that leads to the next one.
struct CurveStep {
  Eigen::VectorXd x, tangent;
  double length = 0.0;  ///< along the tangent
  /// Whether `locate` finds its points by secants from the Jacobian at the first of them: where R alone is
  /// much cheaper, no conditions are held, and nothing begins at x.
  bool by_secants = false;
};

/// The zero of f between the beginning of a step, where it has the value `first`, and its end, where it is
/// `last` of the other sign: Illinois' rule on the length of the step, each evaluation a corrector of its
/// own, which begins at what the ones before predict. Where f does not exist at the beginning, the step is
/// halved until f exists with the other sign; where it never does, the zero is where it begins to exist.
///
/// \param f  of the point at which the equations are evaluated; a template's takes these
/// \return the length; `equations` are left evaluated there. Empty where it cannot be found.
std::optional<double> locate(const AnyEquations& equations, const CurveStep& step,
                             const std::function<std::optional<double>(const Eigen::VectorXd& x)>& f,
                             std::optional<double> first, double last);
template <CurveEquations Equations, std::invocable<Equations&> Function>
std::optional<double> locate(Equations& equations, const CurveStep& step, const Function& f,
                             std::optional<double> first, double last) {
  const auto at = [&](const Eigen::VectorXd&) -> std::optional<double> { return f(equations); };
  return locate(AnyEquations(equations), step, at, first, last);
}

/// The length of a step up to where the parameter, the last of the unknowns, takes a value.
/// \param end  of the step, on the other side of the value
/// \return the length; `equations` are left evaluated there. Empty where it cannot be found.
std::optional<double> length_to_parameter(const AnyEquations& equations, const CurveStep& step,
                                          const Eigen::VectorXd& end, double value);

}  // namespace signorini
