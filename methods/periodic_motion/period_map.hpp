#pragma once
// The stroboscopic map of a scene, and Newton's method for its fixed points: the shooting method.

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>

#include "methods/flow/flow.hpp"

namespace signorini {

/// Maps the state at one phase of the forcing to the state whole forcing periods later. The integrator
/// restarts at every period, so that the map is a function of the state alone.
class PeriodMap {
 public:
  /// \param flow  of the scene, kept by the caller
  explicit PeriodMap(EventFlow& flow) : flow_(flow) {}

  /// Applies the map `count` times; the phase state.time stays, record times run on.
  void apply(FlowState& state, int count, FlowRecord& record);
  /// (u / X, xi / X, v / V), Ns, in the scales of the motion [-].
  [[nodiscard]] Eigen::VectorXd scaled(const State& state) const;
  /// The state that is scaled to a vector.
  [[nodiscard]] State unscaled(const Eigen::VectorXd& vector) const;

  [[nodiscard]] EventFlow& flow() const { return flow_; }  ///< that the map follows
  /// Between two applications [s].
  [[nodiscard]] double forcing_period() const { return flow_.dynamics().structure().forcing_period; }
  [[nodiscard]] long periods() const { return periods_; }  ///< applied since construction

 private:
  EventFlow& flow_;
  long periods_ = 0;
};

/// A fixed point of `order` applications of the map, or the best state towards one.
struct FixedPoint {
  bool converged = false;                ///< the motion from `start` is periodic
  std::string message = {};              ///< why it is not, one clause; of `march` and `shoot`: a sentence
  FlowState start = {};                  ///< state at the beginning of a period
  int order = 1;                         ///< forcing periods per period of the motion
  double residual = 0.0;                 ///< distance between start and end of a period, scaled [-]
  long iterations = 0;                   ///< Newton steps, or periods marched
  std::optional<double> condition = {};  ///< estimate for I - monodromy at the last step, scaled [-]
  Eigen::MatrixXd monodromy = {};        ///< in scaled coordinates, Ns x Ns
  Eigen::VectorXcd multipliers = {};     ///< its eigenvalues, the Floquet multipliers; empty unless converged
  /// Simultaneous impacts feel each other: these are of one of their orders.
  bool order_matters = false;

  /// "largest multiplier 0.7", or that they depend on the order of simultaneous impacts.
  [[nodiscard]] std::string describe_multipliers() const;
};

/// When find_fixed_point gives up.
struct NewtonLimits {
  double accepted = 1e-8;      ///< residual that counts as periodic [-]
  int max_iterations = 20;     ///< Newton steps
  int max_halvings = 0;        ///< of a step that does not reduce the residual
  double largest_step = 10.0;  ///< a longer correction is refused [-]
};

/// Newton's method (`damped_newton`) on P^order(y) - y = 0, with the derivative of P from the transitions
/// between events and the saltation matrices at them. One more step is taken once the residual is accepted.
/// \throws FlowError once the time budget is spent; other failures are `reason`
FixedPoint find_fixed_point(PeriodMap& map, const FlowState& guess, int order, const NewtonLimits& limits,
                            const std::function<bool()>& expired);

}  // namespace signorini
