#pragma once
// The flow of a contact scene through its events.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

#include "methods/flow/compliant_events.hpp"
#include "methods/flow/contact_dynamics.hpp"
#include "methods/flow/crossing.hpp"
#include "methods/flow/cvode_session.hpp"
#include "methods/flow/flow_record.hpp"
#include "methods/flow/linear_flow.hpp"
#include "methods/flow/rigid_events.hpp"

namespace signorini {

/// What fills the time between two events.
enum class Integrator {
  cvode,  ///< CVODE, Adams
  modal,  ///< closed form (LinearFlow)
};

/// Advances a scene in time with a relative error of about `tolerance` over some periods: between events
/// CVODE integrates with rtol = 0.01 tolerance, atol = rtol X and rtol V (MotionScales), never below 1e-13.
/// Events are located on CVODE's dense output by `first_crossing`, not by CVODE's own root finder: that one
/// compares signs at the ends of a step, so a graze or a short rebound inside a step would pass unseen, and
/// the root that an impact leaves at its start would have to be hidden from it. Rebounds shorter than CVODE's
/// first steps are summed by the Taylor series of the linear motion.
///
/// Guards, one per contact: gap g - x (open), force -lambda (closed).
///
/// With Integrator::modal the stretches between events come from the exact flow of the mode (LinearFlow) in
/// steps of an eighth of the fastest period still alive in the guards (LinearArc::fading_rates): the modes of
/// a stiff structure bound the steps only as long as they move a contact by more than the noise. `tolerance`
/// is then that of the events alone.
class EventFlow {
 public:
  /// \param expired  asked now and then; true ends the flow with a FlowError
  EventFlow(const ContactDynamics& dynamics, double tolerance, std::function<bool()> expired,
            Integrator integrator = Integrator::cvode);

  /// A state made admissible: penetrating contacts are moved back to rigid stops, closing ones rebound,
  /// pressed ones stick.
  [[nodiscard]] FlowState place(double time, const State& state) const;

  /// Moves `flow` forward by `duration` > 0; logs into `record`.
  /// \throws FlowError, IntegrationError
  void advance(FlowState& flow, double duration, FlowRecord& record);

  [[nodiscard]] const ContactDynamics& dynamics() const { return dynamics_; }
  [[nodiscard]] double tolerance() const { return tolerance_; }
  [[nodiscard]] long rhs_evaluations() const { return session_ ? session_->rhs_evaluations() : 0; }

 private:
  // A stretch of the solution that can be evaluated anywhere.
  struct Stretch {
    double begin = 0.0, end = 0.0;
    double noise = 0.0;                       // relative to X (gaps) and to the acceleration scale (forces)
    std::function<Guard(int, double)> guard;  // of a contact at a time within
    std::function<std::vector<Guard>(double)> guards;  // of all contacts
  };
  struct Crossing {
    int contact = -1;  // -1: none
    double time = 0.0;
  };

  bool take_short_flight(FlowState& flow, double end, FlowRecord& record);
  void integrate(FlowState& flow, double end, FlowRecord& record);
  void follow(FlowState& flow, double end, FlowRecord& record);
  [[nodiscard]] Guard exact_guard(int contact, double time) const;
  [[nodiscard]] double short_flight(const FlowState& flow, const MotionDerivatives& motion) const;
  [[nodiscard]] Guard guard(int contact, double time, const Eigen::VectorXd& y) const;
  [[nodiscard]] std::vector<bool> fresh_guards(const std::vector<Guard>& guards, double noise) const;
  Crossing first_event(const Stretch& stretch, std::vector<bool>& fresh, std::vector<Guard>& last) const;
  [[nodiscard]] std::vector<Guard> guards(double time, const Eigen::VectorXd& y) const;
  [[nodiscard]] double guard_floor(int contact, double noise) const;
  void arrive(FlowState& flow, double time, const Eigen::VectorXd& y, double since, FlowRecord& record);
  [[nodiscard]] Eigen::MatrixXd transition(const std::vector<bool>& closed, double duration);
  void pass_event(FlowState& flow, const Crossing& crossing, FlowRecord& record) const;
  void keep(double time, const Eigen::VectorXd& y, FlowRecord& record) const;
  void keep_exact(double time, FlowRecord& record) const;

  const ContactDynamics& dynamics_;
  double tolerance_;
  std::function<bool()> expired_;
  RigidEvents rigid_events_;
  CompliantEvents compliant_events_;
  ContactMode mode_;  // the one the integrator is in
  LinearFlows flows_;
  LinearArc arc_;
  std::unique_ptr<CvodeSession> session_;  // none with the modal flow
};

}  // namespace signorini
