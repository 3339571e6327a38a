#pragma once
// The periodic motion of a whole structure by marching a reduced one, and an error bar for it.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "methods/marching/periodic_march.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// When corrections end.
struct CorrectionSettings {
  PeriodicMarchSettings march = {};  ///< of every march
  int corrections = 4;               ///< at most, >= 1 [-]
  double tolerance = 1e-9;           ///< on the defect, relative to max |x| [-]
};

/// A motion of the reduced structure and what the whole one makes of its forces.
struct CorrectedMarch {
  PeriodicMarch answer;  ///< the last march; its motion contains the displacements added
  /// max |x_whole[lambda] - x| / max |x| after each march: exact backward errors [-].
  std::vector<double> defects;
  /// On max |x - x_true| / max |x|, x_true the whole structure's motion on this grid: 2 max |dx|, dx the
  /// linear effect of the last defect, contacts staying in their sets, over 1 less the rate at which defects
  /// fell. Empty: none can be given [-].
  std::optional<double> bar;
  std::string refusal;  ///< why there is no bar, one clause
};

/// Deferred correction. With lambda of a march and x_whole = free + C lambda by the receptances of the whole
/// structure, d = x_whole - x_m is by what the reduced structure is wrong under these forces: x_whole and
/// lambda satisfy the whole structure's equations against stops moved by d, without any linearisation. Added
/// to x of the next march, d leads to the motion of the whole structure: a fixed point is its solution,
/// whatever the vectors.
///
/// The bar is refused where the corrected motion x + dx, lambda + dlambda is not admissible, or where the
/// last correction changed the motion otherwise than the dx predicted for it, by half: then the whole
/// structure has other contacts than the reduced one, and linear theory says nothing; and where corrections
/// do not reduce the defect by half, which asks for more vectors. The bar contains ten times the tolerance of
/// the march, and not the rounding of the stiffness, eps times its condition, nor the error of the grid.
///
/// \param whole  C_n and free response for n = 0..N/2 under HatScheme::bdf2 on the grid of the march
CorrectedMarch march_with_corrections(ContactMarch& march, const MarchGrid& grid,
                                      const ContactReceptance& whole,
                                      const CorrectionSettings& settings = {});

}  // namespace signorini
