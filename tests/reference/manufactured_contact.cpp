#include "tests/reference/manufactured_contact.hpp"

#include <cmath>
#include <numbers>

namespace signorini::test {

namespace {

using Complex = std::complex<double>;

constexpr double kPi = std::numbers::pi;

double turn(double turns) { return turns - std::floor(turns); }

// (e^{2 pi i z} - 1) / (2 pi i z)
Complex mean_of_turns(double z) {
  return std::polar(std::abs(z) < 1e-12 ? 1.0 : std::sin(kPi * z) / (kPi * z), kPi * z);
}

// Coefficient n of sin^power(pi (s - begin) / length) on [begin, begin + length], zero elsewhere: the power
// is a sum of exponentials.
Complex bump_coefficient(int n, double begin, double length, int power) {
  Complex sum = 0.0;
  double binomial = 1.0;
  for (int j = 0; j <= power; ++j) {
    sum += binomial * mean_of_turns(0.5 * power - j - n * length);
    binomial *= -static_cast<double>(power - j) / (j + 1);
  }
  return sum * std::pow(Complex(0.0, 2.0), -power) * length * std::polar(1.0, -2.0 * kPi * n * begin);
}

}  // namespace

double RestingContact::x(double turns, int p) const {
  const double s = turn(turns - close - rest) / (1.0 - rest);
  return s < 1.0 ? gap - depth * std::pow(std::sin(kPi * s), p) : gap;
}

double RestingContact::lambda(double turns, int q) const {
  const double s = turn(turns - close) / rest;
  return s < 1.0 ? -push * std::pow(std::sin(kPi * s), q) : 0.0;
}

Complex RestingContact::x_coefficient(int n, int p) const {
  return (n == 0 ? gap : 0.0) - depth * bump_coefficient(n, close + rest, 1.0 - rest, p);
}

Complex RestingContact::lambda_coefficient(int n, int q) const {
  return -push * bump_coefficient(n, close, rest, q);
}

std::vector<RestingContact> ManufacturedChain::contacts() {
  return {{.gap = 0.1, .close = 0.05, .rest = 0.3, .depth = 1.0, .push = 1.5},
          {.gap = -0.2, .close = 0.45, .rest = 0.2, .depth = 0.6, .push = 0.8},
          {.gap = 0.0, .close = 0.8, .rest = 0.4, .depth = 1.4, .push = 2.0}};
}

Problem ManufacturedChain::problem(int highest) const {
  constexpr int kAll = 6;
  constexpr double kFrequency = 1.3;
  // Contacts touch coordinates 0, 2, 3 and 5.
  const Eigen::VectorXd mass = massless ? (Eigen::VectorXd(kAll) << 0.0, 1.0, 0.0, 0.0, 1.5, 0.0).finished()
                                        : (Eigen::VectorXd(kAll) << 1.0, 0.7, 1.3, 0.9, 1.1, 0.8).finished();
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(kAll, kAll);
  for (int i = 0; i < kAll; ++i) {
    K(i, i) += 1.0 + 0.2 * i;
    if (i + 1 == kAll) continue;
    const double k = 2.0 - 0.3 * i;
    K(i, i) += k;
    K(i + 1, i + 1) += k;
    K(i, i + 1) = K(i + 1, i) = -k;
  }
  const Eigen::MatrixXd M = mass.asDiagonal(), D = 0.5 * M;
  Problem problem;
  problem.name = "manufactured-chain";
  problem.edit_structure([&](Structure& s) {
    s.mass = M.sparseView();
    s.stiffness = K.sparseView();
    s.damping = D.sparseView();
  });
  problem.frequency = kFrequency;
  const std::vector<RestingContact> resting = contacts();
  problem.contacts = {{.normal = {{0, 1.0}}, .gap = resting[0].gap},
                      {.normal = {{5, -1.0}}, .gap = resting[1].gap},
                      {.normal = {{2, 1.0}, {3, -0.5}}, .gap = resting[2].gap}};
  if (massless) {
    problem.set_law(Massless{});
  } else {
    problem.set_law(Restitution{restitution});
  }
  const Eigen::MatrixXd W = contact_directions(problem);
  for (int n = 0; n <= highest; ++n) {
    Eigen::VectorXcd x(3), lambda(3);
    for (int c = 0; c < 3; ++c) {
      x[c] = resting[static_cast<std::size_t>(c)].x_coefficient(n, p);
      lambda[c] = resting[static_cast<std::size_t>(c)].lambda_coefficient(n, q);
    }
    Eigen::VectorXcd u = Eigen::VectorXcd::Zero(kAll);
    if (n == 1) u[1] = Complex(0.3, 0.1);
    if (n == 1) u[3] = Complex(-0.2, 0.1);
    if (n == 2) u[4] = Complex(-0.1, 0.2);
    u[0] = x[0];
    u[2] = x[2] + 0.5 * u[3];
    u[5] = -x[1];
    const double w = n * kFrequency;
    const Eigen::VectorXcd f = K * u - w * w * (M * u) + Complex(0.0, w) * (D * u) - W * lambda;
    for (int dof = 0; dof < kAll; ++dof) {
      const Complex amplitude = n == 0 ? f[dof] : 2.0 * f[dof];
      problem.force.push_back(
          {.dof = dof, .harmonic = n, .cos = amplitude.real(), .sin = n == 0 ? 0.0 : -amplitude.imag()});
    }
  }
  return problem;
}

}  // namespace signorini::test
