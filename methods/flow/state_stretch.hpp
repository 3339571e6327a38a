#pragma once
// Stretches that yield the state, from which guards and nodes follow by the equation of motion.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "methods/flow/cvode_session.hpp"
#include "methods/flow/stretch.hpp"

namespace signorini {

/// Guards and nodes from (u, v) by the equation of motion.
class StateStretch : public Stretch {
 public:
  void state(double time, State& state) const override;
  [[nodiscard]] Guard guard(int contact, double time) const override;
  [[nodiscard]] std::vector<Guard> guards(double time) const override;
  [[nodiscard]] FlowNode node(double time, const State& state) const override;

 protected:
  explicit StateStretch(const ContactDynamics& dynamics) : dynamics_(dynamics) {}
  /// y = (u, v) within the last step, 2 Nd.
  virtual void evaluate(double time, Eigen::VectorXd& y) const = 0;

  const ContactDynamics& dynamics_;
  const ContactMode* mode_ = nullptr;

 private:
  mutable Eigen::VectorXd y_;
};

/// Integrated by CVODE, with a local tolerance of 1 % of the `tolerance` aimed at: its global error over some
/// periods is 5 to 1000 times the local one (measured against closed forms, the more the tighter). Below
/// 1e-13 CVODE only adds round-off. Steps are at most a sixteenth of the period of the highest load harmonic,
/// so that a guard has one extremum per half step.
class CvodeStretch final : public StateStretch {
 public:
  CvodeStretch(const ContactDynamics& dynamics, double tolerance);

  void start(const ContactMode& mode, const FlowState& flow, double end, bool dense) override;
  void step() override;
  [[nodiscard]] bool finished() const override { return end_ >= stop_; }
  [[nodiscard]] double noise() const override { return noise_; }
  /// Right-hand sides since construction.
  [[nodiscard]] long rhs_evaluations() const { return session_.rhs_evaluations(); }

 private:
  void evaluate(double time, Eigen::VectorXd& y) const override;

  double noise_, stop_ = 0.0;
  CvodeSession session_;
  Eigen::VectorXd first_;
  bool stepped_ = false;  // before its first step CVODE has nothing to interpolate
};

/// The rebound of a contact from its rigid stop that is shorter than CVODE's first steps, in one step by the
/// Taylor series of the linear motion.
class TaylorStretch final : public StateStretch {
 public:
  /// \param touch  distance below which a contact is at its stop [m]
  TaylorStretch(const ContactDynamics& dynamics, double touch) : StateStretch(dynamics), touch_(touch) {}

  /// Whether a contact is about to rebound so shortly.
  [[nodiscard]] bool applies(const ContactMode& mode, const FlowState& flow) const;
  void start(const ContactMode& mode, const FlowState& flow, double end, bool dense) override;
  void step() override {}
  [[nodiscard]] bool finished() const override { return true; }
  [[nodiscard]] double noise() const override;

 private:
  void evaluate(double time, Eigen::VectorXd& y) const override;
  [[nodiscard]] double short_flight(const FlowState& flow, const MotionDerivatives& motion) const;

  double touch_;
  MotionDerivatives motion_;
};

}  // namespace signorini
