#pragma once
// What stops do at an event: impacts, sticking and release at rigid ones, pushing and leaving at compliant
// ones.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/flow/flow_record.hpp"
#include "methods/linear_flow/contact_dynamics.hpp"

namespace signorini {

/// The law of contact at the instants where a mode ends: RigidEvents or GivingEvents.
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

 protected:
  /// The time derivative at which contacts are told apart, and what counts as zero of it.
  struct Order {
    int derivative = 0;  ///< of gap or acceleration
    double floor = 0.0;  ///< of coupling times force and of the opening, in its unit
  };

  /// \param dynamics  of the scene, kept by the caller
  explicit StopEvents(const ContactDynamics& dynamics) : dynamics_(dynamics) {}
  /// Settles the contacts that are `undecided` and not `closed`, derivative by derivative: at each order k
  /// the complementarity problem of the k-th derivatives
  ///
  ///     w = A z + q >= 0,   z >= 0,   w z = 0,   z = -d^k lambda / dt^k,   A = Stops::coupling,
  ///
  /// with the contacts closed so far as equalities w = 0; -q is the k-th derivative of W^T u + s - g without
  /// the forces of the others. Where contacts relax, z is a derivative less, and q is that of beta (g - x). A
  /// contact with z > floor closes, one with w > floor stays open, and the others are left to the next order.
  /// The undecided are all rigid, or relax, or are springs: between the kinds A is 0. Undecided after the
  /// last one: open. \throws FlowError if there is no solution (only possible where contacts depend on each
  /// other)
  void decide(double time, const State& state, const std::vector<Order>& orders, std::vector<bool> undecided,
              std::vector<bool>& closed) const;

  /// z of the least displacement A_S z that brings contacts S to 0 <= z, 0 <= gap + A_SS z. \throws FlowError
  static Eigen::VectorXd moving_back(const Eigen::MatrixXd& A, const std::vector<int>& contacts,
                                     const Eigen::VectorXd& gap);

  /// What a contact has done that is closed afterwards, or is not.
  static ContactEvent::Kind change_of(const std::vector<bool>& closed, int contact);
  /// Logs the contacts that have closed or opened, those that give way alone.
  void log_changes(const std::vector<bool>& before, const std::vector<bool>& closed, double time,
                   FlowRecord& record) const;

  const ContactDynamics& dynamics_;  ///< of the scene
};

/// The largest height of elastic impacts that are left out where they fade, over X [-]
inline constexpr double kFadedHeight = 1e-6;

/// Displacement that is left out where the impacts of contact j after one of speed v are carried to their
/// limit, contact, at once; empty where they have none. Under a pressing acceleration a:
///
/// - e < 1: they form a geometric sequence, over after 2 e v / (a (1 - e)), and e v^2 / (2 a (1 - e)) is left
///   out
/// - e = 1: they never end, but the damping that a body feels at its contact alone,
///   c = W_j^T M^-1 D M^-1 W_j / G_jj, takes away (2/3) (c - a_0'/a) v^2 / a of each one's speed, a_0 = a
///   without their own part. Where it does so before a_0 changes much, |a_0'| <= a c / 2, they fade like
///   exp(-c t / 3): no number of them ends in contact, and less and less tells them from it. Their height
///   v^2 / (2 a) is left out, and of the motion besides only what is of its order.
///
/// \param dynamics      of the scene
/// \param acceleration  a, just before the impact [m/s^2]
/// \param jerk          a' = a_0' - c a likewise [m/s^3]
/// \return [m]
std::optional<double> left_out_by_chatter(const ContactDynamics& dynamics, int contact, double speed,
                                          double acceleration, double jerk);

/// Impulses p <= 0 of contacts that touch at the same instant, by Newton's law for all of them together:
/// x'_+ = x'_- + G p satisfies
///
///     x'_+ + e max(x'_-, 0) <= 0,   p <= 0,   p_j (x'_+ + e max(x'_-, 0))_j = 0:
///
/// a contact that pushes rebounds by Newton's law, one that the others carry away gets no impulse, and a
/// resting one passes an impulse on.
///
/// \param delassus     G of the touching contacts, m x m [1/kg]
/// \param approach     x'_- of each, m; <= 0 where the contact is not closing [m/s]
/// \param restitution  e of each, m [-]
/// \return p, m [N s]; empty only if G is degenerate and no solution was found
std::optional<Eigen::VectorXd> newton_impulses(const Eigen::MatrixXd& delassus,
                                               const Eigen::VectorXd& approach,
                                               const Eigen::VectorXd& restitution);

/// What stops that give way do, alone or beside rigid ones, which they leave alone.
///
/// At compliant stops (springs, and stops behind coordinates without mass) the contact force is the solution
/// of the static complementarity problem
///
///     g - W^T u - s(t) - C lambda >= 0,   lambda <= 0,   complementary,
///
/// a continuous function of the state: an event only changes which contacts push, never the motion. Where
/// the solution has contacts with neither gap nor force, their next derivatives decide, in order: the same
/// problem for the first and the second time derivatives (the motion is twice differentiable), with the
/// contacts that push as equalities. What is left undecided stays open.
///
/// At relaxing stops (behind damped coordinates without mass) a contact that closes is stopped without an
/// impulse: the state is continuous, and the forces of all contacts at their stops jump to the solution of
///
///     -(a + G lambda) >= 0,   lambda <= 0,   complementary,   G = C / beta,
///
/// a = W^T v + (s - xi) / beta their speeds without forces; a single one takes lambda = -a / G. So one may
/// open where another closes. Where the solution has contacts with neither speed nor force, the second
/// derivatives of x decide, with lambda'. A contact opens where its force vanishes, and no force jumps.
/// Springs alone beside them close and open as ever.
class GivingEvents final : public StopEvents {
 public:
  /// \param tolerance  of the integration, relative to the scales of the motion [-]
  GivingEvents(const ContactDynamics& dynamics, double tolerance);

  /// The state with the contacts beyond relaxing stops moved back, by the smallest impulses xi takes for
  /// that, and the contacts that push. \throws FlowError
  [[nodiscard]] FlowState place(double time, const State& state) const override;
  /// The contacts that push after the guard of `trigger` has vanished: that contact changes, and those that
  /// are without gap and force at that instant are decided anew. Logs every change; where the record asks for
  /// it, multiplies its derivative by the saltation matrix I + (F+ - F-) n^T / x'_- of a closing at a
  /// relaxing stop, n the gradient of x, F = (v, xi', a) on each side, and takes away what the next mode does
  /// not admit. \throws FlowError
  void resolve(FlowState& flow, int trigger, FlowRecord& record) const override;
  /// x_A = g_A at closed relaxing contacts, by xi in the direction C_A that a force moves it. A compliant
  /// stop lets its contact move.
  void hold(State& state, const ContactMode& mode) const override;
  /// The contacts that are closed after an event: those of `flow`, but for the giving ones that push. That of
  /// `trigger` changes if it is one of them. \param struck  whether impulses have just changed the
  /// velocities: forces of relaxing stops jump then, and contacts may open
  [[nodiscard]] std::vector<bool> closed_after(const FlowState& flow, int trigger, bool struck) const;
  /// Takes from deviations of the state what a mode does not admit: x_A' = 0 at relaxing stops.
  void admit(const ContactMode& mode, Eigen::MatrixXd& derivative) const;

 private:
  void reconsider(const FlowState& flow, int trigger, bool relaxing, bool struck,
                  std::vector<bool>& closed) const;
  [[nodiscard]] Eigen::VectorXd rates(const FlowState& flow) const;
  [[nodiscard]] Eigen::VectorXd moved(int contact, const Eigen::MatrixXd& derivative) const;
  void pass(const FlowState& after, const Eigen::VectorXd& before, int trigger,
            Eigen::MatrixXd& derivative) const;

  double touch_;                    // gap that counts as none [m]
  bool springs_ = false;            // whether some are springs alone
  std::vector<Order> of_springs_;   // of gap, speed and acceleration
  std::vector<Order> of_relaxing_;  // of speed and acceleration
};

/// Applies the laws of impact and contact to the contacts that touch their rigid stops. Others of the scene
/// give way (GivingEvents): which of them push is settled first. Forces of compliant ones are continuous
/// through an impact, those of relaxing ones jump, and such a contact may open.
///
/// Impact: Newton's law for all touching contacts together (`newton_impulses`). Afterwards those at rest
/// stick if the force presses them, lambda_j < 0, or lambda_j = 0 and falling: a linear complementarity
/// problem in the accelerations, and one in their rates for the contacts that it leaves undecided.
///
/// Chatter: with e < 1 and a pressing acceleration a the impacts that follow one of speed v form, as
/// v -> 0, a geometric sequence of ratio e, over after 2 e v / (a (1 - e)). Once the rest of the sequence
/// displaces nothing by more than a tenth of tolerance X it is carried to its limit at once: the contact
/// sticks with its whole momentum as one impulse (error O(v^2)). With e = 1 they may fade
/// (`left_out_by_chatter`), and the contact sticks once they are no higher than a tenth of kFadedHeight X, or
/// than all of it with 3 a / (4 c v) > 128 more impacts before the height has fallen by e.
class RigidEvents final : public StopEvents {
 public:
  /// \param tolerance  of the integration, relative to the scales of the motion [-]
  RigidEvents(const ContactDynamics& dynamics, double tolerance);

  /// Penetrating contacts are moved back to their stops in the metric of M, closing ones rebound, pressed
  /// ones stick.
  [[nodiscard]] FlowState place(double time, const State& state) const override;

  /// Brings `flow` from the left to the right side of an event. `trigger` is the contact that closes, or
  /// -1. Logs impacts, closings and openings; where the record asks for it, multiplies its derivative by
  /// the saltation matrix
  ///
  ///     S = R + (F+ - R F-) n^T / (n^T F-),   R = diag(I, I, dv+/dv-), F = (v, xi', a) on each side,
  ///
  /// n = (w, 0, 0) of a rigid stop, the gradient of x of a relaxing one,
  ///
  /// of impacts at one instant that do not feel each other through the mass by the product of theirs, in the
  /// order of the contacts.
  /// \throws FlowError if the stops depend on each other and no impulses satisfy the law
  void resolve(FlowState& flow, int trigger, FlowRecord& record) const override;

  /// x_A = g_A and x'_A = 0 at closed contacts, in the metric of M.
  void hold(State& state, const ContactMode& mode) const override;

  /// Distance below which a contact counts as touching [m].
  [[nodiscard]] double touch() const { return touch_; }

 private:
  struct Impact;

  [[nodiscard]] std::optional<double> rest_of_chatter(int contact, double v, double a, double jerk) const;
  void collide(FlowState& flow, Impact& impact) const;
  void log(const Impact& impact, const FlowState& before, const std::vector<bool>& closed,
           FlowRecord& record) const;
  [[nodiscard]] std::vector<SequenceEvent> entries(const Impact& impact, const FlowState& before,
                                                   const std::vector<bool>& closed, int trigger) const;
  [[nodiscard]] Eigen::MatrixXd saltation(const Impact& impact, const std::vector<SequenceEvent>& entries,
                                          const FlowState& after, const ContactMode& mode) const;
  [[nodiscard]] Eigen::RowVectorXd earlier_by_state(const SequenceEvent& entry,
                                                    const Eigen::VectorXd& before) const;

  double tolerance_, touch_, rest_, weightless_;
  std::optional<const GivingEvents> giving_;  // of the other contacts, if there are any
};

}  // namespace signorini
