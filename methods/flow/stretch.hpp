#pragma once
// A motion in one mode, from one event to the next, however it is computed.

#include <vector>

#include "methods/flow/crossing.hpp"
#include "methods/flow/flow_record.hpp"
#include "methods/linear_flow/contact_dynamics.hpp"

namespace signorini {

/// The motion in one contact mode, advanced step by step: CvodeStretch, ClosedFormStretch, TaylorStretch.
/// The last step taken can be evaluated at any instant.
///
/// Guards, one per contact: gap g - x [m] (open), -G_jj lambda [m/s^2] or -C_jj lambda [m] (closed).
class Stretch {
 public:
  virtual ~Stretch() = default;

  /// Starts at flow.time towards `end`. \param dense  nodes will be kept, which may ask for shorter steps
  virtual void start(const ContactMode& mode, const FlowState& flow, double end, bool dense) = 0;
  /// Takes a step: [begin(), end()] is known afterwards. \throws IntegrationError, FlowError
  virtual void step() = 0;

  [[nodiscard]] double begin() const { return begin_; }  ///< of the last step [s]
  [[nodiscard]] double end() const { return end_; }      ///< of the last step [s]
  /// The stretch has reached the end asked for, or as far as it can go.
  [[nodiscard]] virtual bool finished() const = 0;
  /// Error of guards relative to their scales: X, or the acceleration scale of a closed rigid stop [-].
  [[nodiscard]] virtual double noise() const = 0;

  /// u and v within the last step.
  virtual void state(double time, State& state) const = 0;
  [[nodiscard]] virtual Guard guard(int contact, double time) const = 0;
  [[nodiscard]] virtual std::vector<Guard> guards(double time) const = 0;
  /// x and lambda with their derivatives; `state` is the motion's at this time, as the flow holds it.
  [[nodiscard]] virtual FlowNode node(double time, const State& state) const = 0;

 protected:
  double begin_ = 0.0, end_ = 0.0;
};

/// Highest derivative of x kept at an instant; of lambda one less.
inline constexpr int kNodeOrder = 5;

}  // namespace signorini
