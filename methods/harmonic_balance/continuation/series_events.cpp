#include "methods/harmonic_balance/continuation/series_events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "methods/continuation/arc_length.hpp"
#include "methods/harmonic_balance/continuation/series_point.hpp"
#include "methods/harmonic_balance/continuation/series_symmetry.hpp"

namespace signorini {

namespace {

/// Unknowns beside a grazing of a motion without contact, at which the curve is evaluated, on the side from
/// which `slope` comes: there it does not touch.
Eigen::VectorXd before_grazing(const SeriesCurve& curve, const Eigen::VectorXd& slope) {
  constexpr double kBefore = 1e-9;  // of the unit of the frequency
  Eigen::VectorXd x = Eigen::VectorXd::Zero(curve.size() + 1);
  x[curve.size()] = curve.x()[curve.size()] - std::copysign(kBefore, slope[curve.size()]);
  return x;
}

/// A search along one step; found points are sorted at the end.
class StepSearch {
 public:
  StepSearch(DepthCurve& curve, const SeriesStation& here, double length, const SeriesStation& next)
      : curve_(curve), here_(here), next_(next), step_{here.z, here.tangent, length} {}

  void folds() {
    const Eigen::Index n = here_.x.size() - 1;
    along(SpecialKind::fold, here_.slope[n], next_.slope[n], [&](DepthCurve& at) {
      const auto slope = slope_of(at);
      return slope ? std::optional((*slope)[n]) : std::nullopt;
    });
  }

  void branch_points() {
    SeriesCurve& series = curve_.series();
    if (is_symmetric(series, here_.x) && is_symmetric(series, next_.x)) return pitchforks();
    // One row for the whole step: the slope itself is not defined at a branch point.
    const Eigen::VectorXd slope = (here_.slope + next_.slope).normalized();
    const auto pivots = [&](DepthCurve& at) {
      return std::optional(signed_pivots(bordered_jacobian(at.series(), slope)));
    };
    if (!along(SpecialKind::branch_point, here_.crossing, next_.crossing, pivots)) return;
    for (SeriesStart& other : crossing_branches(curve_.series(), slope))
      events_.others.push_back(std::move(other));
  }

  // Where all that can branch off has its own block, and the corrector stays on motions for which R_x is
  // regular.
  void pitchforks() {
    SeriesCurve& series = curve_.series();
    const AnyEquations motions = symmetric_motions(series);
    const CurveStep step{here_.x, here_.slope, here_.slope.dot(next_.x - here_.x)};
    const auto test = [&](const Eigen::VectorXd&) -> std::optional<double> { return pitchfork_test(series); };
    const auto at_end = [&](const Eigen::VectorXd& x) {
      return series.evaluate(x) ? pitchfork_test(series) : 0.0;
    };
    const double first = at_end(here_.x), last = at_end(next_.x);
    if (!(first * last < 0.0)) return;
    const auto length = locate(motions, step, test, first, last);
    if (!length) return;
    add(step_.length * *length / step.length, SpecialKind::branch_point, {});
    const Eigen::VectorXd slope = (here_.slope + next_.slope).normalized();
    for (SeriesStart& other : pitchfork_branches(series, slope)) events_.others.push_back(std::move(other));
  }

  void doublings() {
    if (!here_.doubling || !next_.doubling) return;
    const auto pivots = [](DepthCurve& at) {
      return std::optional(signed_pivots(at.series().doubled_jacobian()));
    };
    if (along(SpecialKind::period_doubling, *here_.doubling, *next_.doubling, pivots))
      events_.others.push_back(doubled_branch(curve_.series()));
  }

  // The first gain or loss of an interval of contact.
  void contacts() {
    if (next_.intervals == here_.intervals) return;
    const auto changed = [&](DepthCurve& at) {
      return std::optional(interval_counts(at.series()) == here_.intervals ? -1.0 : 1.0);
    };
    const auto length = locate(curve_, step_, changed, -1.0, 1.0);
    if (!length) return;
    std::size_t contact = 0;
    while (contact + 1 < next_.intervals.size() && next_.intervals[contact] == here_.intervals[contact])
      ++contact;
    const bool gained = next_.intervals[contact] > here_.intervals[contact];
    const bool rigid = has_impacts(curve_.series().problem());
    add(*length, rigid ? SpecialKind::grazing : SpecialKind::contact_change,
        fmt::format("contact {} {} to press", contact, gained ? "begins" : "ceases"));
    const bool free =
        std::all_of(here_.intervals.begin(), here_.intervals.end(), [](auto count) { return count == 0; });
    if (free && gained && curve_.series().multiple() == 1)
      events_.grazing = before_grazing(curve_.series(), here_.slope);
  }

  SeriesEvents take() {
    std::stable_sort(found_.begin(), found_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [length, special] : found_) events_.special.push_back(std::move(special));
    return std::move(events_);
  }

 private:
  std::optional<Eigen::VectorXd> slope_of(DepthCurve& at) const {
    const auto tangent = tangent_of(at, here_.tangent);
    if (!tangent) return std::nullopt;
    return at.without_depths(*tangent).normalized();
  }

  template <class Function>
  bool along(SpecialKind kind, double first, double last, const Function& f) {
    if (!(first * last < 0.0)) return false;
    const auto length = locate(curve_, step_, f, first, last);
    if (length) add(*length, kind, {});
    return length.has_value();
  }

  void add(double length, SpecialKind kind, std::string text) {
    found_.emplace_back(
        length,
        SpecialPoint{.kind = kind, .point = solution_point(curve_.series()), .text = std::move(text)});
  }

  DepthCurve& curve_;
  const SeriesStation& here_;
  const SeriesStation& next_;
  CurveStep step_;
  std::vector<std::pair<double, SpecialPoint>> found_;
  SeriesEvents events_;
};

}  // namespace

std::vector<std::size_t> interval_counts(const SeriesCurve& curve) {
  const double least = kNoPhase / (2.0 * std::numbers::pi * curve.harmonics());
  std::vector<std::size_t> counts;
  for (const std::vector<ContactInterval>& pressing : curve.contacts()) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < pressing.size(); ++i) {
      const double after = i + 1 < pressing.size() ? pressing[i + 1].begin : pressing[0].begin + 1.0;
      const bool whole = pressing.size() == 1;
      if (pressing[i].end - pressing[i].begin >= least && (whole || after - pressing[i].end >= least))
        ++count;
    }
    counts.push_back(count);
  }
  return counts;
}

SeriesStation series_station(DepthCurve& curve, const Eigen::VectorXd& slope, bool doublings) {
  SeriesCurve& series = curve.series();
  const bool smooth = series.family().integral == ContactIntegral::exact;
  curve.follow(smooth ? short_contacts(series) : std::vector<ContactDepth>{});
  SeriesStation at{.z = curve.with_depths(series.x(), curve.depths_here()),
                   .tangent = curve.lifted(slope).normalized(),
                   .x = series.x(),
                   .slope = slope,
                   .depths = curve.depths(),
                   .intervals = interval_counts(series),
                   .motion = series.motion(),
                   .crossing = signed_pivots(bordered_jacobian(series, slope))};
  if (doublings) at.doubling = signed_pivots(series.doubled_jacobian());
  return at;
}

SeriesEvents events_on_step(DepthCurve& curve, const SeriesStation& here, double length,
                            const SeriesStation& next, bool leaving) {
  curve.follow(here.depths);
  StepSearch search(curve, here, length, next);
  // Where a branch leaves another one the frequency may stand still, to rounding of either sign.
  constexpr double kStandsStill = 1e-6;
  if (!leaving || std::abs(here.slope[here.x.size() - 1]) > kStandsStill) search.folds();
  if (!leaving) search.branch_points();
  search.doublings();
  search.contacts();
  return search.take();
}

}  // namespace signorini
