#include "harness/report/figures/drawn_waveform.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini {

namespace {

double between(const std::vector<double>& t, const std::vector<double>& values, double time) {
  const auto after = std::ranges::upper_bound(t, time);
  if (after == t.end()) return values.back();
  if (after == t.begin()) return values.front();
  const auto i = static_cast<std::size_t>(after - t.begin());
  const double share = (time - t[i - 1]) / (t[i] - t[i - 1]);
  return (1.0 - share) * values[i - 1] + share * values[i];
}

/// Values of one signal from `delay` on, at the instants that `delayed` takes. An impulse goes on growing.
std::vector<double> rotated(const std::vector<double>& t, const std::vector<double>& values, double delay,
                            bool grows) {
  const double start = between(t, values, delay);
  const double less = grows ? start : 0.0, whole = grows ? values.back() - values.front() : 0.0;
  std::vector<double> found{start - less};
  for (std::size_t i = 0; i < t.size(); ++i)
    if (t[i] > delay) found.push_back(values[i] - less);
  for (std::size_t i = 1; i < t.size(); ++i)
    if (t[i] <= delay) found.push_back(values[i] + whole - less);
  found.push_back(start + whole - less);
  return found;
}

/// Mean distance of two periodic signals over the instants of the first, the second later by `delay`.
double mismatch(const Waveform& a, std::size_t place, const Waveform& b, std::size_t at, double delay) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < a.t.size(); ++i)
    sum += std::abs(a.x[place][i] - between(b.t, b.x[at], std::fmod(a.t[i] + delay, b.t.back()))) *
           (a.t[i + 1] - a.t[i]);
  return sum;
}

}  // namespace

Waveform delayed(const Waveform& waveform, double delay) {
  Waveform later;
  later.t.push_back(0.0);
  const double end = waveform.t.back();
  for (const double t : waveform.t)
    if (t > delay) later.t.push_back(t - delay);
  for (std::size_t i = 1; i < waveform.t.size(); ++i)
    if (waveform.t[i] <= delay) later.t.push_back(waveform.t[i] + end - delay);
  later.t.push_back(end);
  const auto turn = [&](const std::vector<std::vector<double>>& signals, bool grows) {
    std::vector<std::vector<double>> turned;
    for (const auto& signal : signals) turned.push_back(rotated(waveform.t, signal, delay, grows));
    return turned;
  };
  later.x = turn(waveform.x, false);
  later.velocity = turn(waveform.velocity, false);
  later.force = turn(waveform.force, false);
  later.impulse = turn(waveform.impulse, true);
  return later;
}

Waveform in_phase_with(const Waveform& leader, std::size_t place, const Waveforms& kept, std::size_t at,
                       int order) {
  constexpr double kRounded = 1e-3;  // kept times have four digits
  const double end = kept.answer.t.back();
  if (order < 2 || !kept.orbit || std::abs(end - leader.t.back()) > kRounded * end) return kept.answer;
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < order; ++k) {
    const double distance = mismatch(leader, place, *kept.orbit, at, k * end / order);
    if (distance < (1.0 - kRounded) * least) {
      least = distance;
      best = k;
    }
  }
  return best == 0 ? kept.answer : delayed(kept.answer, best * end / order);
}

std::string portrait_lines(const Waveform& waveform, std::size_t contact) {
  constexpr int kBetween = 8;
  const std::vector<double>&x = waveform.x[contact], &v = waveform.velocity[contact];
  std::string lines = fmt::format("{:.4g} {:.4g}\n", x[0], v[0]);
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double dt = waveform.t[i] - waveform.t[i - 1];
    const double mean = dt > 0.0 ? (x[i] - x[i - 1]) / dt : 0.0;
    const double middle = 1.5 * mean - 0.25 * (v[i] + v[i - 1]);
    const double jump = std::abs(v[i] - v[i - 1]);
    const bool smooth =
        dt > 0.0 && middle <= std::max(v[i], v[i - 1]) + jump && middle >= std::min(v[i], v[i - 1]) - jump;
    for (int k = 1; smooth && k < kBetween; ++k) {
      const double s = static_cast<double>(k) / kBetween, r = 1.0 - s;
      const double place = r * r * (1.0 + 2.0 * s) * x[i - 1] + s * s * (3.0 - 2.0 * s) * x[i] +
                           dt * s * r * (r * v[i - 1] - s * v[i]);
      const double speed = r * (1.0 - 3.0 * s) * v[i - 1] + s * (3.0 * s - 2.0) * v[i] + 6.0 * s * r * mean;
      lines += fmt::format("{:.5g} {:.5g}\n", place, speed);
    }
    lines += fmt::format("{:.4g} {:.4g}\n", x[i], v[i]);
  }
  return lines;
}

std::optional<double> stop_position(const Record& record, std::size_t place) {
  const Waveform& orbit = *record.waveforms->orbit;
  if (!(orbit.impulse[place].back() < 0.0)) return std::nullopt;
  if (!record.law || !std::holds_alternative<Penalty>(*record.law)) return std::ranges::max(orbit.x[place]);
  const int contact = record.waveforms->contacts[place];
  for (const OrbitEvent& event : record.certificate.events)
    if (event.contact == contact && event.kind == ContactEvent::Kind::close)
      return between(orbit.t, orbit.x[place], std::fmod(event.time, orbit.t.back()));
  return std::nullopt;
}

}  // namespace signorini
