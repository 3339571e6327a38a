#include "methods/harmonic_balance/continuation/depth_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "methods/discretisation/fourier_series.hpp"
#include "methods/solvers/bracketed_zero.hpp"

namespace signorini {

namespace {

/// The extremum of y near an instant by Newton's method on y'; empty where it is of the other kind, or more
/// than a quarter of the shortest harmonic's period away.
std::optional<double> extremum_near(const Eigen::VectorXcd& y, bool minimum, double time) {
  const auto slope = [&](double t) {
    const Jet jet = trigonometric_jet(y, t);
    const bool sought = (minimum ? jet.curvature : -jet.curvature) > 0.0;
    return ValueAndSlope{jet.slope, sought ? jet.curvature : std::numeric_limits<double>::quiet_NaN()};
  };
  const double reach = 0.25 / static_cast<double>(y.size() - 1);
  return newton_zero_near(slope, {.guess = time, .reach = reach, .settled = 1e-15});
}

std::optional<ContactDepth> depth_near(const SeriesCurve& curve, Eigen::Index contact, bool gap,
                                       double time) {
  const Eigen::VectorXcd y = curve.pressure(contact);
  const auto at = extremum_near(y, gap, time);
  if (!at) return std::nullopt;
  const double phase = 2.0 * std::numbers::pi, H = curve.harmonics();
  const double bend = std::abs(trigonometric_jet(y, *at).curvature) / (phase * phase);
  return ContactDepth{.contact = contact, .gap = gap, .time = *at, .unit = 0.5 * bend / (H * H)};
}

double square_of(const SeriesCurve& curve, const ContactDepth& depth) {
  const double y = trigonometric_jet(curve.pressure(depth.contact), depth.time).value / depth.unit;
  return depth.gap ? -y : y;
}

}  // namespace

bool DepthCurve::evaluate(const Eigen::VectorXd& z) {
  if (z.size() != size() + 1 || !series_.evaluate(without_depths(z))) return false;
  w_ = z.segment(series_.size(), count());
  for (std::size_t i = 0; i < depths_.size(); ++i) {
    const ContactDepth& depth = depths_[i];
    const auto at = extremum_near(series_.pressure(depth.contact), depth.gap, depth.time);
    if (!at) return false;
    here_[i].time = *at;
  }
  return true;
}

Eigen::VectorXd DepthCurve::residual() const {
  Eigen::VectorXd r(size());
  r.head(series_.size()) = series_.residual();
  for (Eigen::Index i = 0; i < count(); ++i)
    r[series_.size() + i] = w_[i] * w_[i] - square_of(series_, depth_here(i));
  return r;
}

Eigen::MatrixXd DepthCurve::jacobian() const {
  const Eigen::Index n = series_.size(), k = count();
  const Eigen::MatrixXd R = series_.jacobian();
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n + k, n + k + 1);
  J.topLeftCorner(n, n) = R.leftCols(n);
  J.topRightCorner(n, 1) = R.col(n);
  for (Eigen::Index i = 0; i < k; ++i) {
    const ContactDepth& depth = depth_here(i);
    const Eigen::VectorXd row =
        (depth.gap ? 1.0 : -1.0) / depth.unit * series_.pressure_gradient(depth.contact, depth.time);
    J.row(n + i).head(n) = row.head(n).transpose();
    J(n + i, n + i) = 2.0 * w_[i];
    J(n + i, n + k) = row[n];
  }
  return J;
}

double DepthCurve::noise() const {
  double noise = series_.noise();
  for (const ContactDepth& depth : depths_)
    noise = std::max(noise, std::numeric_limits<double>::epsilon() *
                                series_.pressure(depth.contact).cwiseAbs().sum() / depth.unit);
  return noise;
}

void DepthCurve::follow(std::vector<ContactDepth> depths) {
  here_ = depths_ = std::move(depths);
  w_ = depths_here();
}

Eigen::VectorXd DepthCurve::without_depths(const Eigen::VectorXd& z) const {
  Eigen::VectorXd x(series_.size() + 1);
  x << z.head(series_.size()), z[z.size() - 1];
  return x;
}

Eigen::VectorXd DepthCurve::with_depths(const Eigen::VectorXd& x, const Eigen::VectorXd& w) const {
  Eigen::VectorXd z(x.size() + w.size());
  z << x.head(series_.size()), w, x[x.size() - 1];
  return z;
}

Eigen::VectorXd DepthCurve::depths_here() const {
  Eigen::VectorXd w(count());
  for (Eigen::Index i = 0; i < count(); ++i)
    w[i] = std::sqrt(std::max(0.0, square_of(series_, depth_here(i))));
  return w;
}

Eigen::VectorXd DepthCurve::lifted(const Eigen::VectorXd& direction) const {
  Eigen::VectorXd rates(count());
  for (Eigen::Index i = 0; i < count(); ++i)
    rates[i] = square_rate(series_, depth_here(i), direction) / (2.0 * w_[i]);
  return with_depths(direction, rates);
}

double square_rate(const SeriesCurve& curve, const ContactDepth& depth, const Eigen::VectorXd& direction) {
  const double rate = curve.pressure_gradient(depth.contact, depth.time).dot(direction) / depth.unit;
  return depth.gap ? -rate : rate;
}

bool same_extremum(const ContactDepth& one, const ContactDepth& other) {
  constexpr double kSame = 1e-4;  // of the period
  const double apart = one.time - other.time;
  return one.contact == other.contact && one.gap == other.gap && std::abs(apart - std::round(apart)) < kSame;
}

std::vector<ContactDepth> short_contacts(const SeriesCurve& curve) {
  constexpr double kShort = 3.0;  // a phase times H
  const double unit = 2.0 * std::numbers::pi * curve.harmonics();
  std::vector<ContactDepth> found;
  for (std::size_t c = 0; c < curve.contacts().size(); ++c) {
    const std::vector<ContactInterval>& pressing = curve.contacts()[c];
    for (std::size_t i = 0; i < pressing.size(); ++i) {
      const double after = i + 1 < pressing.size() ? pressing[i + 1].begin : pressing[0].begin + 1.0;
      for (const bool gap : {false, true}) {
        const double begin = gap ? pressing[i].end : pressing[i].begin, end = gap ? after : pressing[i].end;
        const double length = (end - begin) * unit;
        if (length > kShort || length < kNoPhase) continue;
        const auto depth = depth_near(curve, static_cast<Eigen::Index>(c), gap, 0.5 * (begin + end));
        if (depth) found.push_back(*depth);
      }
    }
  }
  return found;
}

std::vector<NascentContact> nascent_contacts(const SeriesCurve& curve, const Eigen::VectorXd& direction,
                                             double reach) {
  constexpr double kZero = 1e-9;  // of w^2
  const int count = kResolvingSamples * std::max(curve.harmonics(), 1);
  std::vector<NascentContact> found;
  for (Eigen::Index c = 0; c < curve.motion().cols(); ++c) {
    const Eigen::VectorXcd spectrum = curve.pressure(c);
    const Eigen::VectorXd y = sample_series(spectrum, count);
    for (int i = 0; i < count; ++i) {
      const double before = y[(i + count - 1) % count], after = y[(i + 1) % count];
      const bool top = y[i] >= before && y[i] > after, bottom = y[i] <= before && y[i] < after;
      if (!top && !bottom) continue;
      const auto depth = depth_near(curve, c, bottom, static_cast<double>(i) / count);
      if (!depth) continue;
      const double square = square_of(curve, *depth);
      const double rate = square_rate(curve, *depth, direction);
      if (square < kZero && rate > 0.0 && -square <= reach * rate) found.push_back({*depth, -square / rate});
    }
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });
  return found;
}

}  // namespace signorini
