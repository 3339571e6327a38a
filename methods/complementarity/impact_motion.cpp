#include "methods/complementarity/impact_motion.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "methods/discretisation/real_fft.hpp"
#include "methods/solvers/constants.hpp"
#include "methods/solvers/newton_krylov.hpp"
#include "problems/linear_algebra/lu.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

constexpr double kSettledRounding = 1e-9;  // relative to the motion
constexpr double kOneInstant = 1e-9;       // of the period
constexpr int kInstantsPerHarmonic = 8;
constexpr int kFewestInstants = 4096;  // a parabola of the third harmonic is told to 3e-6 of its height

/// sum over n >= 1 of cos(n theta) / n^2 and sin(n theta) / n^3 with their derivatives by theta, 0 <= theta <
/// 2 pi: polynomials of Bernoulli. At 0 the slope of the first is the mean of both sides.
struct BernoulliSums {
  Jet even;
  Jet odd;
};

BernoulliSums bernoulli_sums(double theta) {
  using std::numbers::pi;
  const double slope = theta == 0.0 ? 0.0 : (theta - pi) / 2.0;
  const double value = pi * pi / 6.0 - pi * theta / 2.0 + theta * theta / 4.0;
  const double odd = pi * pi * theta / 6.0 - pi * theta * theta / 4.0 + theta * theta * theta / 12.0;
  return {{value, slope, 0.5}, {odd, value, slope}};
}

double angle_of(double turn) { return kTwoPi * (turn - std::floor(turn)); }

/// The coefficients without their nought trailing ones: the free motion has the load's harmonics only.
Eigen::MatrixXcd without_trailing_zeros(const Eigen::MatrixXcd& coefficients) {
  Eigen::Index rows = coefficients.rows();
  while (rows > 1 && coefficients.row(rows - 1).isZero(0.0)) --rows;
  return coefficients.topRows(rows);
}

}  // namespace

/// The equations as a JacobianSystem in the instant and mean force of each impact, alternating. A point at
/// which an impact pulls is outside their domain: its residual is no number, which no step is taken to.
class ImpactMotionSystem {
 public:
  ImpactMotionSystem(const ImpactMotion& motion, const std::vector<int>& contacts)
      : motion_(motion), contacts_(contacts) {}

  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& v) {
    at_ = v.reshaped(2, v.size() / 2);
    const bool pushes = at_.allFinite() && (at_.row(1).array() > 0.0).all();
    if (!pushes) return Eigen::VectorXd::Constant(v.size(), std::numeric_limits<double>::quiet_NaN());
    take_jets();
    Eigen::VectorXd result(v.size());
    for (Eigen::Index k = 0; k < at_.cols(); ++k) {
      const int c = contacts_[static_cast<std::size_t>(k)];
      Jet x = free_[static_cast<std::size_t>(k)];
      for (Eigen::Index l = 0; l < at_.cols(); ++l) {
        x.value -= at_(1, l) * jet(k, l).value;
        x.slope -= at_(1, l) * jet(k, l).slope;
      }
      result[2 * k] = x.value - motion_.gap_[c];
      result[2 * k + 1] = x.slope / kTwoPi - motion_.loss(c) * at_(1, k);
    }
    return result;
  }

  [[nodiscard]] KrylovSolve solve_jacobian(const Eigen::VectorXd& r) const {
    return {.x = lu_solve(jacobian(), r)};
  }

  [[nodiscard]] double error(const Eigen::VectorXd& /*v*/, const Eigen::VectorXd& r) const {
    return r.lpNorm<Eigen::Infinity>();
  }

 private:
  [[nodiscard]] const Jet& jet(Eigen::Index k, Eigen::Index l) const {
    return pairs_[static_cast<std::size_t>(k * at_.cols() + l)];
  }

  void take_jets() {
    free_.clear();
    pairs_.clear();
    for (Eigen::Index k = 0; k < at_.cols(); ++k) {
      const int c = contacts_[static_cast<std::size_t>(k)];
      free_.push_back(trigonometric_jet(motion_.free_.col(c), at_(0, k)));
      for (Eigen::Index l = 0; l < at_.cols(); ++l) {
        // The kink of an impact's own response lies exactly at its instant: turn 0, the mean of both sides.
        const double turn = l == k ? 0.0 : at_(0, k) - at_(0, l);
        pairs_.push_back(motion_.answer(c, contacts_[static_cast<std::size_t>(l)], turn));
      }
    }
  }

  [[nodiscard]] Eigen::MatrixXd jacobian() const {
    Eigen::MatrixXd matrix(2 * at_.cols(), 2 * at_.cols());
    for (Eigen::Index k = 0; k < at_.cols(); ++k) {
      // dX(t_k) / dt_k, at which the impact's own response moves along and does not count.
      double rate = free_[static_cast<std::size_t>(k)].slope;
      double change = free_[static_cast<std::size_t>(k)].curvature;
      for (Eigen::Index l = 0; l < at_.cols(); ++l) {
        const Jet& g = jet(k, l);
        matrix(2 * k, 2 * l + 1) = -g.value;
        matrix(2 * k + 1, 2 * l + 1) = -g.slope / kTwoPi;
        if (l == k) continue;
        matrix(2 * k, 2 * l) = at_(1, l) * g.slope;
        matrix(2 * k + 1, 2 * l) = at_(1, l) * g.curvature / kTwoPi;
        rate -= at_(1, l) * g.slope;
        change -= at_(1, l) * g.curvature;
      }
      matrix(2 * k, 2 * k) = rate;
      matrix(2 * k + 1, 2 * k) = change / kTwoPi;
      matrix(2 * k + 1, 2 * k + 1) -= motion_.loss(contacts_[static_cast<std::size_t>(k)]);
    }
    return matrix;
  }

  const ImpactMotion& motion_;
  const std::vector<int>& contacts_;
  Eigen::Matrix2Xd at_;
  std::vector<Jet> free_;   // x_f at each impact
  std::vector<Jet> pairs_;  // T G of impact k after impact l, K x K by rows
};

ImpactMotion::ImpactMotion(const ContactReceptance& response, const Eigen::MatrixXcd& free,
                           const Eigen::VectorXd& gap, double restitution)
    : response_(response),
      free_(without_trailing_zeros(free)),
      limit_(inertial_limit(response)),
      gap_(gap),
      lost_((1.0 - restitution) / (1.0 + restitution)) {}

double ImpactMotion::loss(int contact) const { return std::numbers::pi * limit_.a(contact, contact) * lost_; }

Jet ImpactMotion::answer(int row, int column, double turn) const {
  const auto& receptance = response_.receptance;
  const double a = limit_.a(row, column);
  const double b = limit_.b(row, column);
  const double theta = angle_of(turn);
  const Complex unit = std::polar(1.0, theta);
  Complex phase = 1.0;
  Jet sum{receptance[0](row, column).real(), 0.0, 0.0};
  for (std::size_t n = 1; n < receptance.size(); ++n) {
    phase *= unit;
    const auto order = static_cast<double>(n);
    // What the closed form below has of this harmonic, -a / n^2 - i b / n^3, is not counted twice.
    const Complex rest = receptance[n](row, column) + Complex(a, b / order) / (order * order);
    const Complex term = 2.0 * rest * phase;
    sum.value += term.real();
    sum.slope -= order * term.imag();
    sum.curvature -= order * order * term.real();
  }
  const auto [even, odd] = bernoulli_sums(theta);
  sum.value += 2.0 * (b * odd.value - a * even.value);
  sum.slope += 2.0 * (b * odd.slope - a * even.slope);
  sum.curvature += 2.0 * (b * odd.curvature - a * even.curvature);
  return {sum.value, kTwoPi * sum.slope, kTwoPi * kTwoPi * sum.curvature};
}

Eigen::VectorXd ImpactMotion::residual(const PeriodicImpacts& impacts) const {
  return ImpactMotionSystem(*this, impacts.contacts).residual(impacts.moments.reshaped());
}

std::optional<SettledImpacts> ImpactMotion::settle(const PeriodicImpacts& from, double tolerance,
                                                   int max_steps) const {
  if (from.count() == 0) return SettledImpacts{};
  const double scale = size(from);
  ImpactMotionSystem system(*this, from.contacts);
  const NewtonKrylovResult newton = solve_newton_krylov(system, from.moments.reshaped(), tolerance * scale,
                                                        {.max_steps = max_steps, .max_halvings = 12});
  if (newton.end == NewtonEnd::singular ||
      !(newton.residual <= std::max(tolerance, kSettledRounding) * scale))
    return std::nullopt;
  PeriodicImpacts settled{from.contacts, newton.unknowns.reshaped(2, from.count())};
  for (double& turn : settled.moments.row(0)) turn -= std::floor(turn);
  return SettledImpacts{std::move(settled), newton.iterations, newton.residual};
}

bool ImpactMotion::are_separate(const PeriodicImpacts& impacts) const {
  const Eigen::MatrixXd& a = limit_.a;
  for (int k = 0; k < impacts.count(); ++k) {
    for (int l = 0; l < k; ++l) {
      const int row = impacts.contacts[static_cast<std::size_t>(k)];
      const int column = impacts.contacts[static_cast<std::size_t>(l)];
      const double turn = impacts.moments(0, k) - impacts.moments(0, l);
      const bool coupled =
          std::abs(a(row, column)) > kOneInstant * std::sqrt(a(row, row) * a(column, column));
      if (coupled && std::abs(turn - std::round(turn)) < kOneInstant) return false;
    }
  }
  return true;
}

std::pair<double, double> ImpactMotion::velocities(const PeriodicImpacts& impacts, int impact) const {
  const int c = impacts.contacts[static_cast<std::size_t>(impact)];
  double mean = trigonometric_jet(free_.col(c), impacts.moments(0, impact)).slope;
  for (int l = 0; l < impacts.count(); ++l) {
    const double turn = l == impact ? 0.0 : impacts.moments(0, impact) - impacts.moments(0, l);
    mean -= impacts.moments(1, l) * answer(c, impacts.contacts[static_cast<std::size_t>(l)], turn).slope;
  }
  // Half of the jump J / m per period: (W^T M^-1 W) T = a (2 pi)^2 / T.
  const double half = 0.5 * kTwoPi * kTwoPi * limit_.a(c, c) * impacts.moments(1, impact);
  return {mean + half, mean - half};
}

Eigen::VectorXcd ImpactMotion::spectrum(const PeriodicImpacts& impacts, int contact, bool enriched) const {
  const auto& receptance = response_.receptance;
  Eigen::VectorXcd x = Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(receptance.size()));
  const Eigen::Index loaded = std::min(x.size(), free_.rows());
  x.head(loaded) = free_.col(contact).head(loaded);
  for (int l = 0; l < impacts.count(); ++l) {
    const int column = impacts.contacts[static_cast<std::size_t>(l)];
    const double a = enriched ? limit_.a(contact, column) : 0.0;
    const double b = enriched ? limit_.b(contact, column) : 0.0;
    const Complex unit = std::polar(1.0, -kTwoPi * impacts.moments(0, l));
    Complex phase = -impacts.moments(1, l);
    x[0] += phase * receptance[0](contact, column);
    for (Eigen::Index n = 1; n < x.size(); ++n) {
      phase *= unit;
      const auto order = static_cast<double>(n);
      const Complex rest = Complex(a, b / order) / (order * order);
      x[n] += phase * (receptance[static_cast<std::size_t>(n)](contact, column) + rest);
    }
  }
  return x;
}

double ImpactMotion::overshoot(const PeriodicImpacts& impacts) const {
  const auto least = static_cast<unsigned>(kInstantsPerHarmonic * response_.harmonics());
  const auto instants =
      static_cast<int>(std::bit_ceil(std::max(least, static_cast<unsigned>(kFewestInstants))));
  RealFft fft(instants);
  Eigen::VectorXd x(instants);
  double deepest = 0.0;
  for (int c = 0; c < gap_.size(); ++c) {
    fft.inverse(spectrum(impacts, c, true), x);
    for (int l = 0; l < impacts.count(); ++l) {
      const int column = impacts.contacts[static_cast<std::size_t>(l)];
      const double a = 2.0 * limit_.a(c, column) * impacts.moments(1, l);
      const double b = 2.0 * limit_.b(c, column) * impacts.moments(1, l);
      for (int i = 0; i < instants; ++i) {
        const auto [even, odd] =
            bernoulli_sums(angle_of(static_cast<double>(i) / instants - impacts.moments(0, l)));
        x[i] += a * even.value - b * odd.value;
      }
    }
    deepest = std::max(deepest, x.maxCoeff() - gap_[c]);
  }
  return deepest;
}

double ImpactMotion::size(const PeriodicImpacts& impacts) const {
  double sum = 0.0;
  for (int c = 0; c < gap_.size(); ++c) {
    const Eigen::VectorXcd x = spectrum(impacts, c, false);
    sum += std::norm(x[0]) + 2.0 * x.tail(x.size() - 1).squaredNorm();
  }
  return std::sqrt(sum);
}

}  // namespace signorini
