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

/// x later by so many instants.
Eigen::MatrixXd delayed(const Eigen::MatrixXd& motion, Eigen::Index instants) {
  Eigen::MatrixXd later(motion.rows(), motion.cols());
  later.topRows(instants) = motion.bottomRows(instants);
  later.bottomRows(motion.rows() - instants) = motion.topRows(motion.rows() - instants);
  return later;
}

/// The least value of the parabola through three neighbours, of which the middle one is least.
double least_of_parabola(double before, double least, double after) {
  const double bend = before - 2.0 * least + after, slope = 0.5 * (after - before);
  return bend > 0.0 ? std::max(0.0, least - 0.5 * slope * slope / bend) : least;
}

}  // namespace

// The mean square of a - (b later by so many instants) over A^2, of the contact where it is largest.
double ResponseMetric::square(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, Eigen::Index delay) const {
  const Eigen::Index rows = a.rows(), rest = rows - delay;
  const Eigen::RowVectorXd sums = (a.topRows(delay) - b.bottomRows(delay)).colwise().squaredNorm() +
                                  (a.bottomRows(rest) - b.topRows(rest)).colwise().squaredNorm();
  return sums.maxCoeff() / (static_cast<double>(rows) * amplitude_ * amplitude_);
}

ResponseMetric::Closest ResponseMetric::closest(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const {
  const Eigen::Index rows = a.rows(), step = delays_ == Delays::any ? 1 : kComparedPhases;
  Closest found;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index delay = 0; delay < rows; delay += step) {
    const double here = square(a, b, delay);
    if (here < least) found.instants = delay;
    least = std::min(least, here);
  }
  if (delays_ == Delays::any)  // between two instants
    least = least_of_parabola(square(a, b, (found.instants + rows - 1) % rows), least,
                              square(a, b, (found.instants + 1) % rows));
  found.distance = std::sqrt(least);
  return found;
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
  return std::max(std::abs(a.frequency - b.frequency) / window_, closest(a.motion, b.motion).distance);
}

ResponsePoint ResponseMetric::primitive(ResponsePoint point) const {
  constexpr double kRepeats = 2e-3;
  for (int order = 1; order < point.order; ++order) {
    if (point.order % order != 0 ||
        square(point.motion, point.motion, Eigen::Index{order} * kComparedPhases) > kRepeats * kRepeats)
      continue;
    point.motion = point.motion.topRows(Eigen::Index{order} * kComparedPhases).eval();
    point.order = order;
  }
  return point;
}

std::pair<ResponsePoint, ResponsePoint> ResponseMetric::aligned(const ResponsePoint& a,
                                                                const ResponsePoint& b) const {
  const int periods = std::lcm(a.order, b.order);
  std::pair<ResponsePoint, ResponsePoint> both{repeated(a, periods), repeated(b, periods)};
  both.second.motion = delayed(both.second.motion, closest(both.first.motion, both.second.motion).instants);
  return both;
}

}  // namespace signorini
