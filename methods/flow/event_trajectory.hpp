#pragma once
// A motion as the flow left it: pieces between events, interpolated to the tolerance of the integration.

#include <optional>
#include <vector>

#include "methods/flow/flow_record.hpp"
#include "methods/flow/integrated_trajectory.hpp"
#include "methods/solution.hpp"

namespace signorini {

/// The impulses that listed events take.
std::vector<Impulse> impulses_of(const std::vector<ContactEvent>& events);

/// Piecewise Hermite interpolation of degree 9 between the instants kept: x, x' and lambda, each with its
/// first four derivatives at both ends, which the equation of motion gives exactly. The error is
/// h^10 |x^(10)| / 3.7e9 at most (10! 2^10) for a step h: round-off at the steps that CVODE takes.
/// The velocity is right-sided; the force is the multiplier of a sticking contact or that of a compliant
/// stop.
class EventTrajectory final : public IntegratedTrajectory {
 public:
  /// \param start   state at the instant where the motion was cut open
  /// \param nodes   in time order from start.time to start.time + period, two at each event
  /// \param events  of one period, at any times that differ from theirs by whole periods
  EventTrajectory(double period, FlowState start, std::vector<FlowNode> nodes,
                  std::vector<ContactEvent> events);

  [[nodiscard]] int contact_count() const override { return static_cast<int>(start_.closed.size()); }
  [[nodiscard]] double period() const override { return period_; }
  [[nodiscard]] Samples sample(int count) const override;
  [[nodiscard]] std::vector<Impulse> impulses() const override { return impulses_of(events_); }
  /// Openings with their push.
  [[nodiscard]] std::optional<std::vector<ContactEvent>> events() const override;

  /// State of the coordinates with mass at the time where the motion was cut open.
  [[nodiscard]] const FlowState& start() const { return start_; }

 private:
  double period_;
  FlowState start_;
  std::vector<FlowNode> nodes_;
  std::vector<ContactEvent> events_;
};

}  // namespace signorini
