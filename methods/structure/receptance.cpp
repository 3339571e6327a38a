#include "methods/structure/receptance.hpp"

#include <cblas.h>

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
#include "methods/structure/ritz_reduction.hpp"
#include "problems/matrix_properties.hpp"

namespace signorini {

namespace {

// Right-hand sides solved for at a time: bounds what is kept beside the factors.
constexpr int kColumns = 32;

using Complex = std::complex<double>;

// Vectors of the reduction that goes with a receptance: a march's grid leaves more than others would.
constexpr Eigen::Index kMarchedVectors = 100;

/// A diag(d) B for real A and B, by the BLAS: an eighth of a complex product's work.
Eigen::MatrixXcd scaled_product(const Eigen::MatrixXd& A, const Eigen::VectorXcd& d,
                                const Eigen::MatrixXd& B) {
  Eigen::MatrixXcd result(A.rows(), B.cols());
  const auto rows = static_cast<int>(A.rows()), columns = static_cast<int>(B.cols()),
             inner = static_cast<int>(B.rows());
  if (result.size() == 0) return result;
  Eigen::MatrixXd scaled(inner, columns), part(rows, columns);
  const auto times = [&](const Eigen::VectorXd& weight) -> const Eigen::MatrixXd& {
    scaled = weight.asDiagonal() * B;
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, rows, columns, inner, 1.0, A.data(), rows,
                scaled.data(), inner, 0.0, part.data(), rows);
    return part;
  };
  result.real() = times(d.real());
  result.imag() = times(d.imag());
  return result;
}

ContactReduction no_reduction(std::string obstacle) {
  ContactReduction result;
  result.obstacle = std::move(obstacle);
  return result;
}

/// Harmonics 0..last that rise by a tenth.
std::vector<std::size_t> sampled_harmonics(std::size_t last) {
  std::vector<std::size_t> result;
  for (std::size_t n = 0; n < last; n = std::max(n + 1, n + n / 10)) result.push_back(n);
  result.push_back(last);
  return result;
}

/// The structure projected on a Krylov space that grows until it suffices.
class ReducedModel {
 public:
  ReducedModel(const Problem& problem, const ProportionalDamping& damping, int harmonics,
               const WeightsOfHarmonic& weights)
      : contacts_(problem.contact_count()), loads_(pencil_loads(problem, harmonics, weights)) {
    // sigma = 0 where K is definite; else K + sigma M is, sigma of the size that M has beside K in Z_1.
    const double lowest = std::abs(weights(std::min(1, harmonics)).mass);
    for (const double sigma : {0.0, lowest}) {
      shift_ = sigma;
      shifted_ = problem.stiffness();
      if (shift_ > 0.0) shifted_ += shift_ * problem.mass();
      space_ = std::make_unique<BlockLanczos>(shifted_, problem.mass(), loads_.columns);
      if (space_->definite()) break;
    }
    pencils_ = harmonic_pencils(damping, shift_, harmonics, weights, loads_);
  }

  [[nodiscard]] bool definite() const { return space_->definite(); }

  /// Grows the space until the error of every harmonic is below the tolerance. False if factorising every Z_n
  /// costs less.
  bool refine(double tolerance) {
    diagonalise();
    // The cheap estimate first, block by block; then the bound itself, which needs the modes of t.
    std::vector<HarmonicPencil> sampled;
    for (const std::size_t n : sampled_harmonics(pencils_.size() - 1)) sampled.push_back(pencils_[n]);
    PencilElimination elimination(*space_, sampled, contacts_);
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
      const Eigen::VectorXcd inverse = inverse_of(pencils_[n]);
      result.receptance.push_back(seen(inverse));
      if (pencils_[n].load.size() == 0) continue;
      const Eigen::VectorXcd response = inverse.cwiseProduct(load_of(pencils_[n]));
      result.free_response.row(static_cast<Eigen::Index>(n)) =
          (contact_rows_.transpose() * response).transpose();
    }
    return result;
  }

  /// On the lowest vectors. \param weights  of the loads that the space was started from
  [[nodiscard]] ContactReduction reduction(const Problem& problem, const ProportionalDamping& damping,
                                           const WeightsOfHarmonic& weights) const {
    if (shift_ > 0.0) return no_reduction(std::string(kNotDefinite));
    ContactColumns columns;
    columns.damping = damping;
    columns.normals = SparseMatrix(problem.size(), contacts_);
    const Eigen::Index loads = loads_.columns.cols() - contacts_;
    // The space holds all statics, those of massless coordinates too.
    columns.compliance = Eigen::MatrixXd::Zero(contacts_ + loads, contacts_ + loads);
    std::vector<Eigen::VectorXcd> parts;
    for (std::size_t n = 0; n < loads_.weight.size(); ++n) {
      if (n > 0 && loads_.weight[n].size() == 0) continue;
      columns.load.rates.push_back(static_cast<double>(n) * problem.base_frequency());
      parts.push_back(loads_.weight[n].size() == 0 ? Eigen::VectorXcd::Zero(loads) : loads_.weight[n]);
      parts.back() *= (n == 0 ? 1.0 : 2.0) / weights(static_cast<int>(n)).load;
    }
    columns.load.weight.resize(loads, std::ssize(parts));
    for (std::size_t h = 0; h < parts.size(); ++h)
      columns.load.weight.col(static_cast<Eigen::Index>(h)) = parts[h];
    return reduction_on(columns, projection_from_start(*space_, contacts_), kMarchedVectors);
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
    seen_ = contact_rows_.transpose();
    outside_ = space_->coupling() * vectors_.bottomRows(space_->coupling().cols());
  }

  /// 1 / (kappa + mu theta).
  [[nodiscard]] Eigen::VectorXcd inverse_of(const HarmonicPencil& pencil) const {
    const Eigen::VectorXcd z = pencil.kappa + (pencil.mu * theta_.array().cast<Complex>()).array();
    const double scale = std::abs(pencil.kappa) + std::abs(pencil.mu) * theta_.maxCoeff();
    if (!(z.cwiseAbs().minCoeff() > std::numeric_limits<double>::epsilon() * scale))
      throw SingularStiffness();
    return z.cwiseInverse();
  }

  /// C_n.
  [[nodiscard]] Eigen::MatrixXcd seen(const Eigen::VectorXcd& inverse) const {
    return scaled_product(seen_, inverse, contact_rows_);
  }

  /// The load in modal coordinates.
  [[nodiscard]] Eigen::VectorXcd load_of(const HarmonicPencil& pencil) const {
    return rows_.rightCols(pencil.load.size()).cast<Complex>() * pencil.load;
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

  /// |b - Z_n V y|_{P^{-1}} from what y leaves outside of the space, its norm and the number of columns b.
  [[nodiscard]] double residual(const HarmonicPencil& pencil, double outside, double size,
                                Eigen::Index columns) const {
    return std::abs(pencil.mu) * (outside + space_->omitted() * size) +
           space_->omitted_start() * std::sqrt(static_cast<double>(columns));
  }

  [[nodiscard]] double relative_error(const HarmonicPencil& pencil) const {
    const Eigen::VectorXcd inverse = inverse_of(pencil);
    const double nearest = distance_from_singular(pencil, theta_);
    double error = 0.0;
    const auto add = [&](double rho, double scale) {
      if (scale != 0.0) error = std::max(error, rho * rho / (nearest * scale));
    };
    const double size = std::sqrt(inverse.cwiseAbs2().dot(contact_rows_.rowwise().squaredNorm()));
    add(residual(pencil, scaled_product(outside_, inverse, contact_rows_).norm(), size, contacts_),
        seen(inverse).norm());
    if (pencil.load.size() > 0) {
      const Eigen::VectorXcd load = load_of(pencil), y = inverse.cwiseProduct(load);
      add(residual(pencil, (outside_ * y).norm(), y.norm(), 1), std::abs(load.dot(y)));
    }
    return error;
  }

  int contacts_;
  PencilLoads loads_;
  SparseMatrix shifted_;  // P
  std::unique_ptr<BlockLanczos> space_;
  std::vector<HarmonicPencil> pencils_;
  Eigen::VectorXd theta_;
  double shift_ = 0.0;
  Eigen::MatrixXd vectors_, rows_, contact_rows_;  // U; U^T V^T [W, F]; its part of W
  Eigen::MatrixXd seen_;                           // of W, transposed
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

std::optional<ReducedReceptance> reduced_receptance(const Problem& problem, int harmonics,
                                                    const WeightsOfHarmonic& weights, double tolerance) {
  const auto damping = proportional_damping(problem.mass(), problem.stiffness(), problem.damping());
  if (!damping || problem.contact_count() == 0) return std::nullopt;
  ReducedModel model(problem, *damping, harmonics, weights);
  if (!model.definite() || !model.refine(tolerance)) return std::nullopt;
  return ReducedReceptance{.value = model.receptance(problem),
                           .reduction = model.reduction(problem, *damping, weights)};
}

ReducedReceptance reduced_contact_receptance(const Problem& problem, int harmonics,
                                             const WeightsOfHarmonic& weights) {
  if (problem.size() > kMostFactorised) {
    if (auto reduced = reduced_receptance(problem, harmonics, weights, kReducedTolerance))
      return *std::move(reduced);
  }
  return {.value = factorised_receptance(problem, harmonics, weights, prefers_dense(problem)),
          .reduction = no_reduction("every harmonic was factorised")};
}

ContactReceptance contact_receptance(const Problem& problem, int harmonics,
                                     const WeightsOfHarmonic& weights) {
  return reduced_contact_receptance(problem, harmonics, weights).value;
}

ContactReceptance fourier_receptance(const Problem& problem, int harmonics) {
  const double base = problem.base_frequency();
  return contact_receptance(problem, harmonics, [base](int n) { return exact_weights(n * base); });
}

}  // namespace signorini
