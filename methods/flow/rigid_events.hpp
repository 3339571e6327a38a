#pragma once
// What rigid stops do at an event: impacts, sticking, release, and the limit of a chatter.

#include <Eigen/Core>
#include <vector>

#include "methods/flow/flow_record.hpp"
#include "methods/flow/stop_events.hpp"
#include "methods/linear_flow/contact_dynamics.hpp"

namespace signorini {

/// Applies the laws of impact and contact to the contacts that touch their rigid stops.
///
/// Impact: Newton's law for all touching contacts together (`newton_impulses`). Afterwards those at rest
/// stick if the force presses them, lambda_j < 0, or lambda_j = 0 and falling: a linear complementarity
/// problem in the accelerations, and one in their rates for the contacts that it leaves undecided.
///
/// Chatter: with e < 1 and a pressing acceleration a the impacts that follow one of speed v form, as
/// v -> 0, a geometric sequence of ratio e, over after 2 e v / (a (1 - e)). Once the rest of the sequence
/// displaces nothing by more than a tenth of tolerance X it is carried to its limit at once: the contact
/// sticks with its whole momentum as one impulse (error O(v^2)).
class RigidEvents final : public StopEvents {
 public:
  RigidEvents(const ContactDynamics& dynamics, double tolerance);

  /// Penetrating contacts are moved back to their stops, closing ones rebound, pressed ones stick.
  [[nodiscard]] FlowState place(double time, const State& state) const override;

  /// Brings `flow` from the left to the right side of an event. `trigger` is the contact that closes, or
  /// -1. Logs impacts, closings and openings; where the record asks for it, multiplies its derivative by
  /// the saltation matrix
  ///
  ///     S = R + (F+ - R F-) n^T / (n^T F-),   n = (w, 0), R = diag(I, dv+/dv-), F = (v, a) on each side.
  /// \throws FlowError if the stops depend on each other and no impulses satisfy the law
  void resolve(FlowState& flow, int trigger, FlowRecord& record) const override;

  /// Moves penetrating contacts back to their stops, in the metric of M.
  void expel(State& state) const;
  /// x_A = g_A and x'_A = 0 at closed contacts, in the metric of M.
  void hold(State& state, const ContactMode& mode) const override;

  /// Distance below which a contact counts as touching [m].
  [[nodiscard]] double touch() const { return touch_; }
  /// Speed below which a contact counts as at rest [m/s].
  [[nodiscard]] double rest() const { return rest_; }

 private:
  struct Impact;

  [[nodiscard]] std::vector<int> touching(const FlowState& flow) const;
  [[nodiscard]] bool chatter_ends(double v, double a, double jerk) const;
  void collide(FlowState& flow, Impact& impact) const;
  void log(const Impact& impact, const FlowState& before, const std::vector<bool>& closed,
           FlowRecord& record) const;
  [[nodiscard]] std::vector<bool> pressed(double time, const State& state,
                                          const std::vector<int>& resting) const;
  void decide(double time, const State& state, const std::vector<int>& involved,
              const std::vector<bool>& held, std::vector<bool>& closed) const;
  [[nodiscard]] SequenceEvent entry(const Impact& impact, const FlowState& before,
                                    const std::vector<bool>& closed, int trigger) const;
  [[nodiscard]] Eigen::MatrixXd saltation(const Impact& impact, const FlowState& after,
                                          const ContactMode& mode, int trigger) const;

  const ContactDynamics& dynamics_;
  double tolerance_, touch_, rest_, weightless_;
};

}  // namespace signorini
