#pragma once
// Test functions of the smooth bifurcations and of phase resonance, and the stability of an orbit.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

#include "methods/continuation/arc_length.hpp"
#include "methods/orbit/continuation/orbit_branch.hpp"
#include "methods/orbit/family/extended_equations.hpp"

namespace signorini {

/// Each changes its sign at its bifurcation, none has a pole at a grazing:
///
/// - fold: the last component of the tangent; of free motions, where it is the energy that turns, the product
///   of mu_i - 1 over all multipliers but the two that are always 1;
/// - branch point: det [R_x; tangent^T];
/// - period doubling: det J_-1, J_mu the Jacobian with the closure y(2 pi n) - mu y_0, that is the product of
/// the
///   approach speeds times det(M - mu);
/// - Neimark-Sacker: the product of 1 - mu_i mu_j over all pairs. Identically zero where no energy is lost,
/// and
///   absent there, as for a single coordinate, which has no such point. Branch points of free motions are
///   not looked for;
/// - phase resonance: LoadPhase::in_phase over the frequency. Where it falls as the frequency rises is a
///   resonance, where it rises an antiresonance, which is left out.
///
/// Determinants are divided by the norms of their rows; of 64 states or more that of a doubling is the
/// product of its factors. Where contacts that feel each other through the mass strike at one event the map
/// is not continuous, and the fold alone is a bifurcation.
struct BifurcationTests {
  std::array<std::optional<double>, 5> values = {};  ///< in the order of SpecialKind
  Eigen::VectorXcd multipliers = {};                 ///< 2 Nd, or the largest; empty at a grazing
  /// Whether `multipliers` are the largest alone: those that are not there are within .9 min(1, 1 / |mu|) of
  /// the largest |mu|, so that no two of them, nor one of them with another one, are on the circle.
  bool leading = false;

  /// Those that have test functions.
  static constexpr std::array<SpecialKind, 5> kKinds{SpecialKind::fold, SpecialKind::period_doubling,
                                                     SpecialKind::neimark_sacker, SpecialKind::branch_point,
                                                     SpecialKind::phase_resonance};
  [[nodiscard]] const std::optional<double>& of(SpecialKind kind) const {
    return values[static_cast<std::size_t>(kind)];
  }
};

/// States from which on the largest multipliers are cheaper than a determinant, and secants than Newton's
/// steps
inline constexpr Eigen::Index kManyStates = 64;

/// Which multipliers are wanted.
enum class MultiplierRange {
  all,
  leading,  ///< of 64 states or more the largest, where these are known to 1e-10 (leading_eigenvalues)
};

/// Those of the orbit at which the equations are evaluated, `tangent` that of its curve.
/// \param factors  of the equations there, from which the tangent is, if they are known
BifurcationTests bifurcation_tests(ExtendedEquations& equations, const Eigen::VectorXd& tangent,
                                   MultiplierRange range = MultiplierRange::all,
                                   const CurveFactors* factors = nullptr);

/// One of them alone.
std::optional<double> bifurcation_test(ExtendedEquations& equations, const Eigen::VectorXd& tangent,
                                       SpecialKind kind);

/// How a motion answers a load of one harmonic, Re f e^{i h omega t}: with Re u e^{i h omega t} that harmonic
/// of the displacement, (K - (h omega)^2 M + i h omega D) u = f + W lambda (less what the ends of a period
/// add that does not close, as within Newton's method), the load puts in the power -h omega Im(f^H u) / 2,
/// which dampers and impacts take. Where Re f^H u = 0 it is in quadrature with the displacement, as the
/// forces of dampers are, and balances them: to first order in the damping the motion is one of the structure
/// without load and damping [peeters2011].
struct LoadPhase {
  /// Re(f^H u) |f| X / |f^H u|^2, X of CurveUnits: over |f|^2 / X the real part of the dynamic stiffness that
  /// the load meets, which has no peak at a resonance [-].
  double in_phase = 0.0;
  /// |f^H u| / (2 (h omega)^2 u^H M u): at a phase resonance the ratio of the linear mode that takes this
  /// power at the same frequency, shape and amplitude of the first harmonic [scheel2018]; its own in a linear
  /// structure [-].
  double damping_ratio = 0.0;
};

/// Why a scene has none, one clause: it takes dampers and a load of one harmonic, on coordinates with mass.
std::string phase_obstacle(const FlowStructure& structure);

/// That of the orbit at which the equations are evaluated; empty where there is an obstacle, and where the
/// force of a closed contact is not known as a sum of exponentials.
std::optional<LoadPhase> load_phase(const ExtendedEquations& equations);

/// The eigenvalues of a monodromy matrix. Of a large one whose rank is small to rounding, as where most modes
/// fade within the period, those of the small matrix with the same eigenvalues, and zeros.
Eigen::VectorXcd multipliers_of(const Eigen::MatrixXd& monodromy);

/// Whether the multipliers at a zero of a test function are those of its bifurcation: 1, -1, or a pair on the
/// circle. A product of real multipliers can be 1 without any, and a parameter turns without a fold where a
/// phase of contact begins. Without multipliers folds and branch points are.
bool confirmed(SpecialKind kind, const Eigen::VectorXcd& multipliers);

/// By the largest magnitude of them, but for the two nearest to 1 of a free motion, which are 1, as it may be
/// shifted in time and keeps its energy; to 1e-9; where neither dampers nor impacts take energy by 1e-8 on
/// either side.
OrbitStability stability_of(const ExtendedEquations& equations, const Eigen::VectorXcd& multipliers);

/// det M = prod e_i^2 exp(-T tr M^-1 D) is 1: a motion that loses nothing has its multipliers in pairs mu, 1
/// / mu.
bool loses_nothing(const ExtendedEquations& equations);

}  // namespace signorini
