#include "harness/summary/motion_summary.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <stdexcept>
#include <variant>

#include "harness/judge/measures/impacts.hpp"
#include "harness/summary/coordinate_motion.hpp"
#include "methods/discretisation/contact_phases.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

/// Hermite's cubic x(s), 0 <= s <= 1 between two instants.
struct HermiteCubic {
  HermiteCubic(const SampledDisplacement& displacement, Eigen::Index i) {
    const Eigen::Index count = displacement.x.size(), left = (i + count) % count, right = (left + 1) % count;
    const double step = displacement.period / static_cast<double>(count);
    value = displacement.x[left];
    slope = step * displacement.velocity[left];
    const double rise = displacement.x[right] - value, last = step * displacement.velocity[right];
    square = 3.0 * rise - 2.0 * slope - last;
    cube = slope + last - 2.0 * rise;
    turns = slope * last < 0.0;
  }

  [[nodiscard]] double at(double s) const { return value + s * (slope + s * (square + s * cube)); }
  /// The root of x' in [0, 1] where it changes sign there.
  [[nodiscard]] double turning_point() const {
    const double root = std::sqrt(std::max(0.0, square * square - 3.0 * cube * slope));
    const double q = -(square + std::copysign(root, square));
    const double far = q / (3.0 * cube), near = slope / q;
    return std::isfinite(near) && near >= 0.0 && near <= 1.0 ? near : std::clamp(far, 0.0, 1.0);
  }

  double value = 0.0, slope = 0.0, square = 0.0, cube = 0.0;
  bool turns = false;  ///< the velocity changes its sign
};

/// First and last instant of those that lie in one interval between samples, in steps from its beginning.
struct JumpsInside {
  double first = 0.0, last = 0.0;
};

/// Intervals (t_i, t_{i+1}] with a jump.
std::map<Eigen::Index, JumpsInside> intervals_with_jumps(std::span<const double> jumps, double period,
                                                         Eigen::Index count) {
  std::map<Eigen::Index, JumpsInside> found;
  for (const double time : jumps) {
    const double place = time / period * static_cast<double>(count);
    const auto left = static_cast<Eigen::Index>(std::ceil(place)) - 1;
    const double inside = place - static_cast<double>(left);
    const auto [entry, is_new] = found.try_emplace((left + count) % count, JumpsInside{inside, inside});
    if (!is_new) entry->second.last = inside;
  }
  return found;
}

DisplacementSummary summary_of(const SampledDisplacement& sampled, const Extremes& range, int harmonics) {
  DisplacementSummary summary{.mean = sampled.x.mean(),
                              .min = range.min,
                              .max = range.max,
                              .amplitude = 0.5 * (range.max - range.min)};
  RealFft fft(static_cast<int>(sampled.x.size()));
  Eigen::VectorXcd spectrum(fft.coefficients());
  fft.forward(sampled.x, spectrum);
  for (int n = 1; n <= std::min<int>(harmonics, fft.coefficients() - 1); ++n) {
    summary.harmonics.push_back({.frequency = n * kTwoPi / sampled.period,
                                 .amplitude = 2.0 * std::abs(spectrum[n]),
                                 .phase = std::arg(spectrum[n])});
  }
  return summary;
}

/// Where velocities may jump: at impulses, and where a massless contact closes or opens.
std::vector<double> jump_times(const Motion& motion, const RepresentedLaw& law) {
  std::vector<double> times;
  for (const Impulse& impulse : motion.impulses) times.push_back(impulse.time);
  if (std::holds_alternative<Massless>(law) && motion.events) {
    for (const ContactEvent& event : *motion.events) times.push_back(event.time);
    std::ranges::sort(times);
  }
  return times;
}

/// Instants that show each listed contact by several samples, at most a quarter of a million: those of the
/// motion, or more of them.
int resolving_count(const Motion& motion, const RepresentedLaw& law) {
  constexpr double kSamples = 8.0;  // of the shortest contact
  constexpr int kMost = 1 << 18;
  int count = motion.count();
  if (!motion.events || std::holds_alternative<Undetermined>(law)) return count;
  double shortest = motion.period();
  for (const ListedContact& listed : listed_contacts(*motion.events, motion.period()))
    if (listed.end > listed.begin &&
        !std::holds_alternative<Restitution>(law_of_contact(law, listed.contact)))
      shortest = std::min(shortest, listed.end - listed.begin);
  while (count < kMost && shortest * count < kSamples * motion.period()) count *= 2;
  return count;
}

std::vector<DisplacementSummary> contact_displacements(const Trajectory& answer, const Motion& motion,
                                                       const RepresentedLaw& law, int harmonics) {
  std::vector<DisplacementSummary> all;
  const std::vector<double> jumps = jump_times(motion, law);
  const int resolving = resolving_count(motion, law);
  const Samples fine = resolving > motion.count() ? answer.sample(resolving) : Samples();
  const Eigen::MatrixXd nodal = answer.nodes() ? answer.sample(*answer.nodes()).x : Eigen::MatrixXd();
  for (Eigen::Index c = 0; c < motion.samples.x.cols(); ++c) {
    const SampledDisplacement sampled{motion.period(), motion.samples.x.col(c),
                                      motion.samples.velocity.col(c)};
    const Extremes range = answer.nodes() ? extremes({motion.period(), nodal.col(c), {}}, {})
                           : resolving > motion.count()
                               ? extremes({motion.period(), fine.x.col(c), fine.velocity.col(c)}, jumps)
                               : extremes(sampled, jumps);
    all.push_back(summary_of(sampled, range, std::min(harmonics, motion.bandwidth.value_or(harmonics))));
  }
  return all;
}

/// The coordinates asked for, or why there are none.
void take_coordinates(const Problem& problem, const Trajectory& answer, const Motion& motion,
                      const RepresentedLaw& law, const SummaryRequest& request, MotionSummary& summary) {
  if (request.dofs.empty()) return;
  try {
    const CoordinateMotion field(problem, answer, motion, request.dofs);
    const Eigen::MatrixXd u = field.displacement(motion.count()), v = field.velocity(motion.count());
    const std::vector<double> jumps = motion.bandwidth ? std::vector<double>() : jump_times(motion, law);
    for (std::size_t i = 0; i < request.dofs.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const SampledDisplacement sampled{motion.period(), u.col(column), v.col(column)};
      summary.u.push_back(summary_of(sampled, extremes(sampled, jumps), request.harmonics));
      summary.u.back().dof = request.dofs[i];
    }
  } catch (const std::runtime_error& error) {  // a harmonic at an undamped eigenfrequency
    summary.no_u = error.what();
  }
}

/// Contacts that the motion lists from closing to opening, with the integral of their force.
std::vector<PhaseSummary> listed_phases(const Motion& motion) {
  std::vector<PhaseSummary> phases;
  if (!motion.events) return phases;
  const double step = motion.step();
  for (const ListedContact& listed : listed_contacts(*motion.events, motion.period())) {
    PhaseSummary phase{.contact = listed.contact, .begin = listed.begin, .end = listed.end};
    if (const std::optional<double>& push = (*motion.events)[listed.opening].push) {
      phase.impulse = *push;
    } else {
      for (auto i = static_cast<int>(std::ceil(listed.begin / step)); i * step < listed.end; ++i)
        phase.impulse += step * motion.samples.force(i % motion.count(), listed.contact);
    }
    phases.push_back(phase);
  }
  return phases;
}

void take_contact(const RepresentedLaw& law, const Motion& motion, MotionSummary& summary) {
  const bool open = std::holds_alternative<Undetermined>(law);
  summary.contact_phases = listed_phases(motion);
  const auto listed = static_cast<std::ptrdiff_t>(summary.contact_phases.size());
  for (const ContactPhase& phase : contact_phases(motion)) {
    const bool compliant = !open && !std::holds_alternative<Restitution>(law_of_contact(law, phase.contact));
    if (phase.listed || !(phase.lasting || compliant)) {
      summary.impacts.push_back({.contact = phase.contact,
                                 .time = std::fmod(0.5 * (phase.begin + phase.end), motion.period()),
                                 .speed_before = phase.speed_before,
                                 .speed_after = phase.speed_after,
                                 .impulse = phase.impulse});
      continue;
    }
    const bool known = std::any_of(summary.contact_phases.begin(), summary.contact_phases.begin() + listed,
                                   [&](const PhaseSummary& one) { return one.contact == phase.contact; });
    if (!known)
      summary.contact_phases.push_back(
          {.contact = phase.contact, .begin = phase.begin, .end = phase.end, .impulse = phase.impulse});
  }
  std::ranges::stable_sort(summary.impacts, {}, &ImpactSummary::time);
  std::ranges::stable_sort(summary.contact_phases, {}, &PhaseSummary::begin);
}

}  // namespace

Extremes extremes(const SampledDisplacement& displacement, std::span<const double> jumps) {
  const Eigen::Index count = displacement.x.size();
  Extremes range{displacement.x.minCoeff(), displacement.x.maxCoeff()};
  if (displacement.velocity.size() == 0) return range;
  const auto take = [&range](double x) {
    range.min = std::min(range.min, x);
    range.max = std::max(range.max, x);
  };
  const std::map<Eigen::Index, JumpsInside> cut = intervals_with_jumps(jumps, displacement.period, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    if (cut.contains(i)) continue;
    const HermiteCubic cubic(displacement, i);
    if (cubic.turns) take(cubic.at(cubic.turning_point()));
  }
  for (const auto& [i, inside] : cut) {
    const Eigen::Index before = (i + count - 1) % count, after = (i + 1) % count;
    if (!cut.contains(before)) take(HermiteCubic(displacement, before).at(1.0 + inside.first));
    if (!cut.contains(after)) take(HermiteCubic(displacement, after).at(inside.last - 1.0));
  }
  return range;
}

MotionSummary summarise_motion(const Problem& problem, const RepresentedLaw& law, const Trajectory& answer,
                               const Motion& motion, const SummaryRequest& request) {
  MotionSummary summary;
  summary.x = contact_displacements(answer, motion, law, request.harmonics);
  take_coordinates(problem, answer, motion, law, request, summary);
  take_contact(law, motion, summary);
  return summary;
}

}  // namespace signorini
