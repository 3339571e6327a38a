#include "methods/structure/contact_reduction.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>

#include "methods/solvers/constants.hpp"
#include "methods/solvers/dense_products.hpp"
#include "methods/structure/bases/block_lanczos.hpp"
#include "methods/structure/bases/modal_reduction.hpp"
#include "methods/structure/bases/ritz_reduction.hpp"

namespace signorini {

namespace {

// Powers of K^-1 M that make a Krylov space better than as many modes, and its largest size with them.
constexpr int kPowers = 6;
constexpr int kMostOfPowers = 300;
constexpr int kLeastVectors = 60;

/// Basis and size, none left open.
ReductionSettings chosen(ReductionSettings settings, Eigen::Index contacts, Eigen::Index loads) {
  const auto columns = static_cast<int>(contacts + loads);
  if (settings.basis == ReductionBasis::automatic) {
    settings.basis = kPowers * columns <= kMostOfPowers ? ReductionBasis::krylov : ReductionBasis::modes;
  }
  if (settings.vectors <= 0) {
    settings.vectors =
        settings.basis == ReductionBasis::krylov ? std::max(kPowers * columns, kLeastVectors) : kModes;
  }
  return settings;
}

}  // namespace

ContactReduction reduce_to_contacts(const Problem& problem, const ReductionSettings& settings) {
  ContactReduction result;
  const ContactColumns columns = contact_columns(problem);
  if (!columns.obstacle.empty()) {
    result = modal_reduction(problem);  // it takes other damping
    if (!result.obstacle.empty()) result.obstacle = columns.obstacle;
    return result;
  }
  const SparseMatrix &normals = columns.normals, &pushes = columns.pushes;
  const ReductionSettings asked = chosen(settings, normals.cols(), pushes.cols());
  const bool krylov = asked.basis == ReductionBasis::krylov;
  // M times random columns is nothing at massless coordinates.
  const SparseMatrix start =
      krylov ? columns.all()
             : side_by_side(pushes,
                            SparseMatrix(Eigen::MatrixXd(problem.mass() *
                                                         random_columns(problem.size(), kSolvedTogether - 1))
                                             .sparseView()));
  // More vectors than coordinates with mass would be rounding.
  const Eigen::Index most = columns.most();
  BlockLanczos space(problem.stiffness(), problem.mass(), start, most);
  if (!space.definite()) return ContactReduction::refused(kNotDefinite);
  // Of a Krylov space from random columns the upper half has not converged to modes, nor have the lowest
  // before some powers.
  const Eigen::Index enough = krylov ? asked.vectors : 2 * asked.vectors + kPowers * kSolvedTogether;
  space.grow_to(enough);
  if (krylov) {
    result = reduction_on(columns, projection_from_start(space, normals.cols()), space.size());
  } else {
    StaticCompliance statics(problem, space, columns);
    SpaceProjection projection = statics.projection(space);
    refine_lowest(problem, space, columns, projection);
    result = reduction_on(columns, projection, asked.vectors);
  }
  const bool whole = space.invariant() || space.size() >= most;
  result.complete = whole && (krylov || space.size() <= asked.vectors);
  return result;
}

CondensedStructure condensed(const ContactReduction& reduction) {
  const auto diagonal = [](const Eigen::VectorXd& entries) {
    return SparseMatrix(Eigen::MatrixXd(entries.asDiagonal()).sparseView());
  };
  CondensedStructure result;
  result.obstacle = reduction.obstacle;
  if (!result.obstacle.empty()) return result;
  result.mass = diagonal(Eigen::VectorXd::Ones(reduction.vectors()));
  result.damping = diagonal(reduction.damping);
  result.stiffness = diagonal(reduction.squares);
  result.normals = reduction.rows.sparseView();
  result.massless_compliance = reduction.compliance;
  result.relaxation = Eigen::VectorXd::Constant(
      reduction.contacts(), reduction.compliance.isZero(0.0) ? 0.0 : reduction.relaxation);
  result.rates = reduction.rates;
  result.load = reduction.load;
  result.shift = reduction.shift;
  return result;
}

namespace {

using Complex = std::complex<double>;

/// z_k of all vectors and what C_m is divided by, at the weights of a harmonic.
struct Divisors {
  Eigen::VectorXcd of_vectors;
  Complex of_rest;
};

/// \throws SingularStiffness where some z_k vanishes to rounding
Divisors divisors(const ContactReduction& reduction, const HarmonicWeights& w) {
  const Divisors result{.of_vectors = w.mass + w.damping * reduction.damping.cast<Complex>().array() +
                                      w.stiffness * reduction.squares.cast<Complex>().array(),
                        .of_rest = w.stiffness + reduction.relaxation * w.damping};
  const double scale = std::abs(w.mass) + std::abs(w.damping) * reduction.damping.maxCoeff() +
                       std::abs(w.stiffness) * reduction.squares.maxCoeff();
  if (!(result.of_vectors.cwiseAbs().minCoeff() > kEpsilon * scale)) throw SingularStiffness();
  return result;
}

}  // namespace

ContactReceptance contact_receptance(const ContactReduction& reduction, double period, int harmonics,
                                     const WeightsOfHarmonic& weights) {
  const double base = 2.0 * std::numbers::pi / period;
  const Eigen::MatrixXcd rows = reduction.rows.cast<Complex>();
  ContactReceptance result;
  result.period = period;
  result.free_response = Eigen::MatrixXcd::Zero(harmonics + 1, reduction.contacts());
  for (int n = 0; n <= harmonics; ++n) {
    const HarmonicWeights w = weights(n);
    const auto [z, kappa] = divisors(reduction, w);
    const Eigen::MatrixXcd response = z.cwiseInverse().asDiagonal() * rows;
    result.receptance.emplace_back(rows.transpose() * response +
                                   reduction.compliance.cast<Complex>() / kappa);
    for (std::size_t h = 0; h < reduction.rates.size(); ++h) {
      if (std::lround(reduction.rates[h] / base) != n) continue;
      const auto column = static_cast<Eigen::Index>(h);
      const double half = n == 0 ? 1.0 : 0.5;
      result.free_response.row(n) +=
          half * w.load *
          (response.transpose() * reduction.load.col(column) + reduction.shift.col(column) / kappa)
              .transpose();
    }
  }
  return result;
}

Eigen::MatrixXcd contact_response(const ContactReduction& reduction, double base,
                                  const Eigen::MatrixXcd& force) {
  const Eigen::Index count = force.rows();
  std::vector<int> pushing;  // of many contacts few close
  for (int j = 0; j < static_cast<int>(force.cols()); ++j) {
    if (!force.col(j).isZero(0.0)) pushing.push_back(j);
  }
  const Eigen::MatrixXcd forces = force(Eigen::all, pushing).transpose();
  Eigen::MatrixXcd modal = dense_product(Eigen::MatrixXd(reduction.rows(Eigen::all, pushing)), forces);
  Eigen::MatrixXcd direct = dense_product(Eigen::MatrixXd(reduction.compliance(Eigen::all, pushing)), forces);
  for (std::size_t h = 0; h < reduction.rates.size(); ++h) {
    const auto n = static_cast<Eigen::Index>(std::lround(reduction.rates[h] / base));
    if (n >= count) continue;
    const double half = n == 0 ? 1.0 : 0.5;
    modal.col(n) += half * reduction.load.col(static_cast<Eigen::Index>(h));
    direct.col(n) += half * reduction.shift.col(static_cast<Eigen::Index>(h));
  }
  for (Eigen::Index n = 0; n < count; ++n) {
    const auto [z, kappa] = divisors(reduction, exact_weights(static_cast<double>(n) * base));
    modal.col(n).array() /= z.array();
    direct.col(n) /= kappa;
  }
  return (dense_product(Eigen::MatrixXd(reduction.rows.transpose()), modal) + direct).transpose();
}

}  // namespace signorini
