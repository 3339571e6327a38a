#pragma once
// The equations of a periodic orbit that runs through a prescribed sequence of events.

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "methods/flow/flow_record.hpp"
#include "methods/linear_flow/linear_flows.hpp"

namespace signorini {

/// A scene ready for exact orbits: its dynamics and the flows of the modes met so far.
struct OrbitModel {
  explicit OrbitModel(const Problem& problem, FlowForm form = FlowForm::automatic)
      : owner(std::make_shared<ContactDynamics>(problem)),
        dynamics(*owner),
        flows(dynamics, form),
        period(problem.period()) {}
  /// The same scene with flows of another form.
  OrbitModel(const OrbitModel& other, FlowForm form)
      : owner(other.owner), dynamics(*owner), flows(dynamics, form), period(other.period) {}
  OrbitModel(const OrbitModel&) = delete;
  OrbitModel& operator=(const OrbitModel&) = delete;

  std::shared_ptr<const ContactDynamics> owner;
  const ContactDynamics& dynamics;
  LinearFlows flows;
  double period;  ///< of the orbits looked for [s]
};

/// An orbit up to its polish: a state at the section, and the events until the section comes again.
struct OrbitGuess {
  FlowState start;                    ///< at the section
  std::vector<SequenceEvent> events;  ///< times ascending in (start.time, start.time + period)
  std::string origin;                 ///< how it was found, for messages
};

/// Unknowns: the state y_0 at the section and the instants t_1 < ... < t_m of the events, in the scales
/// (X, V, 1 / omega), 2 Nd + m. Equations, as many:
///
///     y(t_0 + T) - y_0 = 0,    x_j(t_i) - g_j = 0 (impact, close),    lambda_j(t_i) = 0 (open),
///
/// in the scales X, V and, for a force, ContactDynamics::force_scale. Between events the motion is that
/// of LinearFlow; at impacts v_+ = v_- - M^-1 W_S G_SS^-1 diag(1 + e) W_S^T v_-, S the contacts that take an
/// impulse, which also is the projection on sticking where e = 0. The Jacobian is carried along: an event's
/// instant moves the state after it by R F_- - F_+, F = (v, a) on either side.
///
/// The monodromy matrix is its Schur complement: with P(y_0, t) = y(t_0 + T) and h(y_0, t) the event
/// equations, the instants follow the state by dt = -(dh/dt)^-1 (dh/dy_0) dy_0, so that
///
///     dy(T)/dy_0 = dP/dy_0 - dP/dt (dh/dt)^-1 dh/dy_0;
///
/// multiplied out, these are the saltation matrices.
class OrbitEquations {
 public:
  /// \throws std::runtime_error if a flow cannot be formed
  OrbitEquations(OrbitModel& model, const OrbitGuess& guess);

  [[nodiscard]] Eigen::Index size() const { return 2 * n_ + m_; }
  [[nodiscard]] Eigen::Index events() const { return m_; }
  [[nodiscard]] const Eigen::VectorXd& guess() const { return first_; }
  /// The instant at which the section comes again, in the unit of the instants [-].
  [[nodiscard]] double end() const { return model_.period * model_.dynamics.structure().frequency; }
  /// Evaluates residual and Jacobian; false if anything is not finite.
  bool evaluate(const Eigen::VectorXd& unknowns);

  [[nodiscard]] const Eigen::VectorXd& residual() const { return residual_; }
  [[nodiscard]] const Eigen::MatrixXd& jacobian() const { return jacobian_; }
  [[nodiscard]] double largest_state() const { return largest_state_; }  ///< in scales, for round-off [-]
  /// Speeds x'_j at the events, before and after, and impulses of those pushed; of the last evaluation.
  struct EventCrossing {
    double approach = 0.0;
    Eigen::VectorXd speeds;    ///< x'_- of the contacts pushed [m/s]
    Eigen::VectorXd impulses;  ///< p of the contacts pushed [N s]
  };
  [[nodiscard]] const std::vector<EventCrossing>& crossings() const { return crossings_; }
  /// m + 1 arcs: arc i ends at event i. The next evaluation changes them.
  [[nodiscard]] const std::vector<std::shared_ptr<LinearArc>>& arcs() const { return arcs_; }
  /// The Schur complement in scaled coordinates, 2 Nd x 2 Nd; empty if dh/dt is singular.
  [[nodiscard]] Eigen::MatrixXd monodromy() const;
  /// The orbit of given unknowns, with the sequence of this one.
  [[nodiscard]] OrbitGuess orbit(const Eigen::VectorXd& unknowns) const;

 private:
  struct EventLaw {            // what is constant of an event
    bool of_force = false;     // its equation is that of a force
    Eigen::MatrixXd impulse;   // p of those pushed as a map of v_-, |S| x Nd
    Eigen::MatrixXd response;  // v_+ - v_- as a map of p: M^-1 W_S, Nd x |S|
    double unit = 1.0;         // of the equation
  };
  void prepare(const OrbitGuess& guess);
  void pass_event(Eigen::Index i);

  OrbitModel& model_;
  OrbitGuess sequence_;
  Eigen::Index n_ = 0, m_ = 0;
  double x_unit_ = 1.0, v_unit_ = 1.0, t_unit_ = 1.0, largest_state_ = 0.0;
  Eigen::VectorXd first_, residual_, a_;
  Eigen::MatrixXd jacobian_, sensitivity_;
  State state_;
  std::vector<const LinearFlow*> flows_;
  std::vector<EventLaw> laws_;
  std::vector<std::shared_ptr<LinearArc>> arcs_;
  std::vector<EventCrossing> crossings_;
};

}  // namespace signorini
