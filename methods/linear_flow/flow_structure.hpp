#pragma once
// The structure that a flow moves: coordinates with mass, their load, and the contacts as they see them.

#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <vector>

#include "methods/structure/bases/condensation.hpp"
#include "methods/structure/state.hpp"
#include "problems/linear_algebra/sparse/sparse_factors.hpp"

namespace signorini {

/// Magnitudes that the tolerances of the integration and of the periodicity refer to.
struct MotionScales {
  /// X [m]: of the linear response, or of the gap and the forced motion if smaller.
  double displacement = 1.0;
  double velocity = 1.0;      ///< V = omega X [m/s]
  double acceleration = 1.0;  ///< omega_max V [m/s^2]

  /// max(|u_a - u_b| / X, |v_a - v_b| / V), in the maximum norm, u with its relaxing part if any [-].
  [[nodiscard]] double distance(const State& a, const State& b) const {
    return std::max((a.u - b.u).lpNorm<Eigen::Infinity>() / displacement,
                    (a.v - b.v).lpNorm<Eigen::Infinity>() / velocity);
  }
};

/// The order-th time derivative of Re sum_h A_h e^{i r_h t}.
/// \param amplitudes  A, a column for each rate
/// \param rates       r_h [rad/s]
Eigen::VectorXd wave_derivative(const Eigen::MatrixXcd& amplitudes, const std::vector<double>& rates,
                                double time, int order);

/// The condensed structure (`condense`) of a scene, its mass factorised:
///
///     M u'' + D u' + K u = f(t) + W lambda,    x = W^T u + s(t) + C_0 lambda <= g,    lambda <= 0,
///
/// f(t) = Re sum_h f_h e^{i r_h t} and s(t) likewise, over the rates r_h of the harmonics present. With a
/// relaxation time beta > 0 there are Nc more positions xi, which follow u in every state,
///
///     x = W^T u + xi,    beta_j xi_j' + xi_j = (s(t) + C_0 lambda)_j.
class FlowStructure : public CondensedStructure {
 public:
  /// \throws std::runtime_error with flow_obstacle(problem) if there is one
  explicit FlowStructure(const Problem& problem);
  /// `condensed` in place of condense(problem), whose contacts, gaps, law, load and scales are meant: a
  /// reduced structure. \throws std::runtime_error with its obstacle, or that its mass is singular
  FlowStructure(const Problem& problem, CondensedStructure condensed);
  /// The same structure under the same load at another frequency, X of its scales kept.
  [[nodiscard]] FlowStructure at_frequency(double omega) const;

  [[nodiscard]] int size() const { return static_cast<int>(directions.rows()); }  ///< Nd
  /// Nc, those that act: `open` is not among them.
  [[nodiscard]] int contact_count() const { return static_cast<int>(directions.cols()); }
  /// The contact of the scene that an acting one is, or, from Nc on, an open one.
  [[nodiscard]] int scene_contact(int contact) const;
  /// Those of all: Nc that act, then No that stay open.
  [[nodiscard]] std::vector<int> scene_contacts() const;
  /// Of the parts xi: Nc with a relaxation time, else 0.
  [[nodiscard]] int relaxing() const { return static_cast<int>(xi_times.size()); }
  /// Whether xi of this contact moves: beside such stops it is 0 at one on coordinates with mass, which is
  /// rigid or a spring alone.
  [[nodiscard]] bool relaxes(int contact) const { return relaxing() > 0 && relaxation[contact] > 0.0; }
  [[nodiscard]] int positions() const { return size() + relaxing(); }  ///< Np, of u and xi
  [[nodiscard]] int states() const { return positions() + size(); }    ///< of (u, xi, v)
  /// f, Nd [N].
  [[nodiscard]] Eigen::VectorXd load_at(double time) const;
  /// k-th time derivative of f - K u - D u', Nd [N / s^k]; column i of `u` is the i-th derivative of u, and
  /// of xi below it, Np rows.
  [[nodiscard]] Eigen::VectorXd free_force(double time, const Eigen::MatrixXd& u, int k) const;
  /// order-th time derivative of W^T u + s, the contact displacements without contact forces, from that of
  /// u, Nc [m / s^order]; with a relaxation time that of x = W^T u + xi from that of (u, xi), Np.
  [[nodiscard]] Eigen::VectorXd unloaded(double time, const Eigen::Ref<const Eigen::VectorXd>& u,
                                         int order) const;
  /// order-th time derivative of s, Nc [m / s^order].
  [[nodiscard]] Eigen::VectorXd shift_at(double time, int order) const;

  /// C_j / beta, which xi takes at once of an impulse at contact j, Nc [m / (N s)]. Precondition: relaxing().
  [[nodiscard]] Eigen::VectorXd displacement_per_impulse(int contact) const {
    return massless_compliance.col(contact).cwiseQuotient(xi_times);
  }

  /// Newton's law for contacts S that take an impulse together, p as a map of v_-, |S| x Nd [kg]:
  /// W_S^T v_+ = -e W_S^T v_- with v_+ = v_- + M^-1 W_S p, hence p = -G_SS^-1 diag(1 + e) W_S^T v_-. Stops
  /// that depend on each other have a singular G_SS and share p.
  [[nodiscard]] Eigen::MatrixXd impulse_of_velocity(const std::vector<int>& pushed,
                                                    const std::vector<double>& restitution) const;

  std::shared_ptr<const SparseLlt> factors;  ///< of M
  Eigen::MatrixXd directions;                ///< W, the dense normals, Nd x Nc [-]
  Eigen::MatrixXd velocity_per_impulse;      ///< M^-1 W, Nd x Nc [1/kg]
  Eigen::MatrixXd delassus;                  ///< G = W^T M^-1 W, Nc x Nc [1/kg]
  Eigen::MatrixXd compliance;  ///< C = C_0 + diag(1 / k) of springs, C_0 the massless, Nc x Nc [m/N]
  /// beta of each xi, the largest of all where it stays 0; empty where none moves [s]
  Eigen::VectorXd xi_times;
  Eigen::VectorXd gaps;       ///< g, Nc [m]
  Eigen::VectorXd open_gaps;  ///< those of `open`, No [m]
  /// What open contacts follow: x_o = open_rows u + open_by_contacts x + waves, where nothing relaxes with
  /// C_oj lambda in place of the second term; periodic motions, in which what relaxes has forgotten its
  /// beginning. No x Nd, No x Nc and No x Nh.
  Eigen::MatrixXd open_rows, open_by_contacts;  ///< the latter is C_oj C_jj^-1
  Eigen::MatrixXcd open_waves;                  ///< (s_o - open_by_contacts s) / (1 + i beta r_h)
  double open_row_norm = 0.0;                   ///< the largest of open_rows [-]
  double open_contact_sum = 0.0;                ///< the largest row sum of |open_by_contacts| [-]
  /// The largest |C_oj| over open contacts where nothing relaxes, Nc [m/N]; empty where something does.
  Eigen::VectorXd open_compliance;
  /// Those of `open` whose C_oj is no combination of the C_jj to 1e-12: their motion is not known.
  std::vector<int> open_unclear;
  double frequency = 1.0;       ///< omega [rad/s]
  double forcing_period = 1.0;  ///< 2 pi / omega [s]
  int highest_harmonic = 1;     ///< of the load, at least 1
  /// Upper estimate of the fastest rate of structure and load, max(sqrt(K/M), D/M, 1/beta, h omega) [rad/s].
  double fastest_rate = 1.0;
  /// The fastest motions decay without oscillating, D/M > 2 sqrt(K/M): an explicit integrator has to take
  /// steps of 1 / fastest_rate for motions that are long gone.
  bool stiff = false;
  MotionScales scales;  ///< of the motions to expect

 private:
  void measure_rates();
  void set_frequency(double omega);
  void measure_scales(const Problem& problem);
  [[nodiscard]] double reduced_amplitude() const;
  void follow_open();
  void find_unclear();

  double oscillation_ = 0.0, decay_ = 0.0;  // fastest of the structure alone [rad/s]
};

}  // namespace signorini
