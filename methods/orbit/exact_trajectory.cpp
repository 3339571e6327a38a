#include "methods/orbit/exact_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/discretisation/periodic_time.hpp"

namespace signorini {

ExactTrajectory::ExactTrajectory(std::shared_ptr<OrbitModel> model, OrbitGuess orbit,
                                 std::vector<std::shared_ptr<LinearArc>> arcs,
                                 const std::vector<OrbitEquations::EventCrossing>& crossings)
    : model_(std::move(model)), orbit_(std::move(orbit)), arcs_(std::move(arcs)) {
  const std::vector<bool>* before = &orbit_.start.closed;
  for (std::size_t i = 0; i < orbit_.events.size(); ++i) {
    list(orbit_.events[i], *before, crossings[i]);
    before = &orbit_.events[i].closed;
  }
  std::stable_sort(events_.begin(), events_.end(),
                   [](const ContactEvent& a, const ContactEvent& b) { return a.time < b.time; });
}

// Every contact that changes or takes an impulse at an event of the sequence; the one whose guard vanishes
// in any case.
void ExactTrajectory::list(const SequenceEvent& event, const std::vector<bool>& before,
                           const OrbitEquations::EventCrossing& crossing) {
  for (int j = 0; j < contact_count(); ++j) {
    const auto index = static_cast<std::size_t>(j);
    const auto pushed = std::find(event.pushed.begin(), event.pushed.end(), j);
    // A resting contact may have nothing to pass on.
    const double impulse =
        pushed == event.pushed.end() ? 0.0 : std::min(0.0, crossing.impulses[pushed - event.pushed.begin()]);
    if (before[index] == event.closed[index] && impulse == 0.0 && j != event.contact) continue;
    events_.push_back({.kind = before[index] == event.closed[index] ? ContactEvent::Kind::impact
                               : event.closed[index]                ? ContactEvent::Kind::close
                                                                    : ContactEvent::Kind::open,
                       .contact = j,
                       .time = wrapped_time(event.time, period()),
                       .impulse = impulse});
  }
}

std::vector<Impulse> ExactTrajectory::impulses() const {
  std::vector<Impulse> impulses;
  for (const ContactEvent& event : events_) {
    if (event.impulse < 0.0)
      impulses.push_back({.contact = event.contact, .time = event.time, .value = event.impulse});
  }
  return impulses;
}

const LinearArc& ExactTrajectory::arc_at(double& time) const {
  const double start = orbit_.start.time;
  time = start + wrapped_time(time - start, period());
  const auto after = std::upper_bound(orbit_.events.begin(), orbit_.events.end(), time,
                                      [](double t, const SequenceEvent& event) { return t < event.time; });
  return *arcs_[static_cast<std::size_t>(after - orbit_.events.begin())];
}

State ExactTrajectory::at(double time) const {
  State state;
  const LinearArc& arc = arc_at(time);
  arc.state(time, state);
  return state;
}

Samples ExactTrajectory::sample(int count) const {
  const Eigen::Index contacts = contact_count();
  Samples samples{.x = Eigen::MatrixXd(count, contacts),
                  .velocity = Eigen::MatrixXd(count, contacts),
                  .force = Eigen::MatrixXd(count, contacts)};
  for (int i = 0; i < count; ++i) {
    double time = i * (period() / count);
    const LinearArc& arc = arc_at(time);
    for (int j = 0; j < contacts; ++j) {
      samples.x(i, j) = arc.displacement(j, time);
      samples.velocity(i, j) = arc.displacement(j, time, 1);
      samples.force(i, j) = std::min(0.0, arc.force(j, time));
    }
  }
  return samples;
}

}  // namespace signorini
