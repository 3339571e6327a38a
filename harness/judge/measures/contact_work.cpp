#include "harness/judge/measures/contact_work.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>
#include <vector>

namespace signorini {

namespace {

/// Samples from which a speed is extrapolated: the error is of order step^6.
constexpr int kSamples = 6;

/// The polynomial through values at the places first, first + 1, ..., at `place` [steps].
double extrapolated(const std::vector<double>& values, double first, double place) {
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

/// Speeds beside the events of a motion.
class SpeedsBeside {
 public:
  explicit SpeedsBeside(const Motion& motion) : motion_(motion) {
    for (const ContactEvent& event : *motion.events) {
      // Also a period earlier and later: neighbours across the period's ends.
      for (const int turn : {-motion.count(), 0, motion.count()})
        places_.push_back(event.time / motion.step() + turn);
    }
    std::ranges::sort(places_);
  }

  /// x' of a contact just before a place [steps]; empty where no sample lies between it and the event before.
  [[nodiscard]] std::optional<double> before(int contact, double place) const {
    const auto event = std::ranges::lower_bound(places_, place - kSame);
    const double earliest = event == places_.begin() ? place - motion_.count() : *std::prev(event);
    const double last = std::ceil(place - kSame) - 1.0;
    return from_samples(contact, std::max(std::ceil(earliest - kSame), last - kSamples + 1.0), last, place);
  }

  /// The same just after it: a sample at the event itself is right-sided.
  [[nodiscard]] std::optional<double> after(int contact, double place) const {
    const auto event = std::ranges::upper_bound(places_, place + kSame);
    const double latest = event == places_.end() ? place + motion_.count() : *event;
    const double first = std::ceil(place - kSame);
    return from_samples(contact, first, std::min(std::ceil(latest - kSame) - 1.0, first + kSamples - 1.0),
                        place);
  }

 private:
  static constexpr double kSame = 1e-6;  // steps within which two instants are one

  [[nodiscard]] std::optional<double> from_samples(int contact, double first, double last,
                                                   double place) const {
    if (last < first) return std::nullopt;
    std::vector<double> speeds;
    for (double at = first; at <= last; at += 1.0) {
      const int index = static_cast<int>(at) % motion_.count();
      speeds.push_back(motion_.samples.velocity(index < 0 ? index + motion_.count() : index, contact));
    }
    return extrapolated(speeds, first, place);
  }

  const Motion& motion_;
  std::vector<double> places_;  // of events [steps]
};

/// (x'_- + x'_+) / 2 at an impulse; of one side where the other cannot be told, 0 where neither can.
double mean_speed(const SpeedsBeside& speeds, int contact, double place, double restitution) {
  const std::optional<double> before = speeds.before(contact, place), after = speeds.after(contact, place);
  if (before && after) return 0.5 * (*before + *after);
  if (before) return 0.5 * (1.0 - restitution) * *before;
  if (after && restitution > 0.0) return 0.5 * (1.0 - 1.0 / restitution) * *after;
  return 0.0;
}

}  // namespace

double contact_work(const Motion& motion, const RepresentedLaw& law, const Eigen::VectorXd& gaps) {
  Eigen::ArrayXXd force = motion.samples.force.array();
  if (const auto* penalty = std::get_if<Penalty>(&law)) {
    for (Eigen::Index c = 0; c < force.cols(); ++c)
      force.col(c) += penalty->stiffness[static_cast<std::size_t>(c)] *
                      (motion.samples.x.col(c).array() - gaps[c]).max(0.0);
  }
  double work = motion.step() * (force * motion.samples.velocity.array()).sum();
  const auto* restitution = std::get_if<Restitution>(&law);
  const SpeedsBeside speeds(motion);
  for (const Impulse& impulse : motion.impulses) {
    work += impulse.value * mean_speed(speeds, impulse.contact, impulse.time / motion.step(),
                                       restitution != nullptr ? restitution->e : 1.0);
  }
  return work;
}

}  // namespace signorini
