#pragma once
// Orbits of several coordinates with one impact a period, in closed form.

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/linear_algebra/exponential.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/problem.hpp"

namespace signorini::test {

/// Several coordinates, one contact: the state after a unit impulse, repeated every period, is
/// (I - e^{A T})^{-1} (0, M^-1 b); everything else follows in closed form.
struct ImpulsiveOracle {
  explicit ImpulsiveOracle(const Problem& problem, double e) {
    const Eigen::Index n = problem.size();
    const double T = problem.period(), w = problem.frequency, g = problem.contacts[0].gap;
    const Eigen::MatrixXd M(problem.mass()), K(problem.stiffness()), C(problem.damping());
    const Eigen::VectorXd b = contact_directions(problem).col(0);
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    A.topRightCorner(n, n).setIdentity();
    const Eigen::MatrixXd of_force = LuFactors(M).inverse();
    A.bottomLeftCorner(n, n) = -of_force * K;
    A.bottomRightCorner(n, n) = -of_force * C;
    const Eigen::MatrixXd flow = matrix_exponential(A * T);
    Eigen::VectorXd struck = Eigen::VectorXd::Zero(2 * n);
    struck.tail(n) = of_force * b;
    const Eigen::VectorXd after = lu_solve(Eigen::MatrixXd::Identity(2 * n, 2 * n) - flow, struck);
    const Eigen::VectorXd before = after - struck;
    const double g0 = b.dot(after.head(n)), gp = b.dot(after.tail(n)), gm = b.dot(before.tail(n));
    const std::complex<double> i(0.0, 1.0);
    const Eigen::MatrixXcd Z = K.cast<std::complex<double>>() - w * w * M + i * w * C;
    const Eigen::VectorXcd u = lu_solve(Z, load_harmonic(problem, 1));
    const std::complex<double> linear = b.cast<std::complex<double>>().dot(u);
    const double a = std::abs(linear), Gam = (gp + e * gm) / ((1.0 + e) * g0);
    const double q = Gam * g / (a * std::hypot(w, Gam)), psi = std::atan2(Gam, w);
    for (const double phi : {std::asin(q) - psi, std::numbers::pi - std::asin(q) - psi}) {
      const double J = (a * std::cos(phi) - g) / g0, v = -a * w * std::sin(phi) - J * gm;
      if (!(v > 0.0)) continue;
      const double t0 = std::fmod((phi - std::arg(linear)) / w + 2.0 * T, T);
      speeds.push_back(v);
      times.push_back(t0);
      impulses.push_back(J);
      // Saltation.
      Eigen::VectorXd y(2 * n);
      y << u.real() * std::cos(w * t0) - u.imag() * std::sin(w * t0),
          -w * (u.real() * std::sin(w * t0) + u.imag() * std::cos(w * t0));
      const Eigen::VectorXd left = y - J * before, right = y - J * after;
      const auto rate = [&](const Eigen::VectorXd& state) {
        Eigen::VectorXd f = A * state;
        f.tail(n) += of_force * load_at(problem, t0);
        return f;
      };
      const double me = 1.0 / b.dot(of_force * b);
      Eigen::MatrixXd R = Eigen::MatrixXd::Identity(2 * n, 2 * n);
      R.bottomRightCorner(n, n) -= (1.0 + e) * me * of_force * b * b.transpose();
      Eigen::RowVectorXd normal = Eigen::RowVectorXd::Zero(2 * n);
      normal.head(n) = b.transpose() / v;
      const Eigen::MatrixXd S = R + (rate(right) - R * rate(left)) * normal;
      multipliers.push_back(general_eigenvalues(S * flow));
    }
  }
  std::vector<double> speeds, times, impulses;
  std::vector<Eigen::VectorXcd> multipliers;
};

}  // namespace signorini::test
