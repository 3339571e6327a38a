#include "methods/hat_functions/continuation/hat_curve.hpp"

#include <cmath>
#include <complex>
#include <utility>

#include "methods/hat_functions/hat_contact.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

ReceptanceRate scheme_receptance(const Problem& problem, HatScheme scheme, int samples) {
  ReceptanceRate result = receptance_with_rate(problem, samples / 2, grid_weights(problem, scheme, samples));
  weigh_contact_force(result.value.receptance, scheme, samples);
  weigh_contact_force(result.receptance, scheme, samples);
  return result;
}

}  // namespace

HatCurve::HatCurve(const HatFamily& family, int multiple)
    : family_(family),
      samples_(multiple * family.samples),
      problem_(with_subharmonic(family.problem, multiple * family.problem.subharmonic)),
      stops_(nodal_stops(family.problem, family.restitution)) {
  receptance_ = scheme_receptance(problem_, family.scheme, samples_);
  const BlockCirculant middle = operator_of(receptance_.value.receptance, stops_.compliance);
  weight_.resize(problem_.contact_count());
  for (int c = 0; c < problem_.contact_count(); ++c)
    weight_[c] = std::abs(middle(c * samples_, c * samples_)) / family.displacement_unit;
  const Eigen::MatrixXd& E = receptance_.value.rigid;
  if (E.cols() > 0) border_ = E * E.colwise().lpNorm<Eigen::Infinity>().cwiseInverse().asDiagonal();
  const double largest = weight_.maxCoeff();
  // A contact whose own lag vanishes by accident borrows the scale of the others.
  weight_ = weight_.cwiseMax(largest > 0.0 ? 1e-3 * largest : 1.0);
}

BlockCirculant HatCurve::operator_of(const std::vector<Eigen::MatrixXcd>& receptance,
                                     const Eigen::VectorXd& diagonal) const {
  std::vector<Eigen::MatrixXcd> symbol;
  symbol.reserve(receptance.size());
  for (std::size_t n = 0; n < receptance.size(); ++n) {
    symbol.emplace_back(stops_.shift(static_cast<int>(n), samples_).asDiagonal() * receptance[n]);
    symbol.back().diagonal() += diagonal;
  }
  return {samples_, symbol};
}

// -S y of a function with coefficients y_n, n = 0..N/2, N Nc: what q is made of.
Eigen::VectorXd HatCurve::shifted_samples(const Eigen::MatrixXcd& spectrum) const {
  Eigen::MatrixXcd shifted = spectrum;
  for (Eigen::Index n = 0; n < shifted.rows(); ++n)
    shifted.row(n) *= stops_.shift(static_cast<int>(n), samples_).asDiagonal();
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(spectrum.cols());
  return -free_penetration(shifted, none, Eigen::VectorXd::Ones(spectrum.cols()), samples_);
}

bool HatCurve::evaluate(const Eigen::VectorXd& x) {
  const double frequency = x[size()] * family_.frequency_unit;
  if (!x.allFinite() || !(frequency > 0.0)) return false;
  problem_ = at_frequency(std::move(problem_), frequency);
  try {
    receptance_ = scheme_receptance(problem_, family_.scheme, samples_);
  } catch (const SingularStiffness&) {
    return false;
  }
  x_ = x;
  pressure_ = Eigen::VectorXd::Zero(nodes());
  for (Eigen::Index k = 0; k < pressing_count(); ++k) {
    const int node = pressing_[static_cast<std::size_t>(k)];
    pressure_[node] = x[k] / weight(node);
  }
  const double unit = family_.displacement_unit;
  matrix_.emplace(operator_of(receptance_.value.receptance, stops_.compliance));
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(problem_.contact_count());
  const BlockCirculant rate = operator_of(receptance_.receptance, none);
  gaps_ = shifted_samples(receptance_.value.free_response) + *matrix_ * pressure_;
  for (int c = 0; c < problem_.contact_count(); ++c)
    gaps_.segment(c * samples_, samples_).array() += stops_.gap[c];
  gaps_ /= unit;
  if (rigid_count() > 0) {
    const Eigen::VectorXd means = border_ * x.segment(pressing_count(), rigid_count());
    Eigen::VectorXd sums(problem_.contact_count());
    for (int c = 0; c < problem_.contact_count(); ++c) {
      gaps_.segment(c * samples_, samples_).array() -= means[c];
      sums[c] = pressure_.segment(c * samples_, samples_).sum();
    }
    const Eigen::VectorXd scale =
        receptance_.value.rigid.colwise().lpNorm<Eigen::Infinity>().transpose().cwiseInverse();
    balance_ = weight_.maxCoeff() *
               (border_.transpose() * sums - samples_ * scale.cwiseProduct(receptance_.value.rigid_load));
  }
  rates_ = (family_.frequency_unit / unit) * (shifted_samples(receptance_.free_response) + rate * pressure_);
  noise_ = kSumRounding * (1.0 + (x.size() > 1 ? x.head(size()).lpNorm<Eigen::Infinity>() : 0.0));
  return gaps_.allFinite() && rates_.allFinite();
}

Eigen::VectorXd HatCurve::residual() const {
  Eigen::VectorXd result(size());
  result << gaps_(pressing_), balance_.head(rigid_count());
  return result;
}

Eigen::MatrixXd HatCurve::jacobian() const {
  Eigen::MatrixXd J(size(), size() + 1);
  if (size() == 0) return J;
  const Eigen::Index count = pressing_count(), m = rigid_count();
  J.topLeftCorner(count, count) = matrix_->submatrix(pressing_, pressing_) / family_.displacement_unit;
  for (Eigen::Index k = 0; k < count; ++k) {
    const int node = pressing_[static_cast<std::size_t>(k)];
    J.col(k).head(count) /= weight(node);
    if (m == 0) continue;
    J.row(k).segment(count, m) = -border_.row(node / samples_);
    J.col(k).tail(m) = weight_.maxCoeff() / weight(node) * border_.row(node / samples_).transpose();
  }
  J.block(count, count, m, m).setZero();
  J.col(size()).head(count) = rates_(pressing_);
  J.col(size()).tail(m).setZero();
  return J;
}

double HatCurve::gap_rate(int node, const Eigen::VectorXd& tangent) const {
  double rate = rates_[node] * tangent[size()];
  if (rigid_count() > 0)
    rate -= border_.row(node / samples_).dot(tangent.segment(pressing_count(), rigid_count()));
  for (Eigen::Index k = 0; k < pressing_count(); ++k) {
    const int other = pressing_[static_cast<std::size_t>(k)];
    rate += (*matrix_)(node, other) / (family_.displacement_unit * weight(other)) * tangent[k];
  }
  return rate;
}

Eigen::VectorXd HatCurve::on_all(const Eigen::VectorXd& x) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(nodes() + rigid_count() + 1);
  all(pressing_) = x.head(pressing_count());
  all.tail(rigid_count() + 1) = x.tail(rigid_count() + 1);
  return all;
}

Eigen::VectorXd HatCurve::on_pressing(const Eigen::VectorXd& all) const {
  Eigen::VectorXd x(size() + 1);
  x << all(pressing_), all.tail(rigid_count() + 1);
  return x;
}

Eigen::MatrixXd HatCurve::motion() const {
  Eigen::MatrixXd x =
      nodal_response(receptance_.value, -pressure_.reshaped(samples_, problem_.contact_count()));
  if (rigid_count() > 0)
    x.rowwise() +=
        (family_.displacement_unit * border_ * x_.segment(pressing_count(), rigid_count())).transpose();
  return x;
}

}  // namespace signorini
