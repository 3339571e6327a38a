#pragma once
// What a flow through events works on, and what it may keep.

#include <Eigen/Core>
#include <algorithm>
#include <stdexcept>
#include <vector>

#include "methods/solution.hpp"
#include "methods/solvers/constants.hpp"
#include "methods/structure/state.hpp"

namespace signorini {

/// One entry of the sequence that an orbit runs through: what ends a mode, and what the law makes of it.
struct SequenceEvent {
  /// impact: x_j reaches its stop and leaves again; close: it stays (at a spring stop: the spring begins to
  /// act); open: lambda_j reaches zero (at a spring stop: x_j leaves).
  ContactEvent::Kind kind = ContactEvent::Kind::impact;
  int contact = 0;                       ///< j, whose guard vanishes
  double time = 0.0;                     ///< [s]
  std::vector<int> pushed = {};          ///< rigid contacts that take an impulse, ascending
  std::vector<double> restitution = {};  ///< e of each; 0 at contacts that rest, and where a chatter ends [-]
  std::vector<bool> closed = {};         ///< Nc, afterwards
};

/// Highest derivative of x kept at an instant; of lambda one less.
inline constexpr int kNodeOrder = 5;

/// Contact displacements and forces with their derivatives at one instant.
struct FlowNode {
  double time = 0.0;       ///< [s]
  Eigen::MatrixXd x;       ///< Nc x 6, derivatives 0..5
  Eigen::MatrixXd lambda;  ///< Nc x 5, derivatives 0..4
};

/// What to keep of a flow, and what was kept.
struct FlowRecord {
  bool dense = false;  ///< keep nodes
  /// Keep the derivative of the final state with respect to the first; times the matrix, Ns x k, that
  /// `derivative` holds before.
  bool tangent = false;

  /// As they are met, times not wrapped; a closing that ends a chatter at the limit of its impacts.
  std::vector<ContactEvent> events;
  /// The same, event by event; impacts of one instant are one where they feel each other through the mass.
  std::vector<SequenceEvent> sequence;
  std::vector<FlowNode> nodes;  ///< in time order; two at each event, one for either side
  Eigen::MatrixXd derivative;   ///< Ns x Ns or Ns x k, of (u, xi, v)
  /// Impacts of one instant feel each other: the derivative is that of one of their orders.
  bool order_matters = false;
};

/// What separates events from noise in a flow of this tolerance, relative to the scales of the motion [-]:
/// guards that vanish within a hundredth of it vanish together, far below any error that the flow makes.
inline double event_noise(double tolerance) { return std::max(0.01 * tolerance, 64.0 * kEpsilon); }

/// The flow cannot be continued; what() is a sentence for a person.
class FlowError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A state together with the contacts that are closed.
struct FlowState {
  double time = 0.0;         ///< phase of the forcing [s]
  State state;               ///< of the coordinates with mass
  std::vector<bool> closed;  ///< Nc
};

}  // namespace signorini
