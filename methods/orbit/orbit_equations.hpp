#pragma once
// The equations of a periodic orbit that runs through a prescribed sequence of events, and Newton's method on
// them.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "methods/flow/flow_record.hpp"
#include "methods/linear_flow/linear_flow.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

/// Penetration and tension that an orbit may have, in the scales of the motion [-]
inline constexpr double kAdmissible = 1e-11;
/// What rounding leaves of displacements and speeds of an orbit, over X and V, and of instants, over the
/// period [-]
inline constexpr double kOrbitRounding = 1e-13;

/// A scene ready for exact orbits: its dynamics and the flows of the modes met so far.
struct OrbitModel {
  /// \throws std::runtime_error with flow_obstacle(problem) if there is one
  /// \param shared  modes known from other scenes, if any
  explicit OrbitModel(const Problem& problem, std::shared_ptr<SharedModes> shared = {});
  /// The same scene with another frequency of its load.
  OrbitModel(const OrbitModel& other, double frequency, std::shared_ptr<SharedModes> shared);
  /// Of dynamics that are known, with flows of this form.
  OrbitModel(ContactDynamics known, double of_orbits, FlowForm form = FlowForm::automatic,
             std::shared_ptr<SharedModes> shared = {});
  /// Its parts refer to each other.
  OrbitModel(const OrbitModel&) = delete;
  OrbitModel& operator=(const OrbitModel&) = delete;

  const ContactDynamics dynamics;  ///< of the scene
  LinearFlows flows;               ///< of its contact modes
  double period;                   ///< of the orbits looked for [s]
};

/// An orbit up to its polish: a state at the section, and the events until the section comes again.
struct OrbitGuess {
  FlowState start;                    ///< at the section
  std::vector<SequenceEvent> events;  ///< times ascending in (start.time, start.time + period)
  std::string origin;                 ///< how it was found, for messages

  /// The contacts closed before event i, Nc; of m, those after the last one.
  [[nodiscard]] const std::vector<bool>& closed_before(std::size_t i) const {
    return i == 0 ? start.closed : events[i - 1].closed;
  }
  /// Begin and end of arc i, in a motion of a period [s].
  [[nodiscard]] std::pair<double, double> span(std::size_t i, double period) const {
    return {i == 0 ? start.time : events[i - 1].time,
            i < events.size() ? events[i].time : start.time + period};
  }
  /// How often each contact closes and stays, Nc; several may at one event.
  [[nodiscard]] std::vector<int> closings() const;
};

/// Asked now and then by what takes long; true ends it. Empty: no limit.
using Expired = std::function<bool()>;
/// \throws std::runtime_error "the time is up" if it is
void require_time(const Expired& expired);

/// Unknowns: the state y_0 at the section and the instants t_1 < ... < t_m of the events, in the scales
/// (X, V, 1 / omega), Ns + m, Ns = 2 Nd or, with relaxing contacts, 2 Nd + Nc. Equations, as many:
///
///     y(t_0 + T) - y_0 = 0,    x_j(t_i) - g_j = 0 (impact, close),    lambda_j(t_i) = 0 (open),
///
/// in the scales X, V and, for a force, ContactDynamics::force_scale. Between events the motion is that
/// of LinearFlow; at impacts v_+ = v_- - M^-1 W_S G_SS^-1 diag(1 + e) W_S^T v_-, S the contacts that take an
/// impulse, which also is the projection on sticking where e = 0. The Jacobian is carried along: an event's
/// instant moves the state after it by R F_- - F_+, F = (v, xi', a) on either side.
///
/// The monodromy matrix is its Schur complement: with P(y_0, t) = y(t_0 + T) and h(y_0, t) the event
/// equations, the instants follow the state by dt = -(dh/dt)^-1 (dh/dy_0) dy_0, so that
///
///     dy(T)/dy_0 = dP/dy_0 - dP/dt (dh/dt)^-1 dh/dy_0;
///
/// multiplied out, these are the saltation matrices.
class OrbitEquations {
 public:
  /// What sensitivities are carried along an orbit.
  enum class Columns {
    all,    ///< those of the whole state at the section
    alive,  ///< those of the amplitudes of the modes alive at the first event: less, and the same to rounding
  };
  /// \param expired  asked before each flow is formed and each event is passed
  /// \throws std::runtime_error if a flow cannot be formed, or the time is up
  OrbitEquations(OrbitModel& model, const OrbitGuess& guess, Expired expired = {},
                 Columns columns = Columns::all);
  OrbitEquations(const OrbitEquations&) = delete;
  OrbitEquations& operator=(const OrbitEquations&) = delete;

  [[nodiscard]] Eigen::Index size() const { return states_ + m_; }       ///< Ns + m
  [[nodiscard]] Eigen::Index events() const { return m_; }               ///< m
  [[nodiscard]] const Eigen::VectorXd& guess() const { return first_; }  ///< the unknowns to begin with
  /// The instant at which the section comes again, in the unit of the instants [-].
  [[nodiscard]] double end() const { return model_.period * model_.dynamics.structure().frequency; }
  /// Evaluates residual and Jacobian; false if anything is not finite. \throws std::runtime_error if the time
  /// is up
  bool evaluate(const Eigen::VectorXd& unknowns);
  /// The same without the Jacobian, which is left undefined.
  bool evaluate_residual(const Eigen::VectorXd& unknowns);

  /// Left sides of the equations, in scales, of the last evaluation [-].
  [[nodiscard]] const Eigen::VectorXd& residual() const { return residual_; }
  /// Its derivative with respect to the unknowns [-].
  [[nodiscard]] const Eigen::MatrixXd& jacobian() const { return jacobian_; }
  /// Rounding error of the residual: 32 epsilon times the largest state met, in scales [-].
  [[nodiscard]] double noise() const { return 32.0 * kEpsilon * largest_state_; }
  /// What the law made of an event, in the last evaluation.
  struct EventCrossing {
    double approach = 0.0;     ///< x'_- of the contact whose guard vanishes [m/s]
    Eigen::VectorXd speeds;    ///< x'_- of the contacts pushed [m/s]
    Eigen::VectorXd impulses;  ///< p of the contacts pushed [N s]
  };
  /// Those of all events.
  [[nodiscard]] const std::vector<EventCrossing>& crossings() const { return crossings_; }
  /// m + 1 arcs: arc i ends at event i. The next evaluation changes them.
  [[nodiscard]] const std::vector<std::shared_ptr<LinearArc>>& arcs() const { return arcs_; }
  /// The Schur complement in scaled coordinates, Ns x Ns; empty if dh/dt is singular. Of impacts at one
  /// instant that of their order in the sequence. Events at which u'' and xi' are continuous are left out:
  /// dP/dt is 0 of them, and dh/dt too where a phase of contact has no length.
  [[nodiscard]] Eigen::MatrixXd monodromy() const;
  /// How the instants follow the state at the section, -(dh/dt)^-1 dh/dy_0, m x Ns in the scales; empty
  /// likewise.
  [[nodiscard]] Eigen::MatrixXd instants_by_state() const;
  /// Whether event i may come before event k < i and the equations still mean the same motion: impacts of two
  /// contacts that do not feel each other through the mass.
  [[nodiscard]] bool may_overtake(Eigen::Index i, Eigen::Index k) const;
  /// The orbit of the last evaluation, its state at the section apart.
  [[nodiscard]] const OrbitGuess& sequence() const { return sequence_; }
  /// The orbit of given unknowns, with the sequence of this one.
  [[nodiscard]] OrbitGuess orbit(const Eigen::VectorXd& unknowns) const;

 private:
  struct EventLaw {            // what is constant of an event
    bool of_force = false;     // its equation is that of a force
    Eigen::MatrixXd impulse;   // p of those pushed as a map of v_-, |S| x Nd
    Eigen::MatrixXd response;  // v_+ - v_- as a map of p: M^-1 W_S, Nd x |S|
    double unit = 1.0;         // of the equation
  };
  void pass(const Eigen::VectorXd& unknowns, bool derivatives);
  void carry(Eigen::Index i, double duration);
  void pass_event(Eigen::Index i, bool derivatives);
  void differentiate_event(Eigen::Index i);
  void differentiate_closure();
  [[nodiscard]] bool jumps(const SequenceEvent& event) const;

  OrbitModel& model_;
  OrbitGuess sequence_;
  Expired expired_;
  const Eigen::Index p_ = model_.dynamics.positions(), n_ = model_.dynamics.size(), states_ = p_ + n_;
  const Eigen::Index m_ = std::ssize(sequence_.events);
  const double x_unit_ = model_.dynamics.scales().displacement, v_unit_ = model_.dynamics.scales().velocity;
  const double t_unit_ = 1.0 / model_.dynamics.structure().frequency;
  double largest_state_ = 0.0;
  Eigen::VectorXd first_, residual_, rate_;
  Eigen::MatrixXd jacobian_;
  // Derivatives of the state, in SI units: by the state at the section, or by the amplitudes that `reading_`
  // takes from it, then by the instants passed so far.
  Eigen::MatrixXd sensitivity_, reading_;
  Columns kind_;
  Eigen::Index of_state_ = 0;  // columns of the former
  State state_;
  std::vector<const LinearFlow*> flows_;
  std::vector<EventLaw> laws_;
  std::vector<std::shared_ptr<LinearArc>> arcs_;
  std::vector<EventCrossing> crossings_;
};

/// How Newton's method ended.
struct OrbitNewtonResult {
  bool solved = false;       ///< the unknowns are a solution
  bool merging = false;      ///< it failed because two events of the sequence come together
  std::string reason = {};   ///< why it failed, one clause
  int iterations = 0;        ///< Newton steps
  double residual = 0.0;     ///< largest of the equations, in scales; 0 where they are not finite [-]
  Eigen::VectorXd unknowns;  ///< of the last iterate, at which `equations` are left evaluated
};

/// Solves the equations from their guess by `damped_newton`. Steps are shortened so that no interval between
/// events loses more than four fifths of its length, for beyond an event that overtakes another the equations
/// mean nothing (where it may, within .05, that is added to its length), and halved until the residual falls.
/// Solved: residual <= max(tolerance, noise()), reduced by one more step where that is possible, or a
/// residual that no longer falls, or not by half in ten steps, and is within a hundred times its noise. Any
/// other that falls so slowly is given up. \param expired  asked before every step; true ends the search
/// unsolved
OrbitNewtonResult solve(OrbitEquations& equations, double tolerance, int max_iterations,
                        const std::function<bool()>& expired = {});

/// Whether one of the contacts is closed.
bool any_closed(const std::vector<bool>& closed);

/// Whether a contact presses or is struck. Motions that touch nothing are families of another kind, of any
/// mean within the clearances, and asked for apart (polish_free_member).
bool touches(const OrbitGuess& path);

/// A Jacobian of OrbitEquations where orbits are not isolated.
struct FamilyInverse {
  Eigen::MatrixXd inverse;  ///< J^+, the steps that leave the place in the family alone
  double condition = 1.0;   ///< of J without the family [-]
};

/// The pseudo-inverse of a Jacobian J that is singular for nothing but displacements at rest: no velocity and
/// no instant of an event changes along them, as where a gear pair turns as one, or nothing touches.
/// Equations of an orbit stay solvable there. Nothing for any other J: to 1e-9 of its largest singular value,
/// 1e-6 of a direction's length. \param states  Ns, of which the first half at least are displacements
std::optional<FamilyInverse> family_inverse(const Eigen::MatrixXd& J, Eigen::Index states);

/// That of equations where they are evaluated; nothing where nothing touches, and for a Jacobian whose
/// reciprocal condition is above 1e-12: below it a step is rounding.
std::optional<FamilyInverse> family_inverse(const OrbitEquations& equations, double reciprocal_condition);

}  // namespace signorini
