#include "methods/structure/periodic_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "methods/discretisation/real_fft.hpp"
#include "methods/solvers/constants.hpp"
#include "methods/structure/receptance.hpp"
#include "methods/structure/rigid_motions.hpp"
#include "problems/linear_algebra/orthogonal.hpp"

namespace signorini {

namespace {

/// Forcing periods in the trajectory's period.
int forcing_periods(const Problem& problem, double period) {
  const int periods = whole_periods(period, problem.forcing_period());
  if (periods == 0) {
    throw std::invalid_argument(
        fmt::format("trajectory.period = {} (must be a multiple of the forcing period {})", period,
                    problem.forcing_period()));
  }
  return periods;
}

}  // namespace

Eigen::MatrixXcd force_spectrum(const Trajectory& trajectory, int count) {
  if (const Eigen::MatrixXcd own = trajectory.force_coefficients(); own.size() > 0) {
    Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(count + 1, own.cols());
    const Eigen::Index common = std::min(result.rows(), own.rows());
    result.topRows(common) = own.topRows(common);
    return result;
  }
  // Between the nodes of a grid the force is a straight line: fewer instants than nodes would pass some by.
  const int instants = std::max(samples_for_spectrum(count), trajectory.nodes().value_or(0));
  return force_spectrum(trajectory.sample(instants).force, trajectory.impulses(), trajectory.period(), count);
}

int samples_for_spectrum(int count) {
  // At 16 samples per harmonic the aliasing of a force with jumps stays below one part in a hundred of
  // the coefficient at the highest harmonic, and far below that at low ones.
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(4096, 16 * count))));
}

Eigen::MatrixXcd force_spectrum(const Eigen::MatrixXd& force, const std::vector<Impulse>& impulses,
                                double period, int count) {
  RealFft fft(static_cast<int>(force.rows()));
  Eigen::VectorXcd spectrum(fft.coefficients());
  const Eigen::Index known = std::min<Eigen::Index>(count + 1, spectrum.size());
  Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(count + 1, force.cols());
  for (Eigen::Index c = 0; c < force.cols(); ++c) {
    fft.forward(force.col(c), spectrum);
    result.col(c).head(known) = spectrum.head(known);
  }
  for (const Impulse& impulse : impulses) {
    for (int n = 0; n <= count; ++n) {
      result(n, impulse.contact) +=
          impulse.value / period * std::polar(1.0, -kTwoPi * n * impulse.time / period);
    }
  }
  return result;
}

ForceSeries force_series(const Problem& problem, const Trajectory& trajectory, int max_harmonics) {
  ForceSeries series;
  series.order = forcing_periods(problem, trajectory.period());
  series.base_frequency = kTwoPi / trajectory.period();
  const int harmonics = std::max(std::min(trajectory.bandwidth().value_or(max_harmonics), max_harmonics),
                                 series.order * highest_load_harmonic(problem));
  series.lambda = force_spectrum(trajectory, harmonics);
  return series;
}

Eigen::VectorXd pressure_samples(const Trajectory& trajectory, int count, const Eigen::VectorXd& unit) {
  const Samples motion = trajectory.sample(count);
  Eigen::VectorXd pressure(count * unit.size());
  for (Eigen::Index c = 0; c < unit.size(); ++c)
    pressure.segment(c * count, count) = (-motion.force.col(c) / unit[c]).cwiseMax(0.0);
  const double step = trajectory.period() / count;
  for (const Impulse& impulse : trajectory.impulses()) {
    const int nearest = static_cast<int>(std::lround(impulse.time / step)) % count;
    pressure[impulse.contact * count + nearest] -= impulse.value / step / unit[impulse.contact];
  }
  return pressure;
}

PeriodicResponse::PeriodicResponse(const Problem& problem, const Trajectory& trajectory, int max_harmonics)
    : PeriodicResponse(problem, force_series(problem, trajectory, max_harmonics)) {
  if (free_.cols() == 0) return;
  const Samples motion = trajectory.sample(samples_for_spectrum(0));
  const SparseMatrix directions = contact_directions(problem);
  const Eigen::VectorXd missed = motion.x.colwise().mean().transpose() -
                                 directions.transpose() * Eigen::VectorXd(u_.row(0).real().transpose());
  const Eigen::MatrixXd felt = directions.transpose() * free_;
  u_.row(0) += (free_ * least_norm_solve(felt, missed)).transpose().cast<std::complex<double>>();
}

PeriodicResponse::PeriodicResponse(const Problem& problem, const ForceSeries& series) {
  base_frequency_ = series.base_frequency;
  u_.resize(series.lambda.rows(), problem.size());
  const SparseMatrix directions = contact_directions(problem);
  DynamicStiffness stiffness(problem);
  for (int n = 0; n < static_cast<int>(u_.rows()); ++n) {
    Eigen::VectorXcd rhs = directions * series.lambda.row(n).transpose();
    if (n % series.order == 0) rhs += (n == 0 ? 1.0 : 0.5) * load_harmonic(problem, n / series.order);
    try {
      stiffness.factorise(exact_weights(n * base_frequency_));
      u_.row(n) = stiffness.solve(rhs).transpose();
    } catch (const SingularStiffness&) {
      if (n == 0) free_ = rigid_motions(problem);
      if (n > 0 || free_.cols() == 0) throw;
      const HeldStructure held(problem, free_, base_frequency_);
      u_.row(0) = held.solve(rhs.real()).transpose().cast<std::complex<double>>();
    }
  }
}

State PeriodicResponse::at(double time) const {
  State state{u_.row(0).real().transpose(), Eigen::VectorXd::Zero(u_.cols())};
  for (Eigen::Index n = 1; n < u_.rows(); ++n) {
    const double w = static_cast<double>(n) * base_frequency_;
    const std::complex<double> phase = 2.0 * std::polar(1.0, w * time);
    state.u += (phase * u_.row(n)).real().transpose();
    state.v += (std::complex<double>(0.0, w) * phase * u_.row(n)).real().transpose();
  }
  return state;
}

Eigen::MatrixXd PeriodicResponse::displacement(int count) const { return sample_series(u_, count); }

}  // namespace signorini
