#pragma once
// Scenes whose contacts see the same load with the other sign half a period later, and their symmetric
// motions.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "methods/harmonic_balance/continuation/series_switching.hpp"

namespace signorini {

/// The contact j' opposite to each contact j, so that the equations stay the same when every motion is begun
/// half a period later and j and j' change places: in harmonics C_n(j', k') = C_n(j, k), x_fn(j') = (-1)^n
/// x_fn(j), g_j' = g_j, and the same stiffness of a spring stop; to 1e-9. As between two stops at equal
/// distance from one mass under a load of odd harmonics. Empty where there is no such order of the contacts.
///
/// \throws SingularStiffness at an undamped resonance
std::vector<Eigen::Index> opposite_contacts(const Problem& problem);

/// S x: the unknowns with contacts j and j' exchanged and begun half a period later. The equations have
/// R(S x) = S R(x). Precondition: half_period_symmetry.
Eigen::VectorXd mirrored(const SeriesCurve& curve, const Eigen::VectorXd& x);

/// Whether the curve has this symmetry: its family has opposite contacts, and the multiple is odd.
bool half_period_symmetry(const SeriesCurve& curve);

/// Whether S x = x, to 1e-9 of x; false without the symmetry.
bool is_symmetric(const SeriesCurve& curve, const Eigen::VectorXd& x);

/// At a symmetric motion R_x falls apart into a block of symmetric changes and this one, of changes with S v
/// = -v: size() / 2 square, in orthonormal coordinates. Where it is singular motions without the symmetry
/// branch off, in a pitchfork; folds of the symmetric motions are in the other block.
Eigen::MatrixXd antisymmetric_block(const SeriesCurve& curve);

/// The smallest singular value of that block with the sign of its determinant: zero at a pitchfork, linear
/// beside it.
double pitchfork_test(const SeriesCurve& curve);

/// Both branches of motions without the symmetry where it is singular, at which the curve is evaluated: along
/// its null vector. One is the other one's mirror image.
///
/// \param tangent  of the symmetric motions
std::vector<SeriesStart> pitchfork_branches(const SeriesCurve& curve, const Eigen::VectorXd& tangent);

/// The equations on symmetric motions: the corrector stays on them, where the whole system is singular at a
/// pitchfork and one of symmetric changes is not. Of the concept CurveEquations, which settle.
class SymmetricMotions {
 public:
  /// \param curve  kept by the caller
  explicit SymmetricMotions(SeriesCurve& curve) : curve_(curve) {}
  [[nodiscard]] Eigen::Index size() const { return curve_.size(); }
  bool evaluate(const Eigen::VectorXd& x) { return curve_.evaluate(x); }
  [[nodiscard]] const Eigen::VectorXd& residual() const { return curve_.residual(); }
  [[nodiscard]] Eigen::MatrixXd jacobian() const { return curve_.jacobian(); }
  [[nodiscard]] double noise() const { return curve_.noise(); }
  void settle(Eigen::VectorXd& x) const { x = (0.5 * (x + mirrored(curve_, x))).eval(); }
  [[nodiscard]] SeriesCurve& series() const { return curve_; }

 private:
  SeriesCurve& curve_;
};

}  // namespace signorini
