#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "methods/flow/stop_events.hpp"
#include "methods/orbit/arc_scan.hpp"
#include "methods/orbit/exact_orbit.hpp"

namespace signorini {

namespace {

// An orbit under examination.
struct Check {
  const ContactDynamics& dynamics;
  const OrbitGuess& orbit;
  const OrbitEquations& equations;
  double period;
  Admissibility result = {};
  std::vector<int> reached = {};  // contacts taken for open that pass their stops,
  std::string passing = {};       // the one that passes it most,
  double passed = 0.0;            // and by how much

  // As the scene counts it.
  [[nodiscard]] int named(int contact) const { return dynamics.structure().scene_contact(contact); }

  void fail(const std::string& reason) {
    if (result.ok) result.reason = reason;
    result.ok = false;
  }

  // No penetration and no tension between two events.
  void arc(std::size_t i) {
    constexpr double kUnseen = 0.01;  // of the tolerance: modes below do not move a contact
    const LinearArc& arc = *equations.arcs()[i];
    const auto [begin, end] = orbit.span(i, period);
    const FlowStructure& structure = dynamics.structure();
    const double X = dynamics.scales().displacement;
    std::vector<LimitedOutput> guards, open;
    for (int j = 0; j < dynamics.contact_count(); ++j) {
      const bool closed = arc.mode().closed(j);
      guards.push_back({.arc = arc,
                        .contact = j,
                        .of_force = closed,
                        .offset = closed ? 0.0 : structure.gaps[j],
                        .unit = closed ? dynamics.force_scale(j) : X});
    }
    for (const double gap : structure.open_gaps) {
      const int j = dynamics.contact_count() + static_cast<int>(open.size());
      open.push_back({.arc = arc, .contact = j, .of_force = false, .offset = gap, .unit = X});
    }
    const std::vector<FadingRate> terms = arc.fading_rates(kUnseen * kAdmissible);
    for (std::vector<LimitedOutput>* outputs : {&guards, &open}) {
      const std::vector<LimitedOutput> near = near_limit(*outputs, begin, end, terms);
      const std::vector<LimitedSample> peaks = largest(near, begin, end, terms);
      for (std::size_t k = 0; k < near.size(); ++k)
        outputs == &guards ? guard(near[k], peaks[k]) : open_contact(near[k], peaks[k]);
    }
  }

  // The largest value of a contact that acts.
  void guard(const LimitedOutput& output, const LimitedSample& peak) {
    result.violation = std::max(result.violation, peak.value);
    if (peak.value <= kAdmissible) return;
    const int contact = named(output.contact);
    fail(output.of_force ? fmt::format("contact {} pulls at t = {:.6g} s ({:.2g} of the force scale)",
                                       contact, peak.time, peak.value)
                         : fmt::format("contact {} penetrates at t = {:.6g} s by {:.2g} of the amplitude",
                                       contact, peak.time, peak.value));
  }

  // The same of one taken for open.
  void open_contact(const LimitedOutput& output, const LimitedSample& peak) {
    if (peak.value <= kAdmissible) return;
    const int contact = named(output.contact);
    if (reached.empty() || !(peak.value <= passed)) {
      passed = peak.value;
      passing = fmt::format(
          "contact {}, taken for open, passes its stop at t = {:.6g} s by {:.2g} of the amplitude", contact,
          peak.time, peak.value);
    }
    reached.push_back(contact);
  }

  // Contacts taken for open tell something only where the others are right.
  void open_contacts() {
    if (!result.ok) return;
    for (const int k : dynamics.structure().open_unclear) {
      const int contact = named(dynamics.contact_count() + k);
      if (reached.empty()) passing = fmt::format("what contact {} does while open is not known", contact);
      reached.push_back(contact);
    }
    if (reached.empty()) return;
    std::ranges::sort(reached);
    reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
    result.violation = std::max(result.violation, passed);
    result.reached = std::move(reached);
    fail(passing);
  }

  // Contacts that close or are struck together with the one whose guard vanishes are at their stops, too: one
  // that is held before it is there neither penetrates nor pulls.
  void together(std::size_t i) {
    const SequenceEvent& event = orbit.events[i];
    for (int j = 0; j < dynamics.contact_count(); ++j) {
      const auto index = static_cast<std::size_t>(j);
      const bool meets = event.closed[index] || std::ranges::find(event.pushed, j) != event.pushed.end();
      if (j == event.contact || orbit.closed_before(i)[index] || !meets) continue;
      const double short_of =
          (dynamics.structure().gaps[j] - equations.arcs()[i]->displacement(j, event.time)) /
          dynamics.scales().displacement;
      if (short_of <= kAdmissible) continue;
      fail(fmt::format("contact {} is held at t = {:.6g} s, {:.2g} of the amplitude before its stop",
                       named(j), event.time, short_of));
    }
  }

  // Contacts close with x'_- > 0, and all that push take an impulse <= 0.
  void event(std::size_t i) {
    const SequenceEvent& event = orbit.events[i];
    const OrbitEquations::EventCrossing& crossing = equations.crossings()[i];
    if (event.kind != ContactEvent::Kind::open) {
      const double v = crossing.approach / dynamics.scales().velocity;
      if (event.kind == ContactEvent::Kind::impact) ++result.impacts;
      // A spring may begin to act at any speed; what a chatter ends with is small by its nature.
      const bool tail = event.kind == ContactEvent::Kind::close && dynamics.restitution(event.contact) > 0.0;
      if (dynamics.rigid(event.contact) && !tail) result.weakest_impact = std::min(result.weakest_impact, v);
      if (!(v > kOrbitRounding))
        fail(fmt::format("contact {} does not close at t = {:.6g} s", named(event.contact), event.time));
    }
    for (std::size_t k = 0; k < event.pushed.size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      if (crossing.impulses[row] > 0.0 &&
          crossing.speeds.maxCoeff() > kAdmissible * dynamics.scales().velocity)
        fail(fmt::format("contact {} pulls at the impact at t = {:.6g} s", named(event.pushed[k]),
                         event.time));
      law(i, k, crossing.speeds[row]);
    }
  }

  // The scene's restitution, or the end of a chatter.
  void law(std::size_t i, std::size_t k, double approach) {
    constexpr double kBeside = 1.5;  // what a flow beside the orbit has left out, over that of the orbit
    const SequenceEvent& event = orbit.events[i];
    const int contact = event.pushed[k];
    const double e = dynamics.restitution(contact);
    if (event.restitution[k] == e || approach <= kAdmissible * dynamics.scales().velocity) return;
    const LinearArc& arc = *equations.arcs()[i];
    const auto rate = [&](int order) { return arc.displacement(contact, event.time, order); };
    const auto left_out = left_out_by_chatter(dynamics, contact, approach, rate(2), rate(3));
    const double allowed = (e < 1.0 ? kLeftOut : kBeside * kFadedHeight) * dynamics.scales().displacement;
    if (left_out && *left_out <= allowed) {
      double& most = result.chatter_error[static_cast<Eigen::Index>(i)];
      most = std::max(most, *left_out / dynamics.scales().displacement);
      return;
    }
    fail(fmt::format("contact {} stops at t = {:.6g} s without the chatter that restitution {} calls for",
                     named(contact), event.time, e));
  }
};

}  // namespace

Admissibility check_admissible(const OrbitModel& model, const OrbitGuess& orbit,
                               const OrbitEquations& equations, const Expired& expired) {
  Check check{.dynamics = model.dynamics, .orbit = orbit, .equations = equations, .period = model.period};
  check.result.chatter_error.setZero(std::ssize(orbit.events));
  check.result.weakest_impact = kInfinity;
  for (std::size_t i = 0; i <= orbit.events.size(); ++i) {
    require_time(expired);
    check.arc(i);
    if (i == orbit.events.size()) break;
    check.event(i);
    check.together(i);
  }
  check.open_contacts();
  if (check.result.impacts == 0) check.result.weakest_impact = 0.0;
  return check.result;
}

}  // namespace signorini
