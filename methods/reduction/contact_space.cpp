#include "methods/reduction/contact_space.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

#include "methods/solvers/dense_products.hpp"
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
constexpr int kLowestToSolve = 100;
// Coordinates with mass of which a space takes all.
constexpr int kAllOf = 300;
constexpr int kCheckedPowers = 2;
// Growth of the harmonics at which residuals of the contacts are evaluated.
constexpr double kNextHarmonic = 1.1;

/// Root mean square over time of a series of these magnitudes, n = 0..H.
double size_of(const Eigen::VectorXd& series) {
  return std::sqrt(2.0 * series.squaredNorm() - series[0] * series[0]);
}

/// B^T B for B = [V U, D], U the Ritz vectors in V and D what follows statically.
Eigen::MatrixXd gram_of(const BlockLanczos& space, const Eigen::MatrixXd& ritz, const SparseMatrix& D) {
  const Eigen::Index vectors = ritz.cols();
  Eigen::MatrixXd gram(vectors + D.cols(), vectors + D.cols());
  gram.topLeftCorner(vectors, vectors) = transposed_product(ritz, dense_product(space.gram(), ritz));
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

// The vectors, with the factors of K by which they grow. Large ones are not kept for a growth that may never
// be asked for, but made anew.
struct ContactSpace::Source {
  explicit Source(const Problem& of) : problem(of), columns(contact_columns(of)) {}

  BlockLanczos& vectors() {
    if (!kept) {
      kept.emplace(problem.stiffness(), problem.mass(), columns.all(), columns.most());
      grow_to(begun);
    }
    return *kept;
  }

  void grow_to(Eigen::Index enough) {
    while (kept->size() < enough && !kept->exhausted()) kept->grow();
  }

  void rest() {
    constexpr double kLargest = 5e8;  // [bytes]
    if (kept->bytes() > kLargest) kept.reset();
  }

  Problem problem;  // whose structure the vectors refer to
  ContactColumns columns;
  Eigen::Index begun = 0;  // vectors of a space that has not grown for any forces
  std::optional<BlockLanczos> kept;
};

ContactSpace::ContactSpace(const Problem& problem, const ContactSpaceSettings& settings)
    : source_(std::make_shared<Source>(problem)) {
  const ContactColumns& columns = source_->columns;
  small_.obstacle = columns.obstacle;
  if (!small_.obstacle.empty()) return;
  const Eigen::Index most = columns.most(), contacts = columns.normals.cols();
  const BlockLanczos& space = source_->vectors();
  if (!space.definite()) {
    small_.obstacle = std::string(kNotDefinite);
    return;
  }
  const auto width = static_cast<int>(contacts + columns.pushes.cols());
  const bool few = width <= kFewColumns;
  const int lowest = few ? std::max(kLeastToSolve, kPowersToSolve * width) : kLowestToSolve;
  const int small = settings.small > 0 ? settings.small : lowest;
  const int enough = most <= kAllOf ? static_cast<int>(most) : std::max(2 * small, kCheckedPowers * width);
  source_->begun = settings.whole > 0 ? settings.whole : enough;
  if (few) {
    source_->grow_to(small);
    SpaceProjection first = projection_from_start(space, contacts);
    refine_lowest(problem, space, columns, first);
    small_ = reduction_on(columns, first, space.size());
  }
  source_->grow_to(source_->begun);
  coordinates_ = problem.size();
  damping_ = columns.damping;
  load_ = columns.load;
  direct_ = columns.compliance;
  const SpaceProjection projection = take_whole();
  sprung_ = std::holds_alternative<Penalty>(problem.law);
  take_small(few ? std::move(small_) : reduction_on(columns, projection, small));
  source_->rest();
}

void ContactSpace::take_small(ContactReduction small) {
  small_ = std::move(small);
  small_.rates = load_.rates;
  residual_ = small_.compliance;
  residual_shift_ = small_.shift;
  take_law();
}

SpaceProjection ContactSpace::take_residuals() {
  const BlockLanczos& space = source_->vectors();
  SpaceProjection projection = projection_from_start(space, source_->columns.normals.cols());
  const Eigen::MatrixXd& U = projection.pairs.vectors;
  theta_ = projection.pairs.values;
  contacts_ = U.transpose() * projection.contacts;
  loads_ = U.transpose() * projection.loads;
  whole_.complete = space.exhausted() || space.size() >= source_->columns.most();
  left_out_of_start_ = whole_.complete ? 0.0 : space.left_out_of_start().norm();
  outside_ = left_out_ = Eigen::MatrixXd::Zero(0, theta_.size());
  if (whole_.complete) return projection;
  outside_ = space.coupling() * U.bottomRows(space.coupling().cols());
  left_out_ = space.left_out() * U;
  return projection;
}

SpaceProjection ContactSpace::take_whole() {
  const BlockLanczos& space = source_->vectors();
  const ContactColumns& columns = source_->columns;
  SpaceProjection projection = take_residuals();
  const bool complete = whole_.complete;
  rounding_ = refine_lowest(source_->problem, space, columns, projection);
  whole_ = reduction_on(columns, projection, space.size());
  whole_.complete = complete;
  whole_.rates = load_.rates;
  theta_ = projection.pairs.values;
  contacts_ = projection.contacts;
  loads_ = projection.loads;
  ports_.resize(theta_.size(), contacts_.cols() + loads_.cols());
  ports_ << contacts_, loads_;
  gram_ = gram_of(space, projection.ritz, columns.following);
  return projection;
}

double ContactSpace::bound_size(double base, const Eigen::MatrixXcd& force) const {
  return size_of(bound(base, force));
}

ContactSpace::Residuals ContactSpace::residuals(double base, const Eigen::MatrixXcd& force) const {
  const Eigen::Index count = force.rows();
  const Eigen::VectorXd of_contacts = contact_residuals(base, static_cast<int>(count) - 1);
  Residuals result{.factor = Eigen::VectorXd(count)};
  Eigen::MatrixXcd moved = columns_of(base, force);
  for (Eigen::Index n = 0; n < count; ++n) {
    const Pencil here = pencil(static_cast<double>(n) * base);
    const auto& [kappa, mu, load] = here.numbers;
    moved.col(n).array() *= std::abs(mu) / ((mu * theta_.cast<Complex>()).array() + kappa);
    result.factor[n] = (of_contacts[n] + left_out_of_start_) / here.least;
  }
  result.acting = dense_product(outside_, moved);
  result.left_out = dense_product(left_out_, moved).colwise().norm();
  return result;
}

Eigen::MatrixXd ContactSpace::longest(const Residuals& residuals, double tolerance) {
  constexpr Eigen::Index kMostAtOnce = 64;
  constexpr double kLeft = 0.3;  // of the tolerance, for what is left out
  Eigen::VectorXd weight = std::numbers::sqrt2 * residuals.factor;
  weight[0] = residuals.factor[0];
  Eigen::MatrixXd parts(2 * weight.size(), residuals.acting.rows());
  parts << weight.asDiagonal() * residuals.acting.real().transpose(),
      weight.asDiagonal() * residuals.acting.imag().transpose();
  const Eigen::MatrixXd gram = transposed_product(parts, parts);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> directions(gram);
  const Eigen::VectorXd& squares = directions.eigenvalues();  // rising
  const Eigen::Index count = squares.size();
  double left = 0.0;
  Eigen::Index dropped = 0;
  while (dropped < count) {
    left += std::max(0.0, squares[dropped]);
    if (left > kLeft * kLeft * tolerance * tolerance) break;
    ++dropped;
  }
  return directions.eigenvectors().rightCols(std::min(kMostAtOnce, count - dropped));
}

ContactSpace ContactSpace::grown_for(double base, const std::vector<Wanted>& all) const {
  constexpr Eigen::Index kMostVectors = 1500, kMostPowers = 8, kFewVectors = 400;
  ContactSpace result = *this;
  BlockLanczos& space = source_->vectors();
  const Eigen::Index most =
      std::min({kMostVectors, std::max(kFewVectors, kMostPowers * ports_.cols()), source_->columns.most()});
  for (const Wanted& wanted : all) {
    double before = std::numeric_limits<double>::infinity();
    for (int idle = 0; idle < 2;) {
      result.take_residuals();
      const Residuals residuals = result.residuals(base, wanted.force);
      const double bound = size_of(result.bound(residuals, base, wanted.force));
      if (bound <= wanted.tolerance || result.whole_.complete) break;
      idle = bound > 0.5 * before ? idle + 1 : 0;
      before = bound;
      const Eigen::MatrixXd directions = longest(residuals, wanted.tolerance);
      const Eigen::Index taken = std::min(directions.cols(), most - space.size());
      if (taken <= 0) break;
      space.grow_along(directions.rightCols(taken));
    }
  }
  result.take_whole();
  source_->rest();
  return result;
}

ContactSpace ContactSpace::solved_on_lowest() const {
  ContactSpace result = *this;
  result.take_small(lowest_of(whole_, small_.vectors()));
  return result;
}

// A spring on a part that relaxes is not followed.
void ContactSpace::take_law() {
  const double kept = sprung_ && small_.relaxation > 0.0 ? 0.0 : 1.0;
  small_.compliance = kept * residual_;
  small_.shift = kept * residual_shift_;
}

ContactSpace ContactSpace::of(const Problem& problem) const {
  ContactSpace result = *this;
  if (!obstacle().empty()) return result;
  result.load_.rates = load_columns(problem).rates;
  result.small_.rates = result.whole_.rates = result.load_.rates;
  result.sprung_ = std::holds_alternative<Penalty>(problem.law);
  result.take_law();
  return result;
}

ContactSpace::Amplitudes ContactSpace::amplitudes(double base, const Eigen::MatrixXcd& acting) const {
  Amplitudes result{.modal = dense_product(ports_, acting), .direct = acting};
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
      dense_product(ports_.transpose(), moved.modal) + dense_product(direct_, moved.direct);
  return {.contacts = motion.topRows(contacts).transpose(), .loads = motion.bottomRows(loads).transpose()};
}

double ContactSpace::field_size(double base, const Eigen::MatrixXcd& force, const Eigen::MatrixXcd& load,
                                int first) const {
  Eigen::MatrixXcd acting(force.cols() + load.cols(), force.rows());
  acting << force.transpose(), load.transpose();
  const Amplitudes moved = amplitudes(base, acting);
  Eigen::MatrixXcd both(gram_.rows(), acting.cols());
  both << moved.modal, moved.direct.topRows(gram_.rows() - theta_.size());
  const Eigen::MatrixXcd weighed = dense_product(gram_, both);
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
  return dense_product(contacts_, forces) + dense_product(loads_, loads);
}

double ContactSpace::contact_residual(const Pencil& pencil) const {
  const auto& [kappa, mu, load] = pencil.numbers;
  const Eigen::VectorXcd inverse = ((mu * theta_.cast<Complex>()).array() + kappa).cwiseInverse();
  const Eigen::RowVectorXd lengths = scaled_product(outside_, inverse, contacts_).colwise().norm() +
                                     scaled_product(left_out_, inverse, contacts_).colwise().norm();
  return lengths.size() == 0 ? 0.0 : std::abs(mu) * lengths.maxCoeff();
}

Eigen::VectorXd ContactSpace::contact_residuals(double base, int harmonics) const {
  Eigen::VectorXd result(harmonics + 1);
  const auto at = [&](Eigen::Index n) { return contact_residual(pencil(static_cast<double>(n) * base)); };
  Eigen::Index next = 0;
  double before = 0.0, after = 0.0;  // at the evaluated harmonics about n
  for (Eigen::Index n = 0; n <= harmonics; ++n) {
    if (n == next || n == 0) {
      before = n == 0 ? at(n) : after;
      next = std::max(n + 1, static_cast<Eigen::Index>(kNextHarmonic * static_cast<double>(n)));
      after = at(next);
    }
    result[n] = std::max(before, after);
  }
  return result;
}

Eigen::VectorXd ContactSpace::bound(double base, const Eigen::MatrixXcd& force) const {
  return bound(residuals(base, force), base, force);
}

Eigen::VectorXd ContactSpace::bound(const Residuals& residuals, double base,
                                    const Eigen::MatrixXcd& force) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(force.rows());
  const Eigen::MatrixXcd loads = load_.coefficients(base, static_cast<int>(force.rows()) - 1);
  for (Eigen::Index n = 0; n < force.rows(); ++n) {
    const double acting = force.row(n).norm() + loads.row(n).norm();
    result[n] = residuals.factor[n] *
                (residuals.acting.col(n).norm() + residuals.left_out[n] + left_out_of_start_ * acting);
  }
  return result;
}

double ContactSpace::distance_from_resonance(double base, int harmonics) const {
  double least = 1.0;
  for (int n = 0; n <= harmonics; ++n) least = std::min(least, pencil(n * base).least);
  return least;
}

}  // namespace signorini
