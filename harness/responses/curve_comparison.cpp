#include "harness/responses/curve_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace signorini {

namespace {

/// An element with the size of its motion.
struct SizedElement : CurveElement {
  Eigen::RowVectorXd size = {};
};

/// Elements in the order of their frequencies, so that those near one are found by bisection.
std::vector<SizedElement> ordered(std::vector<CurveElement> elements) {
  std::ranges::stable_sort(elements, {}, [](const CurveElement& e) { return e.middle.frequency; });
  std::vector<SizedElement> sized;
  for (CurveElement& element : elements) {
    Eigen::RowVectorXd size = ResponseMetric::size_of(element.middle.motion);
    sized.push_back({std::move(element), std::move(size)});
  }
  return sized;
}

constexpr int kAllOrders = std::numeric_limits<int>::max();

/// Distance from a point to the nearest of the elements; infinite beyond kWideTolerance.
double nearest(const ResponsePoint& point, const std::vector<SizedElement>& elements,
               const ResponseMetric& metric, double reach) {
  const auto frequency = [](const SizedElement& e) { return e.middle.frequency; };
  const Eigen::RowVectorXd size = ResponseMetric::size_of(point.motion);
  const auto first = std::ranges::lower_bound(elements, point.frequency - reach, {}, frequency);
  const auto last = std::ranges::upper_bound(elements, point.frequency + reach, {}, frequency);
  double least = std::numeric_limits<double>::infinity();
  for (auto element = first; element != last && least > 0.0; ++element) {
    if (element->middle.order != point.order || metric.between(size, element->size) >= least) continue;
    least = std::min(least, metric(point, element->middle));
  }
  return least;
}

/// Length of the elements within a tolerance of the others and of all, and of the stable ones among them.
struct Covered {
  double length = 0.0, all = 0.0, stable = 0.0, all_stable = 0.0;
};

/// \param orders  of `length` and `all`; `stable` and `all_stable` are of every order
Covered covered(const std::vector<SizedElement>& elements, const std::vector<double>& distances,
                double tolerance, int orders = kAllOrders) {
  Covered sum;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const bool stable = elements[i].middle.stable.value_or(false);
    const bool counts = elements[i].middle.order <= orders;
    if (stable) sum.all_stable += elements[i].length;
    if (counts) sum.all += elements[i].length;
    if (!(distances[i] <= tolerance)) continue;
    if (counts) sum.length += elements[i].length;
    if (stable) sum.stable += elements[i].length;
  }
  return sum;
}

std::vector<double> distances(const std::vector<SizedElement>& from, const std::vector<SizedElement>& to,
                              const ResponseMetric& metric, double window) {
  std::vector<double> result;
  for (const SizedElement& element : from)
    result.push_back(nearest(element.middle, to, metric, kWideTolerance * window));
  return result;
}

SpecialKind kind_of(const LocatedPoint& point) {
  return point.kind == SpecialKind::contact_change ? SpecialKind::grazing : point.kind;
}

void match_points(std::vector<LocatedPoint> exact, std::vector<LocatedPoint> located, double window,
                  CurveComparison& result) {
  constexpr double kReach = 0.05;  // of the window
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (std::size_t j = 0; j < located.size(); ++j) {
      const double apart = std::abs(exact[i].frequency - located[j].frequency);
      if (kind_of(exact[i]) == kind_of(located[j]) && exact[i].order == located[j].order &&
          apart <= kReach * window)
        pairs.emplace_back(apart, i, j);
    }
  }
  std::ranges::sort(pairs);
  std::vector<bool> taken(located.size(), false);
  for (const LocatedPoint& point : exact) result.points.push_back({.exact = point});
  for (const auto& [apart, i, j] : pairs) {
    if (result.points[i].frequency || taken[j]) continue;
    result.points[i].frequency = located[j].frequency;
    taken[j] = true;
  }
  for (std::size_t j = 0; j < located.size(); ++j)
    if (!taken[j]) result.invented.push_back(located[j]);
  std::ranges::stable_sort(result.points, {}, [](const PointMatch& m) { return m.exact.frequency; });
}

}  // namespace

std::vector<LocatedPoint> distinct_points(std::vector<LocatedPoint> points, double window) {
  constexpr double kSame = 1e-6;  // of the window
  const auto key = [](const LocatedPoint& p) { return std::tuple(kind_of(p), p.order, p.frequency); };
  std::ranges::sort(points, {}, key);
  const auto same = [&](const LocatedPoint& a, const LocatedPoint& b) {
    return kind_of(a) == kind_of(b) && a.order == b.order &&
           std::abs(a.frequency - b.frequency) <= kSame * window;
  };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  return points;
}

std::vector<ResponseBranch> beside_branches(const ResponseCurve& branches, const ResponseCurve& steps,
                                            const ResponseMetric& metric, double window) {
  const double reach = kCloseTolerance * window;
  const std::vector<SizedElement> followed = ordered(elements_of(branches, metric));
  std::vector<ResponsePoint> kept;
  const auto known = [&](const ResponsePoint& point) {
    return nearest(point, followed, metric, reach) <= kCloseTolerance ||
           std::ranges::any_of(kept, [&](const ResponsePoint& other) {
             return point.frequency == other.frequency && metric(point, other) <= kCloseTolerance;
           });
  };
  std::vector<ResponseBranch> beside;
  for (const ResponseBranch& branch : steps.branches) {
    bool joined = false;
    for (const ResponsePoint& step : branch.points) {
      const ResponsePoint point = metric.primitive(step);
      const bool take = !known(point);
      if (take) {
        if (!joined) beside.push_back({.by_arc_length = false});
        beside.back().points.push_back(point);
        kept.push_back(point);
      }
      joined = take;
    }
  }
  return beside;
}

CurveComparison compare_curves(const ResponseCurve& exact, const ResponseCurve& curve,
                               const ResponseMetric& metric, double window,
                               const ComparisonOptions& options) {
  const std::vector<SizedElement> truth = ordered(elements_of(exact, metric));
  const std::vector<SizedElement> claimed = ordered(elements_of(curve, metric));
  const std::vector<double> to_curve = distances(truth, claimed, metric, window);
  std::vector<double> to_exact = distances(claimed, truth, metric, window);
  CurveComparison result;
  for (std::size_t i = 0; options.is_true && i < claimed.size(); ++i)
    if (to_exact[i] > kWideTolerance && options.is_true(claimed[i].middle)) to_exact[i] = 0.0;
  for (const auto& [tolerance, shares] :
       {std::pair{kCloseTolerance, &result.close}, std::pair{kWideTolerance, &result.wide}}) {
    const Covered of_truth = covered(truth, to_curve, tolerance, options.orders);
    const Covered of_claimed = covered(claimed, to_exact, tolerance);
    result.exact_length = of_truth.all;
    result.length = of_claimed.all;
    if (result.exact_length > 0.0) shares->covered = of_truth.length / result.exact_length;
    if (of_truth.all_stable > 0.0) shares->covered_stable = of_truth.stable / of_truth.all_stable;
    if (result.length > 0.0) shares->false_share = 1.0 - of_claimed.length / result.length;
    result.right_length = of_claimed.length;  // that of the wider tolerance, which comes last
  }
  std::vector<LocatedPoint> to_locate = exact.located;
  std::erase_if(to_locate, [&](const LocatedPoint& point) { return point.order > options.orders; });
  match_points(distinct_points(std::move(to_locate), window), distinct_points(curve.located, window), window,
               result);
  return result;
}

}  // namespace signorini
