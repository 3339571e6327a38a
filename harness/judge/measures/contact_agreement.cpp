#include "harness/judge/measures/contact_agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <vector>

#include "harness/judge/measures/impacts.hpp"

namespace signorini {

namespace {

constexpr double kTouching = 1e-6;      // of the unit of impulse
constexpr double kHitting = 1e-3;       // of the unit of impulse
constexpr double kClear = 1e-2;         // of the largest impulse of a contact
constexpr double kFactor = 2.0;         // of total impulses
constexpr double kStrongPhase = 0.25;   // of the largest impulse of a phase of its contact
constexpr double kWeakPhase = 0.05;     // of the same
constexpr double kShownApart = 6.0;     // resolutions in time: a coarse answer is late by two or three
constexpr double kLongestApart = 0.15;  // of the forcing period
constexpr double kLate = 0.05;          // of the forcing period, what an x within 10 % may be late by

/// Impulses of one motion per forcing period, and where they count as contact.
struct Touches {
  Touches(const Motion& motion, const Eigen::VectorXd& unit)
      : impulse(-impulse_per_forcing_period(motion)),
        relative(impulse.cwiseQuotient(unit)),
        largest(impulse.cwiseAbs().maxCoeff()) {}

  [[nodiscard]] bool touching(Eigen::Index c) const { return relative[c] > kTouching; }
  [[nodiscard]] bool clearly(Eigen::Index c) const { return touching(c) && impulse[c] > kClear * largest; }
  [[nodiscard]] bool none() const { return relative.maxCoeff() <= kTouching; }
  [[nodiscard]] bool hits() const { return relative.maxCoeff() > kHitting; }

  Eigen::VectorXd impulse;   // pressure is positive [N s]
  Eigen::VectorXd relative;  // to the unit [-]
  double largest;
};

/// A push of one contact, or several that the coarser of two motions shows as one.
struct Push {
  double begin = 0.0, end = 0.0;  // [s]
  double impulse = 0.0;           // |J| [N s]
};

/// The pushes of one contact over so many periods of its motion, those closer than `apart` [s] as one.
std::vector<Push> pushes_shown(const Motion& motion, int contact, double apart, int periods) {
  std::vector<Push> shown;
  for (const ContactPhase& phase : contact_phases(motion)) {
    if (phase.contact != contact) continue;
    if (!shown.empty() && phase.begin - shown.back().end < apart) {
      shown.back().impulse += std::abs(phase.impulse);
      shown.back().end = std::max(shown.back().end, phase.end);
    } else {
      shown.push_back({phase.begin, phase.end, std::abs(phase.impulse)});
    }
  }
  // The last one may go on at the beginning of the period.
  if (shown.size() > 1 && shown.front().begin + motion.period() - shown.back().end < apart) {
    shown.front().impulse += shown.back().impulse;
    shown.front().begin = shown.back().begin - motion.period();
    shown.pop_back();
  }
  const std::vector<Push> once = shown;
  for (int k = 1; k < periods; ++k) {
    for (const Push& push : once)
      shown.push_back({push.begin + k * motion.period(), push.end + k * motion.period(), push.impulse});
  }
  return shown;
}

/// The pushes with at least a share of the largest one's impulse.
std::vector<Push> above(const std::vector<Push>& pushes, double share) {
  double largest = 0.0;
  for (const Push& push : pushes) largest = std::max(largest, push.impulse);
  std::vector<Push> strong;
  std::ranges::copy_if(pushes, std::back_inserter(strong),
                       [&](const Push& push) { return push.impulse >= share * largest; });
  return strong;
}

/// Whether each push has one of the others at most `late` [s] before or after it, cyclically.
bool all_met(const std::vector<Push>& pushes, const std::vector<Push>& others, double late, double period) {
  return std::ranges::all_of(pushes, [&](const Push& push) {
    return std::ranges::any_of(others, [&](const Push& other) {
      const double centres = 0.5 * (push.begin + push.end - other.begin - other.end);
      const double lengths = 0.5 * (push.end - push.begin + other.end - other.begin);
      return std::abs(std::remainder(centres, period)) - lengths <= late;
    });
  });
}

std::string phase_difference(const Motion& answer, const Motion& orbit, int contact) {
  const double apart = std::min(kShownApart * std::max(time_resolution(answer), time_resolution(orbit)),
                                kLongestApart * orbit.forcing_period);
  const int common = std::lcm(answer.order, orbit.order);
  const std::vector<Push> found = pushes_shown(answer, contact, apart, common / answer.order);
  const std::vector<Push> exact = pushes_shown(orbit, contact, apart, common / orbit.order);
  const std::vector<Push> found_weak = above(found, kWeakPhase), exact_weak = above(exact, kWeakPhase);
  const std::vector<Push> found_strong = above(found, kStrongPhase),
                          exact_strong = above(exact, kStrongPhase);
  if (found_strong.size() > exact_weak.size() || exact_strong.size() > found_weak.size())
    return fmt::format("contact {} pushes {} times in {} forcing periods, on the orbit {} times", contact,
                       found_weak.size(), common, exact_weak.size());
  const double late = std::max(apart, kLate * orbit.forcing_period);
  const double period = common * orbit.forcing_period;
  if (all_met(found_strong, exact_weak, late, period) && all_met(exact_strong, found_weak, late, period))
    return {};
  return fmt::format("contact {} pushes at other times than on the orbit", contact);
}

}  // namespace

ContactDifference contact_difference(const Problem& problem, const Motion& answer, const Motion& orbit) {
  const Eigen::Index contacts = answer.samples.x.cols();
  if (contacts == 0) return {};
  const double size = std::max(amplitude(orbit), answer.least);
  const Eigen::VectorXd unit = contact_stiffness_scale(problem) * (size * answer.forcing_period);
  if (!(unit.minCoeff() > 0.0)) return {};  // nothing moves, and nothing may
  const Touches found(answer, unit), exact(orbit, unit);
  if (found.none() && exact.none()) return {};
  if (found.none() && exact.hits())
    return {.text = "it has no contact force, and the orbit has", .contradicts = true};
  if (exact.none() && found.hits())
    return {.text = "it has a contact force, and the orbit has none", .contradicts = true};
  for (Eigen::Index c = 0; c < contacts; ++c) {
    if ((found.clearly(c) && !exact.touching(c)) || (exact.clearly(c) && !found.touching(c)))
      return {.text = fmt::format("contact {} touches on {} only", c, found.clearly(c) ? "it" : "the orbit")};
  }
  for (Eigen::Index c = 0; c < contacts; ++c) {
    if (!exact.clearly(c)) continue;
    const double ratio = found.impulse[c] / exact.impulse[c];
    if (!(ratio <= kFactor && ratio >= 1.0 / kFactor))
      return {.text = fmt::format("the impulse of contact {} is {:.2g} times the orbit's", c, ratio)};
  }
  for (int c = 0; c < static_cast<int>(contacts); ++c) {
    if (!found.clearly(c) && !exact.clearly(c)) continue;
    if (const std::string text = phase_difference(answer, orbit, c); !text.empty()) return {.text = text};
  }
  return {};
}

}  // namespace signorini
