#include "methods/kernels/exact_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "methods/kernels/gmres.hpp"
#include "methods/kernels/harmonic_vector.hpp"
#include "methods/kernels/real_fft.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;
constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// y and dy/dt at a fraction t of the period, by Clenshaw-free direct powers of e^{2 pi i t}.
std::pair<double, double> value_and_slope(const Eigen::VectorXcd& y, double t) {
  const Complex unit = std::polar(1.0, kTwoPi * t);
  Complex phase = 1.0;
  double value = y[0].real();
  double slope = 0.0;
  for (Eigen::Index n = 1; n < y.size(); ++n) {
    phase *= unit;
    const Complex term = 2.0 * y[n] * phase;
    value += term.real();
    slope -= kTwoPi * static_cast<double>(n) * term.imag();
  }
  return {value, slope};
}

/// The sign change of y in [left, right], by Newton kept inside a shrinking bracket.
double polish_root(const Eigen::VectorXcd& y, double left, double right, bool rising) {
  double t = 0.5 * (left + right);
  for (int k = 0; k < 60; ++k) {
    const auto [value, slope] = value_and_slope(y, t);
    ((value > 0.0) == rising ? right : left) = t;
    double next = t - value / slope;
    if (!(next > left && next < right)) next = 0.5 * (left + right);
    if (std::abs(next - t) <= 4.0 * std::numeric_limits<double>::epsilon()) return next;
    t = next;
  }
  return t;
}

class ExactResidual {
 public:
  ExactResidual(const ContactReceptance& receptance, const Eigen::VectorXd& gap, const ProjectedLaw& law,
                int samples)
      : harmonics_(receptance.harmonics()), samples_(samples), root_(law.constant.cwiseSqrt()) {
    symbol_.reserve(receptance.receptance.size());
    for (const Eigen::MatrixXcd& c : receptance.receptance) {
      symbol_.emplace_back(root_.asDiagonal() * c * root_.asDiagonal());
      symbol_.back().diagonal() -= law.relief;
    }
    free_ = receptance.free_response;
    free_.row(0) -= gap.transpose();
    free_ = free_ * root_.asDiagonal();
    scale_ = pack_harmonics(free_).norm();
  }

  [[nodiscard]] const Eigen::VectorXd& root() const { return root_; }
  [[nodiscard]] double load_scale() const { return scale_; }

  /// R at lambda (scaled by sqrt(c)); keeps the contact intervals for `product`.
  Eigen::VectorXd operator()(const Eigen::VectorXd& lambda) {
    const Eigen::MatrixXcd y = free_ + rate(unpack_harmonics(lambda, harmonics_));
    Eigen::MatrixXcd pressed(harmonics_ + 1, y.cols());
    indicators_.clear();
    for (Eigen::Index c = 0; c < y.cols(); ++c) {
      indicators_.push_back(indicator_spectrum(positive_intervals(y.col(c), samples_), 2 * harmonics_));
      pressed.col(c) = restrict_to(indicators_.back(), y.col(c));
    }
    return lambda + pack_harmonics(pressed);
  }

  /// J v = v + P chi B v at the intervals of the last residual.
  [[nodiscard]] Eigen::VectorXd product(const Eigen::VectorXd& v) const {
    Eigen::MatrixXcd signal = rate(unpack_harmonics(v, harmonics_));
    for (Eigen::Index c = 0; c < signal.cols(); ++c) {
      signal.col(c) = restrict_to(indicators_[static_cast<std::size_t>(c)], signal.col(c));
    }
    return v + pack_harmonics(signal);
  }

 private:
  [[nodiscard]] Eigen::MatrixXcd rate(Eigen::MatrixXcd spectrum) const {
    for (Eigen::Index n = 0; n < spectrum.rows(); ++n) {
      spectrum.row(n) =
          (symbol_[static_cast<std::size_t>(n)] * spectrum.row(n).transpose()).transpose().eval();
    }
    return spectrum;
  }

  int harmonics_;
  int samples_;
  Eigen::VectorXd root_;
  std::vector<Eigen::MatrixXcd> symbol_;  // B_n = sqrt(c) C_n sqrt(c) - relief
  Eigen::MatrixXcd free_;                 // of sqrt(c) (x_f - g)
  double scale_ = 0.0;
  std::vector<Eigen::VectorXcd> indicators_;
};

}  // namespace

std::vector<ContactInterval> positive_intervals(const Eigen::VectorXcd& y, int samples) {
  RealFft fft(samples);
  Eigen::VectorXd values(samples);
  fft.inverse(y, values);
  std::vector<double> rises;
  std::vector<double> falls;
  for (int i = 0; i < samples; ++i) {
    const bool now = values[i] > 0.0;
    const bool then = values[(i + 1) % samples] > 0.0;
    if (now == then) continue;
    const double edge = polish_root(y, static_cast<double>(i) / samples, (i + 1.0) / samples, then);
    (then ? rises : falls).push_back(edge);
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

Eigen::VectorXcd restrict_to(const Eigen::VectorXcd& indicator, const Eigen::VectorXcd& s) {
  const auto harmonics = static_cast<int>(s.size()) - 1;
  Eigen::VectorXcd result(harmonics + 1);
  for (int n = 0; n <= harmonics; ++n) {
    Complex sum = indicator[n] * s[0].real();
    for (int m = 1; m <= harmonics; ++m) {
      const Complex difference = n >= m ? indicator[n - m] : std::conj(indicator[m - n]);
      sum += difference * s[m] + indicator[n + m] * std::conj(s[m]);
    }
    result[n] = sum;
  }
  return result;
}

ExactProjection project_exactly(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                                const ProjectedLaw& law, const Eigen::MatrixXcd& lambda, int samples,
                                double tolerance) {
  constexpr int kSteps = 25;
  constexpr int kHalvings = 10;
  constexpr double kLinearTolerance = 1e-12;  // of each GMRES solve, relative to its right-hand side
  ExactResidual residual(receptance, gap, law, samples);
  ExactProjection result;
  Eigen::VectorXd unknown = pack_harmonics(lambda * residual.root().cwiseInverse().asDiagonal());
  const auto identity = [](const Eigen::VectorXd& v) { return v; };
  Eigen::VectorXd r = residual(unknown);
  while (true) {
    const double scale = std::max(residual.load_scale(), unknown.norm());
    result.residual = scale > 0.0 ? r.norm() / scale : 0.0;
    result.converged = result.residual <= tolerance;
    if (result.converged || result.iterations == kSteps) break;
    const Eigen::VectorXd step = solve_by_gmres([&](const Eigen::VectorXd& v) { return residual.product(v); },
                                                identity, r, kLinearTolerance);
    if (step.size() == 0) break;
    ++result.iterations;
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
