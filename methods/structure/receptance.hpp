#pragma once
// The linear structure in the frequency domain, reduced to its contacts (seed section 5).

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "problems/problem.hpp"

namespace signorini {

/// Dynamic stiffness of one harmonic, Z = mass * M + damping * D + stiffness * K, and the weight
/// that a time discretisation puts on the load of that harmonic.
struct HarmonicWeights {
  std::complex<double> mass;       ///< [1/s^2]
  std::complex<double> damping;    ///< [1/s]
  std::complex<double> stiffness;  ///< [-]
  double load = 1.0;               ///< [-]
};

/// Weights of the undiscretised equation of motion at angular frequency w: -w^2, i w, 1.
HarmonicWeights exact_weights(double w);

/// Some Z_n has no inverse to working precision.
class SingularStiffness : public std::runtime_error {
 public:
  SingularStiffness()
      : std::runtime_error(
            "dynamic stiffness is singular at a harmonic: undamped resonance or free rigid-body motion") {}
};

/// Factorises Z harmonic by harmonic; the sparsity pattern is analysed once.
/// Dense for a few coordinates, sparse LU beyond (UMFPACK [davis2004]); no matrix is ever inverted.
class DynamicStiffness {
 public:
  /// Dense or sparse by the number of coordinates.
  explicit DynamicStiffness(const Problem& problem);
  /// As told.
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

/// How receptances are found: by dense or sparse factorisation of each Z_n, or by projection
/// (`reduced_receptance`).
enum class ReceptanceMethod { automatic, dense, direct, reduced };

/// What was done, and how well.
struct ReceptanceReport {
  ReceptanceMethod method = ReceptanceMethod::dense;  ///< never automatic
  int basis = 0;                                      ///< coordinates of the projection, 0 without one [-]
  std::optional<double> error = {};  ///< of C_n by projection, relative to |C_n|_F, the worst n [-]
  bool bound = false;                ///< true if `error` is a bound, false if it is an estimate
};

/// The structure as its contacts see it: x_n = free_n + C_n lambda_n for each harmonic n of the base
/// frequency of the motion looked for.
struct ContactReceptance {
  double period = 1.0;                       ///< [s]
  std::vector<Eigen::MatrixXcd> receptance;  ///< C_n = W^T Z_n^{-1} W, Nc x Nc, n = 0..H [m/N]
  Eigen::MatrixXcd free_response;            ///< W^T Z_n^{-1} f_n, (H+1) x Nc [m]
  ReceptanceReport report = {};              ///< how they were found

  /// H, the highest harmonic kept.
  [[nodiscard]] int harmonics() const { return static_cast<int>(receptance.size()) - 1; }
  /// Nc.
  [[nodiscard]] int contacts() const { return static_cast<int>(free_response.cols()); }
};

/// C_n and free response for n = 0..H under the discretisation that gives harmonic n its weights.
/// Loads above harmonic H of the base frequency are dropped. The automatic choice is dense up to 32
/// coordinates; direct to 2000, and where the damping is not proportional or projection turns out to cost
/// more; else reduced, with an error of at most 1e-10 |C_n|_F. \throws SingularStiffness
ContactReceptance contact_receptance(const Problem& problem, int harmonics,
                                     const std::function<HarmonicWeights(int)>& weights,
                                     ReceptanceMethod method = ReceptanceMethod::automatic);

/// Complex coefficient of the load at harmonic n of the BASE frequency, f(t) = sum_n f_n e^{i n w t}, Nd [N].
Eigen::VectorXcd load_coefficient(const Problem& problem, int n);

}  // namespace signorini
