#include "harness/judge/measures/contact_agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <variant>
#include <vector>

#include "harness/judge/measures/force_error.hpp"
#include "harness/judge/measures/impacts.hpp"

namespace signorini {

namespace {

constexpr double kTouching = 1e-6;  // of the unit of impulse
constexpr double kHitting = 1e-3;   // of the unit of impulse
constexpr double kClear = 1e-2;     // of the largest impulse of a contact
constexpr double kOwnShare = 0.5;   // of its own motion, sharp force or impulse that a contact may be off
constexpr double kOwnForce = 0.06;  // ForceErrors::worst of an exact x
constexpr double kForcePerMotion = 4.0;      // more of it per error of x
constexpr double kMostForce = 0.15;          // of it in all
constexpr double kForceOfOne = 0.4;          // error of the force of a contact, of its own size
constexpr double kOpen = 2.0;                // forcing periods per error of x that forces may be apart
constexpr double kLeastShown = 1.0 / 256.0;  // forcing periods that forces may be apart in their instants
constexpr double kRestitution = 0.1;         // of a coefficient of restitution
constexpr double kStrongPhase = 0.25;        // of the largest impulse of a phase of its contact
constexpr double kWeakPhase = 0.05;          // of the same
constexpr double kFaintPhase = 0.01;         // of the same
constexpr double kShownApart = 6.0;          // resolutions in time: a coarse answer is late by two or three
constexpr double kLongestApart = 0.15;       // of the forcing period
constexpr double kLate = 0.05;               // of the forcing period, what an x within 10 % may be late by

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

/// The pushes of one contact over so many periods of its motion, those closer than `apart` [s] as one. Other
/// than those of `short_pushes` they have |J| >= 0 as impulse, and may begin outside of the period.
std::vector<ListedPush> pushes_shown(const Motion& motion, int contact, double apart, int periods) {
  std::vector<ListedPush> shown;
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
  const std::vector<ListedPush> once = shown;
  for (int k = 1; k < periods; ++k) {
    for (const ListedPush& push : once)
      shown.push_back({push.begin + k * motion.period(), push.end + k * motion.period(), push.impulse});
  }
  return shown;
}

/// The pushes with at least a share of the largest one's impulse.
std::vector<ListedPush> above(const std::vector<ListedPush>& pushes, double share) {
  double largest = 0.0;
  for (const ListedPush& push : pushes) largest = std::max(largest, push.impulse);
  std::vector<ListedPush> strong;
  std::ranges::copy_if(pushes, std::back_inserter(strong),
                       [&](const ListedPush& push) { return push.impulse >= share * largest; });
  return strong;
}

/// Whether the others push at most `late` [s] before or after each push, cyclically, and there with half of
/// its impulse, `spared` [N s] aside.
bool all_met(const std::vector<ListedPush>& pushes, const std::vector<ListedPush>& others, double late,
             double period, double spared) {
  return std::ranges::all_of(pushes, [&](const ListedPush& push) {
    bool any = false;
    double impulse = spared;
    for (const ListedPush& other : others) {
      const double centres = 0.5 * (push.begin + push.end - other.begin - other.end);
      const double lengths = 0.5 * (push.end - push.begin + other.end - other.begin);
      if (std::abs(std::remainder(centres, period)) - lengths > late) continue;
      any = true;
      impulse += other.impulse;
    }
    return any && impulse >= kOwnShare * push.impulse;
  });
}

/// How far apart pushes are that the coarser of two motions tells from one [s].
double shown_apart(const Motion& answer, const Motion& orbit) {
  return std::min(kShownApart * std::max(time_resolution(answer), time_resolution(orbit)),
                  kLongestApart * orbit.forcing_period);
}

/// The longest time without a push of a contact, before any are taken for one; 0 where there is none [s].
double longest_break(const Motion& motion, int contact) {
  double longest = 0.0, first = 0.0, last = 0.0;
  bool any = false;
  for (const ContactPhase& phase : contact_phases(motion)) {
    if (phase.contact != contact) continue;
    if (!any) first = phase.begin;
    if (any) longest = std::max(longest, phase.begin - last);
    last = std::max(last, phase.end);
    any = true;
  }
  longest = any ? std::max(longest, first + motion.period() - last) : motion.period();
  return longest > 0.5 * motion.step() ? longest : 0.0;
}

std::string phase_difference(const Motion& answer, const Motion& orbit, int contact, double moved) {
  const double apart = shown_apart(answer, orbit);
  const double open = longest_break(answer, contact), exact_open = longest_break(orbit, contact);
  if ((open == 0.0 && exact_open > apart) || (exact_open == 0.0 && open > apart))
    return fmt::format("contact {} opens on {} only", contact, open == 0.0 ? "the orbit" : "it");
  const int common = std::lcm(answer.order, orbit.order);
  const std::vector<ListedPush> found = pushes_shown(answer, contact, apart, common / answer.order);
  const std::vector<ListedPush> exact = pushes_shown(orbit, contact, apart, common / orbit.order);
  const std::vector<ListedPush> found_weak = above(found, kWeakPhase), exact_weak = above(exact, kWeakPhase);
  const std::vector<ListedPush> found_strong = above(found, kStrongPhase),
                                exact_strong = above(exact, kStrongPhase);
  if (found_strong.size() > exact_weak.size() || exact_strong.size() > found_weak.size())
    return fmt::format("contact {} pushes {} times in {} forcing periods, on the orbit {} times", contact,
                       found_weak.size(), common, exact_weak.size());
  const double late = std::max(apart, kLate * orbit.forcing_period);
  const double period = common * orbit.forcing_period;
  const double anything = std::numeric_limits<double>::infinity();
  if (!all_met(found_strong, exact_weak, late, period, anything) ||
      !all_met(exact_strong, found_weak, late, period, anything))
    return fmt::format("contact {} pushes at other times than on the orbit", contact);
  // The instant of a weak push is the less certain, the slower the contact comes.
  const double latest = kLongestApart * orbit.forcing_period;
  double largest = 0.0;  // of any contact: the error of x is one of all
  for (const ContactPhase& phase : contact_phases(orbit))
    largest = std::max(largest, std::abs(phase.impulse));
  const double spared = kForcePerMotion * moved * largest;
  if (!all_met(above(found, kOwnForce), above(exact, kFaintPhase), latest, period, spared) ||
      !all_met(above(exact, kOwnForce), above(found, kFaintPhase), latest, period, spared))
    return fmt::format("contact {} has a weak push that is none of the orbit's, or misses one", contact);
  return {};
}

/// How the forces differ beyond what is allowed where x is off by `moved`; empty where they do not.
std::string force_difference(const Motion& answer, const Motion& orbit, const Touches& exact, double moved) {
  const ForceErrors errors = force_errors(answer, orbit);
  for (Eigen::Index c = 0; c < std::ssize(errors.error); ++c) {
    const auto at = static_cast<std::size_t>(c);
    if (exact.clearly(c) && errors.error[at] > kForceOfOne * errors.size[at])
      return fmt::format("the force of contact {} is off by {:.2g} of its own", c,
                         errors.error[at] / errors.size[at]);
  }
  const double worst = errors.worst().value_or(0.0);
  if (worst > std::min(kMostForce, kOwnForce + kForcePerMotion * moved))
    return fmt::format("the contact force, its instants included, is off by {:.2g}", worst);
  // What the resolution, or an error of x, leaves open is no difference: a force that makes x wrong by a
  // share of it is late by a third of as many periods.
  const double off = std::max(kOpen * moved, kLeastShown);
  double coarse = shown_apart(answer, orbit);
  if (const std::optional<int> told = harmonics_of_force(answer))  // though it may call itself coarser
    coarse = std::min(coarse, 0.5 * answer.period() / std::max(1, *told));
  const double open = std::max(coarse, off * orbit.forcing_period);
  const Measure sharp = force_error_up_to(std::max(1.0, 0.5 * orbit.forcing_period / open), answer, orbit);
  if (sharp && *sharp > kOwnShare)
    return fmt::format("the contact force is off by {:.2g} at instants that it shows", *sharp);
  return {};
}

/// -x'_+ / x'_- of the strong impacts that a motion lists, their speeds weighted by the impulses and
/// extrapolated from samples `offset` and twice as many steps away; empty where they do not approach.
std::optional<double> listed_restitution(const Motion& motion, int offset, std::optional<int> contact) {
  const int count = motion.count();
  const auto velocity = [&](const Impulse& impulse, int steps) {
    const double place = impulse.time / motion.step();
    const int at = static_cast<int>(steps < 0 ? std::ceil(place) : std::floor(place)) + steps;
    return motion.samples.velocity(((at % count) + count) % count, impulse.contact);
  };
  double largest = 0.0, before = 0.0, after = 0.0;
  for (const Impulse& impulse : motion.impulses) largest = std::max(largest, std::abs(impulse.value));
  for (const Impulse& impulse : motion.impulses) {
    if (contact && impulse.contact != *contact) continue;
    const double weight = std::abs(impulse.value);
    if (weight < kStrongPhase * largest) continue;
    before += weight * (2.0 * velocity(impulse, -offset) - velocity(impulse, -2 * offset));
    after += weight * (2.0 * velocity(impulse, offset) - velocity(impulse, 2 * offset));
  }
  return before > 0.0 ? std::optional(-after / before) : std::nullopt;
}

/// Whether the strong impacts of an answer show another coefficient of restitution than the law has, at every
/// distance from them at which samples tell the speeds: near by those of few instants do not, far away those
/// of stiff structures, and none where impacts follow each other too soon, as samples of the orbit show. Of
/// one contact, or of all together.
std::string restitution_difference(const Motion& answer, const Motion& orbit, double restitution,
                                   std::optional<int> contact = {}) {
  constexpr std::array kOffsets{1, 4, 16, 64};  // steps
  std::optional<double> nearest;
  for (const int offset : kOffsets) {
    const std::optional<double> exact = listed_restitution(orbit, offset, contact);
    if (!exact || std::abs(*exact - restitution) > 0.5 * kRestitution) continue;
    const std::optional<double> found = listed_restitution(answer, offset, contact);
    if (found && (!nearest || std::abs(*found - restitution) < std::abs(*nearest - restitution)))
      nearest = found;
  }
  if (!nearest || std::abs(*nearest - restitution) <= kRestitution) return {};
  return fmt::format("its impacts have a restitution of {:.2g}, where the law has {:.2g}", *nearest,
                     restitution);
}

}  // namespace

ContactDifference contact_difference(const Problem& problem, const Motion& answer, const Motion& orbit) {
  const Eigen::Index contacts = answer.samples.x.cols();
  if (contacts == 0) return {};
  const double size = std::max(amplitude(orbit), answer.least);
  const Eigen::VectorXd unit = contact_stiffness_scale(problem) * (size * answer.forcing_period);
  if (!(unit.minCoeff() > 0.0)) return {};  // nothing moves, and nothing may
  const Touches found(answer, unit), exact(orbit, unit);
  if (found.none() && exact.hits())
    return {.text = "it has no contact force, and the orbit has", .contradicts = true};
  if (exact.none() && found.hits())
    return {.text = "it has a contact force, and the orbit has none", .contradicts = true};
  const Distance apart = distance(answer, orbit);
  if (apart.x_worst.value_or(0.0) > kOwnShare) {
    return {.text = fmt::format("one of its contacts is off by {:.2g} of that contact's own motion",
                                *apart.x_worst)};
  }
  if (found.none() && exact.none()) return {};
  for (Eigen::Index c = 0; c < contacts; ++c) {
    if ((found.clearly(c) && !exact.touching(c)) || (exact.clearly(c) && !found.touching(c)))
      return {.text = fmt::format("contact {} touches on {} only", c, found.clearly(c) ? "it" : "the orbit")};
  }
  for (int c = 0; c < static_cast<int>(contacts); ++c) {
    if (!found.clearly(c) && !exact.clearly(c)) continue;
    if (const std::string text = phase_difference(answer, orbit, c, apart.x_l2.value_or(0.0)); !text.empty())
      return {.text = text};
  }
  if (const std::string text = force_difference(answer, orbit, exact, apart.x_l2.value_or(0.0));
      !text.empty())
    return {.text = text};
  const Law scene_law = problem.law();
  if (std::holds_alternative<MixedLaws>(scene_law)) {
    for (int c = 0; c < static_cast<int>(contacts); ++c) {
      const auto* own = std::get_if<Restitution>(&problem.contacts[static_cast<std::size_t>(c)].law);
      if (own == nullptr) continue;
      if (const std::string text = restitution_difference(answer, orbit, own->e, c); !text.empty())
        return {.text = text};
    }
    return {};
  }
  const auto* restitution = std::get_if<Restitution>(&scene_law);
  return {.text =
              restitution == nullptr ? std::string() : restitution_difference(answer, orbit, restitution->e)};
}

}  // namespace signorini
