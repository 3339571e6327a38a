#include "methods/linear_flow/modes/weak_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <utility>

#include "methods/solvers/dense_products.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

ComplexModes ComplexModes::of_size(Eigen::Index modes, Eigen::Index coordinates) {
  return {.mu = Eigen::VectorXcd(modes),
          .weight = Eigen::VectorXd(modes),
          .shapes = Eigen::MatrixXcd(coordinates, modes),
          .left = Eigen::MatrixXcd(modes, 2 * coordinates),
          .of_load = Eigen::MatrixXcd(modes, coordinates)};
}

Eigen::VectorXcd ComplexModes::forced(const Eigen::VectorXcd& load, double rate) const {
  // Each mode of a pair answers by itself: q = sum_k U_k (of_load_k f) / (i rate - mu_k), conjugates
  // included. Most loads act on few coordinates.
  const std::complex<double> i_rate(0.0, rate);
  Eigen::VectorXcd direct = Eigen::VectorXcd::Zero(mu.size()), mirrored = direct;
  for (Eigen::Index i = 0; i < load.size(); ++i) {
    if (load[i] == 0.0) continue;
    direct += of_load.col(i) * load[i];
    mirrored += of_load.col(i).conjugate() * load[i];
  }
  direct.array() /= i_rate - mu.array();
  mirrored.array() *= (weight.array() - 1.0) / (i_rate - mu.array().conjugate());
  // U d + U* m = Re U (d + m) + Im U i (d - m).
  Eigen::VectorXcd q = Eigen::VectorXcd::Zero(shapes.rows());
  for (Eigen::Index k = 0; k < mu.size(); ++k) {
    const std::complex<double> sum = direct[k] + mirrored[k], difference = direct[k] - mirrored[k];
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      const double real = shapes(i, k).real(), imaginary = shapes(i, k).imag();
      q[i] += std::complex<double>(real * sum.real() - imaginary * difference.imag(),
                                   real * sum.imag() + imaginary * difference.real());
    }
  }
  return q;
}

namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// y -> C y.
using Coupling = std::function<Eigen::VectorXcd(const Eigen::VectorXcd&)>;

Coupling coupling_by(const Eigen::MatrixXd& C) {
  return [C](const Eigen::VectorXcd& y) {
    Eigen::VectorXcd result(C.rows());
    result.real() = image(C, Eigen::VectorXd(y.real()));
    result.imag() = image(C, Eigen::VectorXd(y.imag()));
    return result;
  };
}

Coupling coupling_by(const DashpotCoupling& dashpots) {
  Eigen::VectorXd own = Eigen::VectorXd::Zero(dashpots.shares.rows());  // the diagonal
  for (Index j = 0; j < dashpots.strength.size(); ++j)
    for (Index k = 0; k < own.size(); ++k)
      own[k] += dashpots.strength[j] * dashpots.shares(k, j) * dashpots.shares(k, j);
  return [&dashpots, own = std::move(own)](const Eigen::VectorXcd& y) {
    Eigen::VectorXcd result(y.size());
    for (Index k = 0; k < y.size(); ++k) result[k] = -own[k] * y[k];
    for (Index j = 0; j < dashpots.strength.size(); ++j) {
      const double* share = dashpots.shares.col(j).data();
      Complex depth = 0.0;
      for (Index k = 0; k < y.size(); ++k) depth += share[k] * y[k];
      depth *= dashpots.strength[j];
      for (Index k = 0; k < y.size(); ++k) result[k] += share[k] * depth;
    }
    return result;
  };
}

class WeakCoupling {
 public:
  WeakCoupling(const RealModes& real, Coupling coupling, double rate)
      : real_(real),
        size_(std::ssize(real.squares)),
        coupling_(std::move(coupling)),
        shift_(rate * rate),
        d_(size_),
        l_(size_) {
    for (Index k = 0; k < size_; ++k) {
      d_[k] = static_cast<double>(damping(k));
      l_[k] = static_cast<double>(square(k));
    }
  }

  // False where it does not converge, or the mode is ill-conditioned. \param larger  of two real mu
  [[nodiscard]] bool find(Index k, bool larger) {
    constexpr int kMost = 60;
    constexpr double kStill = 2e-16, kWeak = 0.25;
    y_ = Eigen::VectorXcd::Zero(size_);
    y_[k] = 1.0;
    mu_ = root(k, 0.0, larger);
    for (int i = 0; i < kMost; ++i) {
      const Eigen::VectorXcd pushed = coupling_(y_);
      mu_ = root(k, pushed[k], larger);
      double change = 0.0, most = 0.0;
      for (Index j = 0; j < size_; ++j) {
        if (j == k) continue;
        const Complex next = -mu_ * pushed[j] / (mu_ * mu_ + d_[j] * mu_ + l_[j]);
        change = std::max(change, std::norm(next - y_[j]));
        most = std::max(most, std::norm(next));
        y_[j] = next;
      }
      if (!(most <= kWeak * kWeak)) return false;
      if (change <= kStill * kStill) return well_conditioned();
    }
    return false;
  }

  // What was found. False where it is no pair, or one, against is_pair.
  [[nodiscard]] bool write(Index k, Index place, ComplexModes& modes) const {
    if (is_pair(k) != (mu_.imag() > 0.0)) return false;
    modes.mu[place] = mu_;
    modes.weight[place] = is_pair(k) ? 2.0 : 1.0;
    modes.shapes.col(place) = y_;
    modes.left.row(place) << position_.transpose(), velocity_.transpose();
    modes.of_load.row(place) = velocity_.transpose();
    return true;
  }
  [[nodiscard]] bool is_pair(Index k) const { return square(k) - 0.25L * damping(k) * damping(k) > 0.0L; }

 private:
  [[nodiscard]] long double square(Index k) const { return real_.squares[static_cast<std::size_t>(k)]; }
  [[nodiscard]] long double damping(Index k) const { return real_.damping[static_cast<std::size_t>(k)]; }

  // Of the larger of two real mu the other one is l / mu.
  [[nodiscard]] Complex root(Index k, Complex coupled, bool larger) const {
    using ExtendedComplex = std::complex<long double>;
    const ExtendedComplex half = 0.5L * (damping(k) + ExtendedComplex(coupled.real(), coupled.imag()));
    const ExtendedComplex length = std::sqrt(half * half - square(k));
    if (is_pair(k)) return static_cast<Complex>(length.imag() > 0.0L ? -half + length : -half - length);
    const ExtendedComplex large = (half * std::conj(length)).real() > 0.0L ? -half - length : -half + length;
    return static_cast<Complex>(larger ? large : square(k) / large);
  }

  // By the condition of the eigenvalue in the coordinates of the energy.
  [[nodiscard]] bool well_conditioned() {
    const Eigen::VectorXcd pushed = coupling_(y_);
    position_.resize(size_);
    velocity_ = y_;
    Complex theta = 0.0;
    double right = 0.0, left = 0.0;
    for (Index j = 0; j < size_; ++j) {
      position_[j] = (mu_ + d_[j]) * y_[j] + pushed[j];
      theta += y_[j] * (position_[j] + mu_ * y_[j]);
      const double energy = l_[j] + shift_;
      right += (energy + std::norm(mu_)) * std::norm(y_[j]);
      left += std::norm(position_[j]) / energy + std::norm(y_[j]);
    }
    position_ /= theta;
    velocity_ /= theta;
    return std::sqrt(right * left) < most_cancelled(size_) * std::abs(theta);
  }

  const RealModes& real_;
  Index size_;
  Coupling coupling_;
  double shift_;  // s^2
  Eigen::VectorXd d_, l_;
  Complex mu_;
  Eigen::VectorXcd y_, position_, velocity_;  // of z = sum_k phi_k y_k and of a = position z + velocity z'
};

// Whether modes of y give back a state that is not one of them.
bool complete(const ComplexModes& modes, double rate) {
  constexpr double kComplete = 1e-9;
  const Index n = modes.shapes.rows();
  Eigen::VectorXcd state(2 * n);
  for (Index i = 0; i < n; ++i) {
    state[i] = std::cos(1.0 + 2.0 * static_cast<double>(i));
    state[n + i] = rate * std::cos(2.0 + 3.0 * static_cast<double>(i));
  }
  Eigen::VectorXcd amplitude = complex_image(modes.left, state);
  for (Index k = 0; k < modes.mu.size(); ++k) amplitude[k] *= modes.weight[k];
  const Eigen::VectorXcd rates = modes.mu.cwiseProduct(amplitude);
  const Eigen::VectorXd y = complex_image(modes.shapes, amplitude).real(),
                        v = complex_image(modes.shapes, rates).real();
  return (y - state.head(n).real()).norm() <= kComplete * state.head(n).norm() &&
         (v - state.tail(n).real()).norm() <= kComplete * rates.norm();
}

std::optional<ComplexModes> found_by(WeakCoupling coupling, Index n, double rate) {
  Index count = 0;
  for (Index k = 0; k < n; ++k) count += coupling.is_pair(k) ? 1 : 2;
  ComplexModes modes = ComplexModes::of_size(count, n);
  Index place = 0;
  for (Index k = 0; k < n; ++k) {
    for (int part = 0; part < (coupling.is_pair(k) ? 1 : 2); ++part) {
      if (!coupling.find(k, part == 0) || !coupling.write(k, place++, modes)) return std::nullopt;
    }
  }
  if (!complete(modes, rate)) return std::nullopt;
  return modes;
}

}  // namespace

// Of the hundred vectors of a reduced structure one is often as near to critical damping as a thousandth,
// which costs that mode alone three digits, and exponentials a minute.
double most_cancelled(Index coordinates) {
  constexpr double kIllConditioned = 1e3, kIllConditionedOfMany = 1e4;
  return coordinates > kLongDouble ? kIllConditionedOfMany : kIllConditioned;
}

std::optional<ComplexModes> weakly_coupled(const RealModes& real, double rate) {
  return found_by(WeakCoupling(real, coupling_by(extended::rounded(real.coupling)), rate),
                  std::ssize(real.squares), rate);
}

std::optional<ComplexModes> weakly_coupled(const RealModes& real, const DashpotCoupling& coupling,
                                           double rate) {
  return found_by(WeakCoupling(real, coupling_by(coupling), rate), std::ssize(real.squares), rate);
}

ComplexModes in_coordinates(ComplexModes modes, const Eigen::MatrixXd& S, const Eigen::MatrixXd& R) {
  const Index n = S.cols(), coordinates = S.rows();
  const Eigen::MatrixXcd position = modes.left.leftCols(n).transpose(),
                         velocity = modes.left.rightCols(n).transpose();
  modes.shapes = dense_product(S, modes.shapes);
  modes.left.resize(modes.mu.size(), 2 * coordinates);
  modes.left.leftCols(coordinates) = dense_product(R, position).transpose();
  modes.left.rightCols(coordinates) = dense_product(R, velocity).transpose();
  modes.of_load = dense_product(S, velocity).transpose();
  return modes;
}

}  // namespace signorini
