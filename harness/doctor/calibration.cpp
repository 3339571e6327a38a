#include "harness/doctor/calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <limits>
#include <numbers>

namespace signorini {

namespace {

constexpr std::size_t kMasses = 32, kLast = kMasses - 1;
constexpr int kPeriods = 20, kSteps = 100;                              // per period
constexpr double kOfMass = 0.05, kOfStiffness = 0.2;                    // damping [1/s] [s]
constexpr double kFrequency = 0.1;                                      // of the load [rad/s]
constexpr double kStep = 2.0 * std::numbers::pi / kFrequency / kSteps;  // [s]
constexpr double kRestitution = 0.8;

using Row = std::array<double, kMasses>;  ///< a number for each mass
using Square = std::array<Row, kMasses>;  ///< a matrix, its columns

void add(double factor, const Row& x, Row& sum) {
  for (std::size_t i = 0; i < kMasses; ++i) sum[i] += factor * x[i];
}

Row product(const Square& a, const Row& x) {
  Row sum{};
  for (std::size_t j = 0; j < kMasses; ++j) add(x[j], a[j], sum);
  return sum;
}

/// By elimination after Gauss and Jordan, of a symmetric positive definite matrix.
Square inverse(Square a) {
  for (std::size_t p = 0; p < kMasses; ++p) {
    const double pivot = a[p][p];
    a[p][p] = 1.0;
    for (double& entry : a[p]) entry /= pivot;
    for (std::size_t i = 0; i < kMasses; ++i) {
      if (i == p) continue;
      const double factor = a[i][p];
      a[i][p] = 0.0;
      add(-factor, a[p], a[i]);
    }
  }
  return a;
}

/// a I + b K, K the stiffness of the row: clamped at its first mass's side, free at its last.
Square of_mass_and_stiffness(double a, double b) {
  Square sum{};
  for (std::size_t i = 0; i < kMasses; ++i) {
    sum[i][i] = a + b * (i == kLast ? 1.0 : 2.0);
    if (i > 0) sum[i][i - 1] = sum[i - 1][i] = -b;
  }
  return sum;
}

/// (M + h/2 D + h^2/4 K) v' = (M - h/2 D - h^2/4 K) v - h K u + h f, solved for v'.
class MidpointStep {
 public:
  MidpointStep() {
    constexpr double kHalf = 0.5 * kStep, kMass = kHalf * kOfMass,
                     kStiffness = kHalf * kOfStiffness + kHalf * kHalf;
    inverse_ = inverse(of_mass_and_stiffness(1.0 + kMass, kStiffness));
    const Square of_velocity = of_mass_and_stiffness(1.0 - kMass, -kStiffness);
    const Square of_displacement = of_mass_and_stiffness(0.0, -kStep);
    for (std::size_t j = 0; j < kMasses; ++j) {
      of_velocity_[j] = product(inverse_, of_velocity[j]);
      of_displacement_[j] = product(inverse_, of_displacement[j]);
    }
  }

  /// One step on from time `t` [s]. Where the middle of the step would be behind the stop, an impulse turns
  /// the velocity there around.
  void advance(double t, double gap, Row& u, Row& v) const {
    Row next = product(of_velocity_, v);
    add(1.0, product(of_displacement_, u), next);
    add(kStep * std::cos(kFrequency * (t + 0.5 * kStep)), inverse_[kLast], next);
    if (u[kLast] + 0.5 * kStep * v[kLast] >= gap) {
      const double impulse = (next[kLast] + kRestitution * v[kLast]) / inverse_[kLast][kLast];
      add(-std::max(0.0, impulse), inverse_[kLast], next);
    }
    add(0.5 * kStep, v, u);
    add(0.5 * kStep, next, u);
    v = next;
  }

 private:
  Square inverse_{}, of_velocity_{}, of_displacement_{};
};

}  // namespace

std::vector<double> calibration_solve(double gap) {
  std::vector<double> motion;
  Row u{}, v{};
  for (int period = 0; period < kPeriods; ++period) {
    const MidpointStep step;
    for (int k = 0; k < kSteps; ++k) {
      step.advance(kStep * k, gap, u, v);
      motion.push_back(u[kLast]);
    }
  }
  return motion;
}

double calibration_seconds() {
  double least = std::numeric_limits<double>::infinity();
  volatile double last = 0.0;  // so that no solve is left out
  for (int i = 0; i < kCalibrationSolves; ++i) {
    const std::clock_t begin = std::clock();
    last = calibration_solve().back();
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  static_cast<void>(last);
  return least;
}

}  // namespace signorini
