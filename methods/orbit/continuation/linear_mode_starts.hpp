#pragma once
// Where nonlinear modes begin: linear modes of just the amplitude at which they reach a stop.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "methods/orbit/continuation/switching.hpp"

namespace signorini {

/// The parameter of free motions that are followed over their energy.
inline constexpr std::string_view kEnergy = "energy";

/// A linear mode about the equilibrium, u = u_s + A phi cos(omega_r t), at the amplitude
///
///     A = min_j d_j / |c_j|
///
/// at which it reaches the first stop: of an open contact d_j = g_j - x_j and c_j = w_j^T phi, of one that
/// presses at the equilibrium -lambda_j and the amplitude of its force. Below it the motion is linear; there
/// the nonlinear mode begins, with an impact of no speed or a phase of contact, or a break of one, of no
/// length at each stop that is reached.
struct LinearModeStart {
  double frequency = 0.0;  ///< omega_r [rad/s]
  double energy = 0.0;     ///< there [J]
  CurveStart start;        ///< along the way on which all impacts or phases grow alike
};

/// Those of free motions, and why others are none.
struct LinearModeStarts {
  std::vector<LinearModeStart> starts = {};  ///< omega_r rising
  std::string obstacle = {};                 ///< one clause: why there are none, or of what modes none
};

/// The starts of all nonlinear modes whose range of frequencies meets that of `family`, in whose unknowns
/// they are: the range between the frequencies of the mode of the same number with all contacts open and with
/// all held, infinite where stops are rigid.
///
/// \param family  not driven
/// \return none where no spring holds the structure at rest, its own or that of a stop, a rigid stop is
///         pressed at the equilibrium, or a stop is reached at rest (a gap of 0: the frequency does not
///         depend on the energy then)
LinearModeStarts linear_mode_starts(OrbitFamily& family);

/// From below the lowest frequency of the free motions of a scene without load to above those of its first
/// three modes: twice that of the third with all contacts open, or with all held where that is less, and in
/// any case above that about the state of rest [rad/s]. Of what rests on the springs of its stops alone, from
/// a tenth of the first frequency there: in flight nothing holds it.
/// Empty where there is nothing that moves, or no spring holds it at rest.
std::optional<ParameterRange> free_motion_band(const Problem& problem);

}  // namespace signorini
