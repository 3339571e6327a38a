#pragma once
// A motion in one mode, from one event to the next, however it is computed.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "methods/flow/cvode_session.hpp"
#include "methods/flow/flow_record.hpp"
#include "methods/linear_flow/contact_dynamics.hpp"
#include "methods/linear_flow/linear_flow.hpp"

namespace signorini {

/// A quantity that stays >= 0 as long as the mode lasts, and its time derivative.
struct Guard {
  double value = 0.0;  ///< gap [m], or coupling times force
  double rate = 0.0;   ///< its time derivative
};

/// What is known of a guard over a step.
struct GuardWindow {
  double begin = 0.0;  ///< [s]
  double end = 0.0;    ///< [s]
  bool fresh = false;  ///< true if the guard starts from zero (it has just closed, opened or rebounded)
  double floor = 0.0;  ///< a fresh guard may lie this far below zero: its noise (unit of the guard)
};

/// First time in (begin, end] at which the guard falls below zero, to round-off; empty if it does not.
///
/// Signs at the ends of the step are not enough: a guard that dips below zero and returns inside the
/// step (grazing) is found through its minimum, and a fresh one that rises and falls back inside the
/// step (a short rebound) through its maximum. A fresh guard is not reported at `begin`.
/// Assumes at most one extremum per half step, which a step resolved to tolerance satisfies.
std::optional<double> first_crossing(const std::function<Guard(double)>& guard, const GuardWindow& window);

/// The motion in one contact mode, advanced step by step: CvodeStretch, TaylorStretch, ClosedFormStretch.
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
  [[nodiscard]] bool finished() const { return end_ >= stop_; }
  /// Error of guards relative to their scales: X, or the acceleration scale of a closed rigid stop [-].
  [[nodiscard]] double noise() const { return noise_; }
  /// Right-hand sides since construction; 0 where none are evaluated.
  [[nodiscard]] virtual long rhs_evaluations() const { return 0; }

  /// u and v within the last step.
  virtual void state(double time, State& state) const = 0;
  /// The guard of one contact within the last step.
  [[nodiscard]] virtual Guard guard(int contact, double time) const = 0;
  /// All guards within the last step.
  [[nodiscard]] virtual std::vector<Guard> guards(double time) const = 0;
  /// x and lambda with their derivatives; `state` is the motion's at this time, as the flow holds it.
  [[nodiscard]] virtual FlowNode node(double time, const State& state) const = 0;
  /// The same with the state of the stretch itself.
  [[nodiscard]] virtual FlowNode node(double time) const {
    State own;
    state(time, own);
    return node(time, own);
  }

 protected:
  /// \param noise  error of guards relative to their scales [-]
  explicit Stretch(double noise) : noise_(noise) {}
  /// The guard of a contact at this displacement, or, where it is closed, of this force.
  static Guard guard_of(const ContactDynamics& dynamics, int contact, bool closed, double value, double rate);

  double begin_ = 0.0;  ///< of the last step [s]
  double end_ = 0.0;    ///< of the last step [s]
  double stop_ = 0.0;   ///< where the stretch is to end [s]

 private:
  double noise_;
};

/// A stretch that yields the state, from which guards and nodes follow by the equation of motion.
class StateStretch : public Stretch {
 public:
  void state(double time, State& state) const override;
  [[nodiscard]] Guard guard(int contact, double time) const override;
  [[nodiscard]] std::vector<Guard> guards(double time) const override;
  using Stretch::node;
  [[nodiscard]] FlowNode node(double time, const State& state) const override;

 protected:
  /// \param dynamics  of the scene, kept by the caller
  StateStretch(const ContactDynamics& dynamics, double noise) : Stretch(noise), dynamics_(dynamics) {}
  /// y = (u, xi, v) within the last step.
  virtual void evaluate(double time, Eigen::VectorXd& y) const = 0;

  const ContactDynamics& dynamics_;    ///< of the scene
  const ContactMode* mode_ = nullptr;  ///< that the stretch was started in

 private:
  [[nodiscard]] State unpacked() const;

  mutable Eigen::VectorXd y_;
};

/// Integrated by CVODE, with a local tolerance of 1 % of the `tolerance` aimed at: its global error over some
/// periods is 5 to 1000 times the local one (measured against closed forms, the more the tighter). Below
/// 1e-13 CVODE only adds round-off. Steps are at most a sixteenth of the period of the highest load harmonic,
/// so that a guard has one extremum per half step.
class CvodeStretch final : public StateStretch {
 public:
  /// \param tolerance  relative error aimed at over some periods [-]
  CvodeStretch(const ContactDynamics& dynamics, double tolerance, Multistep multistep);

  void start(const ContactMode& mode, const FlowState& flow, double end, bool dense) override;
  void step() override;
  [[nodiscard]] long rhs_evaluations() const override { return session_.rhs_evaluations(); }

 private:
  void evaluate(double time, Eigen::VectorXd& y) const override;

  CvodeSession session_;
  Eigen::VectorXd first_;
  bool stepped_ = false;  // before its first step CVODE has nothing to interpolate
};

/// The rebound of a contact from its rigid stop that is shorter than CVODE's first steps, in one step by the
/// Taylor series of the linear motion.
class TaylorStretch final : public StateStretch {
 public:
  /// \param touch  distance below which a contact is at its stop [m]
  TaylorStretch(const ContactDynamics& dynamics, double touch);

  /// Whether a contact is about to rebound so shortly.
  [[nodiscard]] bool applies(const ContactMode& mode, const FlowState& flow) const;
  void start(const ContactMode& mode, const FlowState& flow, double end, bool dense) override;
  void step() override {}

 private:
  void evaluate(double time, Eigen::VectorXd& y) const override;
  [[nodiscard]] double short_flight(const FlowState& flow, const MotionDerivatives& motion) const;

  double touch_;
  MotionDerivatives motion_;
};

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
  void state(double time, State& state) const override { arc_->state(time, state); }
  [[nodiscard]] Guard guard(int contact, double time) const override;
  [[nodiscard]] std::vector<Guard> guards(double time) const override;
  [[nodiscard]] FlowNode node(double time, const State&) const override { return node(time); }
  [[nodiscard]] FlowNode node(double time) const override;

 private:
  LinearFlows& flows_;
  double angle_ = 0.0;
  std::unique_ptr<LinearArc> arc_;
  std::vector<FadingRate> terms_;
};

}  // namespace signorini
