#include "methods/orbit/exact_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

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
  const std::vector<bool>* before = &orbit_.start.closed;
  for (std::size_t i = 0; i < orbit_.events.size(); ++i) {
    const SequenceEvent& event = orbit_.events[i];
    for (int j = 0; j < model_->dynamics.contact_count(); ++j) {
      const auto index = static_cast<std::size_t>(j);
      const bool was = (*before)[index], is = event.closed[index];
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
    before = &event.closed;
  }
  std::stable_sort(events_.begin(), events_.end(),
                   [](const ContactEvent& a, const ContactEvent& b) { return a.time < b.time; });
}

const LinearArc& ExactTrajectory::arc_at(double& time) const {
  const double start = orbit_.start.time;
  time = start + wrapped_time(time - start, period());
  const auto after = std::upper_bound(orbit_.events.begin(), orbit_.events.end(), time,
                                      [](double t, const SequenceEvent& event) { return t < event.time; });
  return *arcs_[static_cast<std::size_t>(after - orbit_.events.begin())];
}

// From event to event, in pieces so short that every term of the motion that still matters turns by less than
// a radian within one.
double ExactTrajectory::push(int contact, double begin, double end) const {
  const auto acting = static_cast<int>(std::ranges::find(contacts_, contact) - contacts_.begin());
  constexpr double kTurn = 0.8, kUnseen = 1e-9;  // rad; share of a scale
  constexpr int kMostPieces = 4096, kDerivatives = 4;
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
    const double rate = fastest_left(arc.fading_rates(kUnseen, kTurn, kDerivatives), start);
    const int pieces = std::clamp(static_cast<int>(std::ceil(rate * length / kTurn)), 1, kMostPieces);
    const auto derivatives = [&](int piece) {
      Derivatives values{};
      for (std::size_t k = 0; k < values.size(); ++k)
        values[k] = arc.force(acting, start + length * piece / pieces, static_cast<int>(k));
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
  const std::vector<ArcPush> arcs = listed.empty() ? std::vector<ArcPush>() : arc_pushes();
  for (const ListedContact& closed : listed) {
    if (arcs.empty()) {
      events[closed.opening].push = push(closed.contact, closed.begin, closed.end);
      continue;
    }
    const auto acting = std::ranges::find(contacts_, closed.contact) - contacts_.begin();
    double sum = 0.0;
    for (const ArcPush& arc : arcs) {
      if (wrapped_time(arc.middle - closed.begin, period()) < closed.end - closed.begin)
        sum += arc.push[acting];
    }
    events[closed.opening].push = std::min(0.0, sum);
  }
  return events;
}

std::vector<ExactTrajectory::ArcPush> ExactTrajectory::arc_pushes() const {
  std::vector<ArcPush> pushes;
  double begin = orbit_.start.time;
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    const double end = i < orbit_.events.size() ? orbit_.events[i].time : orbit_.start.time + period();
    Eigen::MatrixXcd integrals = Eigen::MatrixXcd::Zero(1, model_->dynamics.contact_count());
    if (!arcs_[i]->add_force_integrals(begin, end, 0.0, integrals)) return {};
    pushes.push_back({.middle = 0.5 * (begin + end), .push = integrals.row(0).real()});
    begin = end;
  }
  return pushes;
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
  double begin = orbit_.start.time;
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    const double end = i < orbit_.events.size() ? orbit_.events[i].time : orbit_.start.time + period();
    if (!arcs_[i]->add_force_integrals(begin, end, w, acting)) return {};
    begin = end;
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
