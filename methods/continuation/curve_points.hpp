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
  /// The same of the curve up to its end, of which a point is the last or the same motion begun later: a
  /// cubic counts from where the curve has gone on for more than twice its length. Of steps that become a
  /// thousand times as short, as at corners, any number ends within the tolerance of the cubics before.
  [[nodiscard]] bool passed_before(const Eigen::VectorXd& point, double distance,
                                   std::optional<std::size_t> label = {}) const;
};

}  // namespace signorini
