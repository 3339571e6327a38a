#pragma once
// The motion of any coordinate of a structure behind a motion that knows only its contacts.

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "harness/judge/measures/exact_motion.hpp"
#include "harness/judge/measures/motion.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// u_d over one period, and where stops move the motion of the frame in which that is told. Of exact orbits
/// it is their own state, to rounding, where the orbit knows the coordinate (ExactMotion) and the structure
/// has no more than 100; else the structure's response to the load and to the answer's contact force, with
///
///     u_n = Z_n^{-1} (f_n + W lambda_n),   n = 0..H,   w = 2 pi / T.
///
/// H is the motion's bandwidth where it has one: the field is then the method's own. Else H = 512 per forcing
/// period, of forces sampled at 65536 instants unless the orbit knows their integrals, and of impulses p_k at
/// t_k the rest of the series is added in closed form as far as its first two terms in 1 / (n w), -M^-1 W p_k
/// / (T (n w)^2) and -i M^-1 D M^-1 W p_k / (T (n w)^3): velocities jump where they must, and what is missing
/// of u falls as H^-3. `error` bounds both.
class CoordinateMotion {
 public:
  /// \param dofs  coordinates, each in [0, Nd)
  /// \throws SingularStiffness if some harmonic excites an undamped eigenfrequency
  /// \param motion  the answer's, sampled by `sample_answer`
  CoordinateMotion(const Problem& problem, const Trajectory& answer, const Motion& motion,
                   std::span<const int> dofs);

  /// u at count equidistant instants from t = 0, count x dofs [m].
  [[nodiscard]] Eigen::MatrixXd displacement(int count) const;
  /// u', right-sided where it jumps, count x dofs [m/s].
  [[nodiscard]] Eigen::MatrixXd velocity(int count) const;
  /// How far u may be off for what samples and harmonics miss, of any of the coordinates: twice what half the
  /// samples change, and what follows the last harmonics if they fall as 1 / n^2. Empty where it is the
  /// orbit's or the method's own [m].
  [[nodiscard]] std::optional<double> error() const { return error_; }

 private:
  /// What an impulse does at the coordinates.
  struct Kick {
    double turn = 0.0;            // t_k / T
    Eigen::VectorXd jump;         // M^-1 W p_k [m/s]
    Eigen::VectorXd retardation;  // M^-1 D M^-1 W p_k [m/s^2]
  };

  // The response of the structure in place of the coordinates that the orbit knows not.
  void respond(const Problem& problem, const Trajectory& answer, const Motion& motion,
               std::span<const int> dofs);
  // r(t) of the scene's frame (Problem::frame).
  void add_frame(const Problem& problem, int order, std::span<const int> dofs);
  void take_out_kicks(const Problem& problem, const Motion& motion, std::span<const int> dofs);
  void take_out(const Kick& kick);
  template <class Add>
  void add_kicks(Eigen::MatrixXd& values, const Add& add) const;

  double base_frequency_ = 1.0;
  Eigen::MatrixXcd u_;  // (H+1) x dofs, less what the kicks add
  std::vector<Kick> kicks_;
  std::optional<double> error_ = {};
  std::optional<ExactMotion> exact_ = {};  // of dofs_ at columns_; u_ is there the frame's part alone
  std::vector<int> dofs_;
  std::vector<Eigen::Index> columns_;
};

}  // namespace signorini
