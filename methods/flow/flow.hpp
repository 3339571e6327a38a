#pragma once
// The flow of a contact scene through its events.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

#include "methods/flow/flow_record.hpp"
#include "methods/flow/stop_events.hpp"
#include "methods/flow/stretch.hpp"
#include "methods/linear_flow/linear_flow.hpp"

namespace signorini {

/// What fills the time between two events.
enum class Integrator {
  cvode,  ///< CVODE: BDF where the structure is stiff (FlowStructure::stiff), else Adams
  adams,  ///< CVODE, Adams
  bdf,    ///< CVODE, backward differentiation
  modal,  ///< closed form (LinearFlow)
};

/// Advances a scene in time with a relative error of about `tolerance` over some periods, mode by mode: a
/// Stretch moves it until the guard of a contact vanishes, StopEvents take it to the right side of that
/// event, and the next mode begins. With Integrator::cvode the stretches are CVODE's (CvodeStretch), rebounds
/// shorter than its first steps Taylor sums (TaylorStretch); with Integrator::modal they are in closed form
/// (ClosedFormStretch), and `tolerance` is that of the events alone.
///
/// Events are located on the dense output by `first_crossing`, not by CVODE's own root finder: that one
/// compares signs at the ends of a step, so a graze or a short rebound inside a step would pass unseen, and
/// the root that an impact leaves at its start would have to be hidden from it.
class EventFlow {
 public:
  /// \param expired  asked now and then; true ends the flow with a FlowError
  EventFlow(const ContactDynamics& dynamics, double tolerance, std::function<bool()> expired,
            Integrator integrator = Integrator::cvode);
  /// Its parts refer to each other.
  EventFlow(const EventFlow&) = delete;
  EventFlow& operator=(const EventFlow&) = delete;

  /// A state made admissible: penetrating contacts are moved back to rigid stops, closing ones rebound,
  /// pressed ones stick.
  [[nodiscard]] FlowState place(double time, const State& state) const;

  /// Moves `flow` forward by `duration` > 0; logs into `record`.
  /// \throws FlowError, IntegrationError
  void advance(FlowState& flow, double duration, FlowRecord& record);

  [[nodiscard]] const ContactDynamics& dynamics() const { return dynamics_; }  ///< of the scene
  /// Right-hand sides that CVODE has asked for.
  [[nodiscard]] long rhs_evaluations() const { return between_->rhs_evaluations(); }

 private:
  struct Crossing {
    int contact = -1;  // -1: none
    double time = 0.0;
  };

  void follow(Stretch& stretch, FlowState& flow, double end, FlowRecord& record);
  [[nodiscard]] double guard_floor(int contact, double noise) const;
  Crossing first_event(const Stretch& stretch, std::vector<bool>& fresh, std::vector<Guard>& last) const;
  [[nodiscard]] Eigen::MatrixXd carried(const std::vector<bool>& closed, double duration,
                                        const Eigen::MatrixXd& deviations);

  const ContactDynamics& dynamics_;
  Integrator integrator_;
  std::function<bool()> expired_;
  std::unique_ptr<const StopEvents> events_;
  ContactMode mode_;  // the one that the motion is in
  LinearFlows flows_;
  std::unique_ptr<Stretch> between_;        // fills the time between events,
  std::unique_ptr<TaylorStretch> rebound_;  // this one short rebounds from rigid stops
};

}  // namespace signorini
