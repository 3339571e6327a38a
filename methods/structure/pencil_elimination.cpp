#include "methods/structure/pencil_elimination.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace signorini {

Eigen::MatrixXcd start_columns(const HarmonicPencil& pencil, const Eigen::MatrixXd& rows, int contacts) {
  using Complex = std::complex<double>;
  const bool loaded = pencil.load.size() > 0;
  Eigen::MatrixXcd columns(rows.rows(), contacts + (loaded ? 1 : 0));
  columns.leftCols(contacts) = rows.leftCols(contacts).cast<Complex>();
  if (loaded) columns.col(contacts) = rows.rightCols(pencil.load.size()).cast<Complex>() * pencil.load;
  return columns;
}

PencilElimination::PencilElimination(const BlockLanczos& space, const std::vector<HarmonicPencil>& pencils,
                                     int contacts)
    : space_(space), pencils_(pencils), contacts_(contacts), fronts_(pencils.size()) {
  for (std::size_t n = 0; n < pencils_.size(); ++n) {
    Front& front = fronts_[n];
    front.rest = start_columns(pencils_[n], space_.projected_start(), contacts_);
    front.pivot = Eigen::MatrixXcd::Zero(space_.size(), space_.size());
    front.seen = Eigen::MatrixXcd::Zero(contacts_, contacts_);
  }
  take_newest_block();
}

void PencilElimination::take_newest_block() {
  const Eigen::MatrixXcd newest = space_.newest_mass().cast<std::complex<double>>();
  for (std::size_t n = 0; n < pencils_.size(); ++n) {
    if (fronts_[n].converged) continue;
    fronts_[n].pivot += pencils_[n].mu * newest;
    fronts_[n].pivot.diagonal().array() += pencils_[n].kappa;
  }
}

bool PencilElimination::advance(double tolerance, const Eigen::VectorXd& theta) {
  const Eigen::MatrixXcd coupling = space_.coupling().cast<std::complex<double>>();
  bool converged = true;
  for (std::size_t n = 0; n < pencils_.size(); ++n) {
    if (!fronts_[n].converged) {
      const double least = tolerance * distance_from_singular(pencils_[n], theta).least;
      advance(fronts_[n], pencils_[n], coupling, least);
    }
    converged = converged && fronts_[n].converged;
  }
  return converged;
}

void PencilElimination::advance(Front& front, const HarmonicPencil& pencil, const Eigen::MatrixXcd& coupling,
                                double least) const {
  const Eigen::PartialPivLU<Eigen::MatrixXcd> factors(front.pivot);
  const Eigen::MatrixXcd newest = factors.solve(front.rest);
  // What M carries out of the space is P-orthogonal to it: the residual, and the next block's right-hand
  // side.
  const Eigen::MatrixXcd outside = -pencil.mu * (coupling * newest);
  front.seen += front.rest.leftCols(contacts_).transpose() * newest.leftCols(contacts_);
  double error = outside.leftCols(contacts_).squaredNorm() / (least * front.seen.norm());
  if (pencil.load.size() > 0) {
    front.self += front.rest.col(contacts_).cwiseProduct(newest.col(contacts_)).sum();
    error = std::max(error, outside.col(contacts_).squaredNorm() / (least * std::abs(front.self)));
  }
  front.converged = error <= 1.0;
  front.rest = outside;
  // Schur complement of the block just eliminated; the next diagonal block is added when the space has grown.
  front.pivot = -pencil.mu * pencil.mu * (coupling * factors.solve(coupling.transpose()));
}

}  // namespace signorini
