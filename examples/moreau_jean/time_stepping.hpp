#pragma once
// The time-stepping scheme of Moreau and Jean for a structure with rigid stops.

#include <Eigen/Core>
#include <Eigen/SparseCholesky>

#include "problems/problem.hpp"

namespace moreau_jean {

struct State {
  Eigen::VectorXd u;  ///< displacements [m]
  Eigen::VectorXd v;  ///< velocities [m/s]
};

/// One step of length h from (u, v) at time t, with v* = theta v_+ + (1 - theta) v, u* = u + h theta v* and
/// f* = theta f(t + h) + (1 - theta) f(t):
///
///     M (v_+ - v) + h (D v* + K u*) = h f* + W p,     u_+ = u + h v*.
///
/// A contact is looked at if u + h v / 2 reaches its stop; then, with x' = W^T v,
///
///     x'_+ + e x' <= 0,     p <= 0,     p (x'_+ + e x') = 0,
///
/// Newton's law of impact and, where the contact stays, Signorini's conditions on the velocity: p is the
/// impulse over the step, be it of an impact or of a force. No impact is located in time, which costs an
/// error of order h and makes chatter and many contacts harmless. Sources: [moreau1988], [jean1999].
class TimeStepping {
 public:
  /// \param h  step [s]; \param theta  in [1/2, 1]; 1/2 keeps the energy of free motion
  /// \throws std::runtime_error if the matrix of a step cannot be factorised
  TimeStepping(const signorini::Problem& problem, double h, double theta);

  /// Takes one step; returns the impulses p, Nc [N s], valid until the next call.
  const Eigen::VectorXd& advance(State& state, double t);

 private:
  /// Adds h f* to rhs.
  void add_load(double t, Eigen::VectorXd& rhs) const;
  /// p from the velocity that the contacts would have without it and the one that they had.
  void find_impulses(const Eigen::VectorXd& predicted, const Eigen::VectorXd& free,
                     const Eigen::VectorXd& before);

  const signorini::Problem& problem_;
  double h_, theta_;
  double e_ = 0.0;                                    // [-]
  signorini::SparseMatrix W_;                         // Nd x Nc
  Eigen::VectorXd gaps_;                              // [m]
  Eigen::SimplicialLDLT<signorini::SparseMatrix> A_;  // M + h theta D + h^2 theta^2 K
  Eigen::MatrixXd response_;                          // A^-1 W, Nd x Nc
  Eigen::MatrixXd G_;                                 // W^T A^-1 W, Nc x Nc [1/kg]
  Eigen::VectorXd p_;
};

}  // namespace moreau_jean
