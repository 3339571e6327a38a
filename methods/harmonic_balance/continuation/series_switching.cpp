#include "methods/harmonic_balance/continuation/series_switching.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "methods/continuation/arc_length.hpp"
#include "methods/discretisation/fourier_series.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/singular_values.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

/// A nearest approach of a contact to its stop where it does not press.
struct Approach {
  Eigen::Index contact = 0;
  double time = 0.0;       // share of the period
  double clearance = 0.0;  // g - x there [m]
};

std::vector<Approach> approaches(const SeriesCurve& curve) {
  const int count = kResolvingSamples * std::max(curve.harmonics(), 1);
  const Eigen::MatrixXd x = sample_series(curve.motion(), count);
  const Eigen::VectorXd gaps = contact_gaps(curve.problem());
  const double margin = 0.25 / curve.harmonics();
  std::vector<Approach> found;
  for (Eigen::Index c = 0; c < x.cols(); ++c) {
    const std::vector<ContactInterval>& pressing = curve.contacts()[static_cast<std::size_t>(c)];
    for (int i = 0; i < count; ++i) {
      const double t = static_cast<double>(i) / count;
      if (x(i, c) < x((i + count - 1) % count, c) || x(i, c) <= x((i + 1) % count, c)) continue;
      const bool inside = std::any_of(pressing.begin(), pressing.end(), [&](const ContactInterval& interval) {
        const double since = t - interval.begin - std::floor(t - interval.begin + margin);
        return since < interval.end - interval.begin + margin;
      });
      if (!inside) found.push_back({c, t, gaps[c] - x(i, c)});
    }
  }
  std::sort(found.begin(), found.end(),
            [](const Approach& a, const Approach& b) { return a.clearance < b.clearance; });
  return found;
}

std::size_t intervals_of(const SeriesCurve& curve) {
  std::size_t count = 0;
  for (const auto& pressing : curve.contacts()) count += pressing.size();
  return count;
}

/// Leads the curve to a motion beside `x` of so many intervals of contact: a small force at the nearest
/// approach of a contact to its stop where it does not press, then the equations with the size of that force
/// prescribed; the four nearest approaches. \return whether there is one, at which the curve is then left
bool press_further(SeriesCurve& curve, const Eigen::VectorXd& x, std::size_t intervals) {
  constexpr double kReach = 40.0;  // of the size prescribed
  if (!curve.evaluate(x)) return false;
  std::vector<Approach> found = approaches(curve);
  if (found.size() > 4) found.resize(4);
  const LuFactors lu(curve.jacobian().leftCols(curve.size()));
  for (const Approach& approach : found) {
    Eigen::MatrixXcd push = Eigen::MatrixXcd::Zero(curve.harmonics() + 1, curve.motion().cols());
    for (Eigen::Index n = 0; n < push.rows(); ++n)
      push(n, approach.contact) =
          -std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(n) * approach.time);
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(x.size());
    direction.head(curve.size()) =
        lu.solve(Eigen::VectorXd(curve.weight().cwiseProduct(pack_harmonics(push))));
    if (!direction.allFinite() || direction.isZero(0.0)) continue;
    direction.normalize();
    for (const double size : {1e-4, -1e-4, 3e-4, -3e-4, 1e-3, -1e-3, 3e-3, -3e-3}) {
      if (!correct(curve, x + size * direction, direction, {.iterations = 25})) continue;
      if ((curve.x() - x).norm() > kReach * std::abs(size)) continue;
      if (intervals_of(curve) == intervals) return true;
    }
  }
  return false;
}

}  // namespace

Eigen::VectorXd begun_later(const Eigen::VectorXd& x, int harmonics, double share) {
  Eigen::VectorXd later = x;
  const Eigen::Index stride = 2 * harmonics + 1;
  for (Eigen::Index first = 0; first + stride < x.size(); first += stride) {
    for (Eigen::Index n = 1; n <= harmonics; ++n) {
      const Eigen::Rotation2Dd turn(2.0 * std::numbers::pi * static_cast<double>(n) * share);
      later.segment<2>(first + 2 * n - 1) = turn * x.segment<2>(first + 2 * n - 1);
    }
  }
  return later;
}

double rounding_of(const Eigen::VectorXd& x) { return std::min(1e-7, 1e-3 * x.head(x.size() - 1).norm()); }

Eigen::VectorXd unrepeated_part(const Eigen::VectorXd& x, const SeriesCurve& curve, int p) {
  Eigen::VectorXd part = x.head(curve.size());
  const Eigen::Index stride = 2 * curve.harmonics() + 1;
  for (Eigen::Index i = 0; i < part.size(); ++i) {
    const Eigen::Index n = (i % stride + 1) / 2;
    if (n % p == 0) part[i] = 0.0;
  }
  return part;
}

SeriesStart doubled_branch(const SeriesCurve& curve) {
  const Eigen::VectorXd null = right_singular_vectors(curve.doubled_jacobian()).rightCols(1);
  const SeriesCurve twice(curve.family(), 2 * curve.multiple());
  const Eigen::Index stride = 2 * curve.harmonics();
  Eigen::MatrixXcd direction = Eigen::MatrixXcd::Zero(2 * curve.harmonics() + 1, curve.motion().cols());
  for (Eigen::Index c = 0; c < direction.cols(); ++c) {
    const double root = std::sqrt(curve.law().constant[c]);
    for (Eigen::Index n = 0; n < curve.harmonics(); ++n)
      direction(2 * n + 1, c) = root * Complex(null[c * stride + 2 * n], null[c * stride + 2 * n + 1]);
  }
  return {.multiple = twice.multiple(),
          .x = twice.unknowns(repeated(curve.force(curve.x()), 2), curve.frequency()),
          .tangent = twice.unknowns(direction, 0.0).normalized(),
          .origin = fmt::format("period doubling of motions of order {}", curve.order()),
          .leaves_repetition = true};
}

std::vector<SeriesStart> both_ways(const SeriesCurve& curve, const Eigen::VectorXd& direction,
                                   const Eigen::VectorXd& crossed) {
  std::vector<SeriesStart> starts;
  for (const double sign : {1.0, -1.0})
    starts.push_back({.multiple = curve.multiple(),
                      .x = curve.x(),
                      .tangent = sign * direction,
                      .origin = fmt::format("branch point at {:.10g} rad/s", curve.frequency()),
                      .leaves_repetition = false,
                      .crossed = crossed});
  return starts;
}

std::vector<SeriesStart> crossing_branches(const SeriesCurve& curve, const Eigen::VectorXd& tangent) {
  const Eigen::MatrixXd null = right_singular_vectors(curve.jacobian()).rightCols(2);
  Eigen::VectorXd in_plane = null.transpose() * tangent;
  const Eigen::Vector2d across(-in_plane[1], in_plane[0]);
  const Eigen::VectorXd direction = (null * across).normalized();
  return both_ways(curve, direction, tangent);
}

std::optional<SeriesStart> grazing_branch(const SeriesFamily& family, const Eigen::VectorXd& x,
                                          int multiple) {
  SeriesCurve one(family, 1), curve(family, multiple);
  if (!one.evaluate(x)) return std::nullopt;
  const Eigen::VectorXd start = curve.unknowns(repeated(one.force(x), multiple), one.frequency());
  if (!press_further(curve, start, 1)) return std::nullopt;
  const Eigen::VectorXd pressed = curve.x();
  const auto tangent = tangent_of(curve, Eigen::VectorXd((pressed - start).normalized()));
  if (!tangent) return std::nullopt;
  return SeriesStart{.multiple = multiple,
                     .x = pressed,
                     .tangent = *tangent,
                     .origin = fmt::format("grazing of motions of order {}", one.order()),
                     .leaves_repetition = false};
}

}  // namespace signorini
