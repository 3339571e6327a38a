#include "harness/summary/coordinate_motion.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "harness/judge/measures/contact_response.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "methods/discretisation/fourier_series.hpp"
#include "methods/solvers/constants.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/sparse_cholesky.hpp"

namespace signorini {

namespace {

/// The force of an answer at eight times the instants of the motion; at these where it has no more.
Eigen::MatrixXd fine_force(const Trajectory& answer, const Motion& motion) {
  const int instants = 8 * motion.count();
  const Samples fine = answer.sample(instants);
  return samples_defect(fine, instants, motion.samples.force.cols()).empty() ? fine.force
                                                                             : motion.samples.force;
}

constexpr double kPiSquared = kTwoPi * kTwoPi / 4.0;

/// Sums over n >= 1 at an angle in [0, 2 pi): Bernoulli's polynomials.
double sine_over_n(double angle) { return 0.5 * (0.5 * kTwoPi - angle); }
double cosine_over_n2(double angle) { return kPiSquared / 6.0 - kTwoPi * angle / 4.0 + angle * angle / 4.0; }
double sine_over_n3(double angle) {
  return angle * (kPiSquared / 6.0 - kTwoPi * angle / 8.0 + angle * angle / 12.0);
}

}  // namespace

CoordinateMotion::CoordinateMotion(const Problem& problem, const Trajectory& answer, const Motion& motion,
                                   std::span<const int> dofs)
    : base_frequency_(kTwoPi / motion.period()) {
  // A state at each instant costs little then.
  if (problem.size() <= 100) exact_ = ExactMotion::of(problem, answer);
  for (std::size_t i = 0; exact_ && i < dofs.size(); ++i) {
    if (!exact_->knows(dofs[i])) continue;
    dofs_.push_back(dofs[i]);
    columns_.push_back(static_cast<Eigen::Index>(i));
  }
  if (dofs_.size() == dofs.size())
    u_ = Eigen::MatrixXcd::Zero(1, std::ssize(dofs_));
  else
    respond(problem, answer, motion, dofs);
  for (const Eigen::Index column : columns_) {
    u_.col(column).setZero();
    for (Kick& kick : kicks_) kick.jump[column] = kick.retardation[column] = 0.0;
  }
  add_frame(problem, motion.order, dofs);
}

void CoordinateMotion::respond(const Problem& problem, const Trajectory& answer, const Motion& motion,
                               std::span<const int> dofs) {
  ForceSeries series = force_series(problem, motion, kMeasuredHarmonics * motion.order);
  const Eigen::Index harmonics = series.lambda.rows() - 1;
  // The coordinates are watched as contacts without a force.
  Problem watched = problem;
  for (const int dof : dofs) watched.contacts.push_back({.normal = {{dof, 1.0}}});
  const auto response = [&](const Eigen::MatrixXcd& lambda) -> Eigen::MatrixXcd {
    const auto count = static_cast<Eigen::Index>(dofs.size());
    series.lambda = lambda;
    series.lambda.conservativeResize(Eigen::NoChange, lambda.cols() + count);
    series.lambda.rightCols(count).setZero();
    const ContactResponse whole(watched, series);
    Eigen::MatrixXcd u = whole.coefficients().rightCols(count);
    if (whole.mean_is_free()) {  // what it is follows from the contacts
      const Eigen::VectorXd means = motion.samples.x.colwise().mean().transpose();
      const Eigen::VectorXd held = whole.coefficients().row(0).leftCols(means.size()).real().transpose();
      const Eigen::VectorXd offset = rigid_offset(problem, means - held);
      for (Eigen::Index i = 0; i < count; ++i) u(0, i) += offset[dofs[static_cast<std::size_t>(i)]];
    }
    return u;
  };
  if (motion.bandwidth) {
    u_ = response(series.lambda);
    return;
  }
  if (motion.force_coefficients.size() > 0) {
    u_ = response(series.lambda);
    error_ = 0.0;
  } else {
    const Eigen::MatrixXd force = fine_force(answer, motion);
    const auto spectrum = [&](const Eigen::MatrixXd& samples) {
      return force_spectrum(samples, motion.impulses, motion.period(), static_cast<int>(harmonics));
    };
    u_ = response(spectrum(force));
    // What half the instants make of it is farther off, twice at least.
    const Eigen::MatrixXcd coarse =
        response(spectrum(force(Eigen::seqN(0, force.rows() / 2, 2), Eigen::all)));
    error_ = 2.0 * (coarse - u_).cwiseAbs().colwise().sum().maxCoeff();
  }
  take_out_kicks(problem, motion, dofs);
  // The largest of the last harmonics tells how small those are that are left out.
  const Eigen::Index last = std::min<Eigen::Index>(16, harmonics);
  *error_ += static_cast<double>(harmonics) * u_.bottomRows(last).cwiseAbs().maxCoeff();
}

void CoordinateMotion::take_out_kicks(const Problem& problem, const Motion& motion,
                                      std::span<const int> dofs) {
  if (motion.impulses.empty() || !is_definite(problem.mass())) return;
  const Eigen::MatrixXd jumps = velocity_jumps(problem);
  const Eigen::MatrixXd retardations =
      SparseCholesky(problem.mass()).solve(Eigen::MatrixXd(problem.damping() * jumps));
  const std::vector<int> rows(dofs.begin(), dofs.end());
  for (const Impulse& impulse : motion.impulses) {
    kicks_.push_back({.turn = impulse.time / motion.period(),
                      .jump = impulse.value * jumps(rows, impulse.contact),
                      .retardation = impulse.value * retardations(rows, impulse.contact)});
    take_out(kicks_.back());
  }
}

void CoordinateMotion::add_frame(const Problem& problem, int order, std::span<const int> dofs) {
  for (const FrameTerm& term : problem.frame) {
    const Eigen::Index n = static_cast<Eigen::Index>(term.harmonic) * order;
    if (n >= u_.rows()) {
      const Eigen::Index known = u_.rows();
      u_.conservativeResize(n + 1, Eigen::NoChange);
      u_.bottomRows(n + 1 - known).setZero();
    }
    for (std::size_t column = 0; column < dofs.size(); ++column)
      if (dofs[column] == term.dof)
        u_(n, static_cast<Eigen::Index>(column)) += std::complex<double>(0.5 * term.cos, -0.5 * term.sin);
  }
}

void CoordinateMotion::take_out(const Kick& kick) {
  const std::complex<double> i(0.0, 1.0);
  const double period = kTwoPi / base_frequency_;
  for (Eigen::Index n = 1; n < u_.rows(); ++n) {
    const double w = static_cast<double>(n) * base_frequency_;
    const std::complex<double> late = std::polar(1.0 / period, -kTwoPi * static_cast<double>(n) * kick.turn);
    u_.row(n) += late * (kick.jump / (w * w) + i * kick.retardation / (w * w * w)).transpose();
  }
}

template <class Add>
void CoordinateMotion::add_kicks(Eigen::MatrixXd& values, const Add& add) const {
  for (const Kick& kick : kicks_) {
    for (Eigen::Index k = 0; k < values.rows(); ++k) {
      const double turn = static_cast<double>(k) / static_cast<double>(values.rows()) - kick.turn;
      values.row(k) += add(kick, kTwoPi * (turn - std::floor(turn))).transpose();
    }
  }
}

Eigen::MatrixXd CoordinateMotion::displacement(int count) const {
  Eigen::MatrixXd values = sample_series(u_, count);
  if (exact_) values(Eigen::all, columns_) += exact_->coordinates(dofs_, count).u;
  // 2 / (T w^2) = 1 / (pi w)
  const double second = -2.0 / (kTwoPi * base_frequency_), third = -second / base_frequency_;
  add_kicks(values, [&](const Kick& kick, double angle) -> Eigen::VectorXd {
    return second * cosine_over_n2(angle) * kick.jump + third * sine_over_n3(angle) * kick.retardation;
  });
  return values;
}

Eigen::MatrixXd CoordinateMotion::velocity(int count) const {
  Eigen::MatrixXcd rate = u_;
  for (Eigen::Index n = 0; n < rate.rows(); ++n)
    rate.row(n) *= std::complex<double>(0.0, static_cast<double>(n) * base_frequency_);
  Eigen::MatrixXd values = sample_series(rate, count);
  if (exact_) values(Eigen::all, columns_) += exact_->coordinates(dofs_, count).v;
  const double first = 2.0 / kTwoPi, second = first / base_frequency_;
  add_kicks(values, [&](const Kick& kick, double angle) -> Eigen::VectorXd {
    return first * sine_over_n(angle) * kick.jump + second * cosine_over_n2(angle) * kick.retardation;
  });
  return values;
}

}  // namespace signorini
