#pragma once
// The exact flow of a contact scene while the set of closed contacts does not change.

#include <Eigen/Core>
#include <map>
#include <memory>
#include <vector>

#include "methods/flow/contact_dynamics.hpp"
#include "methods/flow/energy_form.hpp"
#include "methods/solution.hpp"

namespace signorini {

/// How a flow is represented.
enum class FlowForm {
  automatic,    ///< complex modes; where they fail, the exponential
  exponential,  ///< the matrix exponential of structure and load together: slow, always defined
};

/// The linear motions of one contact mode A in closed form.
///
/// A rigid stop's constraint is removed, not penalised: u = u_g + Q q with Q an orthonormal basis of the
/// null space of W_A^T and W_A^T u_g = g_A, so that q obeys Q^T (M, D, K) Q and the load Q^T (f - K u_g) (and
/// the double eigenvalue zero of x'' = 0 is gone). Compliant stops add W_A C_AA^-1 W_A^T to K and
/// W_A C_AA^-1 (g_A - s_A) to the load (ContactDynamics). With the complex modes (mu_k, U_k) of the reduced
/// structure, proportional damping or not,
///
///     u(t) = Re sum_k w_k U_k a_k e^{mu_k (t - t0)} + Re sum_h P_h e^{i h omega t},
///
/// Im mu_k >= 0, w_k = 2 for a pair and 1 for a real mu_k (ComplexModes). Where they are ill-conditioned
/// (critical damping, a rigid-body motion) or the load resonates with an undamped mode, the exponential of
/// the structure augmented by the harmonic generators of the load takes over, in the coordinates of the
/// energy (EnergyForm): there no motion grows on its way, and squaring the exponential loses no digits to it.
class LinearFlow {
 public:
  /// \throws std::runtime_error if the structure has more coordinates than a dense flow can take (300)
  LinearFlow(const ContactDynamics& dynamics, ContactMode mode, FlowForm form = FlowForm::automatic);

  [[nodiscard]] const ContactMode& mode() const { return mode_; }
  [[nodiscard]] int size() const { return static_cast<int>(basis_.rows()); }  ///< Nd
  [[nodiscard]] int degrees_of_freedom() const { return static_cast<int>(basis_.cols()); }
  [[nodiscard]] bool modal() const { return modal_; }
  /// Largest |mu_k| and h omega [rad/s].
  [[nodiscard]] double fastest_rate() const { return fastest_rate_; }
  /// d(u, v)(t0 + duration) / d(u, v)(t0), 2 Nd x 2 Nd; deviations normal to the constraint are dropped.
  [[nodiscard]] Eigen::MatrixXd transition(double duration) const;
  /// What impulses at the contacts, each `time` before now, have made of a structure at rest without load.
  [[nodiscard]] State response(const std::vector<Impulse>& impulses) const;
  /// d lambda_j / d(u, v) at a closed contact, 1 x 2 Nd.
  [[nodiscard]] Eigen::RowVectorXd multiplier_gradient(int contact) const;
  /// d x_j / d(u, v), 1 x 2 Nd.
  [[nodiscard]] Eigen::RowVectorXd displacement_gradient(int contact) const;

 private:
  friend class LinearArc;
  bool find_modes(const EnergyForm& energy);
  void prepare_exponential(const EnergyForm& energy);
  void prepare_outputs();
  [[nodiscard]] Eigen::VectorXcd reduced_load(Eigen::Index h) const;
  [[nodiscard]] Eigen::MatrixXd multiplier_rows() const;
  [[nodiscard]] Eigen::MatrixXd displacement_rows() const;
  [[nodiscard]] Eigen::MatrixXcd outputs_of_load() const;
  [[nodiscard]] int place(int contact) const;  // of a closed contact among the active ones

  const ContactDynamics* dynamics_;
  ContactMode mode_;
  bool modal_ = false;
  double fastest_rate_ = 0.0;
  Eigen::MatrixXd basis_;      // Q, Nd x Nr
  Eigen::VectorXd offset_;     // u_g, Nd
  std::vector<double> rates_;  // h omega of the load, the constant first
  Eigen::MatrixXcd load_;      // Nd x Nh, spring forces of closed penalty stops included

  Eigen::VectorXcd mu_;               // Nm
  Eigen::VectorXd weight_;            // w_k
  Eigen::MatrixXcd shapes_;           // U, Nd x Nm
  Eigen::MatrixXcd left_;             // Nm x 2 Nd: a = left ((u, v) - forced)
  Eigen::MatrixXcd forced_;           // P, Nd x Nh
  Eigen::MatrixXcd row_of_mode_;      // outputs x_0..x_Nc-1, lambda_A: rows x Nm, w_k included
  Eigen::MatrixXcd row_of_harmonic_;  // rows x Nh

  // Exponential form: the coordinates of the energy, e of the position and z' of the velocity, Nr each.
  Eigen::MatrixXd u_of_e_, v_of_z_;  // Nd x Nr
  Eigen::MatrixXd e_of_u_, z_of_v_;  // Nr x Nd
  Eigen::MatrixXd generator_;        // of (e, z', cos and sin of each harmonic)
  Eigen::MatrixXd output_;           // rows x generator size
};

/// A term of a motion that oscillates or decays, and how long it matters.
struct FadingRate {
  double rate = 0.0;   ///< |mu_k| or h omega [rad/s]
  double until = 0.0;  ///< [s]
};

/// Largest rate that still matters at a time; `terms` as `LinearArc::fading_rates` gives them [rad/s].
double fastest_left(const std::vector<FadingRate>& terms, double time);

/// One motion of a flow. Evaluations allocate nothing in the modal form; they share a cache of the last
/// instant, so that one arc belongs to one thread.
class LinearArc {
 public:
  /// The motion through `state` at `time`; the flow must outlive the arc.
  void start(const LinearFlow& flow, double time, const State& state);

  [[nodiscard]] const LinearFlow& flow() const { return *flow_; }
  [[nodiscard]] double begin() const { return begin_; }
  /// The terms of the motion, fastest first, the load's harmonics as the last one. A mode matters until its
  /// share in every guard (gap of an open contact over X, force of a closed one over its scale) has fallen
  /// below `floor`; with `step` and `order`, so has its share in step^k times the k-th derivatives, k <=
  /// order.
  [[nodiscard]] std::vector<FadingRate> fading_rates(double floor, double step = 0.0, int order = 0) const;
  /// u, v (and u'') at a time, Nd each.
  void state(double time, State& state) const;
  void acceleration(double time, Eigen::VectorXd& a) const;
  /// order-th derivative (0..8) of x_j [m / s^order].
  [[nodiscard]] double displacement(int contact, double time, int order = 0) const;
  /// order-th derivative (0..8) of lambda_j, zero at open contacts [N / s^order].
  [[nodiscard]] double force(int contact, double time, int order = 0) const;

 private:
  [[nodiscard]] double output(Eigen::Index row, double time, int order) const;
  void move_to(double time) const;

  const LinearFlow* flow_ = nullptr;
  double begin_ = 0.0;
  Eigen::VectorXcd amplitude_;     // a_k
  Eigen::MatrixXcd contribution_;  // row_of_mode times a_k
  Eigen::VectorXd first_;          // exponential form: the augmented state at `begin`
  mutable double now_ = 0.0;
  mutable bool placed_ = false;
  mutable Eigen::VectorXcd growth_, wave_;  // e^{mu_k s}, e^{i h omega t}
  mutable Eigen::VectorXd augmented_;
};

/// The flows of a scene's contact modes, each made when first asked for.
class LinearFlows {
 public:
  explicit LinearFlows(const ContactDynamics& dynamics, FlowForm form = FlowForm::automatic)
      : dynamics_(dynamics), form_(form) {}
  /// The flow in which exactly the contacts with closed[j] are closed. \throws std::runtime_error
  const LinearFlow& of(const std::vector<bool>& closed);
  [[nodiscard]] const ContactDynamics& dynamics() const { return dynamics_; }

 private:
  const ContactDynamics& dynamics_;
  FlowForm form_;
  std::map<std::vector<bool>, std::unique_ptr<LinearFlow>> flows_;
};

}  // namespace signorini
