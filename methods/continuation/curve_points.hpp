#pragma once
// The points of a curve that has been followed, as a curve.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace signorini {

/// Neighbouring points of a curve with their unit tangents.
struct CurvePoints {
  std::vector<Eigen::VectorXd> x, tangents;
  std::vector<std::size_t> labels = {};  ///< of each point, if any: what only points of one kind share

  /// Whether the curve passes by a point: within `distance` of the cubics through its points, or 4/1000 of
  /// the length of one, several times what an arc whose tangent turns by .35 rad leaves its cubic.
  /// \param label  cubics without an end of this label do not count; empty: all count
  [[nodiscard]] bool pass_by(const Eigen::VectorXd& point, double distance,
                             std::optional<std::size_t> label = {}) const;
  /// All but the last points.
  [[nodiscard]] CurvePoints before_last(std::size_t count) const;
};

}  // namespace signorini
