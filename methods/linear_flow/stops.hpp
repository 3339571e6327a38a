#pragma once
// The forces of closed contacts: rigid stops, which hold, and compliant ones, which spring.

#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <vector>

#include "methods/linear_flow/flow_structure.hpp"

namespace signorini {

/// The set A of closed contacts: sticking to a rigid stop, or pushing a compliant or relaxing stop.
struct ContactMode {
  std::vector<int> active;  ///< A, ascending
  /// Inverse of Stops::coupling over A: G_AA^-1 [kg] or C_AA^-1 [N/m]. The pseudo-inverse where stops depend
  /// on each other, which shares a force evenly.
  Eigen::MatrixXd response;

  /// Whether a contact is in A.
  [[nodiscard]] bool closed(int contact) const;
};

/// Time derivatives of the motion and of the contact force at one instant.
struct MotionDerivatives {
  /// Np x (order + 1): column k is the k-th derivative of u, above that of xi where contacts relax, which is
  /// filled up to order - 1.
  Eigen::MatrixXd u;
  Eigen::MatrixXd x;       ///< Nc x (order - 1): of the contact displacements
  Eigen::MatrixXd lambda;  ///< Nc x (order - 1): of the contact forces
};

/// The parts xi of relaxing contacts in one mode, by u and by No numbers z of the open ones, which relax
/// alone:
///
///     xi = of_u u + of_z z + offset,   z = of_xi xi,   beta z' + z = Re sum_h shift_h e^{i r_h t}.
///
/// Without relaxing contacts there are no rows.
struct RelaxingForm {
  Eigen::MatrixXd of_u = {};    ///< Nc x Nd [-]
  Eigen::MatrixXd of_z = {};    ///< Nc x No [-]
  Eigen::MatrixXd of_xi = {};   ///< No x Nc [-]
  Eigen::VectorXd offset = {};  ///< Nc [m]
  Eigen::MatrixXcd shift = {};  ///< No x Nh [m]
  Eigen::VectorXd times = {};   ///< beta of each z, No [s]
};

/// A mode's equation of motion without its constraint: u = offset + basis q, and q obeys
/// basis^T (M, D, K) basis, D and K those of Stops::damping and Stops::stiffness, under
/// basis^T (load - K offset). Its contact forces are
/// lambda_A = force_of_state (u, xi, v) + Re sum_h force_of_load_h e^{i r_h t}; empty where no contact is
/// closed.
struct FreeForm {
  Eigen::MatrixXd basis;                ///< Q, Nd x Nr, orthonormal; 1 where nothing is held
  Eigen::VectorXd offset;               ///< u_g, Nd [m]
  Eigen::MatrixXcd load;                ///< f_h and the forces of those springs at u = 0, Nd x Nh [N]
  Eigen::MatrixXd force_of_state = {};  ///< |A| x (Np + Nd)
  Eigen::MatrixXcd force_of_load = {};  ///< |A| x Nh [N]
  RelaxingForm relaxing = {};           ///< of xi
};

/// What the closed contacts A of a mode do to the motion M u'' + D u' + K u = f + W lambda.
///
/// A rigid stop has the multiplier that keeps x_j'' = 0,
///
///     G_AA lambda_A = -W_A^T M^-1 (f - K u - D u'),    G = W^T M^-1 W.
///
/// A compliant stop, because it is a spring (k_j) or because the coordinates behind it carry no mass
/// (compliance C_0, shift s), has the force that keeps it closed:
///
///     W_A^T u + s_A(t) + C_AA lambda_A = g_A,    C = C_0 + diag(1 / k),    x = W^T u + s(t) + C_0 lambda.
///
/// A relaxing stop, behind damped coordinates without mass (relaxation time beta_j), holds its contact at
/// x_A = g_A, which is a spring and a dashpot of the structure:
///
///     lambda_A = C_AA^-1 (g_A - s_A(t) - W_A^T u - beta W_A^T u'),    C = C_0.
///
/// Beside relaxing stops one that is a spring alone, on coordinates with mass, has beta = 0 in this, C_jj =
/// 1 / k_j and xi_j = 0: each kind follows the state, none feels the other.
///
/// Where a structure has rigid and compliant stops, those follow the equations of a structure with the
/// springs of these, K + W C^-1 W^T.
///
/// Meanwhile xi_A = g_A - W_A^T u of relaxing ones, and of the open contacts O the numbers z = xi_O - C_OA
/// C_AA^-1 xi_A relax by themselves, beta z' + z = s_O - C_OA C_AA^-1 s_A.
class Stops {
 public:
  /// Those of a structure, which must outlive them: of each contact whether it is rigid, else compliant,
  /// relaxing if besides the structure has a relaxation time.
  static std::unique_ptr<const Stops> on(const FlowStructure& structure, const std::vector<bool>& rigid);
  virtual ~Stops() = default;

  /// Of each contact whether it takes impulses, so that its velocity may jump.
  [[nodiscard]] const std::vector<bool>& rigid() const { return rigid_; }
  /// Whether one does.
  [[nodiscard]] bool rigid(int contact) const { return rigid_[static_cast<std::size_t>(contact)]; }
  /// Whether some contacts do and others do not.
  [[nodiscard]] bool mixed() const { return mixed_; }
  /// Where in a list of contacts those are that are rigid, or those that give way, ascending.
  [[nodiscard]] std::vector<int> places(const std::vector<int>& contacts, bool rigid) const;
  /// The closed contacts of a mode that are rigid, or those that give way, with their own response.
  [[nodiscard]] ContactMode part(const ContactMode& mode, bool rigid) const;
  /// G or C, by which the forces of closed contacts depend on each other, Nc x Nc. Forces of compliant stops
  /// follow from the state alone: between a rigid and a compliant one it is 0.
  [[nodiscard]] const Eigen::MatrixXd& coupling() const { return coupling_; }
  /// Unit of coupling times force in tolerances: the acceleration scale, or X, or max(X, beta V).
  [[nodiscard]] double scale(int contact) const {
    const MotionScales& scales = structure_.scales;
    if (rigid(contact)) return scales.acceleration;
    const double beta = structure_.relaxes(contact) ? structure_.relaxation[contact] : 0.0;
    return std::max(scales.displacement, beta * scales.velocity);
  }

  /// Adds M^-1 W lambda to `a`, the acceleration without contact forces; `u` is Np, `v` and `a` are Nd.
  virtual void add_acceleration(const ContactMode& mode, double time,
                                const Eigen::Ref<const Eigen::VectorXd>& u,
                                const Eigen::Ref<const Eigen::VectorXd>& v,
                                Eigen::Ref<Eigen::VectorXd> a) const = 0;
  /// Writes xi' where contacts relax.
  virtual void relax(const ContactMode&, double, const Eigen::Ref<const Eigen::VectorXd>&,
                     const Eigen::Ref<const Eigen::VectorXd>&, Eigen::Ref<Eigen::VectorXd>) const {}
  /// Derivatives 0..order (>= 2) of u and 0..order-2 of x and lambda, exact from the equation of motion.
  [[nodiscard]] MotionDerivatives derivatives(const ContactMode& mode, double time, const State& state,
                                              int order) const;
  /// x, x', lambda and lambda' at a state, Nc each, the forces zero at open contacts.
  virtual void forces(const ContactMode& mode, double time, const State& state, Eigen::VectorXd& x,
                      Eigen::VectorXd& rate, Eigen::VectorXd& force, Eigen::VectorXd& force_rate) const;
  /// K and the springs of closed stops, Nd x Nd [N/m].
  [[nodiscard]] virtual Eigen::MatrixXd stiffness(const ContactMode&) const { return structure_.stiffness; }
  /// D and their dashpots, Nd x Nd [N s/m].
  [[nodiscard]] virtual Eigen::MatrixXd damping(const ContactMode&) const { return structure_.damping; }
  /// Takes the part of the accelerations u'' = from_u u + from_v u' (second and third argument, Nd x Nd) that
  /// closed contacts do not admit away: nothing at compliant stops.
  virtual void constrain(const ContactMode&, Eigen::MatrixXd&, Eigen::MatrixXd&) const {}
  /// The mode's equation without constraint, and its contact forces.
  [[nodiscard]] virtual FreeForm free_form(const ContactMode& mode) const = 0;
  /// The rate of the fastest motion where closed contacts make it faster than `rate` [rad/s].
  [[nodiscard]] virtual double fastest_rate(const ContactMode&, double rate) const { return rate; }

  /// Fills column k of x and lambda, k + 2 of u and k + 1 of xi, `load` being the k-th derivative of
  /// f - K u - D u'.
  virtual void differentiate(const ContactMode& mode, double time, int k, Eigen::VectorXd load,
                             MotionDerivatives& motion) const = 0;

 protected:
  /// \param structure  of the scene, kept by the caller
  Stops(const FlowStructure& structure, std::vector<bool> rigid);
  /// Rigid ones, alone or beside others (rigid_stops.cpp).
  static std::unique_ptr<const Stops> rigid_on(const FlowStructure& structure,
                                               const std::vector<bool>& rigid);
  /// The form of a mode without closed contacts.
  [[nodiscard]] FreeForm open_form() const;
  const FlowStructure& structure_;  ///< of the scene

 private:
  std::vector<bool> rigid_;
  bool mixed_ = false;
  Eigen::MatrixXd coupling_;
};

}  // namespace signorini
