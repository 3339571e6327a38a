#include "harness/summary/coordinate_motion.hpp"

#include <cmath>
#include <complex>
#include <vector>

#include "harness/judge/measures/contact_response.hpp"
#include "methods/discretisation/fourier_series.hpp"
#include "methods/solvers/constants.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/sparse_cholesky.hpp"

namespace signorini {

namespace {

/// Harmonics of the load of a motion without a bandwidth of its own.
constexpr int kCoordinateHarmonics = 512;

constexpr double kPiSquared = kTwoPi * kTwoPi / 4.0;

/// Sums over n >= 1 at an angle in [0, 2 pi): Bernoulli's polynomials.
double sine_over_n(double angle) { return 0.5 * (0.5 * kTwoPi - angle); }
double cosine_over_n2(double angle) { return kPiSquared / 6.0 - kTwoPi * angle / 4.0 + angle * angle / 4.0; }
double sine_over_n3(double angle) {
  return angle * (kPiSquared / 6.0 - kTwoPi * angle / 8.0 + angle * angle / 12.0);
}

}  // namespace

CoordinateMotion::CoordinateMotion(const Problem& problem, const Motion& motion, std::span<const int> dofs)
    : base_frequency_(kTwoPi / motion.period()) {
  ForceSeries series = force_series(problem, motion, kCoordinateHarmonics * motion.order);
  // The coordinates are watched as contacts without a force.
  Problem watched = problem;
  for (const int dof : dofs) watched.contacts.push_back({.normal = {{dof, 1.0}}});
  const auto count = static_cast<Eigen::Index>(dofs.size());
  series.lambda.conservativeResize(Eigen::NoChange, series.lambda.cols() + count);
  series.lambda.rightCols(count).setZero();
  u_ = ContactResponse(watched, std::move(series)).coefficients().rightCols(count);
  add_frame(problem, motion.order, dofs);
  if (motion.bandwidth || motion.impulses.empty() || !is_definite(problem.mass())) return;
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
  const double first = 2.0 / kTwoPi, second = first / base_frequency_;
  add_kicks(values, [&](const Kick& kick, double angle) -> Eigen::VectorXd {
    return first * sine_over_n(angle) * kick.jump + second * cosine_over_n2(angle) * kick.retardation;
  });
  return values;
}

}  // namespace signorini
