#include "methods/complementarity/exact_quadrature.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "methods/complementarity/contact_symbol.hpp"
#include "methods/discretisation/harmonic_vector.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/discretisation/trigonometric_jet.hpp"
#include "methods/solvers/condition_estimate.hpp"
#include "methods/solvers/constants.hpp"
#include "methods/solvers/gmres.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

/// The zero of `function` (value and derivative at t) in [left, right], where it rises or falls through
/// zero: Newton kept inside a shrinking bracket.
template <class Function>
double polish_root(const Function& function, double left, double right, bool rising) {
  double t = 0.5 * (left + right);
  for (int k = 0; k < 60; ++k) {
    const auto [value, slope] = function(t);
    ((value > 0.0) == rising ? right : left) = t;
    double next = t - value / slope;
    if (!(next > left && next < right)) next = 0.5 * (left + right);
    if (std::abs(next - t) <= 4.0 * std::numeric_limits<double>::epsilon()) return next;
    t = next;
  }
  return t;
}

/// An instant at which the sign of y is known.
struct Sign {
  double t = 0.0;
  bool positive = false;
};

/// A polynomial raised by what a shifted stop adds to it.
struct RaisedPolynomial {
  const Eigen::VectorXcd& y;
  const std::vector<StopShift>& shifts;
  double scale = 1.0;

  [[nodiscard]] Jet at(double t) const {
    Jet jet = trigonometric_jet(y, t);
    if (shifts.empty()) return jet;
    const StopShift shift = shift_at(shifts, t);
    jet.value += scale * shift.at(t);
    jet.slope += scale * shift.speed;
    return jet;
  }
};

/// Signs at the samples, and at each extremum between samples of one sign that reaches over to the other.
std::vector<Sign> signs_of(const RaisedPolynomial& y, const Eigen::VectorXd& values) {
  const auto samples = static_cast<int>(values.size());
  std::vector<Sign> signs;
  signs.reserve(static_cast<std::size_t>(samples) + 8);
  for (int i = 0; i < samples; ++i) signs.push_back({static_cast<double>(i) / samples, values[i] > 0.0});
  for (int i = 0; i < samples; ++i) {
    const double before = values[(i + samples - 1) % samples];
    const double after = values[(i + 1) % samples];
    const double side = values[i] > 0.0 ? -1.0 : 1.0;  // the extremum looked for: a minimum or a maximum
    if (side * (values[i] - before) < 0.0 || side * (values[i] - after) < 0.0) continue;
    // The parabola through three samples rises this far above the middle one; twice that is safe.
    const double bend = 0.5 * std::abs(after - 2.0 * values[i] + before);
    if (bend == 0.0 || std::abs(values[i]) > 0.5 * bend) continue;
    const double left = (i - 1.0) / samples;
    const double right = (i + 1.0) / samples;
    const auto slope = [&](double t) {
      const Jet jet = y.at(t);
      return std::pair{jet.slope, jet.curvature};
    };
    const double extremum = polish_root(slope, left, right, side < 0.0);
    if (side * y.at(extremum).value > 0.0) {
      signs.push_back({extremum - std::floor(extremum), side > 0.0});
    }
  }
  if (static_cast<int>(signs.size()) > samples)
    std::sort(signs.begin(), signs.end(), [](const Sign& a, const Sign& b) { return a.t < b.t; });
  return signs;
}

class ExactResidual {
 public:
  ExactResidual(const ContactReceptance& receptance, const Eigen::VectorXd& gap, const ProjectedLaw& law,
                int samples, const StopShifts& shifts)
      : harmonics_(receptance.harmonics()),
        samples_(samples),
        symbol_(receptance, law),
        shifts_(shifts.empty() ? StopShifts(static_cast<std::size_t>(receptance.contacts())) : shifts) {
    free_ = receptance.free_response;
    free_.row(0) -= gap.transpose();
    free_ = free_ * root().asDiagonal();
    scale_ = pack_harmonics(free_).norm();
  }

  [[nodiscard]] const Eigen::VectorXd& root() const { return symbol_.root(); }
  [[nodiscard]] double load_scale() const { return scale_; }

  /// R at lambda (scaled by sqrt(c)); keeps the contact intervals for `product`.
  Eigen::VectorXd operator()(const Eigen::VectorXd& lambda) {
    const Eigen::MatrixXcd y = free_ + symbol_.rate(lambda);
    Eigen::MatrixXcd pressed(harmonics_ + 1, y.cols());
    indicators_.clear();
    for (Eigen::Index c = 0; c < y.cols(); ++c) {
      const std::vector<StopShift>& shifts = shifts_[static_cast<std::size_t>(c)];
      const auto intervals = positive_intervals(y.col(c), samples_, shifts, root()[c]);
      indicators_.emplace_back(intervals, harmonics_);
      pressed.col(c) = indicators_.back().restrict(y.col(c));
      if (shifts.empty()) continue;
      for (const ContactInterval& interval : intervals) {
        pressed.col(c) += root()[c] * shift_spectrum(interval, shifts, harmonics_);
      }
    }
    return lambda + pack_harmonics(pressed);
  }

  /// J^{-1} r at the intervals of the last residual, J = 1 + P chi B; empty if that is not to be had.
  [[nodiscard]] KrylovSolve solve_jacobian(const Eigen::VectorXd& r) const {
    if (r.size() <= kDense) {
      const Eigen::PartialPivLU<Eigen::MatrixXd> lu(jacobian());
      return {.x = lu.solve(r), .condition = condition_from(lu.rcond())};
    }
    Eigen::VectorXd duty(root().size());
    for (Eigen::Index c = 0; c < duty.size(); ++c) duty[c] = indicators_[static_cast<std::size_t>(c)].duty();
    const LastingContactInverse lasting(symbol_, duty);
    return solve_by_gmres([this](const Eigen::VectorXd& v) { return product(v); },
                          [&lasting](const Eigen::VectorXd& v) { return lasting * v; }, r, kLinearTolerance);
  }

 private:
  static constexpr Eigen::Index kDense = 100;        // unknowns up to which factorising is the cheaper step
  static constexpr double kLinearTolerance = 1e-12;  // of each GMRES solve, relative to its right-hand side

  [[nodiscard]] Eigen::MatrixXd jacobian() const {
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

  [[nodiscard]] Eigen::VectorXd product(const Eigen::VectorXd& v) const {
    Eigen::MatrixXcd signal = symbol_.rate(v);
    for (Eigen::Index c = 0; c < signal.cols(); ++c) {
      signal.col(c) = indicators_[static_cast<std::size_t>(c)].restrict(signal.col(c));
    }
    return v + pack_harmonics(signal);
  }

  /// What unit harmonics of one contact's lambda press at another one's samples in contact, in the packing
  /// of harmonic_vector.hpp: a cosine of harmonic m drives s_m = B_m / sqrt 2, and (chi s)_n =
  /// chi_{n-m} s_m + chi_{n+m} conj(s_m) is packed with a factor sqrt 2.
  void fill_block(Eigen::Index row, Eigen::Index column, Eigen::Ref<Eigen::MatrixXd> block) const {
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

  int harmonics_;
  int samples_;
  ContactSymbol symbol_;
  Eigen::MatrixXcd free_;  // of sqrt(c) (x_f - g)
  double scale_ = 0.0;
  StopShifts shifts_;
  std::vector<ContactIndicator> indicators_;
};

}  // namespace

std::vector<ContactInterval> positive_intervals(const Eigen::VectorXcd& y, int samples,
                                                const std::vector<StopShift>& shifts, double scale) {
  RealFft fft(samples);
  Eigen::VectorXd values(samples);
  fft.inverse(y, values);
  const RaisedPolynomial raised{y, shifts, scale};
  for (int i = 0; i < samples && !shifts.empty(); ++i) {
    const double t = static_cast<double>(i) / samples;
    values[i] += scale * shift_at(shifts, t).at(t);
  }
  const std::vector<Sign> signs = signs_of(raised, values);
  const auto value = [&](double t) {
    const Jet jet = raised.at(t);
    return std::pair{jet.value, jet.slope};
  };
  std::vector<double> rises;
  std::vector<double> falls;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    const Sign& now = signs[i];
    const bool last = i + 1 == signs.size();
    const Sign then = last ? Sign{signs.front().t + 1.0, signs.front().positive} : signs[i + 1];
    if (now.positive == then.positive) continue;
    (then.positive ? rises : falls).push_back(polish_root(value, now.t, then.t, then.positive));
  }
  if (rises.empty())
    return values[0] > 0.0 ? std::vector<ContactInterval>{{0.0, 1.0}} : std::vector<ContactInterval>{};
  // Each rise is followed by its fall, the last one perhaps beyond the period's end.
  if (falls.front() < rises.front()) {
    falls.push_back(falls.front() + 1.0);
    falls.erase(falls.begin());
  }
  std::vector<ContactInterval> intervals;
  for (std::size_t k = 0; k < rises.size(); ++k) intervals.push_back({rises[k], falls[k]});
  return intervals;
}

Eigen::VectorXcd indicator_spectrum(const std::vector<ContactInterval>& intervals, int count) {
  Eigen::VectorXcd spectrum = Eigen::VectorXcd::Zero(count + 1);
  for (const auto& [begin, end] : intervals) {
    spectrum[0] += end - begin;
    const double middle = 0.5 * (begin + end);
    const double half = std::numbers::pi * (end - begin);
    for (int n = 1; n <= count; ++n) {
      // The middle and the half width keep their digits for short intervals.
      spectrum[n] += std::polar(std::sin(n * half) / (n * std::numbers::pi), -kTwoPi * n * middle);
    }
  }
  return spectrum;
}

Eigen::VectorXcd shift_spectrum(const ContactInterval& interval, const std::vector<StopShift>& shifts,
                                int count) {
  const double middle = 0.5 * (interval.begin + interval.end);
  const double half = 0.5 * (interval.end - interval.begin);
  const StopShift shift = shift_at(shifts, middle);
  Eigen::VectorXcd spectrum = shift.at(middle) * indicator_spectrum({interval}, count);
  // The integral of s e^{-2 pi i n s} over |s| < half.
  for (int n = 1; n <= count; ++n) {
    const double angle = kTwoPi * n * half;
    const double moment = 2.0 * (std::sin(angle) - angle * std::cos(angle)) / std::pow(kTwoPi * n, 2);
    spectrum[n] += shift.speed * moment * Complex(0.0, -1.0) * std::polar(1.0, -kTwoPi * n * middle);
  }
  return spectrum;
}

ContactIndicator::ContactIndicator(const std::vector<ContactInterval>& intervals, int harmonics)
    // chi s reaches harmonic 3 H: on more than 4 H samples none of it folds onto |n| <= H.
    : spectrum_(indicator_spectrum(intervals, 2 * harmonics)), values_(4 * harmonics + 2) {
  RealFft(static_cast<int>(values_.size())).inverse(spectrum_, values_);
}

Eigen::VectorXcd ContactIndicator::restrict(const Eigen::VectorXcd& s) const {
  RealFft fft(static_cast<int>(values_.size()));
  Eigen::VectorXd values(fft.samples());
  fft.inverse(s, values);
  values.array() *= values_.array();
  Eigen::VectorXcd spectrum(fft.coefficients());
  fft.forward(values, spectrum);
  return spectrum.head(s.size());
}

ExactProjection project_exactly(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                                const ProjectedLaw& law, const Eigen::MatrixXcd& lambda, int samples,
                                double tolerance, const StopShifts& shifts, const Start& start) {
  constexpr int kSteps = 40;
  constexpr int kHalvings = 10;
  ExactResidual residual(receptance, gap, law, samples, shifts);
  ExactProjection result;
  Eigen::VectorXd unknown = pack_harmonics(lambda * residual.root().cwiseInverse().asDiagonal());
  Eigen::VectorXd r = residual(unknown);
  // Short contacts press little on the mean, and much less than the load would: the force is the scale. Below
  // it lies the rounding of y, in which the load and the response to the force cancel.
  const double rounding = 16.0 * std::numeric_limits<double>::epsilon() * residual.load_scale();
  while (true) {
    const double scale = std::max(unknown.norm(), rounding / tolerance);
    result.residual = scale > 0.0 ? r.norm() / scale : 0.0;
    result.converged = result.residual <= tolerance;
    if (result.converged || result.iterations == kSteps || start.expired()) break;
    const auto [step, condition] = residual.solve_jacobian(r);
    if (step.size() == 0 || !step.allFinite()) break;
    ++result.iterations;
    result.condition = condition;
    // Far from the solution a full step may lose a contact; a shorter one keeps it.
    double length = 1.0;
    Eigen::VectorXd trial = residual(unknown - step);
    for (int k = 0; k < kHalvings && !(trial.norm() < (1.0 - 1e-4 * length) * r.norm()); ++k) {
      length *= 0.5;
      trial = residual(unknown - length * step);
    }
    if (!(trial.norm() < r.norm())) break;
    unknown -= length * step;
    r = trial;
  }
  result.lambda = unpack_harmonics(unknown, receptance.harmonics()) * residual.root().asDiagonal();
  return result;
}

}  // namespace signorini
