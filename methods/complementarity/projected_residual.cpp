#include "methods/complementarity/projected_residual.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "methods/discretisation/fourier_series.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/solvers/constants.hpp"
#include "methods/structure/mean_balance.hpp"
#include "problems/linear_algebra/cholesky.hpp"
#include "problems/linear_algebra/lu.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

constexpr double kFelt = 1e-6;  // of x_f - g: a motion that a force of rounding must not cause

/// The runs of positive samples, each sample half a step to either side.
std::vector<ContactInterval> positive_runs(const Eigen::VectorXd& values) {
  const auto count = static_cast<int>(values.size());
  std::vector<ContactInterval> runs;
  for (int i = 0; i < count; ++i) {
    if (!(values[i] > 0.0) || values[(i + count - 1) % count] > 0.0) continue;
    int length = 1;
    while (values[(i + length) % count] > 0.0) ++length;
    runs.push_back({(i - 0.5) / count, (i + length - 0.5) / count});
  }
  if (runs.empty() && values[0] > 0.0) runs.push_back({0.0, 1.0});
  return runs;
}

/// max_n |B_n|: what a force of length 1 does to y at most.
double greatest_answer(const ContactSymbol& symbol) {
  double greatest = 0.0;
  for (int n = 0; n <= symbol.harmonics(); ++n) greatest = std::max(greatest, symbol.block(n).norm());
  return greatest;
}

/// Coefficients n = 0..count <= 2 N of the samples' indicator function, periodic in n.
Eigen::VectorXcd sampled_spectrum(const Eigen::VectorXd& values, int count) {
  const auto samples = static_cast<int>(values.size());
  RealFft fft(samples);
  Eigen::VectorXcd half(fft.coefficients());
  fft.forward((values.array() > 0.0).cast<double>().matrix(), half);
  Eigen::VectorXcd spectrum(count + 1);
  for (int n = 0; n <= count; ++n) {
    const int place = n % samples;
    spectrum[n] = 2 * place <= samples ? half[place] : std::conj(half[samples - place]);
  }
  return spectrum;
}

}  // namespace

ProjectedResidual::ProjectedResidual(const ProjectedEquations& equations, int samples, double tolerance,
                                     const StopShifts& shifts, ContactIntegral integral)
    : harmonics_(equations.receptance.harmonics()),
      samples_(samples),
      integral_(integral),
      symbol_(equations.receptance, equations.law),
      shifts_(shifts.empty() ? StopShifts(static_cast<std::size_t>(symbol_.contacts())) : shifts) {
  free_ = equations.receptance.free_response;
  free_.row(0) -= equations.gap.transpose();
  free_ = free_ * root().asDiagonal();
  if (equations.receptance.rigid_count() > 0) take_balance(equations);
  const double free = pack_harmonics(free_).norm();
  rounding_ = 16.0 * std::numeric_limits<double>::epsilon() * free;
  // With c far above the structure's stiffness a force of that size moves the mass: it must be met then. An
  // overflow makes the comparison false.
  if (greatest_answer(symbol_) * rounding_ <= kFelt * free) least_scale_ = rounding_ / tolerance;
}

Eigen::VectorXd ProjectedResidual::unknowns_of(const Eigen::MatrixXcd& force) const {
  return pack_harmonics(force * root().cwiseInverse().asDiagonal());
}

Eigen::MatrixXcd ProjectedResidual::force_of(const Eigen::VectorXd& lambda) const {
  return unpack_harmonics(lambda, harmonics_) * root().asDiagonal();
}

double ProjectedResidual::error(const Eigen::VectorXd& lambda, const Eigen::VectorXd& r) const {
  const double left = r.norm();
  return left == 0.0 ? 0.0 : left / std::max(lambda.norm(), least_scale_);
}

void ProjectedResidual::take_contacts(Eigen::Index contact, const Eigen::VectorXcd& y) {
  if (integral_ == ContactIntegral::exact) {
    const std::vector<StopShift>& shifts = shifts_[static_cast<std::size_t>(contact)];
    contacts_.push_back(positive_intervals(y, samples_, shifts, root()[contact]));
    indicators_.emplace_back(contacts_.back(), harmonics_);
    return;
  }
  Eigen::VectorXd values(samples_);
  RealFft(samples_).inverse(y, values);
  contacts_.push_back(positive_runs(values));
  indicators_.emplace_back(sampled_spectrum(values, 2 * harmonics_));
}

Eigen::VectorXd ProjectedResidual::residual(const Eigen::VectorXd& lambda) {
  const Eigen::MatrixXcd y = free_ + symbol_.rate(lambda);
  Eigen::MatrixXcd pressed(harmonics_ + 1, y.cols());
  contacts_.clear();
  indicators_.clear();
  for (Eigen::Index c = 0; c < y.cols(); ++c) {
    const std::vector<StopShift>& shifts = shifts_[static_cast<std::size_t>(c)];
    take_contacts(c, y.col(c));
    pressed.col(c) = indicators_.back().restrict(y.col(c));
    if (shifts.empty()) continue;
    for (const ContactInterval& interval : contacts_.back()) {
      pressed.col(c) += root()[c] * shift_spectrum(interval, shifts, harmonics_);
    }
  }
  Eigen::VectorXd result = lambda + pack_harmonics(pressed);
  for (Eigen::Index c = 0; c < balance_.size(); ++c) {
    const Eigen::Index place = c * (2 * harmonics_ + 1);
    result[place] += balance_[c];
    for (Eigen::Index d = 0; d < balance_.size(); ++d)
      result[place] -= share_.row(c).dot(along_.col(d)) * lambda[d * (2 * harmonics_ + 1)];
  }
  return result;
}

// Of mu (MeanBalance), (1 - P) mu_0 + lambda_b stands for lambda_0, in units of sqrt(c).
void ProjectedResidual::take_balance(const ProjectedEquations& equations) {
  const auto& [receptance, gap, law] = equations;
  const MeanBalance balance(receptance);
  balance_ = balance.force.cwiseQuotient(root());
  const Eigen::VectorXd still = receptance.receptance.front().real() * balance.force;
  free_.row(0) +=
      (root().cwiseProduct(still) - law.multiplier_weight.cwiseProduct(balance_)).transpose().cast<Complex>();
  share_ = root().cwiseInverse().asDiagonal() * receptance.rigid;
  const CholeskyFactors gram(receptance.rigid.transpose() * receptance.rigid);
  along_ = gram.solve(Eigen::MatrixXd(receptance.rigid.transpose() * root().asDiagonal()));
}

// J = J' - U V^T on the means, m columns: v = J'^{-1} (r + U s), s = V^T v.
KrylovSolve ProjectedResidual::with_balance(KrylovSolve plain, const JacobianSolver::Contacts& contacts) {
  const Eigen::Index stride = 2 * harmonics_ + 1, m = share_.cols();
  const auto means = [&](const Eigen::VectorXd& v) {
    Eigen::VectorXd result(balance_.size());
    for (Eigen::Index c = 0; c < result.size(); ++c) result[c] = v[c * stride];
    return result;
  };
  if (plain.x.size() == 0) return plain;
  Eigen::MatrixXd answers(plain.x.size(), m), matrix = Eigen::MatrixXd::Identity(m, m);
  for (Eigen::Index k = 0; k < m; ++k) {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(plain.x.size());
    for (Eigen::Index c = 0; c < balance_.size(); ++c) load[c * stride] = share_(c, k);
    const KrylovSolve answer = solver_.solve(symbol_, contacts, load);
    if (answer.x.size() == 0) return {};
    answers.col(k) = answer.x;
    matrix.col(k) -= along_ * means(answer.x);
  }
  // Nothing touches: every mean is as good.
  const LuFactors lu(matrix);
  const Eigen::VectorXd s = lu.solve(Eigen::VectorXd(along_ * means(plain.x)));
  if (!(lu.reciprocal_condition() > 0.0) || matrix.lpNorm<Eigen::Infinity>() < kMatrixRounding ||
      !s.allFinite())
    return {};
  plain.x += answers * s;
  return plain;
}

std::vector<ContactNodes> ProjectedResidual::nodes() const {
  std::vector<ContactNodes> nodes;
  for (const std::vector<ContactInterval>& intervals : contacts_) {
    nodes.push_back(integral_ == ContactIntegral::exact ? nodes_on(intervals, harmonics_)
                                                        : samples_on(intervals, samples_));
  }
  return nodes;
}

KrylovSolve ProjectedResidual::solve_jacobian(const Eigen::VectorXd& r) {
  JacobianSolver::Contacts contacts{.duty = Eigen::VectorXd(root().size()),
                                    .place = [this] { return nodes(); },
                                    .product = [this](const Eigen::VectorXd& v) { return product(v); },
                                    .matrix = {}};
  // Alternating between frequency and time forms no matrix.
  if (integral_ == ContactIntegral::exact) contacts.matrix = [this] { return pressed_jacobian(); };
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    contacts.duty[static_cast<Eigen::Index>(c)] = indicators_[c].duty();
    for (const ContactInterval& interval : contacts_[c]) {
      const double length = interval.end - interval.begin;
      contacts.nodes += integral_ == ContactIntegral::exact ? node_count(length, harmonics_)
                                                            : std::lround(length * samples_);
    }
  }
  KrylovSolve solved = solver_.solve(symbol_, contacts, r);
  return balance_.size() == 0 ? solved : with_balance(std::move(solved), contacts);
}

Eigen::MatrixXd ProjectedResidual::pressed_jacobian() const {
  const Eigen::Index stride = 2 * harmonics_ + 1;
  const Eigen::Index contacts = root().size();
  Eigen::MatrixXd matrix(stride * contacts, stride * contacts);
  for (Eigen::Index row = 0; row < contacts; ++row) {
    for (Eigen::Index column = 0; column < contacts; ++column) {
      fill_block(row, column, matrix.block(row * stride, column * stride, stride, stride));
    }
  }
  matrix.diagonal().array() += 1.0;
  return matrix;
}

Eigen::MatrixXd ProjectedResidual::jacobian() const {
  const Eigen::Index stride = 2 * harmonics_ + 1;
  Eigen::MatrixXd matrix = pressed_jacobian();
  for (Eigen::Index row = 0; row < balance_.size(); ++row)
    for (Eigen::Index column = 0; column < balance_.size(); ++column)
      matrix(row * stride, column * stride) -= share_.row(row).dot(along_.col(column));
  return matrix;
}

Eigen::MatrixXcd ProjectedResidual::pressed(const Eigen::MatrixXcd& s) const {
  Eigen::MatrixXcd signal(s.rows(), s.cols());
  for (Eigen::Index c = 0; c < s.cols(); ++c)
    signal.col(c) = indicators_[static_cast<std::size_t>(c)].restrict(s.col(c));
  return signal;
}

Eigen::VectorXd ProjectedResidual::product(const Eigen::VectorXd& v) const {
  return v + pack_harmonics(pressed(symbol_.rate(v)));
}

// What unit harmonics of one contact's lambda press at another one's samples in contact, in the packing
// of fourier_series.hpp: a cosine of harmonic m drives s_m = B_m / sqrt 2, and (chi s)_n =
// chi_{n-m} s_m + chi_{n+m} conj(s_m) is packed with a factor sqrt 2.
void ProjectedResidual::fill_block(Eigen::Index row, Eigen::Index column,
                                   Eigen::Ref<Eigen::MatrixXd> block) const {
  const Eigen::VectorXcd& chi = indicators_[static_cast<std::size_t>(row)].spectrum();
  for (Eigen::Index m = 0; m <= harmonics_; ++m) {
    const Complex b = symbol_.block(m)(row, column);
    for (int part = 0; part < (m == 0 ? 1 : 2); ++part) {
      const Complex s = part == 0 ? b : Complex(0.0, 1.0) * b;
      const Eigen::Index place = m == 0 ? 0 : 2 * m - 1 + part;
      for (Eigen::Index n = 0; n <= harmonics_; ++n) {
        const Complex below = n >= m ? chi[n - m] : std::conj(chi[m - n]);
        Complex pressed = m == 0 ? below * b.real() : below * s + chi[n + m] * std::conj(s);
        if (n == 0) {
          block(0, place) = pressed.real() * (m == 0 ? 1.0 : std::numbers::sqrt2 / 2.0);
          continue;
        }
        if (m == 0) pressed *= std::numbers::sqrt2;
        block(2 * n - 1, place) = pressed.real();
        block(2 * n, place) = pressed.imag();
      }
    }
  }
}

}  // namespace signorini
