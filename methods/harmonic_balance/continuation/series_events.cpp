#include "methods/harmonic_balance/continuation/series_events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/continuation/arc_length.hpp"
#include "methods/harmonic_balance/continuation/series_point.hpp"

namespace signorini {

namespace {

std::vector<std::size_t> interval_counts(const SeriesCurve& curve) {
  std::vector<std::size_t> counts;
  for (const auto& pressing : curve.contacts()) counts.push_back(pressing.size());
  return counts;
}

/// A search along one step; found points are sorted at the end.
class StepSearch {
 public:
  StepSearch(SeriesCurve& curve, const SeriesStation& here, double length, const SeriesStation& next)
      : curve_(curve), here_(here), next_(next), step_{here.x, here.tangent, length} {}

  void folds() {
    const Eigen::Index n = curve_.size();
    along(SpecialKind::fold, here_.tangent[n], next_.tangent[n], [&](SeriesCurve& at) {
      const auto tangent = tangent_of(at, here_.tangent);
      return tangent ? std::optional((*tangent)[n]) : std::nullopt;
    });
  }

  void branch_points() {
    const auto pivots = [&](SeriesCurve& at) {
      return std::optional(signed_pivots(bordered_jacobian(at, here_.tangent)));
    };
    if (!along(SpecialKind::branch_point, here_.crossing, next_.crossing, pivots)) return;
    for (SeriesStart& other : crossing_branches(curve_, here_.tangent))
      events_.others.push_back(std::move(other));
  }

  void doublings() {
    if (!here_.doubling || !next_.doubling) return;
    const auto pivots = [](SeriesCurve& at) { return std::optional(signed_pivots(at.doubled_jacobian())); };
    if (along(SpecialKind::period_doubling, *here_.doubling, *next_.doubling, pivots))
      events_.others.push_back(doubled_branch(curve_));
  }

  // The first gain or loss of an interval of contact.
  void contacts() {
    if (next_.intervals == here_.intervals) return;
    const auto changed = [&](SeriesCurve& at) {
      return std::optional(interval_counts(at) == here_.intervals ? -1.0 : 1.0);
    };
    const auto length = locate(curve_, step_, changed, -1.0, 1.0);
    if (!length) return;
    std::size_t contact = 0;
    while (contact + 1 < next_.intervals.size() && next_.intervals[contact] == here_.intervals[contact])
      ++contact;
    const bool gained = next_.intervals[contact] > here_.intervals[contact];
    const bool rigid = std::holds_alternative<Restitution>(curve_.problem().law);
    add(*length, rigid ? SpecialKind::grazing : SpecialKind::contact_change,
        fmt::format("contact {} {} to press", contact, gained ? "begins" : "ceases"));
    const bool free =
        std::all_of(here_.intervals.begin(), here_.intervals.end(), [](auto count) { return count == 0; });
    if (!free || !gained || curve_.multiple() > 1) return;
    constexpr double kBefore = 1e-9;  // of the unit of the frequency, on the side without contact
    events_.grazing = Eigen::VectorXd::Zero(curve_.size() + 1);
    (*events_.grazing)[curve_.size()] =
        curve_.x()[curve_.size()] - std::copysign(kBefore, here_.tangent[curve_.size()]);
  }

  SeriesEvents take() {
    std::stable_sort(found_.begin(), found_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [length, special] : found_) events_.special.push_back(std::move(special));
    return std::move(events_);
  }

 private:
  template <class Function>
  bool along(SpecialKind kind, double first, double last, const Function& f) {
    if (!(first * last < 0.0)) return false;
    const auto length = locate(curve_, step_, f, first, last);
    if (length) add(*length, kind, {});
    return length.has_value();
  }

  void add(double length, SpecialKind kind, std::string text) {
    found_.emplace_back(length,
                        SpecialPoint{.kind = kind, .point = branch_point(curve_), .text = std::move(text)});
  }

  SeriesCurve& curve_;
  const SeriesStation& here_;
  const SeriesStation& next_;
  CurveStep step_;
  std::vector<std::pair<double, SpecialPoint>> found_;
  SeriesEvents events_;
};

}  // namespace

SeriesStation series_station(SeriesCurve& curve, const Eigen::VectorXd& tangent, bool doublings) {
  SeriesStation at{.x = curve.x(),
                   .tangent = tangent,
                   .intervals = interval_counts(curve),
                   .motion = curve.motion(),
                   .crossing = signed_pivots(bordered_jacobian(curve, tangent))};
  if (doublings) at.doubling = signed_pivots(curve.doubled_jacobian());
  return at;
}

SeriesEvents events_on_step(SeriesCurve& curve, const SeriesStation& here, double length,
                            const SeriesStation& next, bool leaving) {
  StepSearch search(curve, here, length, next);
  // Where a branch leaves another one the frequency may stand still, to rounding of either sign.
  constexpr double kStandsStill = 1e-6;
  if (!leaving || std::abs(here.tangent[curve.size()]) > kStandsStill) search.folds();
  if (!leaving) search.branch_points();
  search.doublings();
  search.contacts();
  return search.take();
}

}  // namespace signorini
