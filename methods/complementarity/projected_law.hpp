#pragma once
// The contact law as the harmonic-balance methods impose it, and the options they have in common.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>

#include "methods/method.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

/// The contact law in projected form, per contact:
///
///     lambda = -P z,   z = max(0, y),   y = c (x - g) - relief * lambda,
///
/// P the projection on harmonics |n| <= H. relief = 1 is Signorini's condition (seed eq. 4), relief =
/// 1 - c / k_p a stop of stiffness k_p; c = k_p with relief = 0 is the penalty law (seed eq. 47).
struct ProjectedLaw {
  Eigen::VectorXd constant;  ///< c, Nc, > 0 [N/m]
  Eigen::VectorXd relief;    ///< Nc [-]
};

/// How the contact integral is taken: on the grid of N samples, or exactly between the instants where
/// contact begins and ends, starting from the sampled solution.
enum class Quadrature { exact, sampled };

/// The values of the option `quadrature`.
template <>
struct EnumNames<Quadrature> {
  /// In the order of the enumerators.
  static constexpr std::array<std::string_view, 2> values{"exact", "sampled"};
};

/// H where it is left to the method and nothing asks for more.
constexpr int kDefaultHarmonics = 20;

/// Size of the dynamic stiffness at the highest harmonics kept, per contact: the harmonic mean of
/// 1 / |C_n| over H/2 <= n <= H, Nc [N/m]. For one mass about m (3 H w / 4)^2.
Eigen::VectorXd highest_dynamic_stiffness(const ContactReceptance& receptance);

/// Signorini's condition, or the scene's spring stop behind it, with the constant c asked for (times
/// contact_stiffness_scale), else 4 times the highest dynamic stiffness kept.
ProjectedLaw lipschitz_law(const Problem& problem, const std::optional<double>& c,
                           const ContactReceptance& receptance);

/// The penalty law: the stiffness asked for; else the scene's; else, for a rigid stop, 8 times the highest
/// dynamic stiffness kept, on massless contacts growing as H^1.5 beyond ten harmonics, where penalty error
/// and truncation error are of one size.
ProjectedLaw penalty_law(const Problem& problem, const std::optional<Scaled>& penalty,
                         const ContactReceptance& receptance);

/// The law that every projected method represents: the scene's if it is conservative, restitution 1
/// where the scene is rigid, for the projected force does no net work (docs/theory.md). On a scene whose
/// stop is a spring, a penalty asked for replaces the spring's stiffness.
RepresentedLaw projected_method_law(const Problem& problem, const std::optional<Scaled>& penalty = {});

/// Refused where the load has harmonics beyond H, or the samples asked for do not carry H.
Support supports_harmonics(const Problem& problem, int harmonics, const std::optional<int>& samples);

/// The contact integral asked for: exact, but sampled if `plain`.
template <class Options>
Quadrature quadrature_of(const Options& options) {
  return options.quadrature.value_or(options.plain ? Quadrature::sampled : Quadrature::exact);
}

/// Whether impacts are compensated: unless `plain`, if not asked for; only with the exact contact integral.
template <class Options>
bool compensates(const Options& options) {
  return options.compensate.value_or(!options.plain) && quadrature_of(options) == Quadrature::exact;
}

/// Factor by which the law's constant grows once impacts are compensated: the harder the law, the nearer the
/// force is to an impulse, and the error to that of truncation alone (docs/decisions/0011). 1 where the user
/// chose the constant.
template <class Options>
double hardening_of(const Options& options) {
  constexpr double kHardening = 8.0;
  bool chosen = false;
  if constexpr (requires { options.c; }) chosen = chosen || options.c.has_value();
  if constexpr (requires { options.penalty; }) chosen = chosen || options.penalty.has_value();
  return chosen ? 1.0 : kHardening;
}

/// N asked for; else 32 H if `plain`, and empty (what the solve needs) otherwise.
template <class Options>
std::optional<int> samples_of(const Options& options, int harmonics) {
  constexpr int kPlain = 32;
  return options.plain ? options.samples.value_or(kPlain * harmonics) : options.samples;
}

/// Ranges of the options that all harmonic-balance methods share. \throws InvalidOption
template <class Options>
void validate_harmonic_options(const Options& options) {
  const int harmonics = options.harmonics.value_or(kDefaultHarmonics);
  require_option(harmonics >= 1 && harmonics <= 100000, "harmonics", options.harmonics,
                 "must be from 1 to 100000, or auto");
  require_option(!options.samples || *options.samples >= 2 * harmonics + 1, "samples", options.samples,
                 "must be at least 2 * harmonics + 1, or auto");
  require_option(!options.samples || *options.samples <= 10000000, "samples", options.samples,
                 "must be at most 10000000");
  require_option(options.tolerance > 0.0 && options.tolerance <= 1e-2, "tolerance", options.tolerance,
                 "must be in (0, 1e-2]");
  require_option(options.max_iterations >= 0, "max_iterations", options.max_iterations, "must be 0 or more");
}

}  // namespace signorini
