#include "harness/responses/true_motion.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <variant>
#include <vector>

#include "harness/judge/exact_certificate.hpp"
#include "harness/orbits/listed_motion.hpp"

namespace signorini {

namespace {

using Kind = ContactEvent::Kind;

/// x of one contact of a motion, around its period.
class ContactMotion {
 public:
  ContactMotion(const Eigen::MatrixXd& motion, Eigen::Index contact, double gap, double step)
      : x_(motion.col(contact)),
        gap_(gap),
        step_(step),
        range_(x_.maxCoeff() - x_.minCoeff()),
        contact_(static_cast<int>(contact)) {}

  /// Before a spring or a massless contact: closings and openings where x passes the gap.
  void add_phases(double level, std::vector<ContactEvent>& events) const {
    for (Eigen::Index i = 0; i < x_.size(); ++i) {
      const double here = x_[i] - level, next = at(i + 1) - level;
      if ((here > 0.0) == (next > 0.0)) continue;
      const double time = (static_cast<double>(i) + here / (here - next)) * step_;
      events.push_back({.kind = next > 0.0 ? Kind::close : Kind::open, .contact = contact_, .time = time});
    }
  }
  /// Before a rigid stop: an impact at each maximum beside it; where x stays there a phase of contact.
  void add_impacts(std::vector<ContactEvent>& events) const {
    constexpr double kBeside = 0.1, kStays = 0.01;  // of the range of x
    constexpr int kLong = 6;                        // instants: no impact is beside its stop for so long
    if (longest_stay(gap_ - kStays * range_) > kLong) return add_phases(gap_ - kStays * range_, events);
    for (Eigen::Index i = 0; i < x_.size(); ++i) {
      const double before = at(i - 1), here = x_[i], after = at(i + 1);
      if (here < gap_ - kBeside * range_ || before > here || after >= here) continue;
      // The flanks of an impact are straight, and meet where x is largest.
      const double turn = 0.5 * (after - before) / (here - std::min(before, after));
      events.push_back({.kind = Kind::impact,
                        .contact = contact_,
                        .time = std::max(0.0, (static_cast<double>(i) + turn) * step_)});
    }
  }
  /// Whether it is never away from the stop.
  [[nodiscard]] bool stays() const { return x_.minCoeff() > gap_; }

 private:
  [[nodiscard]] double at(Eigen::Index i) const { return x_[(i + x_.size()) % x_.size()]; }
  [[nodiscard]] int longest_stay(double level) const {
    int longest = 0, length = 0;
    for (Eigen::Index i = 0; i < 2 * x_.size(); ++i) {
      length = at(i) > level ? length + 1 : 0;
      longest = std::max(longest, length);
    }
    return longest;
  }

  Eigen::VectorXd x_;
  double gap_, step_, range_;
  int contact_;
};

/// The motion by what its events seem to be.
ListedMotion listed(const Problem& problem, const Eigen::MatrixXd& motion) {
  const double period = problem.period(), step = period / static_cast<double>(motion.rows());
  std::vector<ContactEvent> events;
  std::vector<bool> pushing;
  for (Eigen::Index j = 0; j < motion.cols(); ++j) {
    const Contact& contact = problem.contacts[static_cast<std::size_t>(j)];
    const ContactMotion one(motion, j, contact.gap, step);
    const bool rigid = std::holds_alternative<Restitution>(contact.law);
    pushing.push_back(!rigid && one.stays());
    if (rigid)
      one.add_impacts(events);
    else
      one.add_phases(contact.gap, events);
  }
  for (ContactEvent& event : events) event.time = std::min(event.time, std::nextafter(period, 0.0));
  std::ranges::stable_sort(events, {}, &ContactEvent::time);
  return {period, std::move(events), std::move(pushing)};
}

}  // namespace

bool TrueMotions::contain(const ResponsePoint& point) {
  if (point.motion.size() == 0) return false;
  if (deadline_.passed()) {
    ++unasked_;
    return false;
  }
  try {
    const Problem problem = with_subharmonic(scene_.at(point.frequency), point.order);
    const CertifiedOrbit orbit = exact_orbits()(problem, listed(problem, point.motion), {}, deadline_);
    if (!orbit.motion) return false;
    const ResponsePoint exact{.frequency = point.frequency,
                              .order = point.order,
                              .motion = orbit.motion->sample(kComparedPhases * point.order).x};
    const bool there = metric_(point, metric_.primitive(exact)) <= tolerance_;
    if (there) ++confirmed_;
    return there;
  } catch (const std::exception&) {  // no flow, or no orbit
    return false;
  }
}

}  // namespace signorini
