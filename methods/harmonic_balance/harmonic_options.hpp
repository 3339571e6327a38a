#pragma once
// The options that all methods of harmonic balance share, and what they mean for a scene.

#include <array>
#include <optional>
#include <string_view>

#include "methods/complementarity/projected_law.hpp"
#include "methods/method.hpp"
#include "methods/options.hpp"

namespace signorini {

/// How the contact integral is taken: on the grid of N samples, or exactly between the instants where
/// contact begins and ends, starting from the sampled solution.
enum class Quadrature { exact, sampled };

/// The values of the option `quadrature`.
template <>
struct EnumNames<Quadrature> {
  /// In the order of the enumerators.
  static constexpr std::array<std::string_view, 2> values{"exact", "sampled"};
};

/// Where Newton's method of a plain form begins: at the motion without contact forces, or at what a
/// continuation in the load's frequency leads to (frequency_continuation.hpp).
enum class Continuation { none, frequency };

/// The values of the option `continuation`.
template <>
struct EnumNames<Continuation> {
  /// In the order of the enumerators.
  static constexpr std::array<std::string_view, 2> values{"none", "frequency"};
};

/// H where it is left to the method and nothing asks for more.
inline constexpr int kDefaultHarmonics = 20;
/// Harmonics beyond which none are tried unasked: where errors fall like 1/H, a series that is off by its own
/// size at 20 of them is off by a thirtieth.
inline constexpr int kMostHarmonics = 640;

/// Samples per harmonic where the contact integral is their sum. On so many the path of pivots met no ray on
/// a population with damping ratios down to 0.0016.
inline constexpr int kSampledPerHarmonic = 32;

/// What options of several methods mean.
struct OptionMeanings {
  std::string_view harmonics;  ///< of the option of this name
  std::string_view constant;   ///< of c
  std::string_view penalty;    ///< of the option of this name
  std::string_view solver;     ///< of the option of this name
  std::string_view tolerance;  ///< of the option of this name
};
inline constexpr OptionMeanings kMeanings{
    .harmonics =
        "highest harmonic H kept, 1..100000; auto: 20 or what the load needs, and twice as many, up to 640, "
        "until two agree; the first number if plain, or with a solver, a grid or a limit",
    .constant =
        "constant c > 0 of the Lipschitz form, times the contact's stiffness; auto: 4x the dynamic one near "
        "H, in series with a spring of the scene; plain 1x the static one, 1e5x by pivots",
    .penalty =
        "stiffness of the stop, 1e6 or 100x the contact's; auto: the scene's, else 8x the dynamic one near "
        "H, stiffer if massless; plain 100x the static one, 1e5x by pivots",
    .solver = "auto (pivoting with restarts; newton if plain) | pivoting | newton",
    .tolerance = "relative complementarity residual accepted, in (0, 1e-2]"};

/// Options that methods of harmonic balance no longer have.
inline constexpr std::array<FormerOption, 2> kOptionsOfClosure{
    {{"compensate", "unknown option: impacts stay as the series has them; the method closed-hbm closes them"},
     {"restitution",
      "unknown option: rigid stops have restitution 1; the method closed-hbm has the scene's"}}};

/// Options of every method of harmonic balance. A method adds those of its contact law and of its solver.
struct HarmonicOptions {
  std::optional<int> harmonics = {};               ///< H >= 1 [-]
  std::optional<int> samples = {};                 ///< N >= 2 H + 1 [-]
  std::optional<Quadrature> quadrature = {};       ///< of the contact integral
  Continuation continuation = Continuation::none;  ///< of the plain form
  double tolerance = 1e-10;                        ///< on the relative residual of the method's equations [-]
  int max_iterations = 0;  ///< pivots and Newton steps in all; 0: the solver's own limit [-]
  bool plain = false;      ///< as the literature does it

  /// Visits all options in the order in which users see them; `law` and `solver` visit the method's own.
  void visit(auto&& field, auto&& law, auto&& solver) {
    field("harmonics", harmonics, "[-]", kMeanings.harmonics);
    field("samples", samples, "[-]",
          "N per period, >= 2 H + 1; auto: no grid beyond 20 harmonics, else 8 H or finer (sampled: 32 H)");
    law();
    field("quadrature", quadrature, "[-]",
          "exact: contact integral between its edges | sampled: on the N samples; auto: exact, sampled if "
          "plain");
    solver();
    field("continuation", continuation, "[-]",
          "if plain: none | frequency: in steps of the load's frequency, from where nothing touches");
    field("tolerance", tolerance, "[-]", kMeanings.tolerance);
    field("max_iterations", max_iterations, "[-]", "limit on pivots or Newton steps; 0: the solver's own");
    field("plain", plain, "[-]", "true: the literature's form and constants; sets what is left at auto");
  }

  /// The contact integral to take: the one asked for; else exact, sampled if `plain`.
  [[nodiscard]] Quadrature contact_integral() const;
  /// N to solve on with H harmonics: the one asked for; else 32 H if `plain`, and empty (as fine as the solve
  /// turns out to need) otherwise.
  [[nodiscard]] std::optional<int> fixed_samples(int harmonics) const;
  /// The constant of the Lipschitz form, in units of contact_stiffness_scale: the one asked for; else the
  /// that of plain forms if `plain`, and empty (tied to the highest dynamic stiffness) otherwise.
  /// \param by_pivots  whether pivoting solves the plain form: no iteration loses its way then, and the
  ///        harder the law, the better the answer
  [[nodiscard]] std::optional<double> lipschitz_constant(const std::optional<double>& asked,
                                                         bool by_pivots) const;
  /// The penalty: the one asked for and, for rigid stops, that of plain forms if `plain`.
  [[nodiscard]] StopPenalty penalty(const std::optional<Scaled>& asked, bool by_pivots) const;
  /// H to begin with: the one asked for; else 20, doubled until the load's harmonics are kept, at most 640.
  [[nodiscard]] int first_harmonics(const Problem& problem) const;
  /// Whether nothing that depends on the grid or on the number of steps is fixed by the user.
  [[nodiscard]] bool grid_is_open(int harmonics) const;
};

/// Ranges of the shared options. \throws InvalidOption
void validate(const HarmonicOptions& options);
/// The range of the constant c. \throws InvalidOption
void validate_constant(const std::optional<double>& c);

/// Refuses scenes whose load has harmonics beyond H, and samples that do not carry H.
Support supports_harmonics(const Problem& problem, const HarmonicOptions& options);

}  // namespace signorini
