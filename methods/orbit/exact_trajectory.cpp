#include "methods/orbit/exact_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>

#include "methods/discretisation/contact_phases.hpp"
#include "methods/discretisation/periodic_time.hpp"
#include "methods/discretisation/two_point_integral.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

ExactTrajectory::ExactTrajectory(std::shared_ptr<OrbitModel> model, OrbitGuess orbit,
                                 std::vector<std::shared_ptr<LinearArc>> arcs,
                                 const std::vector<OrbitEquations::EventCrossing>& crossings)
    : model_(std::move(model)),
      contacts_(model_->dynamics.structure().scene_contacts()),
      orbit_(std::move(orbit)),
      arcs_(std::move(arcs)) {
  // Listed of each event: every contact that changes or takes an impulse, and the one whose guard vanishes.
  for (std::size_t i = 0; i < orbit_.events.size(); ++i) {
    const SequenceEvent& event = orbit_.events[i];
    for (int j = 0; j < model_->dynamics.contact_count(); ++j) {
      const auto index = static_cast<std::size_t>(j);
      const bool was = orbit_.closed_before(i)[index], is = event.closed[index];
      const auto pushed = std::find(event.pushed.begin(), event.pushed.end(), j);
      // A resting contact may have nothing to pass on.
      const double impulse = pushed == event.pushed.end()
                                 ? 0.0
                                 : std::min(0.0, crossings[i].impulses[pushed - event.pushed.begin()]);
      if (was == is && impulse == 0.0 && j != event.contact) continue;
      events_.push_back({.kind = was == is ? ContactEvent::Kind::impact
                                 : is      ? ContactEvent::Kind::close
                                           : ContactEvent::Kind::open,
                         .contact = scene_contact(j),
                         .time = wrapped_time(event.time, period()),
                         .impulse = impulse});
    }
  }
  std::ranges::stable_sort(events_, {}, &ContactEvent::time);
}

const LinearArc& ExactTrajectory::arc_at(double& time) const {
  const double start = orbit_.start.time;
  time = start + wrapped_time(time - start, period());
  const auto after = std::ranges::upper_bound(orbit_.events, time, {}, &SequenceEvent::time);
  return *arcs_[static_cast<std::size_t>(after - orbit_.events.begin())];
}

int ExactTrajectory::acting(int contact) const {
  return static_cast<int>(std::ranges::find(contacts_, contact) - contacts_.begin());
}

// From event to event, in pieces so short that every term of the motion that still matters turns by less than
// a radian within one.
double ExactTrajectory::push(int contact, double begin, double end) const {
  constexpr double kTurn = 0.8, kUnseen = 1e-9;  // rad; share of a scale
  constexpr int kMostPieces = 4096;
  std::vector<double> ends{begin, end};
  for (const ContactEvent& event : events_) {
    for (const double time : {event.time, event.time + period()}) {
      if (time > begin && time < end) ends.push_back(time);
    }
  }
  std::sort(ends.begin(), ends.end());
  double sum = 0.0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double length = ends[i] - ends[i - 1];
    double middle = ends[i - 1] + 0.5 * length;  // within the arc, whatever rounding does to its ends
    const LinearArc& arc = arc_at(middle);
    const double start = middle - 0.5 * length;
    const double rate = fastest_left(
        arc.fading_rates(kUnseen, kTurn, static_cast<int>(std::ssize(Derivatives{})) - 1), start);
    const int pieces = std::clamp(static_cast<int>(std::ceil(rate * length / kTurn)), 1, kMostPieces);
    const auto derivatives = [&](int piece) {
      Derivatives values{};
      for (std::size_t k = 0; k < values.size(); ++k)
        values[k] = arc.force(acting(contact), start + length * piece / pieces, static_cast<int>(k));
      return values;
    };
    Derivatives left = derivatives(0);
    for (int piece = 1; piece <= pieces; ++piece) {
      const Derivatives right = derivatives(piece);
      sum += two_point_integral(length / pieces, left, right);
      left = right;
    }
  }
  return std::min(0.0, sum);
}

// A contact that is listed is closed from its event to the next one, and in no arc for a part of it.
std::optional<std::vector<ContactEvent>> ExactTrajectory::events() const {
  std::vector<ContactEvent> events = events_;
  const std::vector<ListedContact> listed = listed_contacts(events_, period());
  std::vector<double> pushes(listed.size(), 0.0);
  bool closed_form = !listed.empty();
  for (std::size_t i = 0; i < arcs_.size() && closed_form; ++i) {
    const auto [begin, end] = orbit_.span(i, period());
    Eigen::MatrixXcd integrals = Eigen::MatrixXcd::Zero(1, model_->dynamics.contact_count());
    closed_form = arcs_[i]->add_force_integrals(begin, end, 0.0, integrals);
    for (std::size_t k = 0; k < listed.size() && closed_form; ++k) {
      const double after = wrapped_time(0.5 * (begin + end) - listed[k].begin, period());
      if (after < listed[k].end - listed[k].begin)
        pushes[k] += integrals(0, acting(listed[k].contact)).real();
    }
  }
  for (std::size_t k = 0; k < listed.size(); ++k) {
    const auto& [opening, contact, begin, end] = listed[k];
    events[opening].push = closed_form ? std::min(0.0, pushes[k]) : push(contact, begin, end);
  }
  return events;
}

State ExactTrajectory::at(double time) const {
  State state;
  const LinearArc& arc = arc_at(time);
  arc.state(time, state);
  return state;
}

Eigen::MatrixXcd ExactTrajectory::force_spectrum(int count) const {
  const double w = kTwoPi / period();
  Eigen::MatrixXcd acting = Eigen::MatrixXcd::Zero(count + 1, model_->dynamics.contact_count());
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    const auto [begin, end] = orbit_.span(i, period());
    if (!arcs_[i]->add_force_integrals(begin, end, w, acting)) return {};
  }
  Eigen::MatrixXcd sums = Eigen::MatrixXcd::Zero(count + 1, contact_count());
  for (Eigen::Index j = 0; j < acting.cols(); ++j)
    sums.col(scene_contact(static_cast<int>(j))) = acting.col(j);
  for (const Impulse& impulse : impulses()) {
    for (int n = 0; n <= count; ++n)
      sums(n, impulse.contact) += impulse.value * std::polar(1.0, -n * w * impulse.time);
  }
  return sums / period();
}

Samples ExactTrajectory::sample(int count) const {
  const Eigen::Index contacts = contact_count(), acting = model_->dynamics.contact_count();
  Samples samples{.x = Eigen::MatrixXd(count, contacts),
                  .velocity = Eigen::MatrixXd(count, contacts),
                  .force = Eigen::MatrixXd(count, contacts)};
  samples.force.setZero();
  // Instants of one arc together, some at a time.
  constexpr std::size_t kAtOnce = 256;
  std::vector<double> times;
  for (int first = 0; first < count; first += static_cast<int>(times.size())) {
    times.assign(1, first * (period() / count));
    const LinearArc& arc = arc_at(times.front());
    for (int i = first + 1; i < count && times.size() < kAtOnce; ++i) {
      double time = i * (period() / count);
      if (&arc_at(time) != &arc) break;
      times.push_back(time);
    }
    const auto together = std::ssize(times);
    const std::vector<Eigen::MatrixXd> derivatives = arc.outputs(times, 1);
    const Eigen::MatrixXd& values = derivatives[0];
    const auto take = [&](Eigen::MatrixXd& all, const Eigen::MatrixXd& rows, Eigen::Index begin) {
      for (Eigen::Index j = 0; j < rows.rows(); ++j)
        all.col(scene_contact(static_cast<int>(begin + j))).segment(first, together) =
            rows.row(j).transpose();
    };
    take(samples.x, values.topRows(acting), 0);
    take(samples.velocity, derivatives[1].topRows(acting), 0);
    if (acting < contacts) {
      const std::vector<Eigen::MatrixXd> open =
          arc.open_displacements(times, 1, 0, static_cast<int>(contacts - acting));
      take(samples.x, open[0], acting);
      take(samples.velocity, open[1], acting);
    }
    const std::vector<int>& closed = arc.mode().active;
    for (std::size_t c = 0; c < closed.size(); ++c)
      samples.force.col(scene_contact(closed[c])).segment(first, together) =
          values.row(acting + static_cast<Eigen::Index>(c)).transpose().cwiseMin(0.0);
  }
  return samples;
}

}  // namespace signorini
