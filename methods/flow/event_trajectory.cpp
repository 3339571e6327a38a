#include "methods/flow/event_trajectory.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "methods/discretisation/contact_phases.hpp"
#include "methods/discretisation/periodic_time.hpp"
#include "methods/discretisation/two_point_integral.hpp"

namespace signorini {

namespace {

// Of a function and of its derivatives that are matched.
using Weights = std::array<double, kNodeOrder>;

// Weights of h^k f^(k) at the left end, at a fraction `s` of the interval:
// A_k(s) = s^k / k! (1 - s)^5 sum_{j <= 4 - k} binomial(4 + j, j) s^j. The right end has (-1)^k A_k(1 - s).
Weights hermite_weights(double s) {
  constexpr Weights kBinomial{1.0, 5.0, 15.0, 35.0, 70.0};
  const double r = 1.0 - s;
  Weights weights{};
  double factor = r * r * r * r * r;  // s^k / k! (1 - s)^5
  for (std::size_t k = 0; k < weights.size(); ++k) {
    if (k > 0) factor *= s / static_cast<double>(k);
    double sum = 0.0;
    for (std::size_t j = weights.size() - k; j-- > 0;) sum = sum * s + kBinomial[j];
    weights[k] = factor * sum;
  }
  return weights;
}

// Where one instant lies between two that were kept.
struct Place {
  double h = 0.0;
  Weights left{}, right{};
};

// Value of the function whose derivatives 0..4 stand in columns first..first + 4.
double interpolate(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right, Eigen::Index row,
                   Eigen::Index first, const Place& place) {
  // h^k from the fraction s to the time, (-1)^k because the right end's weights look back.
  double value = 0.0, power = 1.0, sign = 1.0;
  for (int k = 0; k < kNodeOrder; ++k) {
    const auto i = static_cast<std::size_t>(k);
    value += power * (place.left[i] * left(row, first + k) + sign * place.right[i] * right(row, first + k));
    power *= place.h;
    sign = -sign;
  }
  return value;
}

}  // namespace

EventTrajectory::EventTrajectory(double period, FlowState start, std::vector<FlowNode> nodes,
                                 std::vector<ContactEvent> events)
    : period_(period), start_(std::move(start)), nodes_(std::move(nodes)), events_(std::move(events)) {
  for (ContactEvent& event : events_) event.time = wrapped_time(event.time, period_);
  std::stable_sort(events_.begin(), events_.end(),
                   [](const auto& a, const auto& b) { return a.time < b.time; });
}

Samples EventTrajectory::sample(int count) const {
  const Eigen::Index contacts = contact_count();
  Samples samples{.x = Eigen::MatrixXd::Zero(count, contacts),
                  .velocity = Eigen::MatrixXd::Zero(count, contacts),
                  .force = Eigen::MatrixXd::Zero(count, contacts)};
  for (int i = 0; i < count; ++i) {
    const double time = start_.time + wrapped_time(i * (period_ / count) - start_.time, period_);
    // Of the two nodes at an event the later one begins an interval: what is right-sided stays so.
    const auto after =
        std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, time,
                         [](double instant, const FlowNode& node) { return instant < node.time; });
    const FlowNode &left = *std::prev(after), &right = *after;
    const double h = right.time - left.time;
    const double s = h > 0.0 ? std::clamp((time - left.time) / h, 0.0, 1.0) : 1.0;
    const Place place{.h = h, .left = hermite_weights(s), .right = hermite_weights(1.0 - s)};
    for (Eigen::Index j = 0; j < contacts; ++j) {
      samples.x(i, j) = interpolate(left.x, right.x, j, 0, place);
      samples.velocity(i, j) = interpolate(left.x, right.x, j, 1, place);
      samples.force(i, j) = std::min(0.0, interpolate(left.lambda, right.lambda, j, 0, place));
    }
  }
  return samples;
}

std::optional<std::vector<ContactEvent>> EventTrajectory::events() const {
  std::vector<ContactEvent> events = events_;
  const auto derivatives = [](const FlowNode& node, Eigen::Index contact) {
    Derivatives values{};
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = node.lambda(contact, static_cast<Eigen::Index>(k));
    return values;
  };
  for (const ListedContact& closed : listed_contacts(events_, period_)) {
    double push = 0.0;
    for (std::size_t i = 1; i < nodes_.size(); ++i) {
      const FlowNode &left = nodes_[i - 1], &right = nodes_[i];
      // Events are nodes: an interval lies in the contact if its middle does.
      const double since = wrapped_time(0.5 * (left.time + right.time) - closed.begin, period_);
      if (since < closed.end - closed.begin)
        push += two_point_integral(right.time - left.time, derivatives(left, closed.contact),
                                   derivatives(right, closed.contact));
    }
    events[closed.opening].push = std::min(0.0, push);
  }
  return events;
}

std::vector<Impulse> impulses_of(const std::vector<ContactEvent>& events) {
  std::vector<Impulse> impulses;
  for (const ContactEvent& event : events) {
    if (event.impulse < 0.0)
      impulses.push_back({.contact = event.contact, .time = event.time, .value = event.impulse});
  }
  return impulses;
}

}  // namespace signorini
