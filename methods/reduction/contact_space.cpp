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

// Real matrices by real and imaginary parts: half the work of a complex product.
Eigen::MatrixXcd real_times(const Eigen::MatrixXd& A, const Eigen::MatrixXcd& B) {
  Eigen::MatrixXcd result(A.rows(), B.cols());
  result.real() = A * B.real();
  result.imag() = A * B.imag();
  return result;
}

/// B^T B for B = [V U, D], U the Ritz vectors in V and D what follows statically.
Eigen::MatrixXd gram_of(const BlockLanczos& space, const Eigen::MatrixXd& ritz, const SparseMatrix& D) {
  const Eigen::Index vectors = ritz.cols();
  Eigen::MatrixXd gram(vectors + D.cols(), vectors + D.cols());
  gram.topLeftCorner(vectors, vectors) = ritz.transpose() * space.gram() * ritz;
  if (D.cols() == 0) return gram;
  gram.topRightCorner(vectors, D.cols()) = ritz.transpose() * space.projected(D);
  gram.bottomLeftCorner(D.cols(), vectors) = gram.topRightCorner(vectors, D.cols()).transpose();
  gram.bottomRightCorner(D.cols(), D.cols()) = Eigen::MatrixXd(SparseMatrix(D.transpose() * D));
  return gram;
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
  const Eigen::Index most = columns.most(), contacts = columns.normals.cols();
  BlockLanczos space(problem.stiffness(), problem.mass(), start, most);
  if (!space.definite()) {
    small_.obstacle = std::string(kNotDefinite);
    return;
  }
  const auto grow_to = [&](Eigen::Index enough) {
    while (space.size() < enough && !space.exhausted()) space.grow();
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
  const Eigen::MatrixXd left_out = space.left_out() * projection.pairs.vectors;
  rounding_ = refine_lowest(problem, space, columns, projection);
  if (!few) small_ = reduction_on(columns, projection, small);
  residual_ = small_.compliance;
  residual_shift_ = small_.shift;
  take_law(problem);
  whole_ = reduction_on(columns, projection, space.size());
  theta_ = projection.pairs.values;
  contacts_ = projection.contacts;
  loads_ = projection.loads;
  ports_.resize(theta_.size(), contacts_.cols() + loads_.cols());
  ports_ << contacts_, loads_;
  gram_ = gram_of(space, projection.ritz, columns.following);
  coordinates_ = problem.size();
  damping_ = columns.damping;
  load_ = std::move(columns.load);
  direct_ = std::move(columns.compliance);
  whole_.complete = space.exhausted() || space.size() >= most;
  if (whole_.complete) {
    outside_ = left_out_ = Eigen::MatrixXd::Zero(0, theta_.size());
    return;
  }
  outside_ = space.coupling() * newest;
  left_out_ = left_out;
  left_out_of_start_ = space.left_out_of_start().norm();
}

// A spring on a part that relaxes is not followed.
void ContactSpace::take_law(const Problem& problem) {
  const bool sprung = small_.relaxation > 0.0 && std::holds_alternative<Penalty>(problem.law);
  const double kept = sprung ? 0.0 : 1.0;
  small_.compliance = kept * residual_;
  small_.shift = kept * residual_shift_;
}

ContactSpace ContactSpace::of(const Problem& problem) const {
  ContactSpace result = *this;
  if (!obstacle().empty()) return result;
  result.load_.rates = load_columns(problem).rates;
  result.small_.rates = result.whole_.rates = result.load_.rates;
  result.take_law(problem);
  return result;
}

ContactSpace::Amplitudes ContactSpace::amplitudes(double base, const Eigen::MatrixXcd& acting) const {
  Amplitudes result{.modal = real_times(ports_, acting), .direct = acting};
  for (Eigen::Index n = 0; n < acting.cols(); ++n) {
    const auto [kappa, mu, load] = pencil(static_cast<double>(n) * base).numbers;
    const Eigen::VectorXcd z = (mu * theta_.cast<Complex>()).array() + kappa;
    const double scale = std::abs(kappa) + std::abs(mu) * theta_.maxCoeff();
    if (!(z.cwiseAbs().minCoeff() > std::numeric_limits<double>::epsilon() * scale))
      throw SingularStiffness();
    result.modal.col(n).array() /= z.array();
    result.direct.col(n) /= kappa;
  }
  return result;
}

ContactSpace::PortMotion ContactSpace::motion(double base, const Eigen::MatrixXcd& force) const {
  const Eigen::Index contacts = contacts_.cols(), loads = loads_.cols();
  Eigen::MatrixXcd acting(contacts + loads, force.rows());
  acting.topRows(contacts) = force.transpose();
  acting.bottomRows(loads) = load_.coefficients(base, static_cast<int>(force.rows()) - 1).transpose();
  const Amplitudes moved = amplitudes(base, acting);
  const Eigen::MatrixXcd motion =
      real_times(ports_.transpose(), moved.modal) + real_times(direct_, moved.direct);
  return {.contacts = motion.topRows(contacts).transpose(), .loads = motion.bottomRows(loads).transpose()};
}

double ContactSpace::field_size(double base, const Eigen::MatrixXcd& force, const Eigen::MatrixXcd& load,
                                int first) const {
  Eigen::MatrixXcd acting(force.cols() + load.cols(), force.rows());
  acting << force.transpose(), load.transpose();
  const Amplitudes moved = amplitudes(base, acting);
  Eigen::MatrixXcd both(gram_.rows(), acting.cols());
  both << moved.modal, moved.direct.topRows(gram_.rows() - theta_.size());
  const Eigen::MatrixXcd weighed = real_times(gram_, both);
  double sum = 0.0;
  for (Eigen::Index n = first; n < both.cols(); ++n)
    sum += (n == 0 ? 1.0 : 2.0) * both.col(n).dot(weighed.col(n)).real();
  return std::sqrt(std::max(0.0, sum) / static_cast<double>(coordinates_));
}

Eigen::MatrixXcd ContactSpace::missing(double base, const Eigen::MatrixXcd& force) const {
  return contact_response(whole_, base, force) - contact_response(small_, base, force);
}

ContactSpace::Pencil ContactSpace::pencil(double rate) const {
  const auto [alpha, beta] = damping_;
  Pencil result{
      .numbers = {.kappa = Complex(1.0, beta * rate), .mu = Complex(-rate * rate, alpha * rate), .load = {}}};
  result.least = distance_from_singular(result.numbers, theta_);
  return result;
}

// Columns of the start of b at all harmonics, in Ritz coordinates, k x (H+1).
Eigen::MatrixXcd ContactSpace::columns_of(double base, const Eigen::MatrixXcd& force) const {
  const Eigen::MatrixXcd forces = force.transpose();
  const Eigen::MatrixXcd loads = load_.coefficients(base, static_cast<int>(force.rows()) - 1).transpose();
  Eigen::MatrixXcd start(theta_.size(), force.rows());
  start.real() = contacts_ * forces.real() + loads_ * loads.real();
  start.imag() = contacts_ * forces.imag() + loads_ * loads.imag();
  return start;
}

double ContactSpace::residual(const Pencil& pencil, const Eigen::VectorXcd& start) const {
  const auto& [kappa, mu, load] = pencil.numbers;
  const Eigen::VectorXcd y = start.array() / ((mu * theta_.cast<Complex>()).array() + kappa);
  return std::abs(mu) * (real_times(outside_, y).norm() + real_times(left_out_, y).norm());
}

double ContactSpace::contact_residual(const Pencil& pencil) const {
  const auto& [kappa, mu, load] = pencil.numbers;
  const Eigen::VectorXcd inverse = ((mu * theta_.cast<Complex>()).array() + kappa).cwiseInverse();
  const Eigen::MatrixXcd moved = inverse.asDiagonal() * contacts_.cast<Complex>();
  const Eigen::RowVectorXd lengths =
      real_times(outside_, moved).colwise().norm() + real_times(left_out_, moved).colwise().norm();
  return lengths.size() == 0 ? 0.0 : std::abs(mu) * lengths.maxCoeff();
}

Eigen::VectorXd ContactSpace::bound(double base, const Eigen::MatrixXcd& force) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(force.rows());
  const Eigen::MatrixXcd start = columns_of(base, force);
  const Eigen::MatrixXcd loads = load_.coefficients(base, static_cast<int>(force.rows()) - 1);
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
    const double of_contacts = std::max(before, after) + left_out_of_start_;
    const double acting = force.row(n).norm() + loads.row(n).norm();
    result[n] = of_contacts * (residual(here, start.col(n)) + left_out_of_start_ * acting) / here.least;
  }
  return result;
}

double ContactSpace::distance_from_resonance(double base, int harmonics) const {
  double least = 1.0;
  for (int n = 0; n <= harmonics; ++n) least = std::min(least, pencil(n * base).least);
  return least;
}

}  // namespace signorini
