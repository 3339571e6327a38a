#include "methods/reduction/contact_space.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "methods/reduction/principal_directions.hpp"
#include "methods/solvers/constants.hpp"
#include "methods/solvers/dense_products.hpp"
#include "methods/structure/bases/ritz_reduction.hpp"
#include "methods/structure/harmonic_pencil.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/sparse/sparse_products.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

// Vectors to solve on where contacts are many and no motion has said which: the lowest.
constexpr int kLowestToSolve = 48;
// Vectors to solve on for the force of a motion: the lowest of all, whatever the force, and at most so many
// others.
constexpr Eigen::Index kLowest = 30, kMostToSolve = 150;
// A space begins with twice as many vectors, and grows for the forces of motions; where coordinates are not
// many with more, since a vector costs less than to find that one is missing.
constexpr int kBegunOfSmall = 180, kSmallStructure = 20000;
// Coordinates with mass of which a space takes all.
constexpr int kAllOf = 300;

/// What a space starts from where contacts are many: the load and random combinations of contacts, which
/// move what contacts see most. Blocks of 16 solve several times faster than single columns. The same numbers
/// at every call.
SparseMatrix start_of_many(const ContactColumns& columns) {
  const Eigen::MatrixXd parts = random_columns(
      columns.normals.cols(), std::max(kSolvedTogether / 2, kSolvedTogether - columns.pushes.cols()));
  return side_by_side(columns.pushes, SparseMatrix(sparse_product(columns.normals, parts).sparseView()));
}

/// B^T B for B = [V U, D], U the Ritz vectors in V and D what follows statically.
Eigen::MatrixXd gram_of(const BlockLanczos& space, const Eigen::MatrixXd& ritz, const SparseMatrix& D) {
  const Eigen::Index vectors = ritz.cols();
  Eigen::MatrixXd gram(vectors + D.cols(), vectors + D.cols());
  gram.topLeftCorner(vectors, vectors) = transposed_product(ritz, dense_product(space.gram(), ritz));
  if (D.cols() == 0) return gram;
  gram.topRightCorner(vectors, D.cols()) = product_of_transposed(ritz, space.projected(D));
  gram.bottomLeftCorner(D.cols(), vectors) = gram.topRightCorner(vectors, D.cols()).transpose();
  gram.bottomRightCorner(D.cols(), D.cols()) = sparse_product_of_transposed(D, D);
  return gram;
}

}  // namespace

// The vectors, with the factors of K by which they grow.
struct ContactSpace::Source {
  Source(const Problem& of, Factorise by)
      : problem(of), columns(contact_columns(of)), factorise(std::move(by)) {
    if (columns.obstacle.empty()) all = columns.all();
  }

  BlockLanczos& vectors() {
    if (!kept) {
      kept.emplace(problem.stiffness(), problem.mass(), few() ? all : start_of_many(columns), columns.most(),
                   factorise);
      kept->grow_to(begun);
    }
    return *kept;
  }

  /// Whether the space starts from all that acts.
  [[nodiscard]] bool few() const { return all.cols() <= kFewColumns; }

  SpaceProjection projection() {
    const Eigen::Index contacts = columns.normals.cols();
    BlockLanczos& space = vectors();
    if (few()) return projection_from_start(space, contacts);
    if (!statics) statics.emplace(problem, space, columns);
    return statics->projection(space);
  }

  /// Whether nothing but rounding of what acts is statically outside; a space may be invariant without that,
  /// where many parts of a structure are alike.
  [[nodiscard]] bool holds_statics(const SpaceProjection& projection) const {
    return !statics || projection.outside.diagonal().maxCoeff() <=
                           kMatrixRounding * statics->rest().diagonal().maxCoeff();
  }

  bool release() {
    constexpr double kLargest = 1e9;  // [bytes]
    if (!kept || kept->bytes() <= kLargest) return false;
    kept.reset();
    refined_size_ = -1;
    if (statics) statics->forget_vectors();
    return true;
  }

  /// A projection with its lowest vectors refined (`refine_lowest`), which costs as much as growing does.
  struct Refined {
    SpaceProjection projection;
    double rounding = 0.0;
  };
  /// Of the vectors made so far: once for all spaces that have them. \param projected  their projection
  const Refined& refined(SpaceProjection projected) {
    if (refined_size_ != kept->size()) {
      latest_.projection = std::move(projected);
      latest_.rounding = refine_lowest(problem, *kept, columns, latest_.projection);
      refined_size_ = kept->size();
    }
    return latest_;
  }

  Problem problem;  // whose structure the vectors refer to
  ContactColumns columns;
  Factorise factorise;
  SparseMatrix all;                              // B = [N, F]
  std::optional<StaticCompliance> statics = {};  // where the space does not start from B
  Eigen::Index begun = 0;                        // vectors of a space that has not grown for any forces
  std::optional<BlockLanczos> kept;

 private:
  Refined latest_;
  Eigen::Index refined_size_ = -1;  // number of vectors that it is of
};

ContactSpace::ContactSpace(const Problem& problem, const ContactSpaceSettings& settings)
    : source_(std::make_shared<Source>(problem, settings.factorise)) {
  const ContactColumns& columns = source_->columns;
  small_.obstacle = columns.obstacle;
  if (!small_.obstacle.empty()) return;
  const Eigen::Index most = columns.most(), contacts = columns.normals.cols();
  BlockLanczos& space = source_->vectors();
  if (!space.definite()) {
    small_.obstacle = std::string(kNotDefinite);
    return;
  }
  given_small_ = settings.small > 0;
  const int unasked = source_->few() ? 2 * kLowestToSolve : kLowestToSolve;
  const int small = given_small_ ? settings.small : unasked;
  const int least = source_->few() && most <= kSmallStructure ? kBegunOfSmall : 2 * kLowestToSolve;
  const int begun = given_small_ ? std::max(2 * small, least) : least;
  const int enough = most <= kAllOf ? static_cast<int>(most) : begun;
  source_->begun = settings.whole > 0 ? settings.whole : enough;
  const bool powers = given_small_ && source_->few();
  if (powers) {
    space.grow_to(small);
    SpaceProjection first = projection_from_start(space, contacts);
    refine_lowest(problem, space, columns, first);
    small_ = reduction_on(columns, first, space.size());
  }
  space.grow_to(source_->begun);
  coordinates_ = problem.size();
  damping_ = columns.damping;
  load_ = columns.load;
  const SpaceProjection projection = take_whole();
  sprung_ = has_springs(problem);
  take_small(powers ? std::move(small_) : reduction_on(columns, projection, small));
}

bool ContactSpace::release() const { return source_->release(); }

void ContactSpace::take_small(ContactReduction small) {
  small_ = std::move(small);
  small_.rates = load_.rates;
  residual_ = small_.compliance;
  residual_shift_ = small_.shift;
  take_law();
}

SpaceProjection ContactSpace::projection() {
  SpaceProjection result = source_->projection();
  const BlockLanczos& space = source_->vectors();
  whole_.complete =
      space.size() >= source_->columns.most() || (space.invariant() && source_->holds_statics(result));
  return result;
}

void ContactSpace::take(const SpaceProjection& projection) {
  theta_ = projection.pairs.values;
  ports_.resize(theta_.size(), source_->all.cols());
  ports_ << projection.contacts, projection.loads;
  ports_ = transposed_product(projection.pairs.vectors, ports_);
  const StaticCompliance* statics = source_->statics ? &*source_->statics : nullptr;
  remainder_ = whole_.complete ? SpaceRemainder() : SpaceRemainder(source_->vectors(), projection, statics);
}

SpaceProjection ContactSpace::take_whole() {
  const ContactColumns& columns = source_->columns;
  const auto& [refined, rounding] = source_->refined(projection());
  const BlockLanczos& space = source_->vectors();
  const bool complete = whole_.complete;
  rounding_ = rounding;
  take(refined);
  whole_ = reduction_on(columns, refined, space.size());
  whole_.complete = complete;
  whole_.rates = load_.rates;
  direct_ = columns.compliance + refined.outside;
  gram_ = gram_of(space, refined.ritz, columns.following);
  return refined;
}

Eigen::MatrixXcd ContactSpace::acting(double base, const Eigen::MatrixXcd& force) const {
  Eigen::MatrixXcd result(ports_.cols(), force.rows());
  result << force.transpose(), load_.coefficients(base, static_cast<int>(force.rows()) - 1).transpose();
  return result;
}

SpaceRemainder::Residuals ContactSpace::residuals(double base, const Eigen::MatrixXcd& acting,
                                                  Eigen::Index contacts) const {
  return remainder_.residuals(damping_, base, theta_, ports_, contacts, acting);
}

Eigen::VectorXd ContactSpace::bound(double base, const Eigen::MatrixXcd& force) const {
  if (whole_.complete) return Eigen::VectorXd::Zero(force.rows());
  const Eigen::MatrixXcd forces = acting(base, force);
  return remainder_.bound(residuals(base, forces, small_.contacts()), forces);
}

Eigen::VectorXd ContactSpace::work_bound(double base, const Eigen::MatrixXcd& force) const {
  if (whole_.complete) return Eigen::VectorXd::Zero(force.rows());
  const Eigen::MatrixXcd forces = acting(base, force);
  Eigen::MatrixXcd weights = forces.conjugate();  // Z is symmetric: the adjoint response is that to them
  weights.bottomRows(weights.rows() - force.cols()).setZero();
  return remainder_.weighted_bound(residuals(base, weights, 0), weights, residuals(base, forces, 0), forces);
}

ContactSpace ContactSpace::grown_for(double base, const std::vector<Wanted>& all) const {
  constexpr double kMostBytes = 4e9;  // of all vectors
  constexpr Eigen::Index kMostVectors = 1500, kMostPowers = 8, kFewVectors = 400;
  ContactSpace result = *this;
  BlockLanczos& space = source_->vectors();
  const Eigen::Index most =
      std::min({kMostVectors, std::max(kFewVectors, kMostPowers * ports_.cols()), source_->columns.most(),
                static_cast<Eigen::Index>(kMostBytes / (8.0 * coordinates_))});
  for (const auto& [force, tolerance] : all) {
    const Eigen::MatrixXcd forces = acting(base, force);
    double before = std::numeric_limits<double>::infinity();
    for (int idle = 0; idle < 2;) {
      const SpaceProjection projected = result.projection();
      result.take(projected);
      if (result.whole_.complete) break;
      SpaceRemainder::Residuals residuals = result.residuals(base, forces, result.small_.contacts());
      const double bound = root_mean_square(result.remainder_.bound(residuals, forces));
      if (bound <= tolerance) break;
      idle = bound > 0.5 * before ? idle + 1 : 0;
      before = bound;
      if (space.size() >= most) break;
      if (SpaceRemainder::left_out_matters(residuals, tolerance)) {
        space.grow_by_left_out();
        continue;
      }
      const Eigen::MatrixXd missing = result.remainder_.missing_columns(residuals, forces, tolerance);
      if (missing.cols() > 0) {
        space.offer(space.solve(sparse_product(source_->all, missing)));
        result.take(projected);  // the space is the same, what would come next is not
        residuals = result.residuals(base, forces, result.small_.contacts());
      }
      const Eigen::MatrixXd directions = result.remainder_.longest(residuals, tolerance);
      const Eigen::Index taken = std::min(directions.cols(), most - space.size());
      space.grow_along(directions.rightCols(taken));
    }
  }
  result.take_whole();
  return result;
}

ContactSpace ContactSpace::solved_for(double base, const Eigen::MatrixXcd& force, double tolerance) const {
  // The lowest vectors are kept whatever the force: the resonances and the stability of a motion are theirs,
  // and so large in its response that the others would be lost in their rounding.
  const Eigen::Index lowest = std::min(kLowest, theta_.size()), others = theta_.size() - lowest;
  const Eigen::Index contacts = small_.contacts();
  Eigen::MatrixXcd moved = amplitudes(base, acting(base, force)).modal.topRows(others);
  if (static_residual()) {
    for (Eigen::Index n = 0; n < moved.cols(); ++n) {
      const auto [kappa, mu, load] = response_pencil(damping_, static_cast<double>(n) * base);
      moved.col(n).array() *= theta_.head(others).array().cast<Complex>() * (mu / kappa);
    }
  }
  const Eigen::MatrixXd other_ports = ports_.topRows(others);
  const double seen =
      other_ports.leftCols(contacts).norm() / std::sqrt(std::max(1.0, static_cast<double>(contacts)));
  const Eigen::MatrixXd principal = principal_directions(
      mean_square(moved, Eigen::VectorXd::Constant(moved.cols(), seen)), tolerance, kMostToSolve);
  const Eigen::Index kept = principal.cols() + lowest;
  Eigen::MatrixXd taken = Eigen::MatrixXd::Zero(theta_.size(), kept);
  taken.topLeftCorner(others, principal.cols()) = principal;
  taken.bottomRightCorner(lowest, lowest).setIdentity();
  const SymmetricEigen pairs = symmetric_eigen(transposed_product(taken, theta_.asDiagonal() * taken));
  const Eigen::MatrixXd rows = transposed_product(dense_product(taken, pairs.vectors), ports_);
  // What is not taken, without the softest vectors: subtracted as a whole their rounding would be left.
  const Eigen::MatrixXd left =
      other_ports - dense_product(principal, transposed_product(principal, other_ports));
  const SpaceProjection projection{
      .pairs = {.values = pairs.values, .vectors = Eigen::MatrixXd::Identity(kept, kept)},
      .ritz = {},
      .contacts = rows.leftCols(contacts),
      .loads = rows.rightCols(rows.cols() - contacts),
      .outside = direct_ - source_->columns.compliance + transposed_product(left, left)};
  ContactSpace result = *this;
  result.take_small(reduction_on(source_->columns, projection, kept));
  return result;
}

bool ContactSpace::static_residual() const { return !sprung_ || small_.relaxation == 0.0; }

// A spring on a part that relaxes is not followed.
void ContactSpace::take_law() {
  const double kept = static_residual() ? 1.0 : 0.0;
  small_.compliance = kept * residual_;
  small_.shift = kept * residual_shift_;
}

ContactSpace ContactSpace::of(const Problem& problem) const {
  ContactSpace result = *this;
  if (!obstacle().empty()) return result;
  result.load_.rates = load_columns(problem).rates;
  result.small_.rates = result.whole_.rates = result.load_.rates;
  result.sprung_ = has_springs(problem);
  result.take_law();
  return result;
}

ContactSpace::Amplitudes ContactSpace::amplitudes(double base, const Eigen::MatrixXcd& acting) const {
  Amplitudes result{.modal = dense_product(ports_, acting), .direct = acting};
  for (Eigen::Index n = 0; n < acting.cols(); ++n) {
    const auto [kappa, mu, load] = response_pencil(damping_, static_cast<double>(n) * base);
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
  const Eigen::Index contacts = force.cols();
  const Eigen::MatrixXcd forces = acting(base, force);
  const Amplitudes moved = amplitudes(base, forces);
  const Eigen::MatrixXcd motion =
      dense_product(ports_.transpose(), moved.modal) + dense_product(direct_, moved.direct);
  return {.contacts = motion.topRows(contacts).transpose(),
          .loads = motion.bottomRows(motion.rows() - contacts).transpose()};
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

double ContactSpace::distance_from_resonance(double base, int harmonics) const {
  double least = 1.0;
  for (int n = 0; n <= harmonics; ++n)
    least = std::min(least, distance_from_singular(response_pencil(damping_, n * base), theta_));
  return least;
}

}  // namespace signorini
