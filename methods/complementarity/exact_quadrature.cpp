#include "methods/complementarity/exact_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "methods/discretisation/fourier_series.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/solvers/constants.hpp"

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
    // Between two instants of different sign y has one zero: its extrema near zero are among the instants.
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
      spectrum[n] += std::sin(n * half) / (n * std::numbers::pi) * std::polar(1.0, -kTwoPi * n * middle);
    }
  }
  return spectrum;
}

Eigen::VectorXcd shift_spectrum(const ContactInterval& interval, const std::vector<StopShift>& shifts,
                                int count) {
  const double middle = 0.5 * (interval.begin + interval.end);
  const double half = 0.5 * (interval.end - interval.begin);
  // On the interval the shift is a straight line, distance + speed (t - t_k): its value in the middle times
  // the indicator, and its slope times the first moment of e^{-2 pi i n t}.
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
    : ContactIndicator(indicator_spectrum(intervals, 2 * harmonics)) {}

ContactIndicator::ContactIndicator(Eigen::VectorXcd spectrum)
    // chi s reaches harmonic 3 H: on more than 4 H samples none of it folds onto |n| <= H.
    : spectrum_(std::move(spectrum)), values_(2 * spectrum_.size()) {
  RealFft(static_cast<int>(values_.size())).inverse(spectrum_, values_);
}

Eigen::VectorXcd ContactIndicator::restrict(const Eigen::VectorXcd& s) const {
  RealFft fft(static_cast<int>(values_.size()));
  Eigen::VectorXd values(fft.samples());
  fft.inverse(s, values);
  values.array() *= values_.array();  // the convolution of the spectra, as a product in time
  Eigen::VectorXcd spectrum(fft.coefficients());
  fft.forward(values, spectrum);
  return spectrum.head(s.size());
}

}  // namespace signorini
