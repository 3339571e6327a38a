#include "methods/structure/reduced_receptance.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "methods/structure/block_lanczos.hpp"
#include "methods/structure/dynamic_stiffness.hpp"
#include "problems/proportional_damping.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

/// Z = kappa P + mu M of one harmonic, and its load F phi.
struct HarmonicPencil {
  Complex kappa, mu;
  Eigen::VectorXcd load;  // phi, one number per load column; empty if the harmonic is not loaded
};

/// Block elimination of kappa + mu t for one harmonic, one block of t at a time: the part of the solution in
/// the newest block is all that its residual needs.
struct Front {
  Eigen::MatrixXcd pivot;  // the newest diagonal block after elimination of all before
  Eigen::MatrixXcd rest;   // its right-hand side, for each column of W and for the load, if any
  Eigen::MatrixXcd seen;   // W^T V (kappa + mu t)^{-1} V^T W
  Complex self = 0.0;      // the same of the load, transposed without conjugation
  bool converged = false;
};

/// Real and imaginary parts of the loads, Nd x 2 (H+1) at most, those that are not zero.
struct LoadColumns {
  std::vector<Eigen::Triplet<double>> entries;
  int count = 0;

  // Column of the part of a load, or -1 if it is zero.
  int add(const Eigen::VectorXd& part, int first_column) {
    if (part.isZero(0.0)) return -1;
    for (int i = 0; i < part.size(); ++i) {
      if (part[i] != 0.0) entries.emplace_back(i, first_column + count, part[i]);
    }
    return count++;
  }
};

class ReducedModel {
 public:
  ReducedModel(const Problem& problem, const ProportionalDamping& damping, int harmonics,
               const WeightsOfHarmonic& weights)
      : contacts_(problem.contact_count()) {
    gather_loads(problem, harmonics, weights);
    const double lowest = std::abs(weights(std::min(1, harmonics)).mass);
    for (const double shift : {0.0, lowest}) {
      shifted_ = problem.stiffness();
      if (shift > 0.0) shifted_ += shift * problem.mass();
      space_ = std::make_unique<BlockLanczos>(shifted_, problem.mass(), start_);
      shift_ = shift;
      if (space_->definite()) break;
    }
    for (int n = 0; n <= harmonics; ++n) {
      const HarmonicWeights w = weights(n);
      HarmonicPencil& pencil = pencils_[static_cast<std::size_t>(n)];
      pencil.kappa = w.stiffness + w.damping * damping.beta;
      const Complex inertia = w.mass + w.damping * damping.alpha;
      // A shift was needed: K is singular, and here Z is a multiple of it.
      if (shift_ > 0.0 && inertia == 0.0) throw SingularStiffness();
      pencil.mu = inertia - shift_ * pencil.kappa;
    }
  }

  [[nodiscard]] bool definite() const { return space_->definite(); }

  /// Grows the space until the error of every harmonic is below the tolerance. False if factorising every Z_n
  /// costs less.
  bool refine(double tolerance) {
    diagonalise();
    start_fronts();
    while (advance_fronts(tolerance) && !space_->exhausted()) {
      if (!grow()) return false;
      complete_pivots();
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
    result.report = {ReceptanceMethod::reduced, static_cast<int>(space_->size()), largest_error_, bound_};
    return result;
  }

 private:
  /// Of complex LU factorisations with the fill of P, and their solutions for every column of W.
  [[nodiscard]] double direct_operations() const {
    const SparseCholesky& real = space_->factors();
    return static_cast<double>(pencils_.size()) *
           (8.0 * real.operations() + 16.0 * contacts_ * real.entries());
  }

  void gather_loads(const Problem& problem, int harmonics, const WeightsOfHarmonic& weights) {
    LoadColumns columns;
    std::vector<std::pair<int, int>> places;
    const int loaded = std::min(harmonics, load_bandwidth(problem));
    for (int n = 0; n <= loaded; ++n) {
      const Eigen::VectorXcd load = weights(n).load * load_coefficient(problem, n);
      const int real = columns.add(load.real(), contacts_);
      places.emplace_back(real, columns.add(load.imag(), contacts_));
    }
    pencils_.resize(static_cast<std::size_t>(harmonics) + 1);
    for (std::size_t n = 0; n < places.size(); ++n) {
      if (places[n] == std::pair(-1, -1)) continue;
      pencils_[n].load = Eigen::VectorXcd::Zero(columns.count);
      if (places[n].first >= 0) pencils_[n].load[places[n].first] = 1.0;
      if (places[n].second >= 0) pencils_[n].load[places[n].second] = Complex(0.0, 1.0);
    }
    for (int j = 0; j < contacts_; ++j) {
      for (const auto& [dof, coefficient] : problem.contacts[static_cast<std::size_t>(j)].normal) {
        columns.entries.emplace_back(dof, j, coefficient);
      }
    }
    start_ = SparseMatrix(problem.size(), contacts_ + columns.count);
    start_.setFromTriplets(columns.entries.begin(), columns.entries.end());
  }

  bool grow() {
    operations_ += space_->operations_of_growth();
    if (operations_ > direct_operations()) return false;
    space_->grow();
    return true;
  }

  /// V^T W and V^T f_n.
  [[nodiscard]] Eigen::MatrixXcd start_columns(const HarmonicPencil& pencil,
                                               const Eigen::MatrixXd& rows) const {
    const bool loaded = pencil.load.size() > 0;
    Eigen::MatrixXcd columns(rows.rows(), contacts_ + (loaded ? 1 : 0));
    columns.leftCols(contacts_) = rows.leftCols(contacts_).cast<Complex>();
    if (loaded) columns.col(contacts_) = rows.rightCols(pencil.load.size()).cast<Complex>() * pencil.load;
    return columns;
  }

  void start_fronts() {
    fronts_.assign(pencils_.size(), {});
    for (std::size_t n = 0; n < pencils_.size(); ++n) {
      Front& front = fronts_[n];
      front.rest = start_columns(pencils_[n], space_->projected_start());
      front.pivot = Eigen::MatrixXcd::Zero(space_->size(), space_->size());
      front.seen = Eigen::MatrixXcd::Zero(contacts_, contacts_);
    }
    complete_pivots();
  }

  void complete_pivots() {
    const Eigen::MatrixXcd newest = space_->newest_mass().cast<Complex>();
    for (std::size_t n = 0; n < pencils_.size(); ++n) {
      if (fronts_[n].converged) continue;
      fronts_[n].pivot += pencils_[n].mu * newest;
      fronts_[n].pivot.diagonal().array() += pencils_[n].kappa;
    }
  }

  /// Eliminates the newest block for every harmonic that is not settled; false if all are.
  bool advance_fronts(double tolerance) {
    const Eigen::MatrixXcd coupling = space_->coupling().cast<Complex>();
    bool settled = true;
    for (std::size_t n = 0; n < pencils_.size(); ++n) {
      if (!fronts_[n].converged) advance(fronts_[n], pencils_[n], coupling, tolerance);
      settled = settled && fronts_[n].converged;
    }
    return !settled;
  }

  void advance(Front& front, const HarmonicPencil& pencil, const Eigen::MatrixXcd& coupling,
               double tolerance) const {
    const Eigen::PartialPivLU<Eigen::MatrixXcd> factors(front.pivot);
    const Eigen::MatrixXcd newest = factors.solve(front.rest);
    const Eigen::MatrixXcd outside = -pencil.mu * (coupling * newest);
    const double least = tolerance * distance(pencil).first;
    front.seen += front.rest.leftCols(contacts_).transpose() * newest.leftCols(contacts_);
    double error = outside.leftCols(contacts_).squaredNorm() / (least * front.seen.norm());
    if (pencil.load.size() > 0) {
      front.self += front.rest.col(contacts_).cwiseProduct(newest.col(contacts_)).sum();
      error = std::max(error, outside.col(contacts_).squaredNorm() / (least * std::abs(front.self)));
    }
    front.converged = error <= 1.0;
    front.rest = outside;
    front.pivot = -pencil.mu * pencil.mu * (coupling * factors.solve(coupling.transpose()));
  }

  void diagonalise() {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(space_->projected_mass());
    theta_ = modes.eigenvalues();
    vectors_ = modes.eigenvectors();
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
    return z.cwiseInverse().asDiagonal() * start_columns(pencil, rows_);
  }

  /// d_n, and whether it holds for the whole spectrum.
  [[nodiscard]] std::pair<double, bool> distance(const HarmonicPencil& pencil) const {
    const double top = theta_.maxCoeff();
    // The nearest point to the origin of the straight line of kappa + mu theta, 0 <= theta <= top.
    const double size = std::norm(pencil.mu);
    const double nearest =
        size > 0.0 ? std::clamp(-(std::conj(pencil.mu) * pencil.kappa).real() / size, 0.0, top) : 0.0;
    const double least = std::abs(pencil.kappa + pencil.mu * nearest);
    const double scale = std::abs(pencil.kappa) + std::abs(pencil.mu) * top;
    if (least > kUndamped * scale) return {least, true};
    return {(pencil.kappa + (pencil.mu * theta_.array().cast<Complex>())).abs().minCoeff(), false};
  }

  bool converged(double tolerance) {
    largest_error_ = 0.0;
    bound_ = true;
    // Where it failed last it fails first.
    for (std::size_t i = 0; i < pencils_.size(); ++i) {
      const std::size_t n = (hardest_ + i) % pencils_.size();
      const double error = relative_error(pencils_[n]);
      if (!(error <= tolerance)) {
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

  double relative_error(const HarmonicPencil& pencil) {
    const Eigen::MatrixXcd y = response(pencil);
    const std::pair<double, bool> nearest = distance(pencil);
    double error = 0.0;
    const auto add = [&](const Eigen::MatrixXcd& columns, double scale) {
      if (columns.cols() == 0 || scale == 0.0) return;
      const double rho = residual(pencil, columns);
      error = std::max(error, rho * rho / (nearest.first * scale));
    };
    add(y.leftCols(contacts_), (contact_rows_.transpose() * y.leftCols(contacts_)).norm());
    if (pencil.load.size() > 0) {
      const Eigen::VectorXcd load = rows_.rightCols(pencil.load.size()).cast<Complex>() * pencil.load;
      add(y.rightCols(1), std::abs(load.dot(y.col(contacts_))));
    }
    largest_error_ = std::max(largest_error_, error);
    bound_ = bound_ && nearest.second;
    return error;
  }

  // Damping relative to stiffness and inertia below which it is rounding.
  static constexpr double kUndamped = 1e-12;

  int contacts_;
  SparseMatrix start_;    // [W, loads]
  SparseMatrix shifted_;  // P
  double shift_ = 0.0;
  std::unique_ptr<BlockLanczos> space_;
  std::vector<HarmonicPencil> pencils_;
  Eigen::VectorXd theta_;
  Eigen::MatrixXd vectors_, rows_, contact_rows_;  // eigenvectors of t; what the modes see of the start, of W
  Eigen::MatrixXd outside_;                        // of M times each mode, what lies outside the space
  std::vector<Front> fronts_;
  double operations_ = 0.0;
  std::size_t hardest_ = 0;
  double largest_error_ = 0.0;
  bool bound_ = true;
};

}  // namespace

std::optional<ContactReceptance> reduced_receptance(const Problem& problem, int harmonics,
                                                    const WeightsOfHarmonic& weights, double tolerance) {
  const auto damping = proportional_damping(problem.mass(), problem.stiffness(), problem.damping());
  if (!damping || problem.contact_count() == 0) return std::nullopt;
  ReducedModel model(problem, *damping, harmonics, weights);
  if (!model.definite() || !model.refine(tolerance)) return std::nullopt;
  return model.receptance(problem);
}

}  // namespace signorini
