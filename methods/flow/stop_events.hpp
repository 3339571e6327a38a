#pragma once
// What stops do at an event, whichever kind they are.

#include <memory>

#include "methods/flow/flow_record.hpp"
#include "methods/linear_flow/contact_dynamics.hpp"

namespace signorini {

/// The law of contact at the instants where a mode ends: RigidEvents or CompliantEvents.
class StopEvents {
 public:
  virtual ~StopEvents() = default;

  /// A state made admissible, with the contacts that are closed in it. \throws FlowError
  [[nodiscard]] virtual FlowState place(double time, const State& state) const = 0;
  /// Brings `flow` from the left to the right side of the event at which the guard of contact `trigger`
  /// vanishes, and logs it. \throws FlowError
  virtual void resolve(FlowState& flow, int trigger, FlowRecord& record) const = 0;
  /// Removes what an integration has let a state stray from the constraints of its mode.
  virtual void hold(State& state, const ContactMode& mode) const = 0;
};

}  // namespace signorini
