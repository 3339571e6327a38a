#include "methods/orbit/family/tracked_guards.hpp"

#include <algorithm>
#include <cmath>

namespace signorini {

GuardCubic::Lowest GuardCubic::lowest() const {
  constexpr int kSamples = 16;
  const double rise = last - value;
  const double c2 = 3.0 * rise - 2.0 * slope - last_slope, c3 = slope + last_slope - 2.0 * rise;
  const double doubt = std::abs(c3) + 0.5 * std::abs(c2);
  const auto cubic = [&](double z) { return value + z * (slope + z * (c2 + z * c3)); };
  const auto bound = [&](double z) { return cubic(z) - doubt * z * z * (1.0 - z) * (1.0 - z); };
  Lowest lowest{.at = 0.5, .bound = bound(0.5)};
  double least = std::min(0.0, cubic(0.5));
  // Where the cubic itself is negative, its lowest place; else that of the bound.
  const auto consider = [&](double z) {
    if (!(z > 0.0 && z < 1.0)) return;
    const bool better = cubic(z) < least || (least == 0.0 && bound(z) < lowest.bound);
    least = std::min(least, cubic(z));
    if (better) lowest.at = z;
    lowest.bound = std::min(lowest.bound, bound(z));
  };
  for (int k = 1; k < kSamples; ++k) consider(k / double{kSamples});
  // Zeros of slope + 2 c2 z + 3 c3 z^2, without cancellation: a dip may be narrower than the samples.
  const double root = std::sqrt(std::max(0.0, c2 * c2 - 3.0 * c3 * slope));
  const double sum = -(c2 + std::copysign(root, c2));
  if (c3 != 0.0) consider(sum / (3.0 * c3));
  if (sum != 0.0) consider(slope / sum);
  return lowest;
}

std::vector<TrackedGuard> tracked_guards(ExtendedEquations& equations, const Eigen::VectorXd& x,
                                         const Eigen::VectorXd& tangent, const OrbitSurvey& found) {
  const Eigen::Index states = equations.orbit().states(), events = equations.orbit().count();
  Eigen::VectorXd beside = x + kDifference * tangent;
  equations.settle(beside);
  if (!equations.evaluate_motion(beside)) return {};
  std::vector<TrackedGuard> tracked;
  const std::vector<OrbitGuard> moved = event_guards(equations);
  for (const OrbitGuard& guard : found.guards) {
    const auto same = std::ranges::find_if(moved, [&](const OrbitGuard& other) { return other.same(guard); });
    if (same == moved.end() || guard.kind == GuardKind::together)
      continue;  // which has a corner where it holds
    double change = same->value - guard.value;
    if (guard.kind == GuardKind::interval) {
      // As the tangent has it: the length of a chatter's last flights is below the error of a difference.
      const Eigen::Index later = states + guard.index;
      const Eigen::Index earlier = states + (guard.index + events - 1) % events;
      change = kDifference * (tangent[later] - tangent[earlier]) * interval_weight(equations, guard.index);
    }
    tracked.push_back({{guard, guard.index}, change / kDifference});
  }
  for (const GuardMaximum& maximum : found.maxima)
    tracked.push_back({maximum, (value_at(equations, maximum) - maximum.value) / kDifference});
  return tracked;
}

namespace {

bool of_one_kind(const TrackedGuard& a, const TrackedGuard& b) { return a.part == b.part && a.same(b); }

// The one that is nearest in phase to a guard at the other end; null where there is none.
const TrackedGuard* nearest_guard(const TrackedGuard& guard, const std::vector<TrackedGuard>& others) {
  const TrackedGuard* best = nullptr;
  const auto distance = [&](const TrackedGuard& other) { return std::abs(other.phase - guard.phase); };
  for (const TrackedGuard& other : others) {
    if (of_one_kind(guard, other) && (best == nullptr || distance(other) < distance(*best))) best = &other;
  }
  return best;
}

}  // namespace

const TrackedGuard* counterpart(const TrackedGuard& guard, const std::vector<TrackedGuard>& own,
                                const std::vector<TrackedGuard>& others) {
  const TrackedGuard* other = nearest_guard(guard, others);
  return other != nullptr && nearest_guard(*other, own) == &guard ? other : nullptr;
}

}  // namespace signorini
