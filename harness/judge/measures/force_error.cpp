#include "harness/judge/measures/force_error.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numeric>

#include "methods/discretisation/fourier_series.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

/// Share of the whole force that its varying part is taken to be at least.
constexpr double kLeastVarying = 0.1;

/// Adds the coefficients of an impulse at a time to those of a contact.
void add_impulse(double time, double impulse, double period, Eigen::Ref<Eigen::VectorXcd> spectrum) {
  const std::complex<double> turn = std::polar(1.0, -kTwoPi * time / period);
  std::complex<double> term = impulse / period;
  for (Eigen::Index n = 0; n < spectrum.size(); ++n, term *= turn) spectrum[n] += term;
}

/// Coefficients of force and impulses, (count+1) x Nc. Of pushes that are too short for samples these tell
/// the shape alone, and nothing where they are fewer than sixteen: such a push acts at its middle.
Eigen::MatrixXcd told_spectrum(const Motion& motion, int count) {
  constexpr int kShapes = 16;
  Eigen::MatrixXcd spectrum = contact_force_spectrum(motion, count);
  const double step = motion.step();
  for (int c = 0; c < static_cast<int>(spectrum.cols()); ++c) {
    const std::vector<ListedPush> pushes = short_pushes(motion, c);
    if (pushes.empty()) continue;
    spectrum.col(c).setZero();
    const auto add = [&](double time, double impulse) {
      add_impulse(time, impulse, motion.period(), spectrum.col(c));
    };
    for (const ListedPush& push : pushes) {
      const auto first = static_cast<int>(std::ceil(push.begin / step));
      const auto last = static_cast<int>(std::floor(push.end / step));
      const auto force = [&](int i) { return motion.samples.force(i % motion.count(), c); };
      double sampled = 0.0;
      for (int i = first; i <= last; ++i) sampled += force(i);
      if (last - first + 1 < kShapes || sampled == 0.0) {
        add(0.5 * (push.begin + push.end), push.impulse);
        continue;
      }
      for (int i = first; i <= last; ++i) add(i * step, push.impulse * force(i) / sampled);
    }
    for (const Impulse& impulse : motion.impulses) {
      if (impulse.contact == c) add(impulse.time, impulse.value);
    }
  }
  return spectrum;
}

/// Squares of the coefficients of the difference and of the orbit's force, two-sided, (H+1) x Nc.
struct ForceSpectra {
  ForceSpectra(const Motion& answer, const Motion& orbit) : order(std::lcm(answer.order, orbit.order)) {
    const auto over_both = [&](const Motion& motion) -> Eigen::MatrixXcd {
      return repeated(told_spectrum(motion, kMeasuredHarmonics * motion.order), order / motion.order);
    };
    const Eigen::Index all = kMeasuredHarmonics * order;
    const Eigen::Index shown = resolved_harmonics(answer).value_or(kMeasuredHarmonics * answer.order);
    const Eigen::Index last = std::clamp<Eigen::Index>(shown * (order / answer.order), order, all);
    const Eigen::MatrixXcd own = over_both(orbit).topRows(last + 1);
    apart = 2.0 * (over_both(answer).topRows(last + 1) - own).cwiseAbs2();
    exact = 2.0 * own.cwiseAbs2();
    apart.row(0) *= 0.5;
    exact.row(0) *= 0.5;
  }

  /// Sums over the harmonics, each with the square of a weight of n / order, Nc.
  [[nodiscard]] Eigen::ArrayXd sum(const Eigen::ArrayXXd& squares,
                                   const std::function<double(double)>& weight) const {
    Eigen::ArrayXd weights(squares.rows());
    for (Eigen::Index n = 0; n < squares.rows(); ++n)
      weights[n] = std::pow(weight(static_cast<double>(n) / order), 2);
    return (squares.colwise() * weights).colwise().sum();
  }

  int order;
  Eigen::ArrayXXd apart, exact;
};

/// Share of the period during which samples of the force push.
double pushing_share(const Motion& motion, Eigen::Index contact) {
  const auto force = motion.samples.force.col(contact).array();
  return (force < -kRoundOff * force.abs().maxCoeff()).cast<double>().mean();
}

}  // namespace

Measure ForceErrors::worst() const {
  const double unit = size.empty() ? 0.0 : std::ranges::max(size);
  return unit > 0.0 ? Measure(std::ranges::max(error) / unit) : std::nullopt;
}

ForceErrors force_errors(const Motion& answer, const Motion& orbit) {
  ForceErrors errors;
  if (answer.samples.x.cols() == 0) return errors;
  const ForceSpectra spectra(answer, orbit);
  const auto smooth = [](double s) { return 1.0 / (1.0 + s * s); };
  const Eigen::ArrayXd apart = spectra.sum(spectra.apart, smooth), whole = spectra.sum(spectra.exact, smooth);
  for (Eigen::Index c = 0; c < apart.size(); ++c) {
    const double varying = whole[c] - pushing_share(orbit, c) * spectra.exact(0, c);
    errors.error.push_back(std::sqrt(apart[c]));
    errors.size.push_back(std::sqrt(std::max(varying, kLeastVarying * kLeastVarying * whole[c])));
  }
  return errors;
}

Measure force_error_up_to(double harmonics, const Motion& answer, const Motion& orbit) {
  if (answer.samples.x.cols() == 0) return std::nullopt;
  const ForceSpectra spectra(answer, orbit);
  const auto below = [&](double s) { return s <= harmonics ? 1.0 : 0.0; };
  const double whole = spectra.sum(spectra.exact, below).sum();
  return whole > 0.0 ? Measure(std::sqrt(spectra.sum(spectra.apart, below).sum() / whole)) : std::nullopt;
}

}  // namespace signorini
