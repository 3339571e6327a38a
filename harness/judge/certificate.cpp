#include "harness/judge/certificate.hpp"

#include <fmt/format.h>

#include "harness/judge/orbit.hpp"

namespace signorini {

namespace {

/// Orbits of certificates may be this uncertain; what is smaller than ten error bars is marked in tables.
constexpr double kLargestErrorBar = 1e-6;
constexpr double kDeepPenetration = 0.5;

/// A candidate for the orbit behind an answer, and how far away it is.
struct Candidate {
  Motion motion;
  int shift = 0;
  double distance = 0.0;
};

Candidate place(const Motion& answer, Motion orbit, bool may_shift) {
  Candidate candidate{.motion = std::move(orbit)};
  if (may_shift) candidate.shift = best_shift(answer, candidate.motion);
  // No norm: the contacts rest where they are, or there are none, and so does the answer or it is off.
  const double otherwise =
      answer.samples.x.size() == 0 || answer.samples.x.cwiseAbs().maxCoeff() == 0.0 ? 0.0 : 1.0;
  candidate.distance = distance(answer, candidate.motion, candidate.shift).x_l2.value_or(otherwise);
  return candidate;
}

/// `of` is the certificate of the candidate: for the reference what is known of it.
void describe_orbit(const Candidate& candidate, const CheckedOrbit& of, const Reference& reference,
                    const Motion* reference_motion, Certificate& certificate) {
  certificate.status = CertificateStatus::certified;
  certificate.reason.clear();
  certificate.source = of.source;
  certificate.error_bar = of.error_bar;
  certificate.residual = of.residual;
  certificate.order = least_order(candidate.motion);
  certificate.events = of.events.empty() ? orbit_events(candidate.motion) : of.events;
  certificate.return_distance = of.return_distance;
  certificate.floquet = of.floquet;
  certificate.stable = of.stable;
  certificate.orbit = fingerprint(candidate.motion);
  if (reference_motion == nullptr) return;
  certificate.same_orbit = same_orbit(candidate.motion, *reference_motion);
  if (*certificate.same_orbit) certificate.orbit = reference.fingerprint;
}

/// Tries one way to an orbit; true if it certifies the answer.
bool take(const Problem& problem, const Motion& answer, const CheckedOrbit& found, const Reference& reference,
          const Motion* known, Judgement& judgement) {
  Certificate& certificate = judgement.certificate;
  if (!found.orbit) {
    if (!certificate.reason.empty()) certificate.reason += "; ";
    certificate.reason += found.reason;
    return false;
  }
  if (!(found.error_bar <= kLargestErrorBar)) {
    if (!certificate.reason.empty()) certificate.reason += "; ";
    certificate.reason += fmt::format("the orbit that it leads to is known to {:.1e} only", found.error_bar);
    return false;
  }
  Candidate candidate = place(answer, sample_motion(problem, *found.orbit), false);
  if (!certificate.distance || candidate.distance < *certificate.distance)
    certificate.distance = candidate.distance;
  certificate.source = found.source;
  if (candidate.distance > kNearOrbit) {
    certificate.reason =
        fmt::format("the orbit that it leads to ({}) is {:.2g} away", found.source, candidate.distance);
    return false;
  }
  describe_orbit(candidate, found, reference, known, certificate);
  judgement.orbit = std::move(candidate.motion);
  return true;
}

}  // namespace

Judgement certify(const Problem& problem, std::shared_ptr<const Trajectory> answer, const Motion& motion,
                  const Reference& reference, const OrbitTools& tools,
                  std::chrono::steady_clock::time_point deadline) {
  Judgement judgement;
  Certificate& certificate = judgement.certificate;
  certificate.status = CertificateStatus::uncertified;
  std::optional<Motion> reference_motion;
  if (reference.orbit) {
    reference_motion = sample_motion(problem, *reference.orbit);
    certificate.reference = reference.fingerprint;
  } else {
    certificate.reference_reason = reference.reason;
  }
  const Motion* known = reference_motion ? &*reference_motion : nullptr;

  const Problem same_order = with_subharmonic(problem, motion.order);
  if (tools.polish && take(problem, motion,
                           tools.polish({.problem = same_order,
                                         .answer = *answer,
                                         .confirmed = reference.confirmed,
                                         .deadline = deadline}),
                           reference, known, judgement)) {
    return judgement;
  }
  const CheckedOrbit shot = find_orbit(
      same_order, tools.solver,
      {.tolerance = kOrbitTolerance, .shooting = true, .guess = std::move(answer), .deadline = deadline},
      kLargestErrorBar);
  if (take(problem, motion, shot, reference, known, judgement)) return judgement;
  if (known == nullptr) return judgement;
  Candidate candidate = place(motion, *reference_motion, true);
  if (!certificate.distance || candidate.distance < *certificate.distance)
    certificate.distance = candidate.distance;
  if (candidate.distance > kNearOrbit) return judgement;
  const CheckedOrbit from_rest{.error_bar = reference.error_bar,
                               .residual = reference.residual,
                               .source = "the motion reached from rest"};
  describe_orbit(candidate, from_rest, reference, known, certificate);
  judgement.orbit = std::move(candidate.motion);
  judgement.shift = candidate.shift;
  return judgement;
}

void apply_verdict(Record& record) {
  if (record.status != Status::converged) return;
  const bool rigid = !record.law || !std::holds_alternative<Penalty>(*record.law);
  const Measure depth = record.physics.penetration;
  const Certificate& certificate = record.certificate;
  std::string objection;
  if (rigid && depth && *depth > kDeepPenetration) {
    objection = fmt::format("penetrates the stop by {:.2g} amplitudes", *depth);
  } else if (certificate.status == CertificateStatus::uncertified && !certificate.source.empty()) {
    objection = fmt::format("no orbit within {} of it: {}", kNearOrbit, certificate.reason);
  }
  if (objection.empty()) return;
  record.status = Status::inaccurate;
  record.message = record.message.empty() ? objection : objection + "; the method: " + record.message;
}

}  // namespace signorini
