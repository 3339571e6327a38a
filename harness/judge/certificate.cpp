#include "harness/judge/certificate.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "harness/judge/orbit.hpp"
#include "methods/refinement.hpp"

namespace signorini {

namespace {

/// Orbits of certificates may be this uncertain; what is smaller than ten error bars is marked in tables.
constexpr double kLargestErrorBar = 1e-6;
constexpr double kDeepPenetration = 0.5;

/// An orbit shifted to where it is nearest to an answer.
struct PlacedOrbit {
  Motion motion;
  int shift = 0;          ///< [forcing periods]
  double distance = 0.0;  ///< relative x_l2 [-]
};

PlacedOrbit place(const Motion& answer, Motion orbit, int shift) {
  // No norm: the contacts rest where they are, or there are none, and so does the answer or it is off.
  const double otherwise =
      answer.samples.x.size() == 0 || answer.samples.x.cwiseAbs().maxCoeff() == 0.0 ? 0.0 : 1.0;
  const double apart = distance(answer, orbit, shift).x_l2.value_or(otherwise);
  return {.motion = std::move(orbit), .shift = shift, .distance = apart};
}

void add_reason(const std::string& reason, Certificate& certificate) {
  if (!certificate.reason.empty()) certificate.reason += "; ";
  certificate.reason += reason;
}

/// The attempts to certify one answer, each true where it succeeds.
class Attempts {
 public:
  Attempts(const Problem& problem, const Motion& motion, const Reference& reference)
      : problem_(problem), motion_(motion), reference_(reference) {
    Certificate& certificate = result.certificate;
    certificate.status = CertificateStatus::uncertified;
    if (reference.orbit) {
      from_rest_ = sample_motion(problem, *reference.orbit);
      certificate.reference = reference.fingerprint;
    } else {
      certificate.reference_reason = reference.reason;
    }
  }

  /// By an orbit found from the answer, at the answer's own phase.
  bool take(const CertifiedOrbit& found) {
    Certificate& certificate = result.certificate;
    if (!found.motion) {
      add_reason(found.reason, certificate);
      return false;
    }
    if (!(found.error_bar <= kLargestErrorBar)) {
      add_reason(fmt::format("the orbit that it leads to is known to {:.1e} only", found.error_bar),
                 certificate);
      return false;
    }
    PlacedOrbit orbit = place(motion_, sample_motion(problem_, *found.motion), 0);
    note_distance(orbit);
    certificate.source = found.source;
    if (orbit.distance > kNearOrbit) {
      certificate.reason =
          fmt::format("the orbit that it leads to ({}) is {:.2g} away", found.source, orbit.distance);
      return false;
    }
    accept(std::move(orbit), found);
    return true;
  }

  /// By the motion reached from rest, at the phase nearest to the answer's.
  bool take_reference() {
    if (!from_rest_) return false;
    PlacedOrbit orbit = place(motion_, *from_rest_, best_shift(motion_, *from_rest_));
    note_distance(orbit);
    if (orbit.distance > kNearOrbit) return false;
    accept(std::move(orbit), {.error_bar = reference_.error_bar,
                              .residual = reference_.residual,
                              .source = "the motion reached from rest"});
    return true;
  }

  CertifiedAnswer result;

 private:
  void note_distance(const PlacedOrbit& orbit) {
    std::optional<double>& nearest = result.certificate.distance;
    if (!nearest || orbit.distance < *nearest) nearest = orbit.distance;
  }

  void accept(PlacedOrbit orbit, const CertifiedOrbit& known) {
    Certificate& certificate = result.certificate;
    certificate.status = CertificateStatus::certified;
    certificate.reason.clear();
    certificate.source = known.source;
    certificate.error_bar = known.error_bar;
    certificate.residual = known.residual;
    certificate.order = least_order(orbit.motion);
    certificate.events = known.events.empty() ? orbit_events(orbit.motion) : known.events;
    certificate.return_distance = known.return_distance;
    certificate.floquet = known.floquet;
    certificate.stable = known.stable;
    certificate.orbit = fingerprint(orbit.motion);
    if (from_rest_) {
      certificate.same_orbit = same_orbit(orbit.motion, *from_rest_);
      // Two computations of one orbit may round its fingerprint differently.
      if (*certificate.same_orbit) certificate.orbit = reference_.fingerprint;
    }
    result.shift = orbit.shift;
    result.orbit = std::move(orbit.motion);
  }

  const Problem& problem_;
  const Motion& motion_;
  const Reference& reference_;
  std::optional<Motion> from_rest_;
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
  if (!polished() && !shot()) attempts.take_reference();
  return std::move(attempts.result);
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
