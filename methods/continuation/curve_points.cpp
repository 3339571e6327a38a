#include "methods/continuation/curve_points.hpp"

#include <algorithm>
#include <cstddef>

namespace signorini {

namespace {

// Whether the cubic that begins at the i-th point passes by.
bool passes(const CurvePoints& curve, std::size_t i, const Eigen::VectorXd& point, double distance,
            std::optional<std::size_t> label) {
  constexpr double kBeside = 4e-3;
  const auto& [x, tangents, labels] = curve;
  if (label && !labels.empty() && labels[i] != *label && labels[i + 1] != *label) return false;
  const Eigen::VectorXd chord = x[i + 1] - x[i], away = point - x[i];
  const double length = chord.norm(), s = chord.dot(away) / (length * length);
  if (s < -kBeside || s > 1.0 + kBeside || (away - s * chord).norm() > length) return false;
  const double r = 1.0 - s;  // the cubic of Hermite with the slopes of both tangents
  const Eigen::VectorXd bend = r * s * length * (r * tangents[i] - s * tangents[i + 1]);
  return (away - s * s * (3.0 - 2.0 * s) * chord - bend).norm() <= std::max(distance, kBeside * length);
}

}  // namespace

bool CurvePoints::pass_by(const Eigen::VectorXd& point, double distance,
                          std::optional<std::size_t> label) const {
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    if (passes(*this, i, point, distance, label)) return true;
  return false;
}

bool CurvePoints::passed_before(const Eigen::VectorXd& point, double distance,
                                std::optional<std::size_t> label) const {
  constexpr double kGone = 2.0;  // lengths of a cubic, after which the curve has left it
  double since = 0.0;
  for (std::size_t i = x.size() - std::min<std::size_t>(x.size(), 1); i-- > 0;) {
    const double length = (x[i + 1] - x[i]).norm();
    if (since > kGone * length && passes(*this, i, point, distance, label)) return true;
    since += length;
  }
  return false;
}

bool FollowedCurves::contain(int periods, const Eigen::VectorXd& x, std::optional<std::size_t> label) const {
  for (int shift = 0; shift < periods; ++shift) {
    const Eigen::VectorXd later = begun_later(x, periods, shift);
    for (const auto& [others, points] : followed_)
      if (others == periods && points.pass_by(later, rounding_of(later), label)) return true;
  }
  return false;
}

std::string FollowedCurves::meeting(int periods, const CurvePoints& points,
                                    std::optional<std::size_t> label) const {
  constexpr std::size_t kLeft = 10;  // points, after which a branch has left the one on which it began
  for (int shift = 0; shift < periods; ++shift) {
    const Eigen::VectorXd later = begun_later(points.x.back(), periods, shift);
    if (points.passed_before(later, rounding_of(later), label)) return "the branch meets itself";
  }
  const bool met = points.x.size() > kLeft && contain(periods, points.x.back(), label);
  return met ? "the branch meets one that was followed before" : "";
}

}  // namespace signorini
