#pragma once
// Which of the compliant stops push: springs, and stops behind coordinates without mass.

#include <vector>

#include "methods/flow/flow_record.hpp"
#include "methods/flow/stop_events.hpp"
#include "methods/linear_flow/contact_dynamics.hpp"

namespace signorini {

/// At compliant stops the contact force is the solution of the static complementarity problem
///
///     g - W^T u - s(t) - C lambda >= 0,   lambda <= 0,   complementary,
///
/// a continuous function of the state: an event only changes which contacts push, never the motion. Where
/// the solution has contacts with neither gap nor force, their next derivatives decide, in order: the same
/// problem for the first and the second time derivatives (the motion is twice differentiable), with the
/// contacts that push as equalities. What is left undecided stays open.
class CompliantEvents final : public StopEvents {
 public:
  CompliantEvents(const ContactDynamics& dynamics, double tolerance);

  /// The state as it is, with the contacts that push.
  [[nodiscard]] FlowState place(double time, const State& state) const override;

  /// The contacts that push, from the state alone. \throws FlowError if there is no solution (only possible
  /// where contacts depend on each other)
  [[nodiscard]] std::vector<bool> pushing(double time, const State& state) const;
  /// The contacts that push after the guard of `trigger` has vanished: that contact changes, and those that
  /// are without gap and force at that instant are decided anew. Logs every change. \throws FlowError
  void resolve(FlowState& flow, int trigger, FlowRecord& record) const override;
  /// Nothing: a compliant stop lets its contact move.
  void hold(State&, const ContactMode&) const override {}

 private:
  void decide(double time, const State& state, int first_order, std::vector<bool> undecided,
              std::vector<bool>& closed) const;

  const ContactDynamics& dynamics_;
  double noise_;  // of guards, relative to the scales of the motion [-]
};

}  // namespace signorini
