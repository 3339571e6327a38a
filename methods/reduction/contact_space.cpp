#include "methods/reduction/contact_space.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>
#include <variant>

#include "methods/structure/harmonic_pencil.hpp"
#include "methods/structure/ritz_reduction.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

// Powers that make the first vectors of a Krylov space better than as many modes, and the columns up to which
// so many are few.
constexpr int kPowersToSolve = 6;
constexpr int kFewColumns = 20;
constexpr int kLeastToSolve = 90;
constexpr int kLowestToSolve = 60;
// Coordinates with mass of which a space takes all.
constexpr int kAllOf = 300;
constexpr int kCheckedPowers = 2;
// Growth of the harmonics at which residuals of the contacts are evaluated.
constexpr double kNextHarmonic = 1.1;

Eigen::VectorXcd real_times(const Eigen::MatrixXd& A, const Eigen::VectorXcd& v) {
  Eigen::VectorXcd result(A.rows());
  result.real() = A * v.real();
  result.imag() = A * v.imag();
  return result;
}

}  // namespace

struct ContactSpace::Pencil {
  HarmonicPencil numbers;
  double least = 0.0;  // d
};

ContactSpace::ContactSpace(const Problem& problem, const ContactSpaceSettings& settings) {
  ContactColumns columns = contact_columns(problem);
  small_.obstacle = columns.obstacle;
  if (!small_.obstacle.empty()) return;
  const SparseMatrix start = columns.all();
  BlockLanczos space(problem.stiffness(), problem.mass(), start);
  if (!space.definite()) {
    small_.obstacle = std::string(kNotDefinite);
    return;
  }
  const Eigen::Index most = columns.most(), contacts = columns.normals.cols();
  const auto grow_to = [&](Eigen::Index enough) {
    while (space.size() < enough && !space.exhausted() && space.size() + space.width() <= most) space.grow();
  };
  const auto width = static_cast<int>(start.cols());
  const bool few = width <= kFewColumns;
  const int lowest = few ? std::max(kLeastToSolve, kPowersToSolve * width) : kLowestToSolve;
  const int small = settings.small > 0 ? settings.small : lowest;
  const int enough = most <= kAllOf ? static_cast<int>(most) : std::max(2 * small, kCheckedPowers * width);
  const int whole = settings.whole > 0 ? settings.whole : enough;
  if (few) {
    grow_to(small);
    SpaceProjection first = projection_from_start(space, contacts);
    refine_lowest(problem, space, columns, first);
    small_ = reduction_on(columns, first, space.size());
  }
  grow_to(whole);
  SpaceProjection projection = projection_from_start(space, contacts);
  const Eigen::MatrixXd newest = projection.pairs.vectors.bottomRows(space.coupling().cols());
  rounding_ = refine_lowest(problem, space, columns, projection);
  if (!few) small_ = reduction_on(columns, projection, small);
  if (columns.damping.beta > 0.0 && std::holds_alternative<Penalty>(problem.law)) {
    small_.compliance.setZero();
    small_.shift.setZero();
  }
  whole_ = reduction_on(columns, projection, space.size());
  theta_ = projection.pairs.values;
  contacts_ = projection.contacts;
  loads_ = projection.loads;
  weight_ = std::move(columns.weight);
  whole_.complete = space.exhausted() || space.size() >= most;
  if (whole_.complete) {
    outside_ = Eigen::MatrixXd::Zero(0, theta_.size());
    return;
  }
  outside_ = space.coupling() * newest;
  omitted_ = space.omitted();
  omitted_start_ = space.omitted_start();
}

Eigen::MatrixXcd ContactSpace::missing(double base, const Eigen::MatrixXcd& force) const {
  return contact_response(whole_, base, force) - contact_response(small_, base, force);
}

ContactSpace::Pencil ContactSpace::pencil(double rate) const {
  const auto [alpha, beta] = whole_.damping;
  Pencil result{
      .numbers = {.kappa = Complex(1.0, beta * rate), .mu = Complex(-rate * rate, alpha * rate), .load = {}}};
  result.least = distance_from_singular(result.numbers, theta_);
  return result;
}

// Columns of the start of b at all harmonics, in Ritz coordinates, k x (H+1).
Eigen::MatrixXcd ContactSpace::columns_of(double base, const Eigen::MatrixXcd& force) const {
  const Eigen::MatrixXcd forces = force.transpose();
  Eigen::MatrixXcd start(theta_.size(), force.rows());
  start.real() = contacts_ * forces.real();
  start.imag() = contacts_ * forces.imag();
  for (std::size_t h = 0; h < whole_.rates.size(); ++h) {
    const auto n = static_cast<Eigen::Index>(std::lround(whole_.rates[h] / base));
    if (n >= force.rows()) continue;
    start.col(n) += (n == 0 ? 1.0 : 0.5) * real_times(loads_, weight_.col(static_cast<Eigen::Index>(h)));
  }
  return start;
}

double ContactSpace::residual(const Pencil& pencil, const Eigen::VectorXcd& start) const {
  const auto& [kappa, mu, load] = pencil.numbers;
  const Eigen::VectorXcd y = start.array() / ((mu * theta_.cast<Complex>()).array() + kappa);
  return std::abs(mu) * (real_times(outside_, y).norm() + omitted_ * y.norm());
}

double ContactSpace::contact_residual(const Pencil& pencil) const {
  const auto& [kappa, mu, load] = pencil.numbers;
  const Eigen::VectorXcd inverse = ((mu * theta_.cast<Complex>()).array() + kappa).cwiseInverse();
  const Eigen::MatrixXd real = outside_ * (inverse.real().asDiagonal() * contacts_);
  const Eigen::MatrixXd imaginary = outside_ * (inverse.imag().asDiagonal() * contacts_);
  double largest = 0.0;
  for (Eigen::Index j = 0; j < contacts_.cols(); ++j) {
    const double left_out = inverse.cwiseProduct(contacts_.col(j)).norm();
    largest =
        std::max(largest, std::hypot(real.col(j).norm(), imaginary.col(j).norm()) + omitted_ * left_out);
  }
  return std::abs(pencil.numbers.mu) * largest;
}

Eigen::VectorXd ContactSpace::bound(double base, const Eigen::MatrixXcd& force) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(force.rows());
  const Eigen::MatrixXcd start = columns_of(base, force);
  Eigen::Index next = 0;
  double before = 0.0, after = 0.0;  // rho of contacts at the evaluated harmonics about n
  for (Eigen::Index n = 0; n < force.rows(); ++n) {
    const double rate = static_cast<double>(n) * base;
    const Pencil here = pencil(rate);
    if (n == next || n == 0) {
      before = n == 0 ? contact_residual(here) : after;
      next = std::max(n + 1, static_cast<Eigen::Index>(kNextHarmonic * static_cast<double>(n)));
      after = contact_residual(pencil(static_cast<double>(next) * base));
    }
    const double of_contacts = std::max(before, after) + omitted_start_;
    result[n] =
        of_contacts * (residual(here, start.col(n)) + omitted_start_ * force.row(n).norm()) / here.least;
  }
  return result;
}

double ContactSpace::distance_from_resonance(double base, int harmonics) const {
  double least = 1.0;
  for (int n = 0; n <= harmonics; ++n) least = std::min(least, pencil(n * base).least);
  return least;
}

}  // namespace signorini
