#pragma once
// What a flow through events works on, and what it may keep.

#include <Eigen/Core>
#include <vector>

#include "methods/structure/state.hpp"

namespace signorini {

/// Something that happens to a contact at an instant.
struct ContactEvent {
  enum class Kind { impact, close, open };
  Kind kind = Kind::impact;
  int contact = 0;
  double time = 0.0;      ///< [s]; of a closing that ends a chatter: the limit of the impacts
  double approach = 0.0;  ///< x'_- of an impact [m/s]
  double impulse = 0.0;   ///< p <= 0 of an impact [N s]
};

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

  std::vector<ContactEvent> events;
  std::vector<SequenceEvent> sequence;  ///< the same, event by event
  std::vector<FlowPiece> pieces;
  Eigen::MatrixXd derivative;  ///< 2 Nd x 2 Nd, of (u, v)
  long accumulations = 0;      ///< chatters carried to their limit
};

/// A state together with the contacts that are closed.
struct FlowState {
  double time = 0.0;  ///< phase of the forcing [s]
  State state;
  std::vector<bool> closed;  ///< Nc
};

}  // namespace signorini
