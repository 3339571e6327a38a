#include "methods/reduction/space_remainder.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "methods/reduction/principal_directions.hpp"
#include "methods/solvers/dense_products.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/symmetric_eigen.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

// Growth of the harmonics at which residuals of the contacts are evaluated.
constexpr double kNextHarmonic = 1.1;
// Directions that are taken in at once.
constexpr Eigen::Index kMostAtOnce = 64;
// Part of a tolerance that what is left out of a growth may have.
constexpr double kLeft = 0.3;
// Residual of a Ritz pair relative to its value with which it has converged.
constexpr double kConverged = 1e-2;
// Squared lengths relative to the static compliance without the lowest vectors that its rounding leaves in
// what a space does not hold.
constexpr double kRounding = 1e-15;

double largest(const Eigen::VectorXd& values) { return values.size() == 0 ? 0.0 : values.maxCoeff(); }

}  // namespace

HarmonicPencil response_pencil(const ProportionalDamping& damping, double rate) {
  return {.kappa = {1.0, damping.beta * rate}, .mu = {-rate * rate, damping.alpha * rate}, .load = {}};
}

SpaceRemainder::SpaceRemainder(const BlockLanczos& space, const SpaceProjection& projection,
                               const StaticCompliance* statics) {
  const Eigen::MatrixXd& U = projection.ritz;
  const Eigen::VectorXd& theta = projection.pairs.values;
  outside_ = product(space.coupling(), U.bottomRows(space.coupling().cols()));
  left_out_ = product(space.left_out(), U);
  if (statics == nullptr) {
    left_out_of_start_ = space.left_out_of_start().norm();
    const Eigen::Index ports = projection.contacts.cols() + projection.loads.cols();
    ahead_ = Eigen::MatrixXd::Zero(outside_.rows(), ports);
    beyond_ = Eigen::MatrixXd::Zero(ports, ports);
    still_ = Eigen::VectorXd::Zero(ports);
    longest_static_ = largest(projection.contacts.colwise().norm().transpose());
    return;
  }
  ahead_ = space.projected_on_next(statics->columns());
  beyond_ = projection.outside - transposed_product(ahead_, ahead_);
  rounding_ = kRounding * largest(statics->rest().diagonal());
  still_ = projection.outside.diagonal().cwiseMax(rounding_).cwiseSqrt();
  longest_static_ = largest(statics->lengths().head(projection.contacts.cols()));
  // The norm of T on what is K-orthogonal to the space: of the pairs that have converged, what is left of
  // them; the first that has not; and what the static responses themselves show, where a space knows one of
  // many equal pairs.
  Eigen::Index next = theta.size();
  double converged = 0.0;
  while (next > 0 && outside_.col(next - 1).norm() <= kConverged * theta[next - 1]) {
    --next;
    converged += outside_.col(next).squaredNorm() / theta[next];
  }
  smoothing_ = next == 0 ? theta.maxCoeff() : theta[next - 1] + outside_.col(next - 1).norm() + converged;
  smoothing_ = std::max(smoothing_, statics->largest_quotient());
}

SpaceRemainder::OfContacts SpaceRemainder::of_contacts(const HarmonicPencil& pencil,
                                                       const Eigen::VectorXd& theta,
                                                       const Eigen::MatrixXd& contacts) const {
  const Eigen::VectorXcd inverse =
      ((pencil.mu * theta.cast<Complex>()).array() + pencil.kappa).cwiseInverse();
  const Eigen::VectorXd moved =
      std::abs(pencil.mu) * scaled_product(outside_, inverse, contacts).colwise().norm();
  const Eigen::VectorXd left_out =
      std::abs(pencil.mu) * scaled_product(left_out_, inverse, contacts).colwise().norm();
  const double bracket = largest(still_.head(contacts.cols()) + moved + left_out);
  return {
      .bracket = std::min(bracket, longest_static_), .moved = largest(moved), .left_out = largest(left_out)};
}

SpaceRemainder::Residuals SpaceRemainder::residuals(const ProportionalDamping& damping, double base,
                                                    const Eigen::VectorXd& theta,
                                                    const Eigen::MatrixXd& ports, Eigen::Index contacts,
                                                    const Eigen::MatrixXcd& acting) const {
  const Eigen::Index count = acting.cols();
  const Eigen::MatrixXd of_unit = ports.leftCols(contacts);
  Residuals result{.acting = {},
                   .ahead = dense_product(ahead_, acting),
                   .beyond = Eigen::VectorXd(count),
                   .left_out = {},
                   .ratio = Eigen::VectorXd(count),
                   .least = Eigen::VectorXd(count),
                   .elastic = Eigen::VectorXd(count),
                   .factor = Eigen::VectorXd(count),
                   .cross = Eigen::VectorXd(count),
                   .cross_left_out = Eigen::VectorXd(count)};
  const Eigen::MatrixXcd weighed = dense_product(beyond_, acting);
  Eigen::MatrixXcd moved = dense_product(ports, acting);
  const auto at = [&](Eigen::Index n) {
    if (contacts == 0) return OfContacts{};
    return of_contacts(response_pencil(damping, static_cast<double>(n) * base), theta, of_unit);
  };
  OfContacts before, after;  // at the evaluated harmonics about n
  Eigen::Index next = 0;
  for (Eigen::Index n = 0; n < count; ++n) {
    if (n == next) {
      before = n == 0 ? at(n) : after;
      next = std::max(n + 1, static_cast<Eigen::Index>(kNextHarmonic * static_cast<double>(n)));
      after = at(next);
    }
    const HarmonicPencil here = response_pencil(damping, static_cast<double>(n) * base);
    const double least = distance_from_singular(here, theta);
    moved.col(n).array() *= std::abs(here.mu) / ((here.mu * theta.cast<Complex>()).array() + here.kappa);
    result.beyond[n] = std::sqrt(
        std::max({0.0, acting.col(n).dot(weighed.col(n)).real(), rounding_ * acting.col(n).squaredNorm()}));
    result.ratio[n] = std::abs(here.mu / here.kappa);
    result.least[n] = least;
    result.elastic[n] = std::abs(here.kappa);
    result.factor[n] = (std::max(before.bracket, after.bracket) + left_out_of_start_) / least;
    result.cross[n] = std::max(before.moved, after.moved) / std::abs(here.kappa);
    result.cross_left_out[n] = std::max(before.left_out, after.left_out) / std::abs(here.kappa);
  }
  result.acting = dense_product(outside_, moved);
  result.left_out = dense_product(left_out_, moved).colwise().norm();
  return result;
}

SpaceRemainder::Lengths SpaceRemainder::lengths(const Residuals& residuals,
                                                const Eigen::MatrixXcd& acting) const {
  Lengths result{.whole = Eigen::VectorXd(acting.cols()),
                 .ahead = residuals.ahead.colwise().norm(),
                 .still = Eigen::VectorXd(acting.cols())};
  const Eigen::MatrixXcd seen = dense_product(outside_.transpose(), residuals.ahead);  // X^T K R b
  const double left_out = left_out_.norm();
  for (Eigen::Index n = 0; n < acting.cols(); ++n) {
    result.still[n] = std::hypot(result.ahead[n], residuals.beyond[n]);
    result.whole[n] = residuals.acting.col(n).norm() + residuals.left_out[n] +
                      residuals.ratio[n] * (seen.col(n).norm() + (left_out + smoothing_) * result.still[n]) +
                      left_out_of_start_ * acting.col(n).norm();
  }
  return result;
}

Eigen::VectorXd SpaceRemainder::bound(const Residuals& residuals, const Eigen::MatrixXcd& acting) const {
  const Lengths left = lengths(residuals, acting);
  return residuals.factor.cwiseProduct(left.whole) + residuals.cross.cwiseProduct(left.ahead) +
         residuals.cross_left_out.cwiseProduct(left.still);
}

Eigen::VectorXd SpaceRemainder::weighted_bound(const Residuals& of_weights, const Eigen::MatrixXcd& weights,
                                               const Residuals& residuals,
                                               const Eigen::MatrixXcd& acting) const {
  const Lengths left = lengths(residuals, acting), of_adjoint = lengths(of_weights, weights);
  const Eigen::VectorXd moved = of_weights.acting.colwise().norm(), hidden = of_weights.left_out.transpose();
  const Eigen::VectorXd bracket =
      of_adjoint.still + moved + hidden + left_out_of_start_ * weights.colwise().norm().transpose();
  return bracket.cwiseProduct(left.whole).cwiseQuotient(residuals.least) +
         (moved.cwiseProduct(left.ahead) + hidden.cwiseProduct(left.still)).cwiseQuotient(residuals.elastic);
}

bool SpaceRemainder::left_out_matters(const Residuals& residuals, double tolerance) {
  return root_mean_square(residuals.factor.cwiseProduct(residuals.left_out.transpose())) > kLeft * tolerance;
}

Eigen::MatrixXd SpaceRemainder::longest(const Residuals& residuals, double tolerance) const {
  const Eigen::VectorXd still = smoothing_ * residuals.factor.cwiseProduct(residuals.ratio) + residuals.cross;
  return principal_directions(
      mean_square(residuals.acting, residuals.factor) + mean_square(residuals.ahead, still),
      kLeft * tolerance, kMostAtOnce);
}

Eigen::MatrixXd SpaceRemainder::missing_columns(const Residuals& residuals, const Eigen::MatrixXcd& acting,
                                                double tolerance) const {
  const Eigen::VectorXd weight = smoothing_ * residuals.factor.cwiseProduct(residuals.ratio);
  if (root_mean_square(weight.cwiseProduct(residuals.beyond)) <= kLeft * tolerance)
    return Eigen::MatrixXd(acting.rows(), 0);
  // beyond = L L^T: combinations D = L^-T q make R D of unit length for unit q.
  const SymmetricEigen own = symmetric_eigen(beyond_);
  const Eigen::VectorXd& squares = own.values;  // rising
  const Eigen::Index known = (squares.array() > 10.0 * rounding_).count();
  if (known == 0) return Eigen::MatrixXd(acting.rows(), 0);
  const Eigen::MatrixXd W = own.vectors.rightCols(known);
  const Eigen::VectorXd length = squares.tail(known).cwiseSqrt();
  const Eigen::MatrixXd L = W * length.asDiagonal();
  const Eigen::MatrixXd largest = principal_directions(
      product(product_of_transposed(L, mean_square(acting, weight)), L), kLeft * tolerance, kMostAtOnce);
  return product(W, length.cwiseInverse().asDiagonal() * largest);
}

}  // namespace signorini
