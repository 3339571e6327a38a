#include "tests/reference/distortionless_bar.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "problems/assembly/beam.hpp"

namespace signorini::test {

TipMotion tip_motion(const DistortionlessBar& bar, int steps_per_unit, int periods) {
  const double dt = 1.0 / steps_per_unit, omega = 2.0 * std::numbers::pi / bar.period;
  const auto delay = static_cast<std::size_t>(2 * steps_per_unit);  // there and back along the bar
  const auto per_period = static_cast<std::size_t>(std::lround(bar.period * steps_per_unit));
  const double echo = std::exp(-2.0 * bar.decay), fade = std::exp(-bar.decay * dt);
  std::vector<double> outgoing(delay, 0.0);  // p + u_x of the last two units of time
  TipMotion motion{
      .period = bar.period, .u = std::vector<double>(per_period), .lambda = std::vector<double>(per_period)};
  double u = 0.0, p_before = 0.0;
  const std::size_t steps = per_period * static_cast<std::size_t>(periods);
  for (std::size_t i = 0; i < steps; ++i) {
    const double load = bar.load * std::cos(omega * dt * static_cast<double>(i));
    const double returning = -echo * outgoing[i % delay];
    double strain = load, p = returning + load, lambda = 0.0;
    // u_t + alpha u = p, by the trapezoidal rule on its exponential form.
    double next = fade * u + 0.5 * dt * (fade * p_before + p);
    if (next >= bar.gap) {
      strain = bar.decay * bar.gap - returning;
      lambda = strain - load;
      if (lambda < 0.0) {
        next = bar.gap;
        p = bar.decay * bar.gap;
      } else {
        strain = load;
        lambda = 0.0;
      }
    }
    u = next;
    p_before = p;
    outgoing[i % delay] = p + strain;
    motion.u[i % per_period] = u;
    motion.lambda[i % per_period] = lambda;
  }
  for (const double lambda : motion.lambda) motion.impulse -= lambda * dt;
  return motion;
}

ContactReceptance tip_receptance(const DistortionlessBar& bar, int harmonics) {
  ContactReceptance result{
      .period = bar.period, .receptance = {}, .free_response = Eigen::MatrixXcd::Zero(harmonics + 1, 1)};
  for (int n = 0; n <= harmonics; ++n) {
    const std::complex<double> k(bar.decay, 2.0 * std::numbers::pi * n / bar.period);
    result.receptance.emplace_back(Eigen::MatrixXcd::Constant(1, 1, std::tanh(k) / k));
  }
  result.free_response(1, 0) = 0.5 * bar.load * result.receptance[1](0, 0);
  return result;
}

Problem finite_element_bar(const DistortionlessBar& bar, int elements) {
  const int tip = elements - 1;
  const Structure structure =
      assemble(Bar{.elements = elements, .contact_mass = ContactMass::massless, .contacts = {tip}});
  Problem problem;
  problem.name = "distortionless-bar";
  problem.edit_structure([&](Structure& s) {
    s.mass = structure.mass;
    s.damping = 2.0 * bar.decay * structure.mass;
    s.stiffness = structure.stiffness + bar.decay * bar.decay * structure.mass;
  });
  problem.frequency = 2.0 * std::numbers::pi / bar.period;
  problem.force = {{.dof = tip, .harmonic = 1, .cos = bar.load, .sin = 0.0}};
  problem.contacts = {{.normal = {{tip, 1.0}}, .gap = bar.gap}};
  problem.set_law(Massless{});
  return problem;
}

}  // namespace signorini::test
