#include "tests/support/impact_oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::test {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

double decay(const ImpactOscillator& o) { return 0.5 * o.damping / o.mass; }

double damped_frequency(const ImpactOscillator& o) {
  return std::sqrt(o.stiffness / o.mass - decay(o) * decay(o));
}

double wrap(double time, double period) {
  const double wrapped = time - period * std::floor(time / period);
  return wrapped < period ? wrapped : 0.0;
}

// Receptance of the mass at `w` [m/N].
std::complex<double> receptance(const ImpactOscillator& o, double w) {
  return 1.0 / std::complex<double>(o.stiffness - o.mass * w * w, o.damping * w);
}

// Position (derivative = 0) and velocity (1) a time `s` after the impact.
double flight(const SingleImpactOrbit& orbit, double s, int derivative) {
  const ImpactOscillator& o = orbit.oscillator;
  const double al = decay(o), wd = damped_frequency(o), w = o.frequency;
  const double A = orbit.amplitude_cos, B = orbit.amplitude_sin, X = orbit.forced_amplitude;
  const double envelope = std::exp(-al * s), angle = w * s + orbit.phase;
  if (derivative == 0) {
    return envelope * (A * std::cos(wd * s) + B * std::sin(wd * s)) + o.static_load / o.stiffness +
           X * std::cos(angle);
  }
  return envelope * ((wd * B - al * A) * std::cos(wd * s) - (wd * A + al * B) * std::sin(wd * s)) -
         X * w * std::sin(angle);
}

// x <= g strictly inside the flight: samples, and every local maximum refined by bisection on the velocity.
bool stays_below(const SingleImpactOrbit& orbit) {
  constexpr int kSamples = 4000;
  const double g = orbit.oscillator.gap;
  const double step = orbit.period / kSamples;
  for (int i = 1; i + 1 < kSamples; ++i) {
    double a = i * step, b = a + step;
    if (flight(orbit, a, 0) > g) return false;
    if (flight(orbit, a, 1) <= 0.0 || flight(orbit, b, 1) >= 0.0) continue;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (a + b);
      (flight(orbit, middle, 1) > 0.0 ? a : b) = middle;
    }
    if (flight(orbit, a, 0) > g) return false;
  }
  return true;
}

}  // namespace

double SingleImpactOrbit::x(double time) const { return flight(*this, wrap(time - impact_time, period), 0); }

double SingleImpactOrbit::velocity(double time) const {
  return flight(*this, wrap(time - impact_time, period), 1);
}

bool SingleImpactOrbit::stable() const { return std::abs(trace) < 1.0 + determinant && determinant < 1.0; }

std::complex<double> SingleImpactOrbit::fourier(int n) const {
  const ImpactOscillator& o = oscillator;
  const double base = kTwoPi / period;
  std::complex<double> load = -impulse / period * std::polar(1.0, -n * base * impact_time);
  if (n == 0) load += o.static_load;
  if (std::abs(n) == o.order) load += 0.5 * o.load;
  return load * receptance(o, n * base);
}

std::vector<SingleImpactOrbit> single_impact_orbits(const ImpactOscillator& o) {
  const double al = decay(o), wd = damped_frequency(o), w = o.frequency, e = o.restitution;
  const double period = kTwoPi * o.order / w;
  const double E = std::exp(-al * period), C = std::cos(wd * period), S = std::sin(wd * period);
  const std::complex<double> forced = o.load * receptance(o, w);
  const double X = std::abs(forced), theta = std::arg(forced);
  const double G = o.gap - o.static_load / o.stiffness;

  const double beta = (1.0 - E * C) / (E * S);
  const double h0 = -al + wd * beta;
  const double h1 = E * (h0 * C - (al * beta + wd) * S);
  const double ratio = (h0 + e * h1) / (1.0 + e);
  const double q = ratio * G / (X * std::hypot(w, ratio));
  if (!(std::abs(q) <= 1.0)) return {};

  const double psi = std::atan2(ratio, w);
  std::vector<SingleImpactOrbit> orbits;
  for (const double phase : {std::asin(q) - psi, std::numbers::pi - std::asin(q) - psi}) {
    SingleImpactOrbit orbit;
    orbit.oscillator = o;
    orbit.period = period;
    orbit.impact_time = wrap((phase - theta) / w, kTwoPi / w);
    orbit.phase = phase;
    orbit.forced_amplitude = X;
    orbit.amplitude_cos = G - X * std::cos(phase);
    orbit.amplitude_sin = beta * orbit.amplitude_cos;
    orbit.approach = h1 * orbit.amplitude_cos - X * w * std::sin(phase);
    orbit.impulse = o.mass * (1.0 + e) * orbit.approach;
    const double push = o.static_load + o.load * std::cos(w * orbit.impact_time) - o.stiffness * o.gap;
    orbit.trace = -2.0 * e * E * C + (1.0 + e) * push / (o.mass * orbit.approach) * E * S / wd;
    orbit.determinant = e * e * E * E;
    if (orbit.approach > 0.0 && stays_below(orbit)) orbits.push_back(orbit);
  }
  std::sort(orbits.begin(), orbits.end(),
            [](const auto& a, const auto& b) { return a.approach > b.approach; });
  return orbits;
}

Problem to_problem(const ImpactOscillator& o) {
  const auto scalar = [](double value) {
    SparseMatrix matrix(1, 1);
    matrix.insert(0, 0) = value;
    matrix.makeCompressed();
    return matrix;
  };
  Problem problem;
  problem.name = "impact-oscillator";
  problem.title = "One mass, one stop";
  problem.kind = "sdof";
  problem.edit_structure([&](Structure& s) {
    s.mass = scalar(o.mass);
    s.damping = scalar(o.damping);
    s.stiffness = scalar(o.stiffness);
  });
  problem.frequency = o.frequency;
  problem.subharmonic = o.order;
  problem.force = {{.dof = 0, .harmonic = 1, .cos = o.load, .sin = 0.0}};
  if (o.static_load != 0.0)
    problem.force.push_back({.dof = 0, .harmonic = 0, .cos = o.static_load, .sin = 0.0});
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = o.gap}};
  problem.set_law(Restitution{o.restitution});
  return problem;
}

}  // namespace signorini::test
