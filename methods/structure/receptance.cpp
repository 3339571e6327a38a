#include "methods/structure/receptance.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "methods/discretisation/real_fft.hpp"
#include "methods/structure/bases/block_lanczos.hpp"
#include "methods/structure/bases/modal_reduction.hpp"
#include "methods/structure/bases/ritz_reduction.hpp"
#include "methods/structure/bases/structure_modes.hpp"
#include "methods/structure/contact_reduction.hpp"
#include "methods/structure/harmonic_pencil.hpp"
#include "methods/structure/rigid_motions.hpp"
#include "problems/matrix_properties.hpp"

namespace signorini {

namespace {

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
      if (shift_ > 0.0)
        shifted_ = combination({.alpha = shift_, .beta = 1.0}, problem.mass(), problem.stiffness());
      space_ = std::make_unique<BlockLanczos>(shift_ > 0.0 ? shifted_ : problem.stiffness(), problem.mass(),
                                              loads_.columns);
      if (space_->definite()) break;
    }
    pencils_ = harmonic_pencils(damping, shift_, harmonics, weights, loads_);
  }

  [[nodiscard]] bool definite() const { return space_->definite(); }

  /// Grows the space until the error of every harmonic is below the tolerance, but for those that cost less
  /// to factorise than what was spent so far. False if factorising every Z_n costs less.
  bool refine(double tolerance) {
    diagonalise();
    // The cheap estimate first, block by block; then the bound itself, which needs the modes of t.
    std::vector<HarmonicPencil> sampled;
    const std::vector<std::size_t> numbers = sampled_harmonics(pencils_.size() - 1);
    for (const std::size_t n : numbers) sampled.push_back(pencils_[n]);
    PencilElimination elimination(*space_, sampled, contacts_);
    while (!elimination.advance(tolerance, modes_->theta()) && !space_->exhausted()) {
      if (are_cheap(harmonics_open(elimination, numbers))) break;
      if (!grow()) return false;
      elimination.take_newest_block();
    }
    for (diagonalise(); !are_cheap(find_open(tolerance)); diagonalise()) {
      if (left_out_matters_ && space_->width_with_left_out() > space_->width()) {
        if (!grow(true)) return false;
        continue;
      }
      // The modes cost more than a block: several of these at a time.
      for (Eigen::Index least = space_->size() + std::max<Eigen::Index>(1, space_->size() / kGrowth);
           space_->size() < least;) {
        if (space_->exhausted() || !grow()) return false;
      }
    }
    return true;
  }

  /// Harmonics whose error is above the tolerance, ascending: where damping is next to nothing at a resonance
  /// a space must hold its modes to the last digit. They are to be factorised.
  [[nodiscard]] const std::vector<int>& open() const { return open_; }

  /// But for the open harmonics.
  [[nodiscard]] ContactReceptance receptance(const Problem& problem) const {
    ContactReceptance result;
    result.period = problem.period();
    result.free_response = Eigen::MatrixXcd::Zero(std::ssize(pencils_), contacts_);
    result.receptance.resize(pencils_.size());
    for (std::size_t n = 0; n < pencils_.size(); ++n) {
      if (std::ranges::binary_search(open_, static_cast<int>(n))) continue;
      const Eigen::VectorXcd inverse = *modes_->inverse_of(pencils_[n]);  // the error was found with it
      result.receptance[n] = modes_->receptance(inverse);
      if (pencils_[n].load.size() == 0) continue;
      result.free_response.row(static_cast<Eigen::Index>(n)) =
          modes_->free_response(pencils_[n], inverse).transpose();
    }
    return result;
  }

  /// On the lowest vectors. \param weights  of the loads that the space was started from
  [[nodiscard]] ContactReduction reduction(const Problem& problem, const ProportionalDamping& damping,
                                           const WeightsOfHarmonic& weights) const {
    if (shift_ > 0.0) return ContactReduction::refused(kNotDefinite);
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
    return reduction_on(columns, projection_from_start(*space_, contacts_), kModes);
  }

 private:
  static constexpr Eigen::Index kGrowth = 20;

  /// Floating-point operations of so many complex LU factorisations with the fill of P, and of their
  /// solutions for every column of W.
  [[nodiscard]] double direct_operations(std::size_t harmonics) const {
    const DefiniteSolver& real = space_->factors();
    return static_cast<double>(harmonics) * (8.0 * real.operations() + 16.0 * contacts_ * real.entries());
  }

  /// Whether factorising so many harmonics costs no more than the space so far: at most twice the least
  /// cost is spent in all.
  [[nodiscard]] bool are_cheap(std::size_t harmonics) const {
    return direct_operations(harmonics) <= operations_;
  }

  /// How many harmonics those stand for that are open among the sampled ones.
  static std::size_t harmonics_open(const PencilElimination& elimination,
                                    const std::vector<std::size_t>& numbers) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (elimination.is_open(i)) count += i == 0 ? 1 : numbers[i] - numbers[i - 1];
    return count;
  }

  bool grow(bool by_left_out = false) {
    operations_ += space_->operations_of_growth(by_left_out);
    if (operations_ > direct_operations(pencils_.size())) return false;
    by_left_out ? space_->grow_by_left_out() : space_->grow();
    return true;
  }

  void diagonalise() {
    constexpr double kOfModes = 9.0;  // a tridiagonal form and its eigenvectors, times the cube of the size
    operations_ += kOfModes * std::pow(static_cast<double>(space_->size()), 3);
    modes_.emplace(*space_, contacts_);
  }

  /// Fills open_. \return how many
  std::size_t find_open(double tolerance) {
    open_.clear();
    left_out_matters_ = false;
    for (std::size_t n = 0; n < pencils_.size(); ++n) {
      const PencilModes::Error error = modes_->relative_error(pencils_[n]);
      if (error.all <= tolerance) continue;
      open_.push_back(static_cast<int>(n));
      left_out_matters_ = left_out_matters_ || error.outside <= tolerance;
    }
    return open_.size();
  }

  int contacts_;
  PencilLoads loads_;
  SparseMatrix shifted_;  // P
  std::unique_ptr<BlockLanczos> space_;
  std::vector<HarmonicPencil> pencils_;
  std::optional<PencilModes> modes_;
  double shift_ = 0.0;
  double operations_ = 0.0;
  std::vector<int> open_;
  bool left_out_matters_ = false;  // some are open because of it alone
};

/// Whether all modes at once cost less than a factorisation per harmonic.
bool prefers_modes(const Problem& problem, int harmonics) {
  constexpr int kHarmonics = 16;
  return !prefers_dense(problem) && harmonics >= kHarmonics && has_full_damping(problem);
}

/// C_n and free_n of some harmonics, by factorising their Z_n.
void factorise_harmonics(const Problem& problem, const std::vector<int>& harmonics,
                         const WeightsOfHarmonic& weights, bool dense, ContactReceptance& result) {
  const int contacts = problem.contact_count();
  const SparseMatrix directions = contact_directions(problem);
  const int loaded = load_bandwidth(problem);
  DynamicStiffness stiffness(problem, dense);
  const auto normals = [&](int first, int count) {
    return Eigen::MatrixXcd(
        Eigen::MatrixXd(directions.middleCols(first, count)).cast<std::complex<double>>());
  };
  // Few contacts have the same right-hand sides at every harmonic; those of many are too large to be kept.
  const Eigen::MatrixXcd kept = contacts <= kMostSolvedAtOnce ? normals(0, contacts) : Eigen::MatrixXcd{};
  for (const int n : harmonics) {
    const HarmonicWeights weight = weights(n);
    if (!factorise_or_hold(problem, weight, stiffness, result)) continue;
    Eigen::MatrixXcd& receptance = result.receptance[static_cast<std::size_t>(n)];
    receptance.resize(contacts, contacts);
    for (int first = 0; first < contacts; first += kMostSolvedAtOnce) {
      const int count = std::min(kMostSolvedAtOnce, contacts - first);
      receptance.middleCols(first, count) =
          directions.transpose() *
          (contacts <= kMostSolvedAtOnce ? stiffness.solve(kept) : stiffness.solve(normals(first, count)));
    }
    if (n > loaded) continue;
    const Eigen::MatrixXcd load = weight.load * load_coefficient(problem, n);
    result.free_response.row(n) = (directions.transpose() * stiffness.solve(load)).transpose();
  }
}

}  // namespace

Eigen::MatrixXcd contact_motion(const ContactReceptance& receptance, const Eigen::MatrixXcd& lambda) {
  Eigen::MatrixXcd x = receptance.free_response;
  for (Eigen::Index n = 0; n < x.rows(); ++n)
    x.row(n) += (receptance.receptance[static_cast<std::size_t>(n)] * lambda.row(n).transpose()).transpose();
  return x;
}

InertialLimit inertial_limit(const ContactReceptance& receptance) {
  // C_n n^2 and C_n n^3 tend to -a and -i b with an error of second order in 1/n: two harmonics remove it.
  const int last = receptance.harmonics();
  const int middle = std::max(1, last / 2);
  const auto scaled = [&](int n) {
    const double order = n;
    return Eigen::MatrixXcd(-order * order * receptance.receptance[static_cast<std::size_t>(n)]);
  };
  const double ratio = static_cast<double>(middle) / last;
  const double weight = middle < last ? 1.0 / (1.0 - ratio * ratio) : 1.0;
  const Eigen::MatrixXcd far = scaled(last);
  const Eigen::MatrixXcd near = scaled(middle);
  return {.a = weight * far.real() + (1.0 - weight) * near.real(),
          .b = weight * last * far.imag() + (1.0 - weight) * middle * near.imag()};
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
  ContactReceptance result;
  result.period = problem.period();
  result.receptance.resize(static_cast<std::size_t>(harmonics) + 1);
  result.free_response = Eigen::MatrixXcd::Zero(harmonics + 1, problem.contact_count());
  std::vector<int> all(static_cast<std::size_t>(harmonics) + 1);
  std::iota(all.begin(), all.end(), 0);
  factorise_harmonics(problem, all, weights, dense, result);
  return result;
}

std::optional<ReducedReceptance> reduced_receptance(const Problem& problem, int harmonics,
                                                    const WeightsOfHarmonic& weights, double tolerance) {
  const auto damping = proportional_damping(*problem.structure);
  if (!damping || problem.contact_count() == 0) return std::nullopt;
  ReducedModel model(problem, *damping, harmonics, weights);
  if (!model.definite() || !model.refine(tolerance)) return std::nullopt;
  ReducedReceptance result{.value = model.receptance(problem),
                           .reduction = model.reduction(problem, *damping, weights)};
  if (!model.open().empty()) factorise_harmonics(problem, model.open(), weights, false, result.value);
  return result;
}

ReducedReceptance reduced_contact_receptance(const Problem& problem, int harmonics,
                                             const WeightsOfHarmonic& weights) {
  if (problem.size() > kMostFactorised) {
    if (auto reduced = reduced_receptance(problem, harmonics, weights, kReducedTolerance))
      return *std::move(reduced);
  }
  if (prefers_modes(problem, harmonics)) {
    ContactReduction modes = modal_reduction(problem);
    if (modes.obstacle.empty() && modes.squares.minCoeff() > 0.0) {
      ContactReceptance value = contact_receptance(modes, problem.period(), harmonics, weights);
      return {.value = std::move(value), .reduction = std::move(modes)};
    }
  }
  return {.value = factorised_receptance(problem, harmonics, weights, prefers_dense(problem)),
          .reduction = ContactReduction::refused("every harmonic was factorised")};
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
