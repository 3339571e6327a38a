#pragma once
// Contacts on damped coordinates without mass, and their motion in the coordinates of the whole structure.

#include <Eigen/Core>
#include <vector>

#include "problems/problem.hpp"

namespace signorini::test {

/// Three masses of 1 kg in a row on springs of 4 N/m and dashpots of 0.05 N s/m, a massless tip behind a
/// spring of 4 N/m and a dashpot of `dashpot` [N s/m], 0.2 m before its stop; 0.5 N cos(1.1 rad/s t) on the
/// first mass.
Problem damped_tip_chain(double dashpot);

/// The same chain with D = 0.02 / s M + 0.06 s K and a constant load of 0.1 N on its tip.
Problem rayleigh_chain();

/// coupled_massless_scene with D += beta K.
Problem damped_coupled_scene(unsigned seed, double beta);

/// The motion of a whole structure with D_bb definite, b its coordinates without mass, in y = (u_i, v_i,
/// u_b):
///
///     u_b' = D_bb^-1 (f_b + W_b lambda - D_bi v_i - K_bi u_i - K_bb u_b),
///     v_i' = M_ii^-1 (f_i - D_ii v_i - D_ib u_b' - K_ii u_i - K_ib u_b),
///
/// that is y' = A y + F(t) + B lambda, x = E y, for contacts on b. Forces are those that stop the closed
/// contacts, lambda = -(E B)^-1 E (A y + F). Shares no code with the library but the scene.
class DescriptorFlow {
 public:
  explicit DescriptorFlow(const Problem& problem);

  [[nodiscard]] Eigen::Index size() const { return A_.rows(); }
  /// y' with the closed contacts `active`.
  [[nodiscard]] Eigen::VectorXd rate(const std::vector<int>& active, double time,
                                     const Eigen::VectorXd& y) const;
  [[nodiscard]] Eigen::VectorXd force(const std::vector<int>& active, double time,
                                      const Eigen::VectorXd& y) const;
  /// y after `duration`, by the exponential of the flow and its load together.
  [[nodiscard]] Eigen::VectorXd after(const std::vector<int>& active, double time, const Eigen::VectorXd& y,
                                      double duration) const;
  /// d y(after) / d y.
  [[nodiscard]] Eigen::MatrixXd transition(const std::vector<int>& active, double duration) const;
  [[nodiscard]] const Eigen::MatrixXd& displacement() const { return E_; }              ///< E
  [[nodiscard]] Eigen::VectorXd impulse(int contact) const { return B_.col(contact); }  ///< of B
  /// y of the state (u_i, xi; v_i) of a library flow, with contact c on coordinate b[c] alone.
  [[nodiscard]] Eigen::VectorXd state(const Eigen::VectorXd& u, const Eigen::VectorXd& v,
                                      const Eigen::VectorXd& x) const;

 private:
  [[nodiscard]] Eigen::VectorXd load(double time) const;
  [[nodiscard]] Eigen::MatrixXd projection(const std::vector<int>& active) const;

  Eigen::Index masses_ = 0;
  Eigen::MatrixXd A_, B_, E_;
  std::vector<double> rates_;
  Eigen::MatrixXd cos_, sin_;  // of F, one column per rate
};

/// One period of implicit Euler with a complementarity problem per step on the whole structure, from u and u'
/// of all its coordinates at time 0; x at the ends of the steps, steps x Nc. First order.
Eigen::MatrixXd implicit_euler(const Problem& problem, Eigen::VectorXd u, Eigen::VectorXd v, int steps);

}  // namespace signorini::test
