#pragma once
// The points of a curve that has been followed, as a curve.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace signorini {

/// Neighbouring points of a curve with their unit tangents.
struct CurvePoints {
  std::vector<Eigen::VectorXd> x, tangents;

  /// Whether the curve passes by a point: within `distance` of the cubics through its points, or 4/1000 of
  /// the length of one, several times what an arc whose tangent turns by .35 rad leaves its cubic.
  [[nodiscard]] bool pass_by(const Eigen::VectorXd& point, double distance) const;
  /// All but the last points.
  [[nodiscard]] CurvePoints before_last(std::size_t count) const;
};

}  // namespace signorini
