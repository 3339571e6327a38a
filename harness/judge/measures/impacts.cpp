#include "harness/judge/measures/impacts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

/// Samples from which a speed is extrapolated: the error is of order step^6.
constexpr int kExtrapolatedFrom = 6;

/// The polynomial through values at the places first, first + 1, ..., at `place` [steps].
double polynomial_at(const std::vector<double>& values, double first, double place) {
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    double weight = values[i];
    for (std::size_t j = 0; j < values.size(); ++j) {
      if (j == i) continue;
      const auto a = static_cast<double>(i), b = static_cast<double>(j);
      weight *= (place - first - b) / (a - b);
    }
    sum += weight;
  }
  return sum;
}

/// Speeds that samples tell beside the events of a motion.
class SampledSpeeds {
 public:
  explicit SampledSpeeds(const Motion& motion) : motion_(motion) {
    for (const Impulse& impulse : motion.impulses) add(impulse.time);
    for (const ContactEvent& event : motion.events.value_or(std::vector<ContactEvent>{})) add(event.time);
    std::ranges::sort(places_);
  }

  /// x' of a contact just before a place [steps]; empty where fewer than two samples lie between it and the
  /// event before.
  [[nodiscard]] std::optional<double> before(int contact, double place) const {
    const auto event = std::ranges::lower_bound(places_, place - kSame);
    const double earliest = event == places_.begin() ? place - motion_.count() : *std::prev(event);
    const double last = std::ceil(place - kSame) - 1.0;
    return from_samples(contact, std::max(std::ceil(earliest - kSame), last - kExtrapolatedFrom + 1.0), last,
                        place);
  }

  /// The same just after it: a sample at the event itself is right-sided.
  [[nodiscard]] std::optional<double> after(int contact, double place) const {
    const auto event = std::ranges::upper_bound(places_, place + kSame);
    const double latest = event == places_.end() ? place + motion_.count() : *event;
    const double first = std::ceil(place - kSame);
    return from_samples(contact, first,
                        std::min(std::ceil(latest - kSame) - 1.0, first + kExtrapolatedFrom - 1.0), place);
  }

 private:
  // Also a period earlier and later: neighbours across the period's ends.
  void add(double time) {
    for (const int turn : {-motion_.count(), 0, motion_.count()})
      places_.push_back(time / motion_.step() + turn);
  }

  static constexpr double kSame = 1e-6;  // steps within which two instants are one

  [[nodiscard]] std::optional<double> from_samples(int contact, double first, double last,
                                                   double place) const {
    if (last < first + 1.0) return std::nullopt;
    std::vector<double> speeds;
    for (double at = first; at <= last; at += 1.0) {
      const int index = static_cast<int>(at) % motion_.count();
      speeds.push_back(motion_.samples.velocity(index < 0 ? index + motion_.count() : index, contact));
    }
    return polynomial_at(speeds, first, place);
  }

  const Motion& motion_;
  std::vector<double> places_;  // of impulses and events [steps]
};

ContactPhase listed_impact(const Impulse& impulse, const SpeedsBeside& speeds) {
  return {.contact = impulse.contact,
          .begin = impulse.time,
          .end = impulse.time,
          .impulse = impulse.value,
          .listed = true,
          .speed_before = speeds.before,
          .speed_after = speeds.after};
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

std::vector<SpeedsBeside> speeds_beside_impulses(const Motion& motion) {
  if (!motion.speeds.empty()) return motion.speeds;
  std::vector<SpeedsBeside> speeds;
  const SampledSpeeds sampled(motion);
  for (const Impulse& impulse : motion.impulses) {
    const double place = impulse.time / motion.step();
    speeds.push_back({sampled.before(impulse.contact, place), sampled.after(impulse.contact, place)});
  }
  return speeds;
}

double time_resolution(const Motion& motion) {
  const std::optional<int> harmonics = resolved_harmonics(motion);
  return harmonics ? motion.period() / (2.0 * std::max(1, *harmonics)) : motion.step();
}

std::vector<ContactPhase> contact_phases(const Motion& motion) {
  std::vector<ContactPhase> phases;
  const std::vector<SpeedsBeside> speeds = speeds_beside_impulses(motion);
  for (std::size_t i = 0; i < speeds.size(); ++i)
    phases.push_back(listed_impact(motion.impulses[i], speeds[i]));
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
