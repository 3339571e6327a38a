#pragma once
// Equations of motion of a contact scene while the set of closed contacts does not change.

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <vector>

#include "methods/structure/state.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// The set A of closed contacts: sticking to a rigid stop, or pushing a compliant stop.
struct ContactMode {
  std::vector<int> active;  ///< A, ascending
  /// Rigid stops: G_AA^-1, G = W^T M^-1 W [kg]; compliant ones: C_AA^-1 [N/m]. The pseudo-inverse where stops
  /// depend on each other, which shares a force evenly.
  Eigen::MatrixXd response;

  [[nodiscard]] bool closed(int contact) const;
};

/// Magnitudes that the tolerances of the integration and of the periodicity refer to.
struct MotionScales {
  double displacement =
      1.0;                ///< X [m]: of the linear response, or of the gap and the forced motion if smaller
  double velocity = 1.0;  ///< V = omega X [m/s]
  double acceleration = 1.0;  ///< omega_max V [m/s^2]
};

/// Time derivatives of the motion and of the contact force at one instant.
struct MotionDerivatives {
  Eigen::MatrixXd u;       ///< Nd x (order + 1): column k is the k-th derivative of u
  Eigen::MatrixXd x;       ///< Nc x (order - 1): of the contact displacements
  Eigen::MatrixXd lambda;  ///< Nc x (order - 1): of the contact forces
};

/// Between events the motion of the coordinates with mass (`condense`) obeys the linear equation
///
///     M u'' + D u' + K u = f(t) + W lambda,
///
/// lambda_j = 0 at open contacts. A rigid stop has the multiplier that keeps x_j'' = 0:
/// G_AA lambda_A = -W_A^T M^-1 (f - K u - D u') with the Delassus matrix G = W^T M^-1 W. A compliant stop,
/// because it is a spring (k_j) or because the coordinates behind it carry no mass (compliance C_0, shift
/// s), has the force that keeps it closed:
///
///     W_A^T u + s_A(t) + C_AA lambda_A = g_A,    C = C_0 + diag(1 / k),    x = W^T u + s(t) + C_0 lambda.
class ContactDynamics {
 public:
  /// \throws std::runtime_error with flow_obstacle(problem) if there is one
  explicit ContactDynamics(const Problem& problem);

  /// Nd: coordinates with mass, in the order of the scene's.
  [[nodiscard]] int size() const { return static_cast<int>(directions_.rows()); }
  [[nodiscard]] int contact_count() const { return static_cast<int>(directions_.cols()); }
  /// The state of the coordinates with mass out of that of all.
  [[nodiscard]] State with_mass(const State& whole) const {
    return {.u = whole.u(kept_), .v = whole.v(kept_)};
  }
  /// False where the stops are compliant.
  [[nodiscard]] bool rigid() const { return rigid_; }
  [[nodiscard]] double restitution() const { return restitution_; }  ///< e [-]; 1 without a law
  [[nodiscard]] double frequency() const { return frequency_; }      ///< omega [rad/s]
  [[nodiscard]] const SparseMatrix& mass() const { return mass_matrix_; }
  [[nodiscard]] const SparseMatrix& damping() const { return damping_; }
  [[nodiscard]] const SparseMatrix& stiffness() const { return stiffness_; }
  [[nodiscard]] const Eigen::MatrixXd& compliance() const { return compliance_; }  ///< C, Nc x Nc [m/N]
  /// C_0, by which a contact force moves the contacts themselves at once, Nc x Nc [m/N].
  [[nodiscard]] const Eigen::MatrixXd& massless_compliance() const { return massless_compliance_; }
  /// h omega of the harmonics present in the load, ascending, 0 always the first [rad/s].
  [[nodiscard]] const std::vector<double>& load_rates() const { return rates_; }
  /// f_h of f(t) = Re sum_h f_h e^{i h omega t}, one column per rate, Nd x Nh [N].
  [[nodiscard]] const Eigen::MatrixXcd& load_amplitudes() const { return load_; }
  /// s_h likewise, Nc x Nh [m].
  [[nodiscard]] const Eigen::MatrixXcd& shift_amplitudes() const { return shift_; }
  [[nodiscard]] double forcing_period() const { return forcing_period_; }
  [[nodiscard]] const Eigen::MatrixXd& directions() const { return directions_; }  ///< W, Nd x Nc
  [[nodiscard]] const Eigen::MatrixXd& velocity_per_impulse() const {
    return velocity_per_impulse_;
  }                                                                            ///< M^-1 W
  [[nodiscard]] const Eigen::MatrixXd& delassus() const { return delassus_; }  ///< G, Nc x Nc
  [[nodiscard]] const Eigen::VectorXd& gaps() const { return gaps_; }          ///< g, Nc [m]
  [[nodiscard]] const MotionScales& scales() const { return scales_; }
  /// Upper estimate of the fastest rate of structure and load, max(sqrt(K/M), D/M, h omega) [rad/s].
  [[nodiscard]] double fastest_rate() const { return fastest_rate_; }
  /// Highest harmonic of the load, at least 1.
  [[nodiscard]] int highest_harmonic() const { return highest_harmonic_; }
  /// Unit of lambda_j in tolerances: X / C_jj, or the acceleration scale over G_jj at a rigid stop [N].
  [[nodiscard]] double force_scale(int contact) const;

  /// The mode in which exactly the contacts with closed[j] are closed.
  [[nodiscard]] ContactMode mode(const std::vector<bool>& closed) const;

  /// u'' in a mode; `u`, `v`, `a` are Nd. Allocation apart, free of side effects.
  void acceleration(const ContactMode& mode, double time, const Eigen::Ref<const Eigen::VectorXd>& u,
                    const Eigen::Ref<const Eigen::VectorXd>& v, Eigen::Ref<Eigen::VectorXd> a) const;

  /// Derivatives 0..order (>= 2) of u and 0..order-2 of x and lambda, exact from the equation of motion.
  [[nodiscard]] MotionDerivatives derivatives(const ContactMode& mode, double time, const State& state,
                                              int order) const;

  /// order-th derivative of W^T u + s, the contact displacements without contact forces, from that of u, Nc.
  [[nodiscard]] Eigen::VectorXd unloaded(double time, const Eigen::Ref<const Eigen::VectorXd>& u,
                                         int order) const;
  /// order-th derivative of lambda at compliant stops, from that of `unloaded`, Nc.
  [[nodiscard]] Eigen::VectorXd compliant_force(const ContactMode& mode, const Eigen::VectorXd& unloaded,
                                                int order) const;

  /// The 2 Nd x 2 Nd matrix B of the homogeneous flow (u, v)' = B (u, v) in a mode.
  [[nodiscard]] Eigen::MatrixXd flow_matrix(const ContactMode& mode) const;

 private:
  void take_structure(const Problem& problem);
  [[nodiscard]] Eigen::VectorXd multiplier(const ContactMode& mode, const Eigen::VectorXd& free) const;
  void prepare_small();
  void measure_rates();
  void measure_scales(const Problem& problem);

  // Terms of M^-1 f(t) of one harmonic.
  struct LoadRate {
    double rate = 0.0;         // h omega [rad/s]
    Eigen::VectorXd cos, sin;  // M^-1 times the amplitudes, Nd
  };

  std::vector<int> kept_;  // coordinates of the scene that carry mass
  SparseMatrix mass_matrix_, stiffness_, damping_;
  // Small structures: M^-1 K, M^-1 D and M^-1 f are formed once, so that an evaluation allocates nothing.
  bool small_ = false;
  Eigen::MatrixXd inverse_mass_stiffness_, inverse_mass_damping_;
  std::vector<LoadRate> inverse_mass_load_;
  Eigen::SimplicialLLT<SparseMatrix> mass_;
  std::vector<double> rates_;
  Eigen::MatrixXcd load_, shift_;
  Eigen::MatrixXd directions_, velocity_per_impulse_, delassus_, compliance_, massless_compliance_;
  Eigen::VectorXd gaps_;
  bool rigid_ = true;
  int highest_harmonic_ = 1;
  double restitution_ = 1.0, frequency_ = 1.0, forcing_period_ = 1.0, fastest_rate_ = 1.0;
  MotionScales scales_;
};

}  // namespace signorini
