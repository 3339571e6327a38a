#pragma once
// The points of curves that have been followed, as curves.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
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

/// Curves of a method that were followed, by their unknowns. A curve of motions of k periods of the scene is
/// the same where they begin any number of these periods later.
class FollowedCurves {
 public:
  virtual ~FollowedCurves() = default;

  /// Takes in one of motions of `periods` periods.
  void add(int periods, CurvePoints points) { followed_.emplace_back(periods, std::move(points)); }
  /// Whether unknowns lie on one of them. \param label  as of CurvePoints::pass_by
  [[nodiscard]] bool contain(int periods, const Eigen::VectorXd& x,
                             std::optional<std::size_t> label = {}) const;
  /// Why a curve ends at its last point: one clause where it was there before, or where one of these passes
  /// by and it has gone on for more than ten points; else empty.
  [[nodiscard]] std::string meeting(int periods, const CurvePoints& points,
                                    std::optional<std::size_t> label = {}) const;

 private:
  /// The unknowns of a motion of so many periods, begun `shift` of these later.
  [[nodiscard]] virtual Eigen::VectorXd begun_later(const Eigen::VectorXd& x, int periods,
                                                    int shift) const = 0;
  /// How near two points of unknowns count as one.
  [[nodiscard]] virtual double rounding_of(const Eigen::VectorXd& x) const = 0;

  std::vector<std::pair<int, CurvePoints>> followed_;
};

}  // namespace signorini
