#include "harness/responses/response_metric.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace signorini {

namespace {

/// The motion over `periods` forcing periods, a multiple of its order.
ResponsePoint repeated(const ResponsePoint& point, int periods) {
  ResponsePoint longer = point;
  longer.order = periods;
  longer.motion = point.motion.replicate(periods / point.order, 1);
  return longer;
}

/// x(t - s T).
Eigen::MatrixXd delayed(const Eigen::MatrixXd& motion, int shift) {
  const Eigen::Index first = Eigen::Index{shift} * kComparedPhases, rows = motion.rows();
  Eigen::MatrixXd later(rows, motion.cols());
  later.topRows(first) = motion.bottomRows(first);
  later.bottomRows(rows - first) = motion.topRows(rows - first);
  return later;
}

}  // namespace

double ResponseMetric::apart(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, int shift) const {
  const Eigen::MatrixXd difference = a - delayed(b, shift);
  const double square =
      difference.colwise().squaredNorm().maxCoeff() / static_cast<double>(difference.rows());
  return std::sqrt(square) / amplitude_;
}

Eigen::RowVectorXd ResponseMetric::size_of(const Eigen::MatrixXd& motion) {
  if (motion.size() == 0) return {};
  return (motion.rowwise() - motion.colwise().mean()).array().square().colwise().mean().sqrt();
}

double ResponseMetric::between(const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b) const {
  return a.size() == 0 ? 0.0 : (a - b).cwiseAbs().maxCoeff() / amplitude_;
}

double ResponseMetric::operator()(const ResponsePoint& a, const ResponsePoint& b) const {
  if (a.order != b.order) return std::numeric_limits<double>::infinity();
  double nearest = std::numeric_limits<double>::infinity();
  for (int shift = 0; shift < a.order; ++shift) nearest = std::min(nearest, apart(a.motion, b.motion, shift));
  return std::max(std::abs(a.frequency - b.frequency) / window_, nearest);
}

ResponsePoint ResponseMetric::primitive(ResponsePoint point) const {
  constexpr double kRepeats = 2e-3;
  for (int order = 1; order < point.order; ++order) {
    if (point.order % order != 0 || apart(point.motion, point.motion, order) > kRepeats) continue;
    point.motion = point.motion.topRows(Eigen::Index{order} * kComparedPhases).eval();
    point.order = order;
  }
  return point;
}

std::pair<ResponsePoint, ResponsePoint> ResponseMetric::aligned(const ResponsePoint& a,
                                                                const ResponsePoint& b) const {
  const int periods = std::lcm(a.order, b.order);
  std::pair<ResponsePoint, ResponsePoint> both{repeated(a, periods), repeated(b, periods)};
  int best = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (int shift = 0; shift < periods; ++shift) {
    const double distance = apart(both.first.motion, both.second.motion, shift);
    if (distance < nearest) best = shift;
    nearest = std::min(nearest, distance);
  }
  both.second.motion = delayed(both.second.motion, best);
  return both;
}

}  // namespace signorini
