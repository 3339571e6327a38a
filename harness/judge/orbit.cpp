#include "harness/judge/orbit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "harness/files.hpp"
#include "harness/judge/measures/impacts.hpp"
#include "methods/discretisation/periodic_time.hpp"

namespace signorini {

namespace {

constexpr double kWeakImpact = 1e-3;

/// Instant at which the force of a contact starts (direction 1) or ends (-1) beside sample i.
double crossing(const Motion& motion, int contact, int inside, int outside) {
  const int count = motion.count();
  const auto f = [&](int i) { return motion.samples.force(((i % count) + count) % count, contact); };
  // A force that grows in proportion to the time since it began has its zero on the line through the two
  // innermost samples; one that jumps, anywhere between the instants.
  const double fall = f(inside) - f(2 * inside - outside);
  const double share = fall > 0.0 ? std::min(1.0, -f(inside) / fall) : 0.5;
  return (inside + (outside - inside) * share) * motion.step();
}

/// Four figures of a value, or 0 where it is no more than `noise`.
std::string rounded(double value, double noise) {
  return std::abs(value) <= noise ? "0" : fmt::format("{:.3e}", value);
}

/// Root mean square about the mean, which a shift of the origin leaves as it is.
double fluctuation(const Eigen::Ref<const Eigen::VectorXd>& x) {
  return std::sqrt((x.array() - x.mean()).square().mean());
}

/// How two contacts that move alike move beside each other: empty where they do so together, or opposite to
/// each other.
std::string phase_between(const Eigen::Ref<const Eigen::VectorXd>& a,
                          const Eigen::Ref<const Eigen::VectorXd>& b) {
  constexpr double kAlike = 1e-6;  // of the motion
  const double alone = fluctuation(a);
  const double sum = fluctuation(a + b);
  return std::abs(sum - 2.0 * alone) <= kAlike * alone || sum <= kAlike * alone ? ""
                                                                                : " " + rounded(sum, 0.0);
}

}  // namespace

std::vector<OrbitEvent> orbit_events(const Motion& motion) {
  std::vector<OrbitEvent> events;
  for (const Impulse& impulse : motion.impulses) {
    events.push_back({impulse.time, impulse.contact, ContactEvent::Kind::impact, impulse.value});
  }
  const double step = motion.step();
  for (const ContactPhase& phase : contact_phases(motion)) {
    if (phase.listed) continue;
    const auto first = static_cast<int>(std::lround(phase.begin / step));
    const auto last = static_cast<int>(std::lround(phase.end / step)) - 1;
    if (last - first + 1 >= motion.count()) continue;  // never opens
    const bool seen = last > first && !phase.timed;
    const double close = seen ? crossing(motion, phase.contact, first, first - 1) : phase.begin;
    const double open = seen ? crossing(motion, phase.contact, last, last + 1) : phase.end;
    events.push_back({wrapped_time(close, motion.period()), phase.contact, ContactEvent::Kind::close, {}});
    events.push_back({wrapped_time(open, motion.period()), phase.contact, ContactEvent::Kind::open, {}});
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const OrbitEvent& a, const OrbitEvent& b) { return a.time < b.time; });
  return events;
}

double largest_impulse(std::span<const OrbitEvent> events) {
  double largest = 0.0;
  for (const OrbitEvent& event : events) largest = std::max(largest, std::abs(event.value.value_or(0.0)));
  return largest;
}

std::string fingerprint(const Motion& motion) {
  const int order = least_order(motion);
  const int copies = motion.order / order;
  double largest = 0.0;
  for (const Impulse& impulse : motion.impulses) largest = std::max(largest, std::abs(impulse.value));
  const auto impacts =
      std::count_if(motion.impulses.begin(), motion.impulses.end(),
                    [&](const Impulse& impulse) { return std::abs(impulse.value) > kWeakImpact * largest; });
  const double force_scale =
      motion.samples.force.size() > 0 ? motion.samples.force.cwiseAbs().maxCoeff() : 0.0;
  std::string text = fmt::format("{} {}", order, impacts / copies);
  const double impulse_noise = kRoundOff * (motion.forcing_period * force_scale + largest);
  const Eigen::VectorXd impulse = impulse_per_forcing_period(motion);
  std::map<std::string, int> last_alike;
  for (int c = 0; c < static_cast<int>(motion.samples.x.cols()); ++c) {
    const auto x = motion.samples.x.col(c);
    // What is left of a motion at rest is the rounding of its coordinate, wherever the origin is.
    const double rest = 1e-13 * x.cwiseAbs().maxCoeff();
    const std::string own =
        fmt::format(" {} {}", rounded(impulse[c], impulse_noise), rounded(fluctuation(x), rest));
    text += own;
    // Mirrored contacts may be struck at once or in turn, with the same impulses.
    const auto [alike, first] = last_alike.try_emplace(own, c);
    if (!first) text += phase_between(motion.samples.x.col(std::exchange(alike->second, c)), x);
  }
  return sha256(text).substr(0, 8);
}

bool same_orbit(const Motion& a, const Motion& b) {
  const std::optional<double> apart = distance(a, b, best_shift(a, b)).x_l2;
  if (!apart) return a.samples.x.size() == 0 || a.samples.x.cwiseAbs().maxCoeff() == 0.0;
  return *apart <= kSameOrbit;
}

}  // namespace signorini
