#include "methods/structure/dynamic_stiffness.hpp"

#include <Eigen/UmfPackSupport>
#include <limits>
#include <memory>

#include "methods/solvers/dense_products.hpp"
#include "methods/structure/bases/modal_reduction.hpp"
#include "methods/structure/bases/structure_modes.hpp"
#include "problems/linear_algebra/complex_lu.hpp"
#include "problems/matrix_properties.hpp"
#include "problems/skew_parts.hpp"

namespace signorini {

namespace {

// K is regular where its symmetric part is definite.
bool holds(const SparseMatrix& K) {
  return is_symmetric(K) ? is_definite(K) : is_definite(symmetric_part(K));
}

/// All modes, null where a factorisation per harmonic costs less: with a full damping matrix one of these
/// costs as much as a few harmonics.
std::shared_ptr<const StructureModes> modes_in_place_of_factors(const Problem& problem) {
  return has_shared_modes(problem) ? uncoupled_modes(problem) : nullptr;
}

}  // namespace

bool prefers_dense(const Problem& problem) { return problem.size() <= 32; }

struct DynamicStiffness::Factors {
  using SparseComplex = Eigen::SparseMatrix<std::complex<double>>;

  // A sparse factorisation goes on over pivots of rounding size: whether K is singular is asked beforehand.
  Factors(const Problem& problem, bool as_dense)
      : dense(as_dense), held(as_dense || holds(problem.stiffness())) {
    if (dense) {
      dense_mass = problem.mass();
      dense_damping = problem.damping();
      dense_stiffness = problem.stiffness();
    } else if (modes = modes_in_place_of_factors(problem); !modes) {
      mass = problem.mass().cast<std::complex<double>>();
      damping = problem.damping().cast<std::complex<double>>();
      stiffness = problem.stiffness().cast<std::complex<double>>();
      sparse_lu = std::make_unique<Eigen::UmfPackLU<SparseComplex>>();
      auto& control = sparse_lu->umfpackControl();
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
      // Enough to refuse a singular Z; of more rows an exact one would cost as much as the solve.
      if (!(factors_of_matrix() > std::numeric_limits<double>::epsilon())) throw SingularStiffness();
      return;
    }
    if (modes) return take_modes(weights);
    sparse = weights.mass * mass + weights.damping * damping + weights.stiffness * stiffness;
    sparse.makeCompressed();
    if (!analysed) sparse_lu->analyzePattern(sparse);
    analysed = true;
    sparse_lu->factorize(sparse);
    if (sparse_lu->info() != Eigen::Success) throw SingularStiffness();
  }

  void take_modes(const HarmonicWeights& weights) {
    of_mode =
        weights.mass * modes->mass + weights.damping * modes->damping + weights.stiffness * modes->stiffness;
    const Eigen::ArrayXd terms = std::abs(weights.mass) * modes->mass.array() +
                                 std::abs(weights.damping) * modes->damping.array() +
                                 std::abs(weights.stiffness) * modes->stiffness.array().abs();
    if (!(of_mode.array().abs() > std::numeric_limits<double>::epsilon() * terms).all())
      throw SingularStiffness();
  }

  [[nodiscard]] Eigen::MatrixXcd solve_by_modes(const Eigen::MatrixXcd& rhs) const {
    Eigen::MatrixXd parts(rhs.rows(), 2 * rhs.cols());
    parts << rhs.real(), rhs.imag();
    const Eigen::MatrixXd seen = transposed_product(modes->vectors, parts);
    Eigen::MatrixXcd amplitudes(rhs.rows(), rhs.cols());
    amplitudes.real() = seen.leftCols(rhs.cols());
    amplitudes.imag() = seen.rightCols(rhs.cols());
    for (Eigen::Index c = 0; c < rhs.cols(); ++c) amplitudes.col(c).array() /= of_mode.array();
    return dense_product(modes->vectors, amplitudes);
  }

  // Of the dense matrix, or its inverse where it has few rows. Returns an estimate of its reciprocal
  // condition.
  double factors_of_matrix() {
    if (matrix.rows() <= kMostInverted) {
      inverse = matrix;
      return invert(inverse) ? reciprocal_condition(matrix, inverse) : 0.0;
    }
    lu.compute(matrix);
    return lu.reciprocal_condition();
  }

  [[nodiscard]] Eigen::MatrixXcd solve(const Eigen::MatrixXcd& rhs) const {
    if (dense && matrix.rows() <= kMostInverted) return inverse.lazyProduct(rhs);
    if (dense) return lu.solve(rhs);
    if (modes) return solve_by_modes(rhs);
    Eigen::MatrixXcd solution = sparse_lu->solve(rhs);
    if (!solution.allFinite()) throw SingularStiffness();
    return solution;
  }

  bool dense;
  bool held;
  bool analysed = false;
  Eigen::MatrixXd dense_mass, dense_damping, dense_stiffness;
  Eigen::MatrixXcd matrix;
  Eigen::MatrixXcd inverse;  // where it has kMostInverted rows at most
  ComplexLuFactors lu;
  SparseComplex mass, damping, stiffness, sparse;
  std::unique_ptr<Eigen::UmfPackLU<SparseComplex>> sparse_lu;  // null where dense or by modes
  std::shared_ptr<const StructureModes> modes;                 // in place of sparse factors
  Eigen::VectorXcd of_mode;                                    // what Z is on each of them
};

DynamicStiffness::DynamicStiffness(const Problem& problem)
    : DynamicStiffness(problem, prefers_dense(problem)) {}
DynamicStiffness::DynamicStiffness(const Problem& problem, bool dense)
    : factors_(std::make_unique<Factors>(problem, dense)) {}
DynamicStiffness::~DynamicStiffness() = default;

void DynamicStiffness::factorise(const HarmonicWeights& weights) { factors_->factorise(weights); }

Eigen::MatrixXcd DynamicStiffness::solve(const Eigen::MatrixXcd& rhs) const { return factors_->solve(rhs); }

namespace {

// Coefficient n of the motion sought out of the amplitude that `of_load` gives for a harmonic of the load.
template <class OfLoad>
Eigen::VectorXcd coefficient_of(const Problem& problem, int n, const OfLoad& of_load) {
  if (n % problem.subharmonic != 0) return Eigen::VectorXcd::Zero(problem.size());
  const Eigen::VectorXcd amplitude = of_load(problem, n / problem.subharmonic);
  return n == 0 ? amplitude : Eigen::VectorXcd(0.5 * amplitude);
}

}  // namespace

Eigen::VectorXcd load_coefficient(const Problem& problem, int n) {
  return coefficient_of(problem, n, load_harmonic);
}

Eigen::VectorXcd load_coefficient_rate(const Problem& problem, int n) {
  return coefficient_of(problem, n, load_harmonic_rate);
}

}  // namespace signorini
