#include "methods/continuation/curve_points.hpp"

#include <algorithm>
#include <cstddef>

namespace signorini {

bool CurvePoints::pass_by(const Eigen::VectorXd& point, double distance,
                          std::optional<std::size_t> label) const {
  constexpr double kBeside = 4e-3;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    if (label && !labels.empty() && labels[i] != *label && labels[i + 1] != *label) continue;
    const Eigen::VectorXd chord = x[i + 1] - x[i], away = point - x[i];
    const double length = chord.norm(), s = chord.dot(away) / (length * length);
    if (s < -kBeside || s > 1.0 + kBeside || (away - s * chord).norm() > length) continue;
    const double r = 1.0 - s;  // the cubic of Hermite with the slopes of both tangents
    const Eigen::VectorXd bend = r * s * length * (r * tangents[i] - s * tangents[i + 1]);
    if ((away - s * s * (3.0 - 2.0 * s) * chord - bend).norm() <= std::max(distance, kBeside * length))
      return true;
  }
  return false;
}

CurvePoints CurvePoints::before_last(std::size_t count) const {
  const auto kept = static_cast<std::ptrdiff_t>(x.size() - std::min(count, x.size()));
  CurvePoints first{{x.begin(), x.begin() + kept}, {tangents.begin(), tangents.begin() + kept}};
  if (!labels.empty()) first.labels.assign(labels.begin(), labels.begin() + kept);
  return first;
}

}  // namespace signorini
