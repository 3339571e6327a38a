#pragma once
// The motions that every solid element must reproduce.

#include <Eigen/Core>
#include <vector>

namespace signorini::test {

/// The twelve motions linear in x, y and z: A x and b, one entry at a time; constants come first of each
/// axis. \param at_nodes  makes of a field u(x) its displacements at all nodes
template <class AtNodes>
std::vector<Eigen::VectorXd> linear_motions(AtNodes at_nodes) {
  std::vector<Eigen::VectorXd> motions;
  for (int axis = 0; axis < 3; ++axis) {
    for (int by = -1; by < 3; ++by) {
      motions.push_back(at_nodes([=](const Eigen::Vector3d& x) {
        return Eigen::Vector3d((by < 0 ? 1.0 : x(by)) * Eigen::Vector3d::Unit(axis));
      }));
    }
  }
  return motions;
}

}  // namespace signorini::test
