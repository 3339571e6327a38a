#pragma once
// What a flow through events works on, and what it may keep.

#include <Eigen/Core>
#include <stdexcept>
#include <vector>

#include "methods/solution.hpp"
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

/// Contact displacements and forces with their derivatives at one instant.
struct FlowNode {
  double time = 0.0;
  Eigen::MatrixXd x;       ///< Nc x 6, derivatives 0..5
  Eigen::MatrixXd lambda;  ///< Nc x 5, derivatives 0..4
};

/// The instants between two events, in one mode; at least two of them.
using FlowPiece = std::vector<FlowNode>;

/// What to keep of a flow, and what was kept.
struct FlowRecord {
  bool dense = false;    ///< keep pieces
  bool tangent = false;  ///< keep the derivative of the final state with respect to the first

  /// As they are met, times not wrapped; a closing that ends a chatter at the limit of its impacts.
  std::vector<ContactEvent> events;
  std::vector<SequenceEvent> sequence;  ///< the same, event by event
  std::vector<FlowPiece> pieces;
  Eigen::MatrixXd derivative;  ///< 2 Nd x 2 Nd, of (u, v)
};

/// The flow cannot be continued; what() is a sentence for a person.
class FlowError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A state together with the contacts that are closed.
struct FlowState {
  double time = 0.0;  ///< phase of the forcing [s]
  State state;
  std::vector<bool> closed;  ///< Nc
};

}  // namespace signorini
