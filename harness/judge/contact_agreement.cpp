#include "harness/judge/contact_agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "harness/judge/impacts.hpp"

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

/// |J| of the phases of one contact over a period, those closer than `apart` [s] as one.
std::vector<double> phases_shown(const Motion& motion, int contact, double apart) {
  std::vector<double> shown;
  double first = 0.0, last = 0.0;
  for (const ContactPhase& phase : contact_phases(motion)) {
    if (phase.contact != contact) continue;
    if (shown.empty()) first = phase.begin;
    if (!shown.empty() && phase.begin - last < apart) {
      shown.back() += std::abs(phase.impulse);
    } else {
      shown.push_back(std::abs(phase.impulse));
    }
    last = std::max(last, phase.end);
  }
  // The last one may go on at the beginning of the period.
  if (shown.size() > 1 && first + motion.period() - last < apart) {
    shown.front() += shown.back();
    shown.pop_back();
  }
  return shown;
}

/// How many phases have at least a share of the largest one's impulse.
long count_above(const std::vector<double>& phases, double share) {
  if (phases.empty()) return 0;
  const double least = share * *std::max_element(phases.begin(), phases.end());
  return std::count_if(phases.begin(), phases.end(), [&](double impulse) { return impulse >= least; });
}

std::string phase_difference(const Motion& answer, const Motion& orbit, int contact) {
  const double apart = std::min(kShownApart * std::max(time_resolution(answer), time_resolution(orbit)),
                                kLongestApart * orbit.forcing_period);
  const std::vector<double> found = phases_shown(answer, contact, apart);
  const std::vector<double> exact = phases_shown(orbit, contact, apart);
  // Both over the common period.
  const int common = std::lcm(answer.order, orbit.order);
  const long found_copies = common / answer.order, exact_copies = common / orbit.order;
  if (found_copies * count_above(found, kStrongPhase) <= exact_copies * count_above(exact, kWeakPhase) &&
      exact_copies * count_above(exact, kStrongPhase) <= found_copies * count_above(found, kWeakPhase))
    return {};
  return fmt::format("contact {} pushes {} times in {} forcing periods, on the orbit {} times", contact,
                     found_copies * count_above(found, kWeakPhase), common,
                     exact_copies * count_above(exact, kWeakPhase));
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
