#include "methods/orbit/continuation/dips.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini {

GuardCubic::Lowest GuardCubic::lowest() const {
  constexpr int kSamples = 16;
  const double rise = last - value;
  const double c2 = 3.0 * rise - 2.0 * slope - last_slope, c3 = slope + last_slope - 2.0 * rise;
  const double doubt = std::abs(c3) + 0.5 * std::abs(c2);
  const auto bound = [&](double z) {
    return value + z * (slope + z * (c2 + z * c3)) - doubt * z * z * (1.0 - z) * (1.0 - z);
  };
  Lowest lowest{.at = 0.5, .bound = bound(0.5)};
  const auto consider = [&](double z) {
    if (z > 0.0 && z < 1.0 && bound(z) < lowest.bound) lowest = {.at = z, .bound = bound(z)};
  };
  for (int k = 1; k < kSamples; ++k) consider(k / double{kSamples});
  // Zeros of slope + 2 c2 z + 3 c3 z^2, without cancellation: a dip may be narrower than the samples.
  const double root = std::sqrt(std::max(0.0, c2 * c2 - 3.0 * c3 * slope));
  const double sum = -(c2 + std::copysign(root, c2));
  if (c3 != 0.0) consider(sum / (3.0 * c3));
  if (sum != 0.0) consider(slope / sum);
  return lowest;
}

std::vector<TrackedGuard> tracked_guards(ExtendedEquations& equations, const Station& station) {
  constexpr double kStep = 1e-7;  // in units of the curve, as that of dR/dp
  const Eigen::Index states = equations.orbit().states(), events = equations.orbit().count();
  Eigen::VectorXd beside = station.x + kStep * station.tangent;
  equations.settle(beside);
  if (!equations.evaluate_motion(beside)) return {};
  std::vector<TrackedGuard> tracked;
  const std::vector<OrbitGuard> moved = event_guards(equations);
  for (const OrbitGuard& guard : station.survey.guards) {
    const auto same =
        std::find_if(moved.begin(), moved.end(), [&](const OrbitGuard& other) { return other.same(guard); });
    if (same == moved.end()) continue;
    double change = same->value - guard.value;
    if (guard.kind == GuardKind::interval) {
      // As the tangent has it: the length of a chatter's last flights is below the error of a difference.
      const Eigen::Index later = states + guard.index;
      const Eigen::Index earlier = states + (guard.index + events - 1) % events;
      change = kStep * (station.tangent[later] - station.tangent[earlier]);
    }
    tracked.push_back({.guard = {.guard = guard, .part = guard.index}, .rate = change / kStep});
  }
  for (const GuardMaximum& maximum : station.survey.maxima)
    tracked.push_back(
        {.guard = maximum, .rate = (value_at(equations, maximum) - maximum.guard.value) / kStep});
  return tracked;
}

std::optional<Station> guards_at(ExtendedEquations& equations, const Station& begin, double length) {
  if (!correct(equations, begin.x + length * begin.tangent, begin.tangent,
               {.iterations = 14, .tolerance = 1e-14}))
    return std::nullopt;
  const auto tangent = tangent_of(equations, begin.tangent);
  if (!tangent) return std::nullopt;
  std::optional<Station> station(std::in_place);
  station->x = equations.orbit().x;
  station->tangent = *tangent;
  station->survey = survey(equations);
  return station;
}

namespace {

bool of_one_kind(const TrackedGuard& a, const TrackedGuard& b) {
  return a.guard.part == b.guard.part && a.guard.guard.same(b.guard.guard);
}

// The one that is nearest in phase to a guard at the other end; null where there is none.
const TrackedGuard* nearest_guard(const TrackedGuard& guard, const std::vector<TrackedGuard>& others) {
  const TrackedGuard* best = nullptr;
  const auto distance = [&](const TrackedGuard& other) {
    return std::abs(other.guard.guard.phase - guard.guard.guard.phase);
  };
  for (const TrackedGuard& other : others) {
    if (of_one_kind(guard, other) && (best == nullptr || distance(other) < distance(*best))) best = &other;
  }
  return best;
}

// The same guard at the other end; null where each has a nearer one, or the guard exists at one end only.
const TrackedGuard* counterpart(const TrackedGuard& guard, const std::vector<TrackedGuard>& own,
                                const std::vector<TrackedGuard>& others) {
  const TrackedGuard* other = nearest_guard(guard, others);
  return other != nullptr && nearest_guard(*other, own) == &guard ? other : nullptr;
}

class DipSearch {
 public:
  DipSearch(ExtendedEquations& equations, Station& begin, double length)
      : equations_(equations), begin_(begin), step_(length) {}

  std::optional<StepPoint> run(Station& end) {
    search({.length = 0.0, .station = &begin_}, {.length = step_, .station = &end});
    return std::move(found_);
  }

 private:
  struct End {
    double length;
    Station* station;
  };

  void track(Station& station) {
    if (station.tracked.empty()) station.tracked = tracked_guards(equations_, station);
  }

  // The derivative of a guard by the length in the plane of the step.
  double slope(const TrackedGuard& guard, const Station& station) const {
    return guard.rate / begin_.tangent.dot(station.tangent);
  }

  // A maximum that an impact leaves behind as it fades, and that is gone where it has a speed.
  static bool left_by_an_event(double value) {
    constexpr double kTouching = 1e-8;
    return value < kTouching;
  }

  // The least bound of those guards between two points that may be lower there than at both of them.
  GuardCubic::Lowest lowest(const End& a, const End& b) const {
    const double h = b.length - a.length;
    GuardCubic::Lowest least{.at = 0.5, .bound = 0.0};
    const auto consider = [&](const GuardCubic& cubic, const GuardCubic::Lowest& here) {
      if (here.bound < std::min({0.0, cubic.value, cubic.last}) + kViolated && here.bound < least.bound)
        least = here;
    };
    const auto &first = a.station->tracked, &second = b.station->tracked;
    for (const TrackedGuard& guard : first) {
      GuardCubic cubic{.value = guard.guard.guard.value, .slope = h * slope(guard, *a.station)};
      if (const TrackedGuard* other = counterpart(guard, first, second)) {
        cubic.last = other->guard.guard.value;
        cubic.last_slope = h * slope(*other, *b.station);
        consider(cubic, cubic.lowest());
      } else if (!left_by_an_event(cubic.value)) {
        consider(cubic, {.at = 0.5, .bound = cubic.value + cubic.slope});
      }
    }
    for (const TrackedGuard& guard : second) {
      const double value = guard.guard.guard.value;
      if (left_by_an_event(value) || counterpart(guard, second, first) != nullptr) continue;
      consider({.last = value}, {.at = 0.5, .bound = value - h * slope(guard, *b.station)});
    }
    return least;
  }

  // Leaves a violation in found_.
  void search(const End& a, const End& b) {
    constexpr int kChecks = 24;
    constexpr double kNarrow = 1e-6;  // of the step
    const double h = b.length - a.length;
    if (found_ || checks_ >= kChecks || h < kNarrow * step_) return;
    track(*a.station);
    track(*b.station);
    const GuardCubic::Lowest least = lowest(a, b);
    if (least.bound >= 0.0) return;
    ++checks_;
    const double length = a.length + least.at * h;
    auto between = guards_at(equations_, begin_, length);
    if (!between) return;
    if (violates(*between)) {
      found_ = {.length = length, .station = station_at(equations_, between->tangent)};
      return;
    }
    const End middle{.length = length, .station = &*between};
    search(a, middle);
    search(middle, b);
  }

  ExtendedEquations& equations_;
  Station& begin_;
  double step_;
  int checks_ = 0;
  std::optional<StepPoint> found_ = {};
};

}  // namespace

std::optional<StepPoint> hidden_violation(ExtendedEquations& equations, Station& begin, double length,
                                          Station& end) {
  return DipSearch(equations, begin, length).run(end);
}

}  // namespace signorini
