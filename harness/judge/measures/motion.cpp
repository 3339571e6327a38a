#include "harness/judge/measures/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "harness/judge/measures/contact_response.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "methods/discretisation/contact_phases.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

/// Share of the scale of the scene (`scene_length`) that is the unit of a motion at rest.
constexpr double kLeastSize = 0.1;
/// Share of that unit below which a motion rests.
constexpr double kAtRest = 1e-8;
/// Share of the unit of all contacts that the unit of one is at least.
constexpr double kLeastContact = 0.01;

/// The size of what varies: values less the mean of their column.
struct Size {
  explicit Size(const Eigen::MatrixXd& values) {
    if (values.size() == 0) return;
    const auto varying = (values.rowwise() - values.colwise().mean()).array().abs();
    of_contact = varying.square().colwise().mean();
    mean_square = of_contact.mean();
    largest = varying.maxCoeff();
    round_off = kRoundOff * values.cwiseAbs().maxCoeff();
  }

  double mean_square = 0.0, largest = 0.0, round_off = 0.0;
  Eigen::ArrayXd of_contact;  // mean squares
};

struct Difference {
  [[nodiscard]] double mean_square() const { return of_contact.size() == 0 ? 0.0 : of_contact.mean(); }

  Eigen::ArrayXd of_contact;  // mean squares
  double largest = 0.0;
};

Difference difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, Eigen::Index offset) {
  Difference gap{.of_contact = Eigen::ArrayXd::Zero(a.cols())};
  if (a.cols() == 0) return gap;
  const Eigen::Index common = std::lcm(a.rows(), b.rows());
  Eigen::Index i = 0;
  Eigen::Index j = offset % b.rows();
  // Block by block, so that neither motion wraps around within one: Eigen then vectorises the sums.
  for (Eigen::Index done = 0; done < common;) {
    const Eigen::Index block = std::min({a.rows() - i, b.rows() - j, common - done});
    const auto apart = a.middleRows(i, block).array() - b.middleRows(j, block).array();
    gap.of_contact += apart.square().colwise().sum().transpose();
    gap.largest = std::max(gap.largest, apart.abs().maxCoeff());
    done += block;
    i = (i + block) % a.rows();
    j = (j + block) % b.rows();
  }
  gap.of_contact /= static_cast<double>(common);
  return gap;
}

std::optional<double> in_units_of(double unit, double value) {
  return unit > 0.0 ? std::optional(value / unit) : std::nullopt;
}

/// Coefficients n = 0..count of the contact force, (count+1) x Nc, from no more instants than they need.
Eigen::MatrixXcd sampled_spectrum(const Motion& motion, int count) {
  const int enough = std::max(samples_for_spectrum(count), motion.nodes.value_or(0));
  const int step = std::max(1, motion.count() / enough);
  if (step == 1 || motion.count() % step != 0)
    return force_spectrum(motion.samples.force, motion.impulses, motion.period(), count);
  return force_spectrum(motion.samples.force(Eigen::seqN(0, motion.count() / step, step), Eigen::all),
                        motion.impulses, motion.period(), count);
}

/// Root mean square about the mean; 0 where there is no such motion, or nothing but rounding moves.
double varying_size(const std::optional<Eigen::MatrixXd>& motion) {
  if (!motion) return 0.0;
  const Size size(*motion);
  const double moving = std::sqrt(size.mean_square);
  return moving > size.round_off ? moving : 0.0;
}

/// How far the load would move the contacts against their stiffness scale, the largest; else the largest gap.
double pressed_length(const Problem& problem) {
  const SparseMatrix W = contact_directions(problem);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(problem.contact_count());
  for (int n = 0; n <= highest_load_harmonic(problem); ++n)
    load += (W.transpose() * load_harmonic(problem, n)).cwiseAbs();
  const double pressed = load.cwiseQuotient(contact_stiffness_scale(problem)).maxCoeff();
  return pressed > 0.0 ? pressed : contact_gaps(problem).cwiseAbs().maxCoeff();
}

/// The scale of lengths of `least_size`. Near resonance the contact-free motion is as large as damping lets
/// it be, and no measure of a motion between stops: hence the room.
double scene_length(const Problem& problem, const ContactSpace* space) {
  constexpr int kInstants = 512;
  if (problem.contacts.empty()) return 0.0;
  if (const auto free = contact_free_motion(problem, kInstants, space)) {
    const double room = (contact_gaps(problem) - free->colwise().mean().transpose()).cwiseAbs().maxCoeff();
    const double size = std::min(varying_size(free), room);
    if (size > 0.0) return size;
  }
  Problem without_mean = problem;
  std::erase_if(without_mean.force, [](const ForceTerm& term) { return term.harmonic == 0; });
  const double size = varying_size(contact_free_motion(without_mean, kInstants, nullptr));
  return size > 0.0 ? size : pressed_length(problem);
}

/// Harmonics of samples that leave out no more than a share of their size.
int harmonics_within(double left_out, const Eigen::MatrixXd& samples) {
  RealFft fft(static_cast<int>(samples.rows()));
  Eigen::VectorXcd spectrum(fft.coefficients());
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(spectrum.size());
  for (const auto& column : samples.colwise()) {
    fft.forward(column, spectrum);
    squares += spectrum.cwiseAbs2();
  }
  squares[0] *= 0.5;
  const double most = left_out * left_out * squares.sum();
  Eigen::Index last = squares.size() - 1;
  for (double beyond = 0.0; last > 0 && (beyond += squares[last]) <= most;) --last;
  return static_cast<int>(last);
}

/// Motion::shown.
int shown_harmonics(const Motion& motion) {
  constexpr double kLeftOut = 1e-4;
  const Eigen::MatrixXd& x = motion.samples.x;
  return std::max(harmonics_within(kLeftOut, x.rowwise() - x.colwise().mean()),
                  harmonics_of_force(motion).value_or(0));
}

// `count` instants of a motion. Where it is a grid of more nodes than that, an instant has the impulse of the
// nodes nearest to it: each pushes for period / nodes, and most of them are no instants.
Samples samples_with_impulse(const Trajectory& trajectory, int count) {
  Samples samples = trajectory.sample(count);
  const int nodes = trajectory.nodes().value_or(0);
  if (nodes <= count) return samples;
  const Eigen::MatrixXd force = trajectory.sample(nodes).force;
  if (force.rows() != nodes || samples.force.rows() != count || force.cols() != samples.force.cols())
    return {};  // which samples_defect() names
  samples.force.setZero();
  for (int k = 0; k < nodes; ++k) {
    const long nearest = std::lround(static_cast<double>(k) * count / nodes);
    samples.force.row(nearest % count) += force.row(k) * (static_cast<double>(count) / nodes);
  }
  return samples;
}

}  // namespace

Motion sample_motion(const Problem& problem, const Trajectory& trajectory, int per_period) {
  Motion motion;
  motion.forcing_period = problem.forcing_period();
  motion.order = std::max(1, static_cast<int>(std::lround(trajectory.period() / motion.forcing_period)));
  motion.samples = samples_with_impulse(trajectory, per_period * motion.order);
  motion.impulses = trajectory.impulses();
  motion.events = trajectory.events();
  motion.nodes = trajectory.nodes();
  motion.bandwidth = trajectory.bandwidth();
  motion.force_coefficients = trajectory.force_coefficients();
  motion.integrated = is_integrated(trajectory);
  if (const auto exact = ExactMotion::of(problem, trajectory)) {
    motion.speeds = exact->speeds_beside_impulses();
    if (per_period == kGrid)
      motion.force_coefficients = exact->force_coefficients(kMeasuredHarmonics * motion.order);
  }
  return motion;
}

double least_size(const Problem& problem, const ContactSpace* space) {
  return kLeastSize * scene_length(problem, space);
}

SampledAnswer check_answer(const Problem& problem, const Trajectory& answer) {
  SampledAnswer sampled;
  sampled.defect = trajectory_defect(answer, problem.contact_count(), problem.forcing_period());
  if (!sampled.defect.empty()) return sampled;
  Motion motion = sample_motion(problem, answer);
  sampled.defect = samples_defect(motion.samples, kGrid * motion.order, problem.contact_count());
  if (!sampled.defect.empty()) return sampled;
  if (motion.bandwidth && !motion.nodes) motion.shown = shown_harmonics(motion);
  sampled.motion = std::move(motion);
  return sampled;
}

SampledAnswer sample_answer(const Problem& problem, const Trajectory& answer) {
  SampledAnswer sampled = check_answer(problem, answer);
  if (sampled.defect.empty()) sampled.motion.least = least_size(problem);
  return sampled;
}

std::optional<int> harmonics_of_force(const Motion& motion) {
  constexpr double kLeftOut = 0.5;
  if (!motion.bandwidth || motion.nodes || motion.force_coefficients.size() > 0) return std::nullopt;
  return harmonics_within(kLeftOut, motion.samples.force);
}

std::optional<int> resolved_harmonics(const Motion& motion) {
  return motion.bandwidth ? std::optional(std::max(*motion.bandwidth, motion.shown)) : std::nullopt;
}

// From no more instants than the coefficients need.
Eigen::MatrixXcd contact_force_spectrum(const Motion& motion, int count) {
  if (const Eigen::MatrixXcd& own = motion.force_coefficients; own.size() > 0) {
    Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(count + 1, own.cols());
    const Eigen::Index common = std::min(result.rows(), own.rows());
    result.topRows(common) = own.topRows(common);
    return result;
  }
  return sampled_spectrum(motion, count);
}

ForceSeries force_series(const Problem& problem, const Motion& motion, int max_harmonics) {
  const int harmonics = std::max(std::min(resolved_harmonics(motion).value_or(max_harmonics), max_harmonics),
                                 motion.order * highest_load_harmonic(problem));
  return {.order = motion.order,
          .base_frequency = kTwoPi / motion.period(),
          .lambda = contact_force_spectrum(motion, harmonics)};
}

std::vector<ListedPush> short_pushes(const Motion& motion, int contact) {
  constexpr double kResolved = 256.0, kSeen = 16.0;  // steps
  constexpr double kAgrees = 0.1;
  if (!motion.events) return {};
  const double step = motion.step();
  std::vector<ListedPush> pushes;
  bool all_resolved = true;
  for (const ListedContact& listed : listed_contacts(*motion.events, motion.period())) {
    if (listed.contact != contact) continue;
    const std::optional<double>& push = (*motion.events)[listed.opening].push;
    if (!push) return {};
    const double steps = (listed.end - listed.begin) / step;
    double sampled = 0.0;
    for (auto i = static_cast<int>(std::ceil(listed.begin / step)); i * step < listed.end; ++i)
      sampled += step * motion.samples.force(i % motion.count(), contact);
    if (steps >= kSeen && std::abs(sampled - *push) > kAgrees * std::abs(*push)) return {};
    all_resolved = all_resolved && steps >= kResolved;
    pushes.push_back({listed.begin, listed.end, *push});
  }
  const auto openings = std::ranges::count_if(*motion.events, [&](const ContactEvent& event) {
    return event.contact == contact && event.kind == ContactEvent::Kind::open;
  });
  return all_resolved || std::ssize(pushes) != openings ? std::vector<ListedPush>() : pushes;
}

Eigen::VectorXd impulse_per_forcing_period(const Motion& motion) {
  // Of orbits by their samples, as those that are kept have nothing else: fingerprints are of these digits.
  const Eigen::MatrixXcd mean =
      motion.integrated ? sampled_spectrum(motion, 0) : contact_force_spectrum(motion, 0);
  Eigen::VectorXd impulse = motion.forcing_period * mean.row(0).real().transpose();
  for (int c = 0; c < static_cast<int>(impulse.size()); ++c) {
    const std::vector<ListedPush> pushes = short_pushes(motion, c);
    if (pushes.empty()) continue;
    impulse[c] = 0.0;
    for (const ListedPush& push : pushes) impulse[c] += push.impulse / motion.order;
    for (const Impulse& one : motion.impulses)
      impulse[c] += one.contact == c ? one.value / motion.order : 0.0;
  }
  return impulse;
}

Distance distance(const Motion& a, const Motion& b, int shift) {
  const Eigen::Index offset = shift * b.per_period();
  const double least = std::max(a.least, b.least);
  const Size x(b.samples.x), velocity(b.samples.velocity);
  const double moving = std::sqrt(x.mean_square), at_rest = std::max(least, x.round_off);
  const bool rests = moving <= std::max(kAtRest * least, x.round_off);
  const double unit = rests ? at_rest : moving;
  // A sinusoid of this root mean square is sqrt(2) as large.
  const double unit_of_largest = rests ? std::max(std::numbers::sqrt2 * least, x.round_off) : x.largest;
  const double unit_of_speed = rests ? kTwoPi / b.forcing_period * at_rest : std::sqrt(velocity.mean_square);
  const Difference apart = difference(a.samples.x, b.samples.x, offset);
  double worst = 0.0;
  for (Eigen::Index c = 0; unit > 0.0 && c < apart.of_contact.size(); ++c) {
    const double own = std::sqrt(x.of_contact[c]);
    const bool stays = rests || own <= std::max(kAtRest * unit, x.round_off);
    const double measure = stays ? unit : std::max(own, kLeastContact * unit);
    worst = std::max(worst, std::sqrt(apart.of_contact[c]) / measure);
  }
  const bool functions = a.impulses.empty() && b.impulses.empty() && b.samples.force.size() > 0;
  return {
      .x_l2 = in_units_of(unit, std::sqrt(apart.mean_square())),
      .x_worst = in_units_of(unit, unit * worst),
      .x_max = in_units_of(unit_of_largest, apart.largest),
      .velocity_l2 = in_units_of(
          unit_of_speed, std::sqrt(difference(a.samples.velocity, b.samples.velocity, offset).mean_square())),
      .force_l2 =
          functions
              ? in_units_of(std::sqrt(b.samples.force.array().square().mean()),
                            std::sqrt(difference(a.samples.force, b.samples.force, offset).mean_square()))
              : std::nullopt};
}

int best_shift(const Motion& a, const Motion& b) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int shift = 0; shift < b.order; ++shift) {
    const double apart = difference(a.samples.x, b.samples.x, shift * b.per_period()).mean_square();
    if (apart < least) {
      least = apart;
      best = shift;
    }
  }
  return best;
}

int least_order(const Motion& motion) {
  for (int order = 1; order < motion.order; ++order) {
    if (motion.order % order != 0) continue;
    if (distance(motion, motion, order).x_l2.value_or(0.0) <= kSameOrbit) return order;
  }
  return motion.order;
}

double amplitude(const Motion& motion) {
  double largest = 0.0;
  for (const auto& x : motion.samples.x.colwise())
    largest = std::max(largest, 0.5 * (x.maxCoeff() - x.minCoeff()));
  return largest;
}

}  // namespace signorini
