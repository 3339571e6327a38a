#pragma once
// The first axis of a periodic method: what each discretisation in time makes of d/dt, harmonic by harmonic.

#include <array>
#include <complex>
#include <functional>
#include <optional>
#include <string_view>

#include "methods/options.hpp"

namespace signorini {

/// Dynamic stiffness of one harmonic, Z = mass * M + damping * D + stiffness * K, and the weight
/// that a time discretisation puts on the load of that harmonic.
struct HarmonicWeights {
  std::complex<double> mass;       ///< [1/s^2]
  std::complex<double> damping;    ///< [1/s]
  std::complex<double> stiffness;  ///< [-]
  double load = 1.0;               ///< [-]
};

/// The weights that a discretisation gives harmonic n = 0..H.
using WeightsOfHarmonic = std::function<HarmonicWeights(int)>;

/// Weights of the undiscretised equation of motion at angular frequency w: -w^2, i w, 1; load 1.
HarmonicWeights exact_weights(double w);

/// Schemes on N equidistant nodes per period, by their symbols at theta = 2 pi n / N with the time step dt:
///
///     scheme     mass                       damping             stiffness, load
///     galerkin,  -(2 - 2 cos theta) / dt^2  i sin(theta) / dt   (2 + cos theta) / 3
///     consistent
///     nodal      -(2 - 2 cos theta) / dt^2  i sin(theta) / dt   1
///     backward   s^2                        s                   1,   s = (1 - e^{-i theta}) / dt
///     bdf2       s^2                        s                   1,   s = (3 - 4 z + z^2) / (2 dt), z = e^{-i
///     theta}
///
/// All tend to the exact weights as theta -> 0: with error O(theta^2), backward with O(theta).
enum class HatScheme {
  galerkin,   ///< hat functions as ansatz and test functions; the load is interpolated by them, and the
              ///< contact force is one impulse per node
  nodal,      ///< the same with K and the load lumped at the nodes: central differences
  backward,   ///< backward differences; represents restitution 0
  bdf2,       ///< backward differences of second order; for stops without an impact law
  consistent  ///< galerkin, the contact force interpolated by hat functions too [shi2015, eq. 6 and 7]
};

/// The values of the option `scheme`.
template <>
struct EnumNames<HatScheme> {
  /// In the order of the enumerators.
  static constexpr std::array<std::string_view, 5> values{"galerkin", "nodal", "backward", "bdf2",
                                                          "consistent"};
};

/// Weights of a scheme at theta = 2 pi n / N. \param step  dt > 0 [s]
HarmonicWeights scheme_weights(HatScheme scheme, double theta, double step);

/// Weight of the nodal values of the contact force: (2 + cos theta) / 3 where hat functions interpolate it
/// (the rows 1/6, 4/6, 1/6 of their Gram matrix), else 1 [-].
double contact_force_weight(HatScheme scheme, double theta);

/// Symbol of (x_{k+1} + e x_{k-1}) / (1 + e), the displacement on which the periodic Paoli-Schatzman scheme
/// imposes the contact condition [paoli2002]: (e^{i theta} + e e^{-i theta}) / (1 + e). Without restitution
/// the condition holds on x_k itself, and the symbol is 1.
/// \param e  coefficient of restitution, in [0, 1] [-]
std::complex<double> restitution_shift(const std::optional<double>& e, double theta);

}  // namespace signorini
