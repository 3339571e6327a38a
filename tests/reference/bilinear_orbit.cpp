#include "tests/reference/bilinear_orbit.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace signorini::test {

namespace {

using Complex = std::complex<double>;

// x = static_part + Re(forced e^{i w t}) + e^{-decay s} (a cos(rate s) + b sin(rate s)), s = t - begin.
struct Phase {
  double begin = 0.0, end = 0.0;
  double decay = 0.0, rate = 1.0, w = 1.0;
  double static_part = 0.0;
  Complex forced = 0.0;
  double a = 0.0, b = 0.0;

  [[nodiscard]] double x(double t) const {
    const double s = t - begin;
    return static_part + (forced * std::polar(1.0, w * t)).real() +
           std::exp(-decay * s) * (a * std::cos(rate * s) + b * std::sin(rate * s));
  }
  [[nodiscard]] double velocity(double t) const {
    const double s = t - begin;
    const double c = std::cos(rate * s), q = std::sin(rate * s);
    return (Complex(0.0, w) * forced * std::polar(1.0, w * t)).real() +
           std::exp(-decay * s) * ((rate * b - decay * a) * c - (rate * a + decay * b) * q);
  }
  // State transition over the phase, (x, x') -> (x, x').
  [[nodiscard]] Eigen::Matrix2d flow() const {
    const double s = end - begin, c = std::cos(rate * s), q = std::sin(rate * s) / rate;
    Eigen::Matrix2d matrix;
    matrix << c + decay * q, q, -(decay * decay + rate * rate) * q, c - decay * q;
    return std::exp(-decay * s) * matrix;
  }
};

// The motion under stiffness k + extra that leaves the gap at `begin` with that velocity.
Phase phase_from(const ImpactOscillator& o, double extra, double begin, double end, double velocity) {
  Phase phase;
  const double stiffness = o.stiffness + extra;
  phase.begin = begin;
  phase.end = end;
  phase.decay = 0.5 * o.damping / o.mass;
  phase.rate = std::sqrt(stiffness / o.mass - phase.decay * phase.decay);
  phase.w = o.frequency;
  phase.static_part = (o.static_load + extra * o.gap) / stiffness;
  phase.forced = o.load / Complex(stiffness - o.mass * phase.w * phase.w, o.damping * phase.w);
  const Complex turned = phase.forced * std::polar(1.0, phase.w * begin);
  phase.a = o.gap - phase.static_part - turned.real();
  phase.b = (velocity + phase.w * turned.imag() + phase.decay * phase.a) / phase.rate;
  return phase;
}

std::array<Phase, 2> phases_of(const BilinearOrbit& orbit) {
  const Phase contact = phase_from(orbit.oscillator, orbit.penalty, orbit.close, orbit.open, orbit.approach);
  return {contact, phase_from(orbit.oscillator, 0.0, orbit.open, orbit.close + orbit.period(),
                              contact.velocity(orbit.open))};
}

// What is missing to a periodic motion, as velocities: the gap at opening (in units of the contact's
// frequency), the gap and the velocity at closing.
Eigen::Vector3d mismatch_of(const BilinearOrbit& orbit) {
  const auto [contact, flight] = phases_of(orbit);
  return {(contact.x(orbit.open) - orbit.oscillator.gap) * contact.rate,
          (flight.x(flight.end) - orbit.oscillator.gap) * flight.rate,
          flight.velocity(flight.end) - orbit.approach};
}

// The phase that rules at `time`, and that time within it.
std::pair<Phase, double> phase_at(const BilinearOrbit& orbit, double time) {
  const double turns = std::floor((time - orbit.close) / orbit.period());
  const double t = time - turns * orbit.period();
  const auto phases = phases_of(orbit);
  return {phases[t < orbit.open ? 0 : 1], t};
}

}  // namespace

double BilinearOrbit::period() const { return 2.0 * std::numbers::pi / oscillator.frequency; }

double BilinearOrbit::x(double time) const {
  const auto [phase, t] = phase_at(*this, time);
  return phase.x(t);
}

double BilinearOrbit::velocity(double time) const {
  const auto [phase, t] = phase_at(*this, time);
  return phase.velocity(t);
}

Complex BilinearOrbit::fourier(int n) const {
  const ImpactOscillator& o = oscillator;
  const Phase contact = phases_of(*this)[0];
  const double base = o.frequency, length = open - close;
  // (1/T) integral over the contact of -eps (x - g) e^{-i n w t}, one exponential at a time.
  const auto integral = [&](Complex exponent) {
    return exponent == 0.0 ? Complex(length) : (std::exp(exponent * length) - 1.0) / exponent;
  };
  const Complex shift(0.0, -n * base);
  const Complex own(-contact.decay, contact.rate);
  const Complex amplitude(0.5 * contact.a, -0.5 * contact.b);
  Complex force = (contact.static_part - o.gap) * integral(shift);
  for (const double sign : {1.0, -1.0}) {
    const Complex turn(0.0, sign * base);
    const Complex forced = sign > 0.0 ? contact.forced : std::conj(contact.forced);
    force += 0.5 * forced * std::exp(turn * close) * integral(shift + turn);
    force += (sign > 0.0 ? amplitude : std::conj(amplitude)) *
             integral(shift + (sign > 0.0 ? own : std::conj(own)));
  }
  Complex load = -penalty / period() * std::exp(shift * close) * force;
  if (n == 0) load += o.static_load;
  if (std::abs(n) == 1) load += 0.5 * o.load;
  const double w = n * base;
  return load / Complex(o.stiffness - o.mass * w * w, o.damping * w);
}

double BilinearOrbit::penetration() const {
  const Phase contact = phases_of(*this)[0];
  double low = close, high = open;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (contact.velocity(middle) > 0.0 ? low : high) = middle;
  }
  return contact.x(low) - oscillator.gap;
}

double BilinearOrbit::trace() const {
  const auto [contact, flight] = phases_of(*this);
  return (flight.flow() * contact.flow()).trace();
}

BilinearOrbit bilinear_orbit(const ImpactOscillator& oscillator, double penalty, double close, double open,
                             double approach) {
  BilinearOrbit orbit{
      .oscillator = oscillator, .penalty = penalty, .close = close, .open = open, .approach = approach};
  for (int iteration = 0; iteration < 50; ++iteration) {
    // Central differences, each unknown on its own scale.
    const double length = orbit.open - orbit.close;
    const Eigen::Vector3d step = 1e-6 * Eigen::Vector3d(length, length, orbit.approach);
    const auto shifted = [&](const Eigen::Vector3d& by) {
      BilinearOrbit other = orbit;
      other.close += by[0];
      other.open += by[1];
      other.approach += by[2];
      return other;
    };
    Eigen::Matrix3d jacobian;
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector3d by = step[j] * Eigen::Vector3d::Unit(j);
      jacobian.col(j) = (mismatch_of(shifted(by)) - mismatch_of(shifted(-by))) / (2.0 * step[j]);
    }
    const Eigen::Vector3d change = -jacobian.fullPivLu().solve(mismatch_of(orbit));
    // A contact may at most halve in one step: it must not turn inside out.
    const double shrink = std::min(1.0, 0.5 * length / (std::abs(change[1] - change[0]) + 1e-3 * length));
    orbit = shifted(shrink * change);
    if (change.head<2>().norm() < 1e-15 * orbit.period()) break;
  }
  const double turns = std::floor(orbit.close / orbit.period());
  orbit.close -= turns * orbit.period();
  orbit.open -= turns * orbit.period();
  orbit.mismatch = mismatch_of(orbit).norm() / orbit.approach;
  if (!(orbit.mismatch < 1e-9) || !(orbit.approach > 0.0))
    throw std::runtime_error("no bilinear orbit nearby");
  return orbit;
}

BilinearOrbit bilinear_orbit_of(const SingleImpactOrbit& rigid, double penalty) {
  const auto half_contact = [&](double stiffness) {
    return 0.5 * std::numbers::pi / std::sqrt(stiffness / rigid.oscillator.mass);
  };
  double stiffness = std::max(penalty, 1e9);
  const double time = rigid.impact_time;
  BilinearOrbit orbit = bilinear_orbit(rigid.oscillator, stiffness, time - half_contact(stiffness),
                                       time + half_contact(stiffness), rigid.approach);
  while (stiffness > penalty) {
    stiffness = std::max(penalty, stiffness / 2.0);
    const double middle = 0.5 * (orbit.close + orbit.open);
    orbit = bilinear_orbit(rigid.oscillator, stiffness, middle - half_contact(stiffness),
                           middle + half_contact(stiffness), orbit.approach);
  }
  return orbit;
}

}  // namespace signorini::test
