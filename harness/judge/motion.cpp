#include "harness/judge/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "harness/records/sampled_trajectory.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

struct Difference {
  double squares = 0.0;
  double own_squares = 0.0;
  double largest = 0.0;
  double own_largest = 0.0;

  [[nodiscard]] std::optional<double> l2() const {
    if (own_squares == 0.0) return std::nullopt;
    return std::sqrt(squares / own_squares);
  }
  [[nodiscard]] std::optional<double> max() const {
    if (own_largest == 0.0) return std::nullopt;
    return largest / own_largest;
  }
};

Difference compare(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, Eigen::Index offset) {
  Difference gap;
  if (a.cols() == 0) return gap;
  const Eigen::Index common = std::lcm(a.rows(), b.rows());
  Eigen::Index i = 0;
  Eigen::Index j = offset % b.rows();
  // Block by block, so that neither motion wraps around within one: Eigen then vectorises the sums.
  for (Eigen::Index done = 0; done < common;) {
    const Eigen::Index block = std::min({a.rows() - i, b.rows() - j, common - done});
    const auto own = b.middleRows(j, block).array();
    const auto difference = a.middleRows(i, block).array() - own;
    gap.squares += difference.square().sum();
    gap.own_squares += own.square().sum();
    gap.largest = std::max(gap.largest, difference.abs().maxCoeff());
    gap.own_largest = std::max(gap.own_largest, own.abs().maxCoeff());
    done += block;
    i = (i + block) % a.rows();
    j = (j + block) % b.rows();
  }
  return gap;
}

/// Coefficients n = 0..count of the contact force, (count+1) x Nc, from no more instants than they need.
Eigen::MatrixXcd spectrum_of(const Motion& motion, int count) {
  if (const Eigen::MatrixXcd& own = motion.force_coefficients; own.size() > 0) {
    Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(count + 1, own.cols());
    const Eigen::Index common = std::min(result.rows(), own.rows());
    result.topRows(common) = own.topRows(common);
    return result;
  }
  const int step = std::max(1, motion.count() / samples_for_spectrum(count));
  if (step == 1 || motion.count() % step != 0)
    return force_spectrum(motion.samples.force, motion.impulses, motion.period(), count);
  return force_spectrum(motion.samples.force(Eigen::seqN(0, motion.count() / step, step), Eigen::all),
                        motion.impulses, motion.period(), count);
}

Eigen::Index per_period(const Motion& motion) { return motion.samples.x.rows() / motion.order; }

}  // namespace

Motion sample_motion(const Problem& problem, const Trajectory& trajectory, int per_period) {
  Motion motion;
  motion.forcing_period = problem.forcing_period();
  motion.order = std::max(1, static_cast<int>(std::lround(trajectory.period() / motion.forcing_period)));
  motion.samples = trajectory.sample(per_period * motion.order);
  motion.impulses = trajectory.impulses();
  motion.bandwidth = trajectory.bandwidth();
  motion.force_coefficients = trajectory.force_coefficients();
  return motion;
}

SampledAnswer sample_answer(const Problem& problem, const Trajectory& answer) {
  SampledAnswer sampled;
  sampled.defect = trajectory_defect(answer, problem.contact_count(), problem.forcing_period());
  if (!sampled.defect.empty()) return sampled;
  Motion motion = sample_motion(problem, answer);
  sampled.defect = samples_defect(motion.samples, kGrid * motion.order, problem.contact_count());
  if (sampled.defect.empty()) sampled.motion = std::move(motion);
  return sampled;
}

Motion thinned(const Motion& motion, int step) {
  const auto every = [&](const Eigen::MatrixXd& values) -> Eigen::MatrixXd {
    return values(Eigen::seqN(0, values.rows() / step, step), Eigen::all);
  };
  Motion result;
  result.order = motion.order;
  result.forcing_period = motion.forcing_period;
  result.samples = {every(motion.samples.x), every(motion.samples.velocity), every(motion.samples.force)};
  result.impulses = motion.impulses;
  result.bandwidth = motion.bandwidth;
  result.force_coefficients = motion.force_coefficients;
  return result;
}

ForceSeries force_series(const Problem& problem, const Motion& motion, int max_harmonics) {
  const int harmonics = std::max(std::min(motion.bandwidth.value_or(max_harmonics), max_harmonics),
                                 motion.order * highest_load_harmonic(problem));
  return {.order = motion.order,
          .base_frequency = kTwoPi / motion.period(),
          .lambda = spectrum_of(motion, harmonics)};
}

Eigen::VectorXd impulse_per_forcing_period(const Motion& motion) {
  return motion.forcing_period * spectrum_of(motion, 0).row(0).real().transpose();
}

Distance distance(const Motion& a, const Motion& b, int shift) {
  const Eigen::Index offset = shift * per_period(b);
  const Difference x = compare(a.samples.x, b.samples.x, offset);
  return {.x_l2 = x.l2(),
          .x_max = x.max(),
          .velocity_l2 = compare(a.samples.velocity, b.samples.velocity, offset).l2()};
}

int best_shift(const Motion& a, const Motion& b) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int shift = 0; shift < b.order; ++shift) {
    const Difference x = compare(a.samples.x, b.samples.x, shift * per_period(b));
    if (x.squares < least) {
      least = x.squares;
      best = shift;
    }
  }
  return best;
}

int least_order(const Motion& motion) {
  for (int order = 1; order < motion.order; ++order) {
    if (motion.order % order != 0) continue;
    const Difference x = compare(motion.samples.x, motion.samples.x, order * per_period(motion));
    if (x.squares <= kSameOrbit * kSameOrbit * x.own_squares) return order;
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
