#include "methods/structure/receptance.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

#include "methods/discretisation/real_fft.hpp"
#include "methods/structure/block_lanczos.hpp"
#include "methods/structure/harmonic_pencil.hpp"
#include "problems/matrix_properties.hpp"

namespace signorini {

namespace {

// Right-hand sides solved for at a time: bounds what is kept beside the factors.
constexpr int kColumns = 32;

using Complex = std::complex<double>;

/// The structure projected on a Krylov space that grows until it suffices.
class ReducedModel {
 public:
  ReducedModel(const Problem& problem, const ProportionalDamping& damping, int harmonics,
               const WeightsOfHarmonic& weights)
      : contacts_(problem.contact_count()), loads_(pencil_loads(problem, harmonics, weights)) {
    // sigma = 0 where K is definite; else K + sigma M is, sigma of the size that M has beside K in Z_1.
    const double lowest = std::abs(weights(std::min(1, harmonics)).mass);
    double shift = 0.0;
    for (const double sigma : {0.0, lowest}) {
      shift = sigma;
      shifted_ = problem.stiffness();
      if (shift > 0.0) shifted_ += shift * problem.mass();
      space_ = std::make_unique<BlockLanczos>(shifted_, problem.mass(), loads_.columns);
      if (space_->definite()) break;
    }
    pencils_ = harmonic_pencils(damping, shift, harmonics, weights, loads_);
  }

  [[nodiscard]] bool definite() const { return space_->definite(); }

  /// Grows the space until the error of every harmonic is below the tolerance. False if factorising every Z_n
  /// costs less.
  bool refine(double tolerance) {
    diagonalise();
    // The cheap estimate first, block by block; then the bound itself, which needs the modes of t.
    PencilElimination elimination(*space_, pencils_, contacts_);
    while (!elimination.advance(tolerance, theta_) && !space_->exhausted()) {
      if (!grow()) return false;
      elimination.take_newest_block();
    }
    diagonalise();
    while (!converged(tolerance)) {
      if (space_->exhausted() || !grow()) return false;
      diagonalise();
    }
    return true;
  }

  [[nodiscard]] ContactReceptance receptance(const Problem& problem) const {
    ContactReceptance result;
    result.period = problem.period();
    result.free_response = Eigen::MatrixXcd::Zero(std::ssize(pencils_), contacts_);
    for (std::size_t n = 0; n < pencils_.size(); ++n) {
      const Eigen::MatrixXcd y = response(pencils_[n]);
      const Eigen::MatrixXcd seen = contact_rows_.transpose() * y;
      result.receptance.emplace_back(seen.leftCols(contacts_));
      if (pencils_[n].load.size() > 0) {
        result.free_response.row(static_cast<Eigen::Index>(n)) = seen.col(contacts_).transpose();
      }
    }
    return result;
  }

 private:
  /// Floating-point operations of complex LU factorisations with the fill of P, and of their solutions for
  /// every column of W.
  [[nodiscard]] double direct_operations() const {
    const SparseCholesky& real = space_->factors();
    return static_cast<double>(pencils_.size()) *
           (8.0 * real.operations() + 16.0 * contacts_ * real.entries());
  }

  bool grow() {
    operations_ += space_->operations_of_growth();
    if (operations_ > direct_operations()) return false;
    space_->grow();
    return true;
  }

  /// t = U diag(theta) U^T: modes of the projection, in whose coordinates every harmonic is diagonal.
  void diagonalise() {
    RitzPairs modes = ritz_pairs(*space_);
    theta_ = std::move(modes.values);
    vectors_ = std::move(modes.vectors);
    rows_ = vectors_.transpose() * space_->projected_start();
    contact_rows_ = rows_.leftCols(contacts_);
    outside_ = space_->coupling() * vectors_.bottomRows(space_->coupling().cols());
  }

  /// Modal coordinates of the response to each column of W and to the load, if any.
  [[nodiscard]] Eigen::MatrixXcd response(const HarmonicPencil& pencil) const {
    const Eigen::VectorXcd z = pencil.kappa + (pencil.mu * theta_.array().cast<Complex>()).array();
    const double scale = std::abs(pencil.kappa) + std::abs(pencil.mu) * theta_.maxCoeff();
    if (!(z.cwiseAbs().minCoeff() > std::numeric_limits<double>::epsilon() * scale))
      throw SingularStiffness();
    return z.cwiseInverse().asDiagonal() * start_columns(pencil, rows_, contacts_);
  }

  bool converged(double tolerance) {
    // Where it failed last it fails first.
    for (std::size_t i = 0; i < pencils_.size(); ++i) {
      const std::size_t n = (hardest_ + i) % pencils_.size();
      if (!(relative_error(pencils_[n]) <= tolerance)) {
        hardest_ = n;
        return false;
      }
    }
    return true;
  }

  /// |b - Z_n V y|_{P^{-1}} of columns b of W or the load, V y in modal coordinates.
  [[nodiscard]] double residual(const HarmonicPencil& pencil, const Eigen::MatrixXcd& y) const {
    return std::abs(pencil.mu) * ((outside_ * y).norm() + space_->omitted() * y.norm()) +
           space_->omitted_start() * std::sqrt(static_cast<double>(y.cols()));
  }

  [[nodiscard]] double relative_error(const HarmonicPencil& pencil) const {
    const Eigen::MatrixXcd y = response(pencil);
    const double nearest = distance_from_singular(pencil, theta_);
    double error = 0.0;
    const auto add = [&](const Eigen::MatrixXcd& columns, double scale) {
      if (columns.cols() == 0 || scale == 0.0) return;
      const double rho = residual(pencil, columns);
      error = std::max(error, rho * rho / (nearest * scale));
    };
    add(y.leftCols(contacts_), (contact_rows_.transpose() * y.leftCols(contacts_)).norm());
    if (pencil.load.size() > 0) {
      const Eigen::VectorXcd load = rows_.rightCols(pencil.load.size()).cast<Complex>() * pencil.load;
      add(y.rightCols(1), std::abs(load.dot(y.col(contacts_))));
    }
    return error;
  }

  int contacts_;
  PencilLoads loads_;
  SparseMatrix shifted_;  // P
  std::unique_ptr<BlockLanczos> space_;
  std::vector<HarmonicPencil> pencils_;
  Eigen::VectorXd theta_;
  Eigen::MatrixXd vectors_, rows_, contact_rows_;  // U; U^T V^T [W, F]; its part of W
  Eigen::MatrixXd outside_;                        // of M times each mode, what lies outside the space
  double operations_ = 0.0;
  std::size_t hardest_ = 0;  // the harmonic whose error was too large last
};

}  // namespace

Eigen::MatrixXcd contact_motion(const ContactReceptance& receptance, const Eigen::MatrixXcd& lambda) {
  Eigen::MatrixXcd x = receptance.free_response;
  for (Eigen::Index n = 0; n < x.rows(); ++n)
    x.row(n) += (receptance.receptance[static_cast<std::size_t>(n)] * lambda.row(n).transpose()).transpose();
  return x;
}

bool is_mass_beyond(const ContactReceptance& receptance, int contact, int harmonic) {
  constexpr double kLike = 0.5;
  const int last = receptance.harmonics();
  const auto inertance = [&](int n) {
    const double order = n;
    return -order * order * receptance.receptance[static_cast<std::size_t>(n)](contact, contact);
  };
  const double a = inertance(last).real();
  if (!(a > 0.0)) return false;
  for (int n = harmonic + 1; n <= last; ++n) {
    if (!(std::abs(inertance(n) - a) <= kLike * a)) return false;
  }
  return true;
}

Eigen::MatrixXd nodal_response(const ContactReceptance& receptance, const Eigen::MatrixXd& force) {
  RealFft fft(static_cast<int>(force.rows()));
  Eigen::MatrixXcd spectrum(fft.coefficients(), force.cols());
  for (Eigen::Index c = 0; c < force.cols(); ++c) fft.forward(force.col(c), spectrum.col(c));
  if (force.cols() > 0) spectrum = contact_motion(receptance, spectrum);
  Eigen::MatrixXd x(force.rows(), force.cols());
  for (Eigen::Index c = 0; c < force.cols(); ++c) fft.inverse(spectrum.col(c), x.col(c));
  return x;
}

ContactReceptance factorised_receptance(const Problem& problem, int harmonics,
                                        const WeightsOfHarmonic& weights, bool dense) {
  const int contacts = problem.contact_count();
  const SparseMatrix directions = contact_directions(problem);
  const int loaded = load_bandwidth(problem);
  DynamicStiffness stiffness(problem, dense);
  ContactReceptance result;
  result.period = problem.period();
  result.receptance.assign(static_cast<std::size_t>(harmonics) + 1, Eigen::MatrixXcd(contacts, contacts));
  result.free_response = Eigen::MatrixXcd::Zero(harmonics + 1, contacts);
  for (int n = 0; n <= harmonics; ++n) {
    const HarmonicWeights weight = weights(n);
    stiffness.factorise(weight);
    for (int first = 0; first < contacts; first += kColumns) {
      const int count = std::min(kColumns, contacts - first);
      const Eigen::MatrixXcd columns =
          Eigen::MatrixXd(directions.middleCols(first, count)).cast<std::complex<double>>();
      result.receptance[static_cast<std::size_t>(n)].middleCols(first, count) =
          directions.transpose() * stiffness.solve(columns);
    }
    if (n > loaded) continue;
    const Eigen::MatrixXcd load = weight.load * load_coefficient(problem, n);
    result.free_response.row(n) = (directions.transpose() * stiffness.solve(load)).transpose();
  }
  return result;
}

std::optional<ContactReceptance> reduced_receptance(const Problem& problem, int harmonics,
                                                    const WeightsOfHarmonic& weights, double tolerance) {
  const auto damping = proportional_damping(problem.mass(), problem.stiffness(), problem.damping());
  if (!damping || problem.contact_count() == 0) return std::nullopt;
  ReducedModel model(problem, *damping, harmonics, weights);
  if (!model.definite() || !model.refine(tolerance)) return std::nullopt;
  return model.receptance(problem);
}

ContactReceptance contact_receptance(const Problem& problem, int harmonics,
                                     const WeightsOfHarmonic& weights) {
  if (problem.size() > kMostFactorised) {
    if (auto reduced = reduced_receptance(problem, harmonics, weights, kReducedTolerance))
      return *std::move(reduced);
  }
  return factorised_receptance(problem, harmonics, weights, prefers_dense(problem));
}

ContactReceptance fourier_receptance(const Problem& problem, int harmonics) {
  const double base = problem.base_frequency();
  return contact_receptance(problem, harmonics, [base](int n) { return exact_weights(n * base); });
}

}  // namespace signorini
