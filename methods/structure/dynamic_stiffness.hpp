#pragma once
// The structure at one harmonic: dynamic stiffness, its factors, and the load.

#include <Eigen/Core>
#include <memory>
#include <stdexcept>

#include "methods/discretisation/symbols.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// Some Z_n has no inverse to working precision.
class SingularStiffness : public std::runtime_error {
 public:
  SingularStiffness()
      : std::runtime_error(
            "dynamic stiffness is singular at a harmonic: undamped resonance or free rigid-body motion") {}
  using std::runtime_error::runtime_error;  ///< with a text that says more
};

/// Coordinates up to which each Z_n is factorised without further ado; beyond, a projection is tried first.
inline constexpr int kMostFactorised = 2000;

/// Whether the structure is so small that dense factors are the faster ones: 32 coordinates at most.
bool prefers_dense(const Problem& problem);

/// Factorises Z = mass M + damping D + stiffness K harmonic by harmonic; the sparsity pattern is analysed
/// once. Sparse factors are those of UMFPACK [davis2004]; of a few rows (kMostInverted) the inverse takes
/// less. All modes take the place of factors of 401 to 2000 coordinates under a full damping matrix that does
/// not couple them (`uncoupled_modes`).
class DynamicStiffness {
 public:
  /// Dense or sparse as `prefers_dense` says.
  explicit DynamicStiffness(const Problem& problem);
  /// \param dense  whether the factors are dense, O(Nd^2) numbers, or sparse
  DynamicStiffness(const Problem& problem, bool dense);
  ~DynamicStiffness();
  DynamicStiffness(const DynamicStiffness&) = delete;
  DynamicStiffness& operator=(const DynamicStiffness&) = delete;

  /// \throws SingularStiffness
  void factorise(const HarmonicWeights& weights);
  /// Z^{-1} rhs of the harmonic factorised last, Nd x k. \throws SingularStiffness
  [[nodiscard]] Eigen::MatrixXcd solve(const Eigen::MatrixXcd& rhs) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

/// Complex coefficient of the load at harmonic n of the BASE frequency, f(t) = sum_n f_n e^{i n w t}, Nd [N].
Eigen::VectorXcd load_coefficient(const Problem& problem, int n);

/// d load_coefficient / d omega, Nd [N s].
Eigen::VectorXcd load_coefficient_rate(const Problem& problem, int n);

}  // namespace signorini
