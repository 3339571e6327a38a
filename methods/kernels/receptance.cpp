#include "methods/kernels/receptance.hpp"

#include <Eigen/LU>
#include <Eigen/SparseLU>
#include <limits>
#include <stdexcept>

namespace signorini {

namespace {

// Below this many coordinates a dense factorisation is the faster one.
constexpr int kDenseLimit = 32;

}  // namespace

HarmonicWeights exact_weights(double w) { return {{-w * w, 0.0}, {0.0, w}, {1.0, 0.0}, 1.0}; }

struct DynamicStiffness::Factors {
  using SparseComplex = Eigen::SparseMatrix<std::complex<double>>;

  explicit Factors(const Problem& problem) : dense(problem.size() <= kDenseLimit) {
    if (dense) {
      dense_mass = problem.mass;
      dense_damping = problem.damping;
      dense_stiffness = problem.stiffness;
    } else {
      mass = problem.mass.cast<std::complex<double>>();
      damping = problem.damping.cast<std::complex<double>>();
      stiffness = problem.stiffness.cast<std::complex<double>>();
    }
  }

  Eigen::MatrixXcd solve_dense(const HarmonicWeights& weights, const Eigen::MatrixXcd& rhs) {
    matrix =
        weights.mass * dense_mass + weights.damping * dense_damping + weights.stiffness * dense_stiffness;
    lu.compute(matrix);
    // An exact rcond costs as much as the solve; the estimate is enough to refuse a singular Z.
    if (!(lu.rcond() > std::numeric_limits<double>::epsilon())) throw_singular();
    return lu.solve(rhs);
  }

  Eigen::MatrixXcd solve_sparse(const HarmonicWeights& weights, const Eigen::MatrixXcd& rhs) {
    sparse = weights.mass * mass + weights.damping * damping + weights.stiffness * stiffness;
    sparse.makeCompressed();
    if (!analysed) sparse_lu.analyzePattern(sparse);
    analysed = true;
    sparse_lu.factorize(sparse);
    if (sparse_lu.info() != Eigen::Success) throw_singular();
    Eigen::MatrixXcd solution = sparse_lu.solve(rhs);
    if (!solution.allFinite()) throw_singular();
    return solution;
  }

  [[noreturn]] static void throw_singular() {
    throw std::runtime_error(
        "dynamic stiffness is singular at a harmonic: undamped resonance or free rigid-body motion");
  }

  bool dense;
  bool analysed = false;
  Eigen::MatrixXd dense_mass, dense_damping, dense_stiffness;
  Eigen::MatrixXcd matrix;
  Eigen::PartialPivLU<Eigen::MatrixXcd> lu;
  SparseComplex mass, damping, stiffness, sparse;
  Eigen::SparseLU<SparseComplex> sparse_lu;
};

DynamicStiffness::DynamicStiffness(const Problem& problem) : factors_(std::make_unique<Factors>(problem)) {}
DynamicStiffness::~DynamicStiffness() = default;

Eigen::MatrixXcd DynamicStiffness::solve(const HarmonicWeights& weights, const Eigen::MatrixXcd& rhs) {
  return factors_->dense ? factors_->solve_dense(weights, rhs) : factors_->solve_sparse(weights, rhs);
}

Eigen::VectorXcd load_coefficient(const Problem& problem, int n) {
  if (n % problem.subharmonic != 0) return Eigen::VectorXcd::Zero(problem.size());
  const Eigen::VectorXcd load = load_harmonic(problem, n / problem.subharmonic);
  return n == 0 ? load : Eigen::VectorXcd(0.5 * load);
}

ContactReceptance contact_receptance(const Problem& problem, int harmonics,
                                     const std::function<HarmonicWeights(int)>& weights) {
  const int contacts = problem.contact_count();
  const SparseMatrix directions = contact_directions(problem);
  const int loaded = highest_load_harmonic(problem) * problem.subharmonic;
  DynamicStiffness stiffness(problem);
  ContactReceptance result;
  result.period = problem.period();
  result.receptance.reserve(static_cast<std::size_t>(harmonics) + 1);
  result.free_response = Eigen::MatrixXcd::Zero(harmonics + 1, contacts);
  Eigen::MatrixXcd rhs(problem.size(), contacts + 1);
  rhs.leftCols(contacts) = Eigen::MatrixXd(directions).cast<std::complex<double>>();
  for (int n = 0; n <= harmonics; ++n) {
    const HarmonicWeights weight = weights(n);
    if (n <= loaded) {
      rhs.col(contacts) = weight.load * load_coefficient(problem, n);
    } else {
      rhs.col(contacts).setZero();
    }
    const Eigen::MatrixXcd reduced = directions.transpose() * stiffness.solve(weight, rhs);
    result.receptance.emplace_back(reduced.leftCols(contacts));
    result.free_response.row(n) = reduced.col(contacts).transpose();
  }
  return result;
}

}  // namespace signorini
