#include "methods/linear_flow/modes/weak_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "problems/linear_algebra/products.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;

class WeakCoupling {
 public:
  WeakCoupling(const RealModes& real, double rate)
      : real_(real), size_(real.shapes.rows()), C_(extended::rounded(real.coupling)), shift_(rate * rate) {
    for (Index k = 0; k < size_; ++k) {
      d_.push_back(static_cast<double>(damping(k)));
      l_.push_back(static_cast<double>(square(k)));
    }
  }

  // False where it does not converge, or the mode is ill-conditioned. \param larger  of two real mu
  [[nodiscard]] bool find(Index k, bool larger) {
    constexpr int kMost = 60;
    constexpr double kStill = 2e-16, kWeak = 0.25;
    y_ = Eigen::VectorXcd::Zero(size_);
    y_[k] = 1.0;
    mu = root(k, 0.0, larger);
    for (int i = 0; i < kMost; ++i) {
      const Eigen::VectorXcd pushed = product_by_real_matrix(C_, y_);
      mu = root(k, pushed[k], larger);
      double change = 0.0, most = 0.0;
      for (Index j = 0; j < size_; ++j) {
        if (j == k) continue;
        const auto at = static_cast<std::size_t>(j);
        const Complex next = -mu * pushed[j] / (mu * mu + d_[at] * mu + l_[at]);
        change = std::max(change, std::abs(next - y_[j]));
        most = std::max(most, std::abs(next));
        y_[j] = next;
      }
      if (!(most <= kWeak)) return false;
      if (change <= kStill) return well_conditioned();
    }
    return false;
  }

  // What was found: of z = sum_k phi_k y_k and of a = (of_position z + of_velocity z').
  [[nodiscard]] const Eigen::VectorXcd& shape() const { return y_; }
  [[nodiscard]] const Eigen::VectorXcd& of_position() const { return position_; }
  [[nodiscard]] const Eigen::VectorXcd& of_velocity() const { return velocity_; }
  [[nodiscard]] bool is_pair(Index k) const { return square(k) - 0.25L * damping(k) * damping(k) > 0.0L; }

  Complex mu;

 private:
  [[nodiscard]] long double square(Index k) const { return real_.squares[static_cast<std::size_t>(k)]; }
  [[nodiscard]] long double damping(Index k) const { return real_.damping[static_cast<std::size_t>(k)]; }

  static Eigen::VectorXcd product_by_real_matrix(const Eigen::MatrixXd& A, const Eigen::VectorXcd& x) {
    Eigen::VectorXcd result(A.rows());
    result.real() = image(A, Eigen::VectorXd(x.real()));
    result.imag() = image(A, Eigen::VectorXd(x.imag()));
    return result;
  }

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
    const Eigen::VectorXcd pushed = product_by_real_matrix(C_, y_);
    position_.resize(size_);
    velocity_ = y_;
    Complex theta = 0.0;
    double right = 0.0, left = 0.0;
    for (Index j = 0; j < size_; ++j) {
      const auto at = static_cast<std::size_t>(j);
      position_[j] = (mu + d_[at]) * y_[j] + pushed[j];
      theta += y_[j] * (position_[j] + mu * y_[j]);
      const double energy = l_[at] + shift_;
      right += (energy + std::norm(mu)) * std::norm(y_[j]);
      left += std::norm(position_[j]) / energy + std::norm(y_[j]);
    }
    position_ /= theta;
    velocity_ /= theta;
    return std::sqrt(right * left) < most_cancelled(size_) * std::abs(theta);
  }

  const RealModes& real_;
  Index size_;
  Eigen::MatrixXd C_;
  double shift_;  // s^2
  std::vector<double> d_, l_;
  Eigen::VectorXcd y_, position_, velocity_;
};

}  // namespace

// Of the hundred vectors of a reduced structure one is often as near to critical damping as a thousandth,
// which costs that mode alone three digits, and exponentials a minute.
double most_cancelled(Index coordinates) {
  constexpr double kIllConditioned = 1e3, kIllConditionedOfMany = 1e4;
  return coordinates > kLongDouble ? kIllConditionedOfMany : kIllConditioned;
}

std::optional<WeaklyCoupled> weakly_coupled(const RealModes& real, double rate) {
  const Index n = real.shapes.rows();
  WeakCoupling coupling(real, rate);
  Index count = 0;
  for (Index k = 0; k < n; ++k) count += coupling.is_pair(k) ? 1 : 2;
  WeaklyCoupled modes{.mu = Eigen::VectorXcd(count),
                      .weight = Eigen::VectorXd(count),
                      .shapes = Eigen::MatrixXcd(n, count),
                      .of_position = Eigen::MatrixXcd(n, count),
                      .of_velocity = Eigen::MatrixXcd(n, count)};
  Index place = 0;
  for (Index k = 0; k < n; ++k) {
    const bool pair = coupling.is_pair(k);
    for (int part = 0; part < (pair ? 1 : 2); ++part, ++place) {
      if (!coupling.find(k, part == 0) || pair != (coupling.mu.imag() > 0.0)) return std::nullopt;
      modes.mu[place] = coupling.mu;
      modes.weight[place] = pair ? 2.0 : 1.0;
      modes.shapes.col(place) = coupling.shape();
      modes.of_position.col(place) = coupling.of_position();
      modes.of_velocity.col(place) = coupling.of_velocity();
    }
  }
  return modes;
}

}  // namespace signorini
