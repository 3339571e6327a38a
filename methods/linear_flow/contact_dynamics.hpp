#pragma once
// Equations of motion of a contact scene while the set of closed contacts does not change.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "methods/linear_flow/flow_structure.hpp"
#include "methods/linear_flow/stops.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Between events the motion of the coordinates with mass obeys the linear equation of FlowStructure with
/// lambda_j = 0 at open contacts and, at closed ones, the force of their stops (Stops).
class ContactDynamics {
 public:
  /// \throws std::runtime_error with flow_obstacle(problem) if there is one
  explicit ContactDynamics(const Problem& problem);
  /// `condensed` in place of condense(problem), as FlowStructure takes it.
  ContactDynamics(const Problem& problem, CondensedStructure condensed);
  /// The same scene with another frequency of its load (FlowStructure::at_frequency).
  ContactDynamics(const ContactDynamics& other, double frequency);

  [[nodiscard]] const FlowStructure& structure() const { return *structure_; }  ///< that moves
  [[nodiscard]] const Stops& stops() const { return *stops_; }                  ///< of its contacts
  /// Nd: coordinates with mass, in the order of the scene's.
  [[nodiscard]] int size() const { return structure_->size(); }
  [[nodiscard]] int contact_count() const { return structure_->contact_count(); }  ///< Nc
  /// Units of tolerances.
  [[nodiscard]] const MotionScales& scales() const { return structure_->scales; }
  /// Whether some stop is rigid: its contact takes impulses.
  [[nodiscard]] bool rigid() const { return any_rigid_; }
  /// Whether that of this contact is.
  [[nodiscard]] bool rigid(int contact) const { return stops_->rigid(contact); }
  /// Whether u'' or xi' jumps where this contact meets its stop, which is rigid or damped: before a spring
  /// alone the motion is smooth there.
  [[nodiscard]] bool halts(int contact) const { return rigid(contact) || structure_->relaxes(contact); }
  /// e of a contact; 1 where it takes no impulses, or is none [-].
  [[nodiscard]] double restitution(int contact) const {
    return restitution_[static_cast<std::size_t>(contact)];
  }
  [[nodiscard]] int positions() const { return structure_->positions(); }  ///< Np, of u and xi
  [[nodiscard]] int states() const { return structure_->states(); }        ///< of (u, xi, v)
  /// The state of the coordinates with mass out of that of all, whose contacts are at x: xi = x - W^T u where
  /// they relax.
  [[nodiscard]] State with_mass(const State& whole, const Eigen::VectorXd& x = {}) const;
  /// At rest, all zero.
  [[nodiscard]] State at_rest() const {
    return {.u = Eigen::VectorXd::Zero(positions()), .v = Eigen::VectorXd::Zero(size())};
  }
  /// Unit of lambda_j in tolerances: X / C_jj, max(X, beta V) / C_jj where contacts relax, or the
  /// acceleration scale over G_jj at a rigid stop [N].
  [[nodiscard]] double force_scale(int contact) const;

  /// The mode in which exactly the contacts with closed[j] are closed.
  [[nodiscard]] ContactMode mode(const std::vector<bool>& closed) const;

  /// u'' in a mode; `u` is Np, `v` and `a` are Nd. Allocation apart, free of side effects.
  void acceleration(const ContactMode& mode, double time, const Eigen::Ref<const Eigen::VectorXd>& u,
                    const Eigen::Ref<const Eigen::VectorXd>& v, Eigen::Ref<Eigen::VectorXd> a) const;

  /// (u, xi, v)' in a mode from y = (u, xi, v).
  void rate(const ContactMode& mode, double time, const Eigen::Ref<const Eigen::VectorXd>& y,
            Eigen::Ref<Eigen::VectorXd> rate) const;

  /// Derivatives 0..order (>= 2) of u and 0..order-2 of x and lambda, exact from the equation of motion.
  [[nodiscard]] MotionDerivatives derivatives(const ContactMode& mode, double time, const State& state,
                                              int order) const {
    return stops_->derivatives(mode, time, state, order);
  }

  /// The square matrix B of the homogeneous flow (u, xi, v)' = B (u, xi, v) in a mode.
  [[nodiscard]] Eigen::MatrixXd flow_matrix(const ContactMode& mode) const;

 private:
  // Terms of M^-1 f(t) of one harmonic.
  struct LoadRate {
    double rate = 0.0;         // h omega [rad/s]
    Eigen::VectorXd cos, sin;  // M^-1 times the amplitudes, Nd
  };

  std::shared_ptr<const FlowStructure> structure_;
  std::shared_ptr<const Stops> stops_;
  std::vector<double> restitution_;
  bool any_rigid_ = true;
  // Small structures: M^-1 K, M^-1 D and M^-1 f are formed once, so that an evaluation allocates nothing.
  bool small_ = false;
  Eigen::MatrixXd inverse_mass_stiffness_, inverse_mass_damping_;
  std::vector<LoadRate> inverse_mass_load_;
};

}  // namespace signorini
