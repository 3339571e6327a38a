#include "harness/judge/measures/impacts.hpp"

#include <algorithm>
#include <cmath>

#include "methods/discretisation/contact_phases.hpp"

namespace signorini {

namespace {

/// A force below this share of the motion's largest is ripple, not contact.
constexpr double kRipple = 1e-6;
/// An impact appears spread over one to three resolutions; what takes longer lasts.
constexpr double kLastingResolutions = 5.0;

/// Mean velocity over `window` steps ending (direction -1) or beginning (+1) at sample i.
double mean_speed(const Motion& motion, int contact, int i, int window, int direction) {
  const int count = motion.count();
  const auto x = [&](int place) { return motion.samples.x(((place % count) + count) % count, contact); };
  return direction * (x(i + direction * window) - x(i)) / (window * motion.step());
}

/// True if no impulse lies in the open-ended stretch (from, to) of instants given in steps, cyclically.
bool undisturbed(const Motion& motion, const Impulse& self, double from, double to) {
  const double step = motion.step();
  return std::none_of(motion.impulses.begin(), motion.impulses.end(), [&](const Impulse& other) {
    if (&other == &self || other.time == self.time) return false;
    for (const double turn : {-motion.period(), 0.0, motion.period()}) {
      const double place = (other.time + turn) / step;
      if (place > from && place < to) return true;
    }
    return false;
  });
}

ContactPhase listed_impact(const Motion& motion, const Impulse& impulse) {
  ContactPhase phase{.contact = impulse.contact,
                     .begin = impulse.time,
                     .end = impulse.time,
                     .impulse = impulse.value,
                     .listed = true,
                     .lasting = false,
                     .speed_before = {},
                     .speed_after = {}};
  const int count = motion.count();
  const double place = impulse.time / motion.step();
  const int left = static_cast<int>(std::ceil(place)) - 1;
  const int right = static_cast<int>(std::floor(place)) + 1;
  const auto v = [&](int i) {
    return motion.samples.velocity(((i % count) + count) % count, impulse.contact);
  };
  if (undisturbed(motion, impulse, left - 1.0, place)) {
    phase.speed_before = v(left) + (place - left) * (v(left) - v(left - 1));
  }
  if (undisturbed(motion, impulse, place, right + 1.0)) {
    phase.speed_after = v(right) - (right - place) * (v(right + 1) - v(right));
  }
  return phase;
}

/// A phase of force from `begin` to `end`, with the samples first..last inside it (none if last < first).
ContactPhase force_phase(const Motion& motion, const ContactPhase& push, int first, int last) {
  const double step = motion.step();
  ContactPhase phase = push;
  phase.lasting =
      !motion.impulses.empty() || push.end - push.begin > kLastingResolutions * time_resolution(motion);
  if (last - first + 1 < motion.count()) {
    const int window = std::max(1, static_cast<int>(std::lround(2.0 * time_resolution(motion) / step)));
    phase.speed_before = mean_speed(motion, push.contact, first - 1, window, -1);
    phase.speed_after = mean_speed(motion, push.contact, last + 1, window, 1);
  }
  return phase;
}

/// The phase that samples of the force show.
ContactPhase sampled_phase(const Motion& motion, int contact, const SampledPhase& run) {
  const double step = motion.step();
  ContactPhase push{.contact = contact, .begin = run.first * step, .end = (run.first + run.length) * step};
  for (int i = run.first; i < run.first + run.length; ++i)
    push.impulse += step * motion.samples.force(i % motion.count(), contact);
  return force_phase(motion, push, run.first, run.first + run.length - 1);
}

/// The phase that a motion lists.
ContactPhase listed_phase(const Motion& motion, int contact, const ListedPush& listed) {
  return force_phase(motion,
                     {.contact = contact,
                      .begin = listed.begin,
                      .end = listed.end,
                      .impulse = listed.impulse,
                      .timed = true},
                     static_cast<int>(std::ceil(listed.begin / motion.step())),
                     static_cast<int>(std::floor(listed.end / motion.step())));
}

double force_scale(const Motion& motion) {
  return motion.samples.force.size() == 0 ? 0.0 : motion.samples.force.cwiseAbs().maxCoeff();
}

}  // namespace

double time_resolution(const Motion& motion) {
  return motion.bandwidth ? motion.period() / (2.0 * std::max(1, *motion.bandwidth)) : motion.step();
}

std::vector<ContactPhase> contact_phases(const Motion& motion) {
  std::vector<ContactPhase> phases;
  for (const Impulse& impulse : motion.impulses) phases.push_back(listed_impact(motion, impulse));
  const double scale = force_scale(motion);
  const int bridge = std::max(1, static_cast<int>(std::ceil(time_resolution(motion) / motion.step())));
  for (int c = 0; c < static_cast<int>(motion.samples.force.cols()); ++c) {
    const std::vector<ListedPush> pushes = short_pushes(motion, c);
    for (const ListedPush& push : pushes) phases.push_back(listed_phase(motion, c, push));
    if (!pushes.empty() || scale == 0.0) continue;
    for (const SampledPhase& run : contact_phases(motion.samples.force.col(c), kRipple * scale, bridge))
      phases.push_back(sampled_phase(motion, c, run));
  }
  std::stable_sort(phases.begin(), phases.end(),
                   [](const ContactPhase& a, const ContactPhase& b) { return a.begin < b.begin; });
  return phases;
}

double contact_ratio(const Motion& motion) {
  const double scale = force_scale(motion);
  double largest = 0.0;
  for (const auto& force : motion.samples.force.colwise()) {
    const auto pushing = (force.array() < -kRipple * scale).count();
    largest = std::max(largest, static_cast<double>(pushing) / motion.count());
  }
  return largest;
}

}  // namespace signorini
