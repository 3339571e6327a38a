#pragma once
// Stretches in closed form.

#include <memory>
#include <vector>

#include "methods/flow/stretch.hpp"
#include "methods/linear_flow/linear_flows.hpp"

namespace signorini {

/// The exact flow of the mode (LinearFlow) in steps of an eighth of the fastest period still alive in the
/// guards, a sixteenth where nodes are kept (LinearArc::fading_rates): the modes of a stiff structure bound
/// the steps only as long as they move a contact by more than the noise.
class ClosedFormStretch final : public Stretch {
 public:
  /// \param flows      of the scene, kept by the caller
  /// \param tolerance  of the events [-]
  ClosedFormStretch(LinearFlows& flows, double tolerance);

  void start(const ContactMode& mode, const FlowState& flow, double end, bool dense) override;
  void step() override;
  [[nodiscard]] bool finished() const override { return end_ >= stop_; }
  [[nodiscard]] double noise() const override { return noise_; }

  void state(double time, State& state) const override { arc_->state(time, state); }
  [[nodiscard]] Guard guard(int contact, double time) const override;
  [[nodiscard]] std::vector<Guard> guards(double time) const override;
  [[nodiscard]] FlowNode node(double time, const State& state) const override;

 private:
  LinearFlows& flows_;
  double noise_, stop_ = 0.0, angle_ = 0.0;
  std::unique_ptr<LinearArc> arc_;
  std::vector<FadingRate> terms_;
};

}  // namespace signorini
