#pragma once
// Closed harmonic balance: a series whose impacts obey the scene's law of impact with all harmonics.

#include <array>
#include <optional>
#include <string_view>

#include "methods/harmonic_balance/projected_method.hpp"

namespace signorini {

/// Finds, for the K impacts of a period on rigid stops that carry mass, their instants t_k and impulses J_k,
/// and with them the series of H harmonics that acts as they do. The impacts solve Newton's law
/// X'_+ = -e X'_- and X(t_k) = g on the motion X with all harmonics (ImpactMotion), 2 K equations, whatever e
/// in [0, 1]; the series solves
///
///     lambda + P max(0, y_k) = 0,    y_k = c (x + a_k + b_k (t - t_k) - g) - lambda near impact k,
///
/// its contact k having the impulse J_k and the centre t_k, in the unknowns lambda, a_k, b_k (close_impacts).
/// Where impacts are first read off, and what is refused: closed_answer.hpp. At restitution 1 the series of
/// the projected equations is one more start, and contacts without mass stay as it has them.
///
/// On stops that are springs, and on massless contacts, there is no law of impact to ask: the answer is the
/// series of the projected equations alone (solve_series), that of fourier-lipschitz.
class ClosedHbm final : public ProjectedMethod {
 public:
  enum class ImpactLaw { scene, none };

  static constexpr MethodText kText = completed(
      {.name = "closed-hbm",
       .title = "Harmonic balance whose impacts are closed: their law asked of all harmonics",
       .laws = "restitution 0..1, penalty, massless",
       .limits =
           "On a rigid stop impacts must be separate: contact that lasts, sticks or chatters is refused. At "
           "impacts the error of x falls like H^-3/2: 1e-3 takes some 60 harmonics, 1e-6 some 6000. Follows "
           "no curve in sweep.",
       .order = 1.0});

  struct Options {
    std::optional<int> harmonics = {};         ///< H >= 1 [-]
    std::optional<double> c = {};              ///< > 0, times contact_stiffness_scale [-]
    ImpactLaw restitution = ImpactLaw::scene;  ///< of impacts on rigid stops
    double tolerance = 1e-10;                  ///< on the relative residual of the equations [-]
    int max_iterations = 0;  ///< pivots and Newton steps in all; 0: the solver's own limit [-]

    void visit(auto&& field) {
      field("harmonics", harmonics, "[-]", kMeanings.harmonics);
      field("c", c, "[-]",
            "constant c > 0 times the contact's stiffness; auto: 32x the dynamic one near H at impacts, else "
            "4x, in series with a spring of the scene");
      field("restitution", restitution, "[-]",
            "at which impacts on rigid stops are closed: scene | none (restitution 1)");
      field("tolerance", tolerance, "[-]", kMeanings.tolerance);
      field("max_iterations", max_iterations, "[-]", "limit on pivots and Newton steps; 0: the solvers' own");
    }
  };

  explicit ClosedHbm(const Options& options);  ///< \throws InvalidOption

  [[nodiscard]] std::vector<OptionEcho> options() const override { return echo_options(options_); }
  /// Those of a series, of which impacts have one restitution and no other contact beside them.
  [[nodiscard]] Support supports(const Problem& problem) const override;
  [[nodiscard]] RepresentedLaw law(const Problem& problem) const override;

 private:
  [[nodiscard]] HarmonicMethod preset(const Problem& problem) const override;

  Options options_;
};

/// The values of the option `restitution`.
template <>
struct EnumNames<ClosedHbm::ImpactLaw> {
  /// In the order of the enumerators.
  static constexpr std::array<std::string_view, 2> values{"scene", "none"};
};

}  // namespace signorini
