#include "harness/judge/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/judge/measures/contact_agreement.hpp"
#include "harness/judge/measures/impacts.hpp"
#include "harness/judge/orbit.hpp"
#include "methods/discretisation/periodic_time.hpp"
#include "methods/refinement.hpp"

namespace signorini {

namespace {

// Orbits of certificates may be this uncertain; what is smaller than ten error bars is marked in tables.
constexpr double kLargestErrorBar = 1e-6;
// Amplitudes by which a motion may break the law of contact before it is none of the scene, whatever orbits
// are found.
constexpr double kFarFromLaw = 0.5;  // in the mean over time, and at the deepest
// Equation defects beyond which an answer from which no orbit is found is wrong: as far off as an orbit that
// is not near, and less where an orbit of the scene is known that is not near either.
constexpr double kOff = kNearOrbit, kOffFarFromKnown = 0.1;
// Instants of the period from which a motion is shot for, until one finds an orbit.
constexpr int kShootings = 4;
// Penetration counts so many times: a tenth of the amplitude is as much as half of the motion.
constexpr double kPenetrationWeight = 5.0;

/// The middle of the longest time in which no contact pushes: where a shooting begins, wherever the answer
/// does [s].
double quiet_instant(const Motion& motion) {
  const std::vector<ContactPhase> phases = contact_phases(motion);  // in order
  if (phases.empty()) return 0.0;
  double reached = 0.0;  // by the phases so far, those that go on at the beginning of the period included
  for (const ContactPhase& phase : phases) reached = std::max(reached, phase.end - motion.period());
  const double first = reached;
  double longest = -1.0, middle = 0.0;
  const auto look = [&](double from, double to) {
    if (to - from <= longest) return;
    longest = to - from;
    middle = 0.5 * (from + to);
  };
  std::optional<double> opening;  // of the first phase
  for (const ContactPhase& phase : phases) {
    if (opening) look(reached, phase.begin);
    if (!opening) opening = std::max(first, phase.begin);
    reached = std::max(reached, phase.end);
  }
  look(reached, *opening + motion.period());
  return wrapped_time(middle, motion.period());
}

/// The attempts to certify one answer, each true where it succeeds.
class Attempts {
 public:
  Attempts(const Problem& problem, const Motion& motion, const Reference& reference)
      : problem_(problem), motion_(motion), reference_(reference) {
    Certificate& certificate = result.certificate;
    certificate.status = CertificateStatus::uncertified;
    certificate.rule = kCertificateRule;
    if (reference.orbit) {
      from_rest_ = sample_motion(problem, *reference.orbit);
      certificate.reference = reference.fingerprint;
    } else {
      certificate.reference_reason = reference.reason;
    }
  }

  /// By an orbit found from the answer, at the answer's own phase.
  bool take(const CertifiedOrbit& found) {
    if (!found.motion) return set_aside(found.unconfirmed.get(), found.reason);
    if (!(found.error_bar <= kLargestErrorBar)) {
      return set_aside(found.motion.get(),
                       fmt::format("the orbit that it leads to is known to {:.1e} only", found.error_bar));
    }
    Motion orbit = sample_motion(problem_, *found.motion);
    const double apart = distance_from(orbit);
    take_distance(apart);
    result.certificate.source = found.source;
    const ContactDifference contacts = contact_difference(problem_, motion_, orbit);
    const std::string name = fmt::format("the orbit that it leads to ({})", found.source);
    if (apart > kNearOrbit) {
      add_reason(fmt::format("{} is {:.2g} away", name, apart), refutation_);
    } else if (contacts.contradicts) {
      add_reason(fmt::format("{} is {:.2g} away: {}", name, apart, contacts.text), refutation_);
    } else if (apart > kOwnOrbit || !contacts.text.empty()) {
      const std::string why = apart > kOwnOrbit ? fmt::format("the limit is {}", kOwnOrbit) : contacts.text;
      near_ = fmt::format("near {}, {:.2g} away: {}", name, apart, why);
      result.orbit = std::move(orbit);
    } else {
      accept(std::move(orbit), found);
      return true;
    }
    return false;
  }

  /// Whether an orbit was found near the answer that is not its own: another way leads there too.
  [[nodiscard]] bool near() const { return !near_.empty(); }

  /// Says why there is no certificate. What is near, an orbit or what may be one, speaks against calling the
  /// answer wrong; the orbits found, all far away, speak for it; where none was found, the answer itself.
  void give_up(Deadline deadline, KeptSpace& spaces) {
    Certificate& certificate = result.certificate;
    certificate.expired = deadline.passed();
    if (near_.empty() && !may_be_near_) {
      if (refutation_.empty() && !certificate.distance) refutation_ = own_defect(spaces);
      certificate.refutation = refutation_;
    }
    for (const std::string& reason : {near_, certificate.refutation, nothing_found_, refutation_}) {
      if (certificate.reason.empty()) certificate.reason = reason;
    }
  }

  CertifiedAnswer result;

 private:
  static void add_reason(const std::string& reason, std::string& reasons) {
    if (reasons.find(reason) != std::string::npos) return;  // both ways were out of time
    if (!reasons.empty()) reasons += "; ";
    reasons += reason;
  }

  void take_distance(double apart) {
    std::optional<double>& nearest = result.certificate.distance;
    if (!nearest || apart < *nearest) nearest = apart;
  }

  /// What is no orbit for a reason, and may yet be one near the answer. \return false
  bool set_aside(const Trajectory* candidate, const std::string& reason) {
    if (candidate != nullptr) {
      const double apart = distance_from(sample_motion(problem_, *candidate));
      if (apart <= kNearOrbit) {
        may_be_near_ = true;
        take_distance(apart);
      }
      add_reason(fmt::format("{}, {:.2g} away", reason, apart), nothing_found_);
    } else {
      add_reason(reason, nothing_found_);
    }
    return false;
  }

  /// By how much the answer is off the equations of its scene, where that is too much for an answer near an
  /// orbit; else empty.
  [[nodiscard]] std::string own_defect(KeptSpace& spaces) const {
    std::optional<double> known_apart;
    if (from_rest_) known_apart = distance(motion_, *from_rest_, best_shift(motion_, *from_rest_)).x_l2;
    if (known_apart && *known_apart <= kNearOrbit) return {};  // though it does not lead there
    const double allowed = known_apart ? kOffFarFromKnown : kOff;
    const EquationDefect off = equation_defect(problem_, motion_, spaces);
    const std::string known =
        known_apart ? fmt::format(", and {:.2g} from the motion reached from rest", *known_apart) : "";
    if (off.motion > allowed) {
      return fmt::format(
          "no orbit is found from it, and it is {:.2g} of its size away from the response to its "
          "own contact force{}",
          off.motion, known);
    }
    if (kPenetrationWeight * off.penetration > allowed) {
      return fmt::format(
          "no orbit is found from it, and it passes the stop by {:.2g} amplitudes more than its "
          "resolution explains{}",
          off.penetration, known);
    }
    return {};
  }

  [[nodiscard]] double distance_from(const Motion& orbit) const {
    // No unit: the contacts rest where they are, or there are none, and so does the answer or it is off.
    const bool rests = motion_.samples.x.size() == 0 || motion_.samples.x.cwiseAbs().maxCoeff() == 0.0;
    return distance(motion_, orbit).x_l2.value_or(rests ? 0.0 : 1.0);
  }

  void accept(Motion orbit, const CertifiedOrbit& known) {
    Certificate& certificate = result.certificate;
    certificate.status = CertificateStatus::certified;
    certificate.error_bar = known.error_bar;
    certificate.residual = known.residual;
    certificate.order = least_order(orbit);
    certificate.events = known.events.empty() ? orbit_events(orbit) : known.events;
    certificate.return_distance = known.return_distance;
    certificate.floquet = known.floquet;
    certificate.stable = known.stable;
    certificate.stability = known.stability;
    certificate.undefined = known.undefined;
    certificate.orders = known.orders;
    certificate.orbit = fingerprint(orbit);
    if (from_rest_) {
      certificate.same_orbit = same_orbit(orbit, *from_rest_);
      // Two computations of one orbit may round its fingerprint differently.
      if (*certificate.same_orbit) certificate.orbit = reference_.fingerprint;
    }
    result.orbit = std::move(orbit);
  }

  const Problem& problem_;
  const Motion& motion_;
  const Reference& reference_;
  std::optional<Motion> from_rest_;
  std::string near_, refutation_, nothing_found_;  // reasons
  bool may_be_near_ = false;                       // what is no confirmed orbit
};

}  // namespace

CertifiedAnswer certify(const Problem& problem, std::shared_ptr<const Trajectory> answer,
                        const Motion& motion, const Reference& reference, const OrbitTools& tools,
                        Deadline deadline) {
  Attempts attempts(problem, motion, reference);
  const Problem same_order = with_subharmonic(problem, motion.order);
  const auto polished = [&] {
    return tools.polish && attempts.take(tools.polish(same_order, *answer, reference.confirmed, deadline));
  };
  const auto shot = [&] {
    PeriodicMotionOptions options = shooting_options();
    CertifiedOrbit orbit;
    for (int k = 0; k < kShootings && !orbit.motion; ++k) {
      options.begin = wrapped_time(quiet_instant(motion) + k * motion.period() / kShootings, motion.period());
      orbit = find_orbit(same_order, tools.solver, options, {.guess = answer, .deadline = deadline},
                         kLargestErrorBar);
      if (deadline.passed()) break;
    }
    return attempts.take(orbit);
  };
  if (!polished() && (attempts.near() || !shot())) attempts.give_up(deadline, *tools.spaces);
  return std::move(attempts.result);
}

void apply_verdict(Record& record) {
  if (record.status != Status::converged) return;
  const bool rigid = !record.law || !std::holds_alternative<Penalty>(*record.law);
  const Measure depth = record.physics.penetration, off = record.physics.complementarity;
  std::string objection = record.certificate.refutation;
  if (off && *off > kFarFromLaw)
    objection = fmt::format("is off the law of contact by {:.2g} amplitudes in the mean", *off);
  if (rigid && depth && *depth > kFarFromLaw)
    objection = fmt::format("penetrates the stop by {:.2g} amplitudes", *depth);
  if (objection.empty()) return;
  record.status = Status::inaccurate;
  record.message = record.message.empty() ? objection : objection + "; the method: " + record.message;
}

}  // namespace signorini
