#include "methods/structure/receptance.hpp"

#include <Eigen/LU>
#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <limits>

#include "methods/structure/reduced_receptance.hpp"
#include "problems/definiteness.hpp"

namespace signorini {

namespace {

// Below this many coordinates a dense factorisation is the faster one.
constexpr int kDenseLimit = 32;
// Right-hand sides solved for at a time: bounds what is kept beside the factors.
constexpr int kColumns = 32;

}  // namespace

HarmonicWeights exact_weights(double w) { return {{-w * w, 0.0}, {0.0, w}, {1.0, 0.0}, 1.0}; }

struct DynamicStiffness::Factors {
  using SparseComplex = Eigen::SparseMatrix<std::complex<double>>;

  // A sparse factorisation goes on over pivots of rounding size: whether K is singular is asked beforehand.
  Factors(const Problem& problem, bool as_dense)
      : dense(as_dense), held(as_dense || is_definite(problem.stiffness())) {
    if (dense) {
      dense_mass = problem.mass();
      dense_damping = problem.damping();
      dense_stiffness = problem.stiffness();
    } else {
      mass = problem.mass().cast<std::complex<double>>();
      damping = problem.damping().cast<std::complex<double>>();
      stiffness = problem.stiffness().cast<std::complex<double>>();
      auto& control = sparse_lu.umfpackControl();
      control(UMFPACK_STRATEGY) = UMFPACK_STRATEGY_SYMMETRIC;
      if (problem.size() > kMostFactorised) control(UMFPACK_ORDERING) = UMFPACK_ORDERING_METIS;
      // Diagonal pivots of a well-scaled Z leave residuals of rounding; refining them triples the time of a
      // solve.
      control(UMFPACK_IRSTEP) = 0;
    }
  }

  void factorise(const HarmonicWeights& weights) {
    if (weights.mass == 0.0 && weights.damping == 0.0 && !held) throw SingularStiffness();
    if (dense) {
      matrix =
          weights.mass * dense_mass + weights.damping * dense_damping + weights.stiffness * dense_stiffness;
      lu.compute(matrix);
      // An exact rcond costs as much as the solve; the estimate is enough to refuse a singular Z.
      if (!(lu.rcond() > std::numeric_limits<double>::epsilon())) throw SingularStiffness();
      return;
    }
    sparse = weights.mass * mass + weights.damping * damping + weights.stiffness * stiffness;
    sparse.makeCompressed();
    if (!analysed) sparse_lu.analyzePattern(sparse);
    analysed = true;
    sparse_lu.factorize(sparse);
    if (sparse_lu.info() != Eigen::Success) throw SingularStiffness();
  }

  [[nodiscard]] Eigen::MatrixXcd solve(const Eigen::MatrixXcd& rhs) const {
    if (dense) return lu.solve(rhs);
    Eigen::MatrixXcd solution = sparse_lu.solve(rhs);
    if (!solution.allFinite()) throw SingularStiffness();
    return solution;
  }

  bool dense;
  bool held;
  bool analysed = false;
  Eigen::MatrixXd dense_mass, dense_damping, dense_stiffness;
  Eigen::MatrixXcd matrix;
  Eigen::PartialPivLU<Eigen::MatrixXcd> lu;
  SparseComplex mass, damping, stiffness, sparse;
  Eigen::UmfPackLU<SparseComplex> sparse_lu;
};

DynamicStiffness::DynamicStiffness(const Problem& problem)
    : factors_(std::make_unique<Factors>(problem, problem.size() <= kDenseLimit)) {}
DynamicStiffness::DynamicStiffness(const Problem& problem, bool dense)
    : factors_(std::make_unique<Factors>(problem, dense)) {}
DynamicStiffness::~DynamicStiffness() = default;

void DynamicStiffness::factorise(const HarmonicWeights& weights) { factors_->factorise(weights); }

Eigen::MatrixXcd DynamicStiffness::solve(const Eigen::MatrixXcd& rhs) const { return factors_->solve(rhs); }

Eigen::VectorXcd load_coefficient(const Problem& problem, int n) {
  if (n % problem.subharmonic != 0) return Eigen::VectorXcd::Zero(problem.size());
  const Eigen::VectorXcd load = load_harmonic(problem, n / problem.subharmonic);
  return n == 0 ? load : Eigen::VectorXcd(0.5 * load);
}

namespace {

ContactReceptance factorised_receptance(const Problem& problem, int harmonics,
                                        const std::function<HarmonicWeights(int)>& weights, bool dense) {
  const int contacts = problem.contact_count();
  const SparseMatrix directions = contact_directions(problem);
  const int loaded = load_bandwidth(problem);
  DynamicStiffness stiffness(problem, dense);
  ContactReceptance result;
  result.period = problem.period();
  result.report.method = dense ? ReceptanceMethod::dense : ReceptanceMethod::direct;
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

}  // namespace

ContactReceptance contact_receptance(const Problem& problem, int harmonics,
                                     const std::function<HarmonicWeights(int)>& weights,
                                     ReceptanceMethod method) {
  const bool large = problem.size() > kMostFactorised;
  if (method == ReceptanceMethod::reduced || (method == ReceptanceMethod::automatic && large)) {
    auto reduced = reduced_receptance(problem, harmonics, weights, kReducedTolerance);
    if (reduced) return *std::move(reduced);
  }
  const bool dense = method == ReceptanceMethod::dense ||
                     (method == ReceptanceMethod::automatic && problem.size() <= kDenseLimit);
  return factorised_receptance(problem, harmonics, weights, dense);
}

}  // namespace signorini
