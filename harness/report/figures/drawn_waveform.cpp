#include "harness/report/figures/drawn_waveform.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
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

double range_of(const std::vector<double>& values) {
  const auto [least, largest] = std::ranges::minmax(values);
  return largest > least ? largest - least : 1.0;
}

/// A portrait as a curve through its samples: centripetal splines of Catmull and Rom [yuksel2011], which have
/// neither loops nor cusps between samples however uneven, in shares of the ranges. Times play no part:
/// they are kept with few digits, and instants before an impact are close to it.
class Portrait {
 public:
  Portrait(const std::vector<double>& x, const std::vector<double>& v) : scale_(range_of(x), range_of(v)) {
    for (std::size_t i = 0; i < x.size(); ++i)
      places_.emplace_back(Eigen::Vector2d(x[i], v[i]).cwiseQuotient(scale_));
    closed_ = places_.size() > 3 && (places_.front() - places_.back()).norm() < kNear;
  }

  /// Whether the piece that ends at sample `i` is an impact: upright, and no part of a turn.
  [[nodiscard]] bool jumps(std::size_t i) const {
    constexpr double kLeap = 0.25;
    const Eigen::Vector2d step = places_[i] - places_[i - 1];
    return step.norm() == 0.0 || (std::abs(step.x()) < kNear && std::abs(step.y()) > kLeap);
  }

  /// The curve from sample `i` - 1 to sample `i` at this share of its way.
  [[nodiscard]] Eigen::Vector2d between(std::size_t i, double share) const {
    const Eigen::Vector2d &from = places_[i - 1], &to = places_[i];
    const Eigen::Vector2d before = neighbour(i, false), after = neighbour(i, true);
    const auto knot = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
      return std::sqrt((b - a).norm());
    };
    const double first = knot(before, from), own = knot(from, to), last = knot(to, after);
    // Slopes at both ends, over the length of this piece.
    const Eigen::Vector2d begin = to - from + own * ((from - before) / first - (to - before) / (first + own));
    const Eigen::Vector2d end = to - from + own * ((after - to) / last - (after - from) / (own + last));
    const double s = share, r = 1.0 - share;
    const Eigen::Vector2d place =
        r * r * (1.0 + 2.0 * s) * from + s * s * (3.0 - 2.0 * s) * to + s * r * (r * begin - s * end);
    return place.cwiseProduct(scale_);
  }

 private:
  static constexpr double kNear = 0.01;  // of the ranges

  /// The sample beyond either end of the piece that ends at `i`; where the curve has a corner, as if it went
  /// on.
  [[nodiscard]] Eigen::Vector2d neighbour(std::size_t i, bool beyond) const {
    const std::size_t last = places_.size() - 1, piece = beyond ? i + 1 : i - 1;
    const bool inside = piece >= 1 && piece <= last;
    const std::size_t next = inside ? piece : beyond ? 1 : last;  // where a closed curve goes on
    const Eigen::Vector2d &end = places_[beyond ? i : i - 1], &other = places_[beyond ? i - 1 : i];
    if ((!inside && !closed_) || jumps(next)) return 2.0 * end - other;
    return places_[beyond ? next : next - 1];
  }

  Eigen::Vector2d scale_;
  std::vector<Eigen::Vector2d> places_;
  bool closed_ = false;
};

/// The coarsest answer of a study with a certified orbit whose motion is kept; null if there is none.
const CaseResult* coarsest_kept(const ResolutionStudy& study) {
  for (const ScoredRun& run : study.runs)
    if (run.error && run.result->keeps_motion) return run.result;
  return nullptr;
}

/// Where this contact is kept in a record of the scene; the first if it is not.
std::size_t place_of_contact(const Waveforms& waveforms, int contact) {
  const auto found = std::ranges::find(waveforms.contacts, contact);
  return found == waveforms.contacts.end() ? 0 : static_cast<std::size_t>(found - waveforms.contacts.begin());
}

}  // namespace

std::size_t busiest_place(const Waveform& waveform) {
  const auto total = [](const std::vector<double>& impulse) {
    return impulse.empty() ? 0.0 : impulse.back();
  };
  return static_cast<std::size_t>(std::ranges::min_element(waveform.impulse, {}, total) -
                                  waveform.impulse.begin());
}

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
  const Portrait portrait(waveform.x[contact], waveform.velocity[contact]);
  const std::vector<double>&x = waveform.x[contact], &v = waveform.velocity[contact];
  std::string lines = fmt::format("{:.7g} {:.7g}\n", x[0], v[0]);
  for (std::size_t i = 1; i < x.size(); ++i) {
    for (int k = 1; !portrait.jumps(i) && k < kBetween; ++k) {
      const Eigen::Vector2d place = portrait.between(i, static_cast<double>(k) / kBetween);
      lines += fmt::format("{:.7g} {:.7g}\n", place.x(), place.y());
    }
    lines += fmt::format("{:.7g} {:.7g}\n", x[i], v[i]);
  }
  return lines;
}

std::optional<double> stop_position(const Record& record, std::size_t place) {
  const Waveform& orbit = *record.waveforms->orbit;
  if (!(orbit.impulse[place].back() < 0.0)) return std::nullopt;
  const int contact = record.waveforms->contacts[place];
  if (!record.law || !std::holds_alternative<Spring>(law_of_contact(*record.law, contact)))
    return std::ranges::max(orbit.x[place]);
  for (const OrbitEvent& event : record.certificate.events)
    if (event.contact == contact && event.kind == ContactEvent::Kind::close)
      return between(orbit.t, orbit.x[place], std::fmod(event.time, orbit.t.back()));
  return std::nullopt;
}

KeptMotions kept_motions(const Evaluation& evaluation, const std::string& scene) {
  KeptMotions kept;
  for (const ResolutionStudy& study : evaluation.studies_of(scene)) {
    if (study.eligibility != Eligibility::ranked) continue;
    const CaseResult* result = coarsest_kept(study);
    if (result == nullptr) continue;
    const Record record = evaluation.record_of(*result);
    const Waveforms& own = *record.waveforms;
    if (!kept.leader) {
      kept.leader = record;
      kept.place = busiest_place(*own.orbit);
      kept.contact = own.contacts[kept.place];
    }
    const std::size_t place = place_of_contact(own, kept.contact);
    kept.answers.push_back({.result = result,
                            .place = place,
                            .motion = in_phase_with(kept.orbit(), kept.place, own, place,
                                                    record.certificate.order.value_or(1))});
  }
  return kept;
}

}  // namespace signorini
