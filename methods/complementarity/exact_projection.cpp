#include "methods/complementarity/exact_projection.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include "methods/complementarity/exact_quadrature.hpp"
#include "methods/discretisation/fourier_series.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/solvers/condition_estimate.hpp"
#include "methods/solvers/lcp.hpp"
#include "methods/solvers/newton_krylov.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

/// R as a JacobianSystem, in units of sqrt(c) per contact and packed as in fourier_series.hpp.
class ExactResidual {
 public:
  ExactResidual(const ProjectedEquations& equations, const ExactProjectionSettings& settings,
                const StopShifts& shifts)
      : harmonics_(equations.receptance.harmonics()),
        samples_(settings.samples),
        symbol_(equations.receptance, equations.law),
        shifts_(shifts.empty() ? StopShifts(static_cast<std::size_t>(symbol_.contacts())) : shifts) {
    free_ = equations.receptance.free_response;
    free_.row(0) -= equations.gap.transpose();
    free_ = free_ * root().asDiagonal();
    const double rounding = 16.0 * std::numeric_limits<double>::epsilon() * pack_harmonics(free_).norm();
    least_scale_ = rounding / settings.tolerance;
  }

  [[nodiscard]] const Eigen::VectorXd& root() const { return symbol_.root(); }

  /// |R|_2 / |lambda|_2. Short contacts press little on the mean, and much less than the load would: the
  /// force is the scale. Below it lies the rounding of y, in which the load and the response to the force
  /// cancel.
  [[nodiscard]] double error(const Eigen::VectorXd& lambda, const Eigen::VectorXd& r) const {
    const double scale = std::max(lambda.norm(), least_scale_);
    return scale > 0.0 ? r.norm() / scale : 0.0;
  }

  /// R(lambda); keeps the intervals of contact for the Jacobian.
  Eigen::VectorXd residual(const Eigen::VectorXd& lambda) {
    const Eigen::MatrixXcd y = free_ + symbol_.rate(lambda);
    Eigen::MatrixXcd pressed(harmonics_ + 1, y.cols());
    indicators_.clear();
    for (Eigen::Index c = 0; c < y.cols(); ++c) {
      const std::vector<StopShift>& shifts = shifts_[static_cast<std::size_t>(c)];
      const auto intervals = positive_intervals(y.col(c), samples_, shifts, root()[c]);
      indicators_.emplace_back(intervals, harmonics_);
      pressed.col(c) = indicators_.back().restrict(y.col(c));
      if (shifts.empty()) continue;
      for (const ContactInterval& interval : intervals) {
        pressed.col(c) += root()[c] * shift_spectrum(interval, shifts, harmonics_);
      }
    }
    return lambda + pack_harmonics(pressed);
  }

  /// J^{-1} r at the intervals of the last residual, J = 1 + P chi B. Moving an edge of contact contributes
  /// nothing to J, since y = 0 there.
  [[nodiscard]] KrylovSolve solve_jacobian(const Eigen::VectorXd& r) const {
    if (r.size() <= kDense) {
      const Eigen::PartialPivLU<Eigen::MatrixXd> lu(jacobian());
      return {.x = lu.solve(r), .condition = condition_from(lu.rcond())};
    }
    Eigen::VectorXd duty(root().size());
    for (Eigen::Index c = 0; c < duty.size(); ++c) duty[c] = indicators_[static_cast<std::size_t>(c)].duty();
    const LastingContactInverse lasting(symbol_, duty);
    return solve_by_gmres([this](const Eigen::VectorXd& v) { return product(v); },
                          [&lasting](const Eigen::VectorXd& v) { return lasting * v; }, r, kLinearTolerance);
  }

 private:
  static constexpr Eigen::Index kDense = 100;        // unknowns up to which factorising is the cheaper step
  static constexpr double kLinearTolerance = 1e-12;  // of each GMRES solve, relative to its right-hand side

  [[nodiscard]] Eigen::MatrixXd jacobian() const {
    const Eigen::Index stride = 2 * harmonics_ + 1;
    const Eigen::Index contacts = root().size();
    Eigen::MatrixXd matrix(stride * contacts, stride * contacts);
    for (Eigen::Index row = 0; row < contacts; ++row) {
      for (Eigen::Index column = 0; column < contacts; ++column) {
        fill_block(row, column, matrix.block(row * stride, column * stride, stride, stride));
      }
    }
    matrix.diagonal().array() += 1.0;
    return matrix;
  }

  [[nodiscard]] Eigen::VectorXd product(const Eigen::VectorXd& v) const {
    Eigen::MatrixXcd signal = symbol_.rate(v);
    for (Eigen::Index c = 0; c < signal.cols(); ++c) {
      signal.col(c) = indicators_[static_cast<std::size_t>(c)].restrict(signal.col(c));
    }
    return v + pack_harmonics(signal);
  }

  /// What unit harmonics of one contact's lambda press at another one's samples in contact, in the packing
  /// of fourier_series.hpp: a cosine of harmonic m drives s_m = B_m / sqrt 2, and (chi s)_n =
  /// chi_{n-m} s_m + chi_{n+m} conj(s_m) is packed with a factor sqrt 2.
  void fill_block(Eigen::Index row, Eigen::Index column, Eigen::Ref<Eigen::MatrixXd> block) const {
    const Eigen::VectorXcd& chi = indicators_[static_cast<std::size_t>(row)].spectrum();
    for (Eigen::Index m = 0; m <= harmonics_; ++m) {
      const Complex b = symbol_.block(m)(row, column);
      for (int part = 0; part < (m == 0 ? 1 : 2); ++part) {
        const Complex s = part == 0 ? b : Complex(0.0, 1.0) * b;
        const Eigen::Index place = m == 0 ? 0 : 2 * m - 1 + part;
        for (Eigen::Index n = 0; n <= harmonics_; ++n) {
          const Complex below = n >= m ? chi[n - m] : std::conj(chi[m - n]);
          Complex pressed = m == 0 ? below * b.real() : below * s + chi[n + m] * std::conj(s);
          if (n == 0) {
            block(0, place) = pressed.real() * (m == 0 ? 1.0 : std::numbers::sqrt2 / 2.0);
            continue;
          }
          if (m == 0) pressed *= std::numbers::sqrt2;
          block(2 * n - 1, place) = pressed.real();
          block(2 * n, place) = pressed.imag();
        }
      }
    }
  }

  int harmonics_;
  int samples_;
  ContactSymbol symbol_;
  Eigen::MatrixXcd free_;  // of sqrt(c) (x_f - g)
  double least_scale_ = 0.0;
  StopShifts shifts_;
  std::vector<ContactIndicator> indicators_;
};

/// The contacts that the mean of the load alone closes, in rising order: the static complementarity problem
/// of x_0 = x_f,0 + C_0 lambda_0 with the compliance of the stop, 1 / k_p = (1 - alpha) / c.
std::vector<int> closed_under_mean_load(const ProjectedEquations& equations) {
  const auto& [receptance, gap, law] = equations;
  Eigen::MatrixXd compliance = receptance.receptance[0].real();
  compliance.diagonal().array() += (1.0 - law.multiplier_weight.array()) / law.constant.array();
  const Eigen::VectorXd open = gap - receptance.free_response.row(0).real().transpose();
  const std::vector<bool> none(static_cast<std::size_t>(gap.size()), false);
  std::vector<int> closed;
  if (const auto pressure = solve_small_lcp(compliance, open, none)) {
    for (int c = 0; c < gap.size(); ++c) {
      if ((*pressure)[c] > 0.0) closed.push_back(c);
    }
  }
  return closed;
}

/// lambda with these contacts closed throughout and the others open, n = 0..H.
Eigen::MatrixXcd force_on_closed(const ProjectedEquations& equations, const std::vector<int>& closed) {
  const auto& [receptance, gap, law] = equations;
  Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Zero(receptance.harmonics() + 1, receptance.contacts());
  for (int n = 0; n <= receptance.harmonics(); ++n) {
    Eigen::VectorXcd free = receptance.free_response.row(n).transpose();
    if (n == 0) free -= gap;
    // Where closed y = -lambda throughout: c (x_f - g) + (c C + 1 - alpha) lambda = 0.
    Eigen::MatrixXcd block = law.constant.asDiagonal() * receptance.receptance[static_cast<std::size_t>(n)];
    block.diagonal() += (1.0 - law.multiplier_weight.array()).matrix();
    const Eigen::MatrixXcd held = block(closed, closed);
    const Eigen::VectorXcd load = law.constant.cwiseProduct(free)(closed);
    const Eigen::VectorXcd force = -held.partialPivLu().solve(load);
    lambda(n, closed) = force.transpose();
  }
  return lambda;
}

/// Whether the closed contacts press and the others stay open at every sample.
bool is_consistent(const ProjectedEquations& equations, const std::vector<int>& closed,
                   const Eigen::MatrixXcd& lambda, int samples) {
  Eigen::MatrixXcd penetration = contact_motion(equations.receptance, lambda);
  penetration.row(0) -= equations.gap.transpose();
  RealFft fft(samples);
  Eigen::VectorXd signal(samples);
  for (int c = 0; c < equations.receptance.contacts(); ++c) {
    // Negative at all times: the force of a contact that presses, the penetration of one that is open.
    const bool presses = std::binary_search(closed.begin(), closed.end(), c);
    const Eigen::MatrixXcd& negative = presses ? lambda : penetration;
    fft.inverse(negative.col(c), signal);
    if (signal.maxCoeff() >= 0.0) return false;
  }
  return true;
}

}  // namespace

ExactProjection project_exactly(const ProjectedEquations& equations, const Eigen::MatrixXcd& lambda,
                                const ExactProjectionSettings& settings, const StopShifts& shifts) {
  ExactResidual residual(equations, settings, shifts);
  const Eigen::VectorXd& root = residual.root();
  // Far from the solution a full step may lose a contact; a shorter one keeps it.
  NewtonKrylovResult newton = solve_newton_krylov(
      residual, pack_harmonics(lambda * root.cwiseInverse().asDiagonal()), settings.tolerance,
      {.max_steps = 40, .max_halvings = 10, .deadline = settings.deadline});
  return {.converged = newton.end == NewtonEnd::solved,
          .iterations = newton.iterations,
          .residual = newton.residual,
          .condition = newton.condition,
          .lambda = unpack_harmonics(newton.unknowns, equations.receptance.harmonics()) * root.asDiagonal()};
}

ExactProjection solve_permanent_contact(const ProjectedEquations& equations, double tolerance) {
  const std::vector<int> closed = closed_under_mean_load(equations);
  if (closed.empty()) return {};
  const Eigen::MatrixXcd lambda = force_on_closed(equations, closed);
  if (!lambda.allFinite()) return {};
  const int samples = kResolvingSamples * std::max(1, equations.receptance.harmonics());
  if (!is_consistent(equations, closed, lambda, samples)) return {};
  return project_exactly(equations, lambda, {.samples = samples, .tolerance = tolerance});
}

}  // namespace signorini
