#include "harness/judge/certificate.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "harness/judge/measures/contact_agreement.hpp"
#include "harness/judge/orbit.hpp"
#include "methods/refinement.hpp"

namespace signorini {

namespace {

/// Orbits of certificates may be this uncertain; what is smaller than ten error bars is marked in tables.
constexpr double kLargestErrorBar = 1e-6;
// Amplitudes by which a motion may break the law of contact before it is none of the scene, whatever orbits
// are found.
constexpr double kDeepPenetration = 0.5;
constexpr double kFarFromLaw = 0.5;  // in the mean over time

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
    if (!found.motion) {
      add_reason(found.reason, nothing_found_);
      return false;
    }
    if (!(found.error_bar <= kLargestErrorBar)) {
      add_reason(fmt::format("the orbit that it leads to is known to {:.1e} only", found.error_bar),
                 nothing_found_);
      return false;
    }
    Motion orbit = sample_motion(problem_, *found.motion);
    const double apart = distance_from(orbit);
    std::optional<double>& nearest = result.certificate.distance;
    if (!nearest || apart < *nearest) nearest = apart;
    result.certificate.source = found.source;
    const ContactDifference contacts = contact_difference(problem_, motion_, orbit);
    const std::string name = fmt::format("the orbit that it leads to ({})", found.source);
    if (apart > kNearOrbit) {
      add_reason(fmt::format("{} is {:.2g} away", name, apart), refutation_);
    } else if (contacts.contradicts) {
      add_reason(fmt::format("{} is {:.2g} away: {}", name, apart, contacts.text), refutation_);
    } else if (apart > kOwnOrbit || !contacts.text.empty()) {
      const std::string why = apart > kOwnOrbit ? fmt::format("{} is asked for", kOwnOrbit) : contacts.text;
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

  /// Says why there is no certificate. An orbit near by, or a search without an end, speaks against calling
  /// the answer wrong.
  void give_up(Deadline deadline) {
    Certificate& certificate = result.certificate;
    certificate.expired = std::chrono::steady_clock::now() > deadline;
    if (near_.empty() && nothing_found_.empty()) certificate.refutation = refutation_;
    for (const std::string& reason : {near_, refutation_, nothing_found_}) {
      if (certificate.reason.empty()) certificate.reason = reason;
    }
  }

  CertifiedAnswer result;

 private:
  static void add_reason(const std::string& reason, std::string& reasons) {
    if (!reasons.empty()) reasons += "; ";
    reasons += reason;
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
    return attempts.take(find_orbit(same_order, tools.solver, shooting_options(),
                                    {.guess = answer, .deadline = deadline}, kLargestErrorBar));
  };
  if (!polished() && (attempts.near() || !shot())) attempts.give_up(deadline);
  return std::move(attempts.result);
}

void apply_verdict(Record& record) {
  if (record.status != Status::converged) return;
  const bool rigid = !record.law || !std::holds_alternative<Penalty>(*record.law);
  const Measure depth = record.physics.penetration, off = record.physics.complementarity;
  std::string objection = record.certificate.refutation;
  if (off && *off > kFarFromLaw)
    objection = fmt::format("is off the law of contact by {:.2g} amplitudes in the mean", *off);
  if (rigid && depth && *depth > kDeepPenetration)
    objection = fmt::format("penetrates the stop by {:.2g} amplitudes", *depth);
  if (objection.empty()) return;
  record.status = Status::inaccurate;
  record.message = record.message.empty() ? objection : objection + "; the method: " + record.message;
}

}  // namespace signorini
