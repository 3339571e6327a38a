#pragma once
// A periodic motion of which nothing is known but its events: what the polish needs of an orbit.

#include <span>
#include <utility>
#include <vector>

#include "harness/records/record.hpp"
#include "methods/solution.hpp"

namespace signorini {

/// The events of an orbit as a motion lists them.
inline std::vector<ContactEvent> contact_events(std::span<const OrbitEvent> kept) {
  std::vector<ContactEvent> events;
  for (const OrbitEvent& event : kept)
    events.push_back({event.kind, event.contact, event.time, event.value.value_or(0.0)});
  return events;
}

/// Events of one period; x and velocity are not known, and told as zero.
class ListedMotion final : public Trajectory {
 public:
  /// \param pushing  Nc, contacts that push throughout and have no event
  ListedMotion(double period, std::vector<ContactEvent> events, std::vector<bool> pushing)
      : period_(period), events_(std::move(events)), pushing_(std::move(pushing)) {}

  [[nodiscard]] int contact_count() const override { return static_cast<int>(pushing_.size()); }
  [[nodiscard]] double period() const override { return period_; }
  /// A force of -1 N where a contact pushes throughout.
  [[nodiscard]] Samples sample(int count) const override {
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(count, contact_count());
    Eigen::MatrixXd force = zero;
    for (int j = 0; j < contact_count(); ++j)
      if (pushing_[static_cast<std::size_t>(j)]) force.col(j).setConstant(-1.0);
    return {.x = zero, .velocity = zero, .force = force};
  }
  [[nodiscard]] std::optional<std::vector<ContactEvent>> events() const override { return events_; }

 private:
  double period_;
  std::vector<ContactEvent> events_;
  std::vector<bool> pushing_;
};

}  // namespace signorini
