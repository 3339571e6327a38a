#include "methods/orbit/exact_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/discretisation/periodic_time.hpp"

namespace signorini {

ExactTrajectory::ExactTrajectory(std::shared_ptr<OrbitModel> model, OrbitGuess orbit,
                                 std::vector<LinearArc> arcs,
                                 const std::vector<OrbitEquations::Passage>& passages)
    : model_(std::move(model)), orbit_(std::move(orbit)), arcs_(std::move(arcs)) {
  for (std::size_t i = 0; i < orbit_.events.size(); ++i) {
    const SequenceEvent& event = orbit_.events[i];
    for (std::size_t k = 0; k < event.pushed.size(); ++k) {
      const double value = passages[i].impulses[static_cast<Eigen::Index>(k)];
      if (value < 0.0)  // a resting contact may have nothing to pass on
        impulses_.push_back(
            {.contact = event.pushed[k], .time = wrapped_time(event.time, period()), .value = value});
    }
  }
  std::stable_sort(impulses_.begin(), impulses_.end(),
                   [](const Impulse& a, const Impulse& b) { return a.time < b.time; });
}

const LinearArc& ExactTrajectory::arc_at(double& time) const {
  const double start = orbit_.start.time;
  time = start + wrapped_time(time - start, period());
  const auto after = std::upper_bound(orbit_.events.begin(), orbit_.events.end(), time,
                                      [](double t, const SequenceEvent& event) { return t < event.time; });
  return arcs_[static_cast<std::size_t>(after - orbit_.events.begin())];
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
