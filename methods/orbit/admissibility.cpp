#include "methods/orbit/admissibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace signorini {

namespace {

// A quantity that must not be positive along an arc.
struct Limited {
  const LinearArc& arc;
  int contact;
  bool of_force;
  double offset, unit;

  [[nodiscard]] double value(double t, int order) const {
    const double raw = of_force ? arc.force(contact, t, order) : arc.displacement(contact, t, order);
    return (raw - (order == 0 ? offset : 0.0)) / unit;
  }
};

struct Peak {
  double value = -std::numeric_limits<double>::infinity();
  double time = 0.0;
};

// Local maximum between two instants where the rate falls through zero.
double polished_peak(const Limited& f, double low, double high) {
  double t = 0.5 * (low + high);
  for (int k = 0; k < 30; ++k) {
    const double rate = f.value(t, 1), curvature = f.value(t, 2);
    (rate > 0.0 ? low : high) = t;
    double next = t - rate / curvature;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - t) <= 1e-14 * std::abs(t)) break;
    t = next;
  }
  return t;
}

struct LimitedSample {
  double time = 0.0, value = 0.0, rate = 0.0, curvature = 0.0;
};

LimitedSample sample(const Limited& f, double t) {
  return {.time = t, .value = f.value(t, 0), .rate = f.value(t, 1), .curvature = f.value(t, 2)};
}

// Extremum of the rate between two samples on either side of it.
LimitedSample steepest(const Limited& f, double low, double high) {
  constexpr int kBisections = 40;
  const bool falls = f.value(low, 2) < 0.0;
  for (int k = 0; k < kBisections; ++k) {
    const double middle = 0.5 * (low + high);
    ((f.value(middle, 2) < 0.0) == falls ? low : high) = middle;
  }
  return sample(f, 0.5 * (low + high));
}

Peak largest(const Limited& f, double begin, double end, const std::vector<FadingRate>& terms) {
  constexpr double kAngle = 2.0 * std::numbers::pi / 16.0;  // a step, in terms of the fastest rate left
  LimitedSample before = sample(f, begin);
  Peak peak{before.value, begin};
  const auto rise = [&](const LimitedSample& a, const LimitedSample& b) {
    if (!(a.rate > 0.0 && b.rate < 0.0)) return;
    const double top = polished_peak(f, a.time, b.time);
    if (const double there = f.value(top, 0); there > peak.value) peak = {there, top};
  };
  for (double t = begin; t < end;) {
    const double next = t + std::min(kAngle / fastest_left(terms, t), 0.5 * (end - begin));
    t = next > t ? std::min(end, next) : end;  // an arc as short as rounding has no middle
    const LimitedSample here = sample(f, t);
    if (here.value > peak.value) peak = {here.value, t};
    if (before.rate > 0.0 && here.rate < 0.0) {
      rise(before, here);
    } else if (before.curvature * here.curvature < 0.0) {
      // The rate turns in between: a bump too short for its signs at the samples, as after an impact at e =
      // 0.
      const LimitedSample turn = steepest(f, before.time, t);
      rise(before, turn);
      rise(turn, here);
    }
    before = here;
  }
  return peak;
}

class Check {
 public:
  Check(const OrbitModel& model, const OrbitGuess& orbit, const OrbitEquations& equations, double tolerance,
        double chatter)
      : dynamics_(model.dynamics),
        model_(model),
        orbit_(orbit),
        equations_(equations),
        tolerance_(tolerance),
        chatter_(chatter) {}

  Admissibility run() {
    result_.weakest_impact = std::numeric_limits<double>::infinity();
    double begin = orbit_.start.time;
    const auto arcs = static_cast<std::size_t>(equations_.events()) + 1;
    for (std::size_t i = 0; i < arcs; ++i) {
      const double end = i + 1 == arcs ? orbit_.start.time + model_.period : orbit_.events[i].time;
      arc(*equations_.arcs()[i], begin, end);
      if (i + 1 < arcs) event(i);
      begin = end;
    }
    if (result_.impacts == 0) result_.weakest_impact = 0.0;
    return result_;
  }

 private:
  static constexpr double kUnseen = 0.01;  // of the tolerance: modes below do not move a contact

  void fail(const std::string& reason) {
    if (result_.ok) result_.reason = reason;
    result_.ok = false;
  }

  void arc(const LinearArc& arc, double begin, double end) {
    const std::vector<FadingRate> terms = arc.fading_rates(kUnseen * tolerance_);
    for (int j = 0; j < dynamics_.contact_count(); ++j) {
      const bool closed = arc.mode().closed(j);
      const Limited f{.arc = arc,
                      .contact = j,
                      .of_force = closed,
                      .offset = closed ? 0.0 : dynamics_.structure().gaps[j],
                      .unit = closed ? dynamics_.force_scale(j) : dynamics_.scales().displacement};
      const Peak peak = largest(f, begin, end, terms);
      double& worst = closed ? result_.tension : result_.penetration;
      worst = std::max(worst, peak.value);
      if (peak.value <= tolerance_) continue;
      fail(closed ? fmt::format("contact {} pulls at t = {:.6g} s ({:.2g} of the force scale)", j, peak.time,
                                peak.value)
                  : fmt::format("contact {} penetrates at t = {:.6g} s by {:.2g} of the amplitude", j,
                                peak.time, peak.value));
    }
  }

  void event(std::size_t i) {
    const SequenceEvent& event = orbit_.events[i];
    const OrbitEquations::EventCrossing& crossing = equations_.crossings()[i];
    if (event.kind != ContactEvent::Kind::open) {
      const double v = crossing.approach / dynamics_.scales().velocity;
      if (event.kind == ContactEvent::Kind::impact) ++result_.impacts;
      // A spring may begin to act at any speed; what a chatter ends with is small by its nature.
      const bool tail = event.kind == ContactEvent::Kind::close && dynamics_.restitution() > 0.0;
      if (dynamics_.rigid() && !tail) result_.weakest_impact = std::min(result_.weakest_impact, v);
      if (!(v > 0.0))
        fail(fmt::format("contact {} does not close at t = {:.6g} s", event.contact, event.time));
    }
    for (std::size_t k = 0; k < event.pushed.size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      if (crossing.impulses[row] > 0.0 &&
          crossing.speeds.maxCoeff() > tolerance_ * dynamics_.scales().velocity)
        fail(fmt::format("contact {} pulls at the impact at t = {:.6g} s", event.pushed[k], event.time));
      law(event, crossing.speeds[row], k, *equations_.arcs()[i]);
    }
  }

  void law(const SequenceEvent& event, double approach, std::size_t k, const LinearArc& arc) {
    const double e = dynamics_.restitution();
    if (event.restitution[k] == e || approach <= tolerance_ * dynamics_.scales().velocity) return;
    const double a = arc.displacement(event.pushed[k], event.time, 2);
    const double left_out = 0.5 * e * approach * approach / (a * (1.0 - e)) / dynamics_.scales().displacement;
    if (a > 0.0 && e < 1.0 && left_out <= chatter_) {
      result_.chatter = true;
      result_.chatter_error = std::max(result_.chatter_error, left_out);
      return;
    }
    fail(fmt::format("contact {} stops at t = {:.6g} s without the chatter that restitution {} calls for",
                     event.pushed[k], event.time, e));
  }

  const ContactDynamics& dynamics_;
  const OrbitModel& model_;
  const OrbitGuess& orbit_;
  const OrbitEquations& equations_;
  double tolerance_, chatter_;
  Admissibility result_;
};

}  // namespace

Admissibility check_admissible(const OrbitModel& model, const OrbitGuess& orbit,
                               const OrbitEquations& equations, double tolerance, double chatter) {
  return Check(model, orbit, equations, tolerance, chatter).run();
}

}  // namespace signorini
