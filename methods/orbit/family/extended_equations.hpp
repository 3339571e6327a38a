#pragma once
// The equations of an orbit with the parameter among the unknowns.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "methods/orbit/family/sequenced_orbit.hpp"

namespace signorini {

/// The steps of forward differences along curves [CurveUnits]
inline constexpr double kDifference = 1e-7;

/// OrbitEquations of a sequence, Ns + m of them, in the unknowns x of SequencedOrbit: R(x) = 0 is a curve
/// where [dR/dy, dR/dtheta, dR/dp] has full rank. With phases of the events as unknowns it is smooth through
/// the grazing of an impact, and says nothing of admissibility (`survey`).
///
/// At springs and undamped massless contacts the equation of an event i that follows another one of the same
/// contact, without a third between them, is replaced by the divided difference
///
///     (z(theta_i) - z(theta_{i-1})) / (theta_i - theta_{i-1}) = 0,
///
/// z = lambda_j of an opening, x_j - g_j of a closing, on the arc between the two: the same solutions, for
/// z(theta_{i-1}) = 0 is the equation before, and regular where the phase of contact begins, with the length
/// 0. At rigid stops likewise where a flight of less than .1 rad begins at rest on the stop and ends at event
/// i: after an impact without restitution, or an opening, z = x_j - g_j has a double, or threefold, zero at
/// theta_{i-1}; a double one where a damped stop opens. With l = theta_i - theta_{i-1}, k = 2 or 3, the
/// equation is
///
///     (z(theta_i) - sum_{q<k} z^(q)(theta_{i-1}) l^q / q!) / l^k = 0.
///
/// dR/dp is a forward difference of R over 1e-7 P. Its error tilts the tangent by as much and delays Newton's
/// method by as little; no point of the curve is moved by it.
class ExtendedEquations {
 public:
  /// \param family  kept by the caller
  ExtendedEquations(OrbitFamily& family, SequencedOrbit orbit);
  ~ExtendedEquations();
  ExtendedEquations(const ExtendedEquations&) = delete;
  ExtendedEquations& operator=(const ExtendedEquations&) = delete;

  [[nodiscard]] Eigen::Index size() const { return orbit_.x.size() - 1; }  ///< Ns + m
  /// Evaluates R and its derivative but for dR/dp at x, or goes back there if no other x has had these since;
  /// false where anything is not finite or a flow cannot be formed.
  bool evaluate(const Eigen::VectorXd& x);
  /// Evaluates R and the arcs alone; until the next `evaluate` `jacobian` is that of the last one, and
  /// `monodromy` undefined.
  bool evaluate_motion(const Eigen::VectorXd& x);
  /// Of sequences that end a complete chatter: puts the instants of x where `event_instants` has them, before
  /// an evaluation within Newton's method; leaves x as it is where they are not to be had.
  void settle(Eigen::VectorXd& x);
  [[nodiscard]] const Eigen::VectorXd& residual() const { return residual_; }  ///< R, Ns + m [-]
  /// [dR/dy, dR/dtheta, dR/dp], (Ns + m) x (Ns + m + 1) [-]. dR/dp is evaluated anew where x has moved by
  /// more than 1e-6 since.
  const Eigen::MatrixXd& jacobian();
  /// The same with dR/dp by a central difference of fourth order over 1e-4 P, good to about 1e-10: where the
  /// rank of [R_x] is the question. NaN where there is no scene beside p.
  Eigen::MatrixXd accurate_jacobian() const;

  /// Free motions (OrbitFamily::driven) have a phase too many and, as energy is kept, an equation too many:
  /// along a step their first event stays at its phase. One row of Ns + m + 1; none of driven motions.
  [[nodiscard]] Eigen::MatrixXd conditions() const;

  /// What rounding makes of R: arcs cancel in it [-].
  [[nodiscard]] double noise() const { return equations_->noise(); }

  [[nodiscard]] OrbitFamily& family() const { return family_; }
  /// The sequence, and x of the last evaluation.
  [[nodiscard]] const SequencedOrbit& orbit() const { return orbit_; }
  [[nodiscard]] double parameter() const;                            ///< p of the last evaluation
  [[nodiscard]] double frequency() const;                            ///< omega there [rad/s]
  [[nodiscard]] const OrbitModel& model() const { return *model_; }  ///< there
  [[nodiscard]] const std::shared_ptr<OrbitModel>& shared_model() const { return model_; }  ///< there
  [[nodiscard]] const OrbitEquations& equations() const { return *equations_; }             ///< there
  /// The speed at which event i strikes its stop, over V [-].
  [[nodiscard]] double speed(Eigen::Index i) const {
    return equations_->crossings()[static_cast<std::size_t>(i)].approach / family_.units().velocity;
  }
  /// The motion after i events.
  [[nodiscard]] const LinearArc& arc(Eigen::Index i) const {
    return *equations_->arcs()[static_cast<std::size_t>(i)];
  }
  /// Phase after the section at a time of the arcs of `equations` [rad].
  [[nodiscard]] double phase_of(double time) const { return time * frequency() - orbit_.section; }
  /// Time of a phase after the section in the arcs [s].
  [[nodiscard]] double time_of(double phase) const { return (orbit_.section + phase) / frequency(); }
  /// The state (u / X, v / V) at a phase after the section, in [0, 2 pi n].
  [[nodiscard]] Eigen::VectorXd state_at(double phase) const;
  /// dy(2 pi n) / dy(0), Ns x Ns, in CurveUnits; empty at the grazing of a stop that halts its contact.
  [[nodiscard]] Eigen::MatrixXd monodromy() const;

 private:
  bool take(const Eigen::VectorXd& x, bool derivatives);
  // The equations of the sequence at a value of the parameter, evaluated at x; empty where they are not
  // finite.
  std::unique_ptr<OrbitEquations> evaluated(OrbitModel& model, const Eigen::VectorXd& x,
                                            bool derivatives = true) const;
  // CurveUnits over those of the model, of the first Ns unknowns.
  [[nodiscard]] Eigen::VectorXd state_factors(const OrbitModel& model) const;
  [[nodiscard]] Eigen::VectorXd residual_of(const OrbitEquations& equations, const OrbitModel& model,
                                            const Eigen::VectorXd& x) const;
  // R where the parameter is a step further, x else the same; NaN where there is no scene beside p.
  [[nodiscard]] Eigen::VectorXd residual_beside(double step) const;
  // By which power k of the length since event i - 1 the equation of event i at x is divided; 0 where it is
  // not.
  [[nodiscard]] int divided(const Eigen::VectorXd& x, Eigen::Index i) const;
  // Left side of it, where `equations` are evaluated at x.
  [[nodiscard]] double divided_difference(const OrbitEquations& equations, const OrbitModel& model,
                                          const Eigen::VectorXd& x, Eigen::Index i) const;
  // z(theta_{i-1}) over the left side of equation i - 1; of an opening of a rigid stop z''(theta_{i-1}), of a
  // damped one z'(theta_{i-1}).
  [[nodiscard]] double ratio_of_rows(Eigen::Index i) const;
  [[nodiscard]] double ratio_at_release(Eigen::Index i) const;
  // Puts the rows of divided differences into the Jacobian; false where it cannot be evaluated.
  bool divide_rows(const Eigen::VectorXd& x);

  OrbitFamily& family_;
  SequencedOrbit orbit_;
  std::shared_ptr<OrbitModel> model_;
  std::shared_ptr<OrbitEquations> equations_;
  Eigen::VectorXd residual_, column_at_;
  Eigen::MatrixXd jacobian_;
  // Where `jacobian_` was evaluated, and all else there.
  struct Evaluated {
    Eigen::VectorXd x, residual;
    std::vector<SequenceEvent> events;
    std::shared_ptr<OrbitModel> model;
    std::shared_ptr<OrbitEquations> equations;
  };
  Evaluated whole_;
};

}  // namespace signorini
