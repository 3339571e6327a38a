#pragma once
// A reduced structure stepped through a period against its stops, and the tangent of that map.

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "methods/solvers/lcp/active_set_lcp.hpp"
#include "methods/structure/contact_reduction.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// What a march steps through: the stops and the grid.
struct MarchGrid {
  Eigen::VectorXd gap;         ///< g, Nc [m]
  Eigen::VectorXd compliance;  ///< 1 / k_p of a spring stop, 0 of a rigid one, Nc [m/N]
  double period = 1.0;         ///< T, a whole multiple of the load's period [s]
  int samples = 256;           ///< N >= 4 steps per period [-]
};

/// Gaps, spring compliances and period of a scene. \param samples  N
MarchGrid march_grid(const Problem& problem, int samples);

/// Why the march does not represent a scene, one clause; empty if it does. A contact with mass and an impact
/// law is another one in the reduced structure (`ContactReduction`).
std::string march_obstacle(const Problem& problem);

/// Whether a scene has several contacts, 4 or more, that the march represents. They come and go in turns that
/// neither a coarse grid nor few harmonics show, and paths of pivots over them are long: a march is the way
/// to a start.
bool marches_several(const Problem& problem);

/// Steps of a march per forcing period that show in which turns contacts come and go [-].
inline constexpr int kMarchedPerPeriod = 256;

/// What was done since a march began.
struct MarchWork {
  long steps = 0;           ///< with contact conditions [-]
  long tangent_steps = 0;   ///< linear ones, with given sets [-]
  long sets = 0;            ///< active sets tried [-]
  long factorisations = 0;  ///< of active sets met for the first time [-]
  long fallbacks = 0;       ///< steps left to pivoting [-]
};

/// The equations of a ContactReduction with d/dt replaced by backward differences of second order,
///
///     y'_k = (3 y_k - 4 y_{k-1} + y_{k-2}) / (2 dt),   dt = T / N,   y = (q, q', xi),
///
/// and Signorini's conditions at every node, x_k + k_p^-1 lambda_k <= g, lambda_k <= 0, complementary: one
/// linear complementarity problem per step, of the constant matrix
///
///     G = sum_k n_k n_k^T / (sigma^2 + (alpha + beta omega_k^2) sigma + omega_k^2) + C_m / (1 + beta sigma)
///         + k_p^-1,   sigma = 3 / (2 dt),
///
/// symmetric positive definite where every contact is massless or has a spring. The scheme dissipates at
/// high frequencies, is stable for any dt, and has order 2 for smooth motions.
///
/// A state is two successive y, in units of energy: omega q, q' and xi times (Nc / tr C_m)^(1/2), so that its
/// norm weighs all parts alike. xi is left out of it where beta = 0, for it follows at once then.
class ContactMarch {
 public:
  /// `reduction` must outlive the march, which keeps matrices of its size.
  ContactMarch(const ContactReduction& reduction, MarchGrid grid);

  /// Numbers in a state.
  [[nodiscard]] Eigen::Index size() const { return 2 * part_; }
  /// The state of the periodic motion without contact forces, at node 0.
  [[nodiscard]] Eigen::VectorXd free_state() const;
  /// The state after a period from `state` at node 0; not finite where a step has no solution. Keeps motion,
  /// forces and active sets of that period.
  [[nodiscard]] Eigen::VectorXd period(const Eigen::VectorXd& state);
  /// The derivative of `period` at its last argument, where contacts stay in their sets, applied to a change
  /// of state: exact but at states where a contact is about to open or to close.
  [[nodiscard]] Eigen::VectorXd tangent(const Eigen::VectorXd& change);

  /// Adds a given displacement to x from the next period on. \param moved  at nodes 0..N-1, N x Nc [m]
  void move(Eigen::MatrixXd moved) { moved_ = std::move(moved); }

  /// How a period changes with its state and with displacements added to x, contacts staying in their sets:
  /// dx = dx_free + G dlambda, dx = -k_p^-1 dlambda on the sets, dlambda = 0 elsewhere.
  struct Change {
    Eigen::VectorXd state;   ///< after the period
    Eigen::MatrixXd motion;  ///< dx at nodes 0..N-1, the displacement added included, N x Nc [m]
    Eigen::MatrixXd force;   ///< dlambda likewise [N]
  };
  /// \param state  change of the state before the period
  /// \param moved  displacement added at nodes 0..N-1, N x Nc [m]
  [[nodiscard]] Change change(const Eigen::VectorXd& state, const Eigen::MatrixXd& moved);

  /// x at nodes 0 to N-1 of the last period, N x Nc [m]. Node 0 is its last step.
  [[nodiscard]] const Eigen::MatrixXd& motion() const { return motion_; }
  /// lambda likewise, N x Nc [N].
  [[nodiscard]] const Eigen::MatrixXd& force() const { return force_; }
  /// The contacts that press at the steps 1 to N of the last period, ascending.
  [[nodiscard]] const std::vector<std::vector<int>>& sets() const { return sets_; }
  /// Since the march began.
  [[nodiscard]] MarchWork work() const;

 private:
  /// y at two successive nodes, in units of its own.
  struct History {
    Eigen::VectorXd now, before;
  };

  [[nodiscard]] History unscaled(const Eigen::VectorXd& state) const;
  [[nodiscard]] Eigen::VectorXd scaled(const History& history) const;
  /// The next y without contact forces into next_, under loads on q and on xi.
  void advance_freely(const History& history, const Eigen::VectorXd& load, const Eigen::VectorXd& shift);
  /// Adds what forces of the given contacts do to next_; they are in push_, one per member.
  void press(const std::vector<int>& set);
  /// A linear step under `moved`: next_ with the forces that keep the set where it is, which push_ then has.
  void advance_on(const std::vector<int>& set, const History& history, const Eigen::VectorXd& moved);
  void complete_next();
  void shift_history(History& history);

  const ContactReduction& reduction_;
  MarchGrid grid_;
  Eigen::Index modes_, relaxing_, part_;  // m, numbers of xi in a state, of y
  double sigma_;                          // 3 / (2 dt)
  double relax_;                          // 1 / (1 + beta sigma)
  Eigen::VectorXd response_;              // 1 / (sigma^2 + damping sigma + omega^2)
  Eigen::VectorXd scale_;                 // of y
  ActiveSetLcp contacts_;
  Eigen::VectorXd next_, xi_, history_part_, push_;  // xi_ also where it is no state
  Eigen::VectorXd no_load_, no_shift_;
  Eigen::MatrixXd motion_, force_, moved_;
  std::vector<std::vector<int>> sets_;
  long steps_ = 0, tangent_steps_ = 0;
};

}  // namespace signorini
