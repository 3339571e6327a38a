#pragma once
// The complex modes of scenes that differ in their load, gaps or law of impact alone.

#include <Eigen/Core>
#include <map>
#include <memory>
#include <vector>

#include "methods/linear_flow/linear_flow.hpp"

namespace signorini {

/// Coordinates that closed-form flows take along a curve, where modes are found once for all points [-]
inline constexpr int kMostAlongCurves = 500;

/// The modes of contact modes, found anew only where the matrices of the structure, with the springs and
/// constraints of its closed contacts, are others than the last time. Along a curve over a frequency, a load,
/// a gap or a restitution they are found once.
class SharedModes {
 public:
  /// \param most  coordinates of the flows that they are for: linear_flow refuses more
  explicit SharedModes(int most = kMostInDenseFlow) : most_(most) {}

  [[nodiscard]] int most() const { return most_; }  ///< coordinates
  /// modal_basis(equations); the unit of time in which the energy is shifted may be that of a scene before,
  /// which changes the modes by rounding.
  std::shared_ptr<const ModalBasis> of(const ModeEquations& equations);
  void clear() { entries_.clear(); }                   ///< forgets all modes
  [[nodiscard]] long found() const { return found_; }  ///< how often modes were found anew

 private:
  struct Entry {
    std::shared_ptr<const SparseLlt> factors;  // of the scene: at other frequencies it has the same
    SparseMatrix mass;
    std::vector<Eigen::MatrixXd> others;  // that the modes are of
    std::shared_ptr<const ModalBasis> modes;
  };

  std::map<std::vector<int>, Entry> entries_;  // by the closed contacts
  long found_ = 0;
  int most_;
};

}  // namespace signorini
