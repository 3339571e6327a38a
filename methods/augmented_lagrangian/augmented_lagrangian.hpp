#pragma once
// Augmented Lagrangian harmonic balance: a penalty inside, a multiplier that takes its error back outside.

#include <optional>

#include "methods/complementarity/projected_law.hpp"
#include "methods/harmonic_balance/projected_method.hpp"

namespace signorini {

/// lambda = -P max(0, rho (x - g) - mu) with x = x_f + C lambda, |n| <= H, by Newton's method, and mu <-
/// lambda until that changes nothing (multiplier_grid_solver) [alart1991, wriggers2006]. The source paper
/// names it in section 6 and does not write it out. What it converges to solves the Lipschitz form with c =
/// rho, without the penetration of a penalty, at any rho; rho decides whether and how fast it converges. The
/// contact integral is exact, the law represented restitution 1. A scene whose stop is a spring is solved by
/// its own penalty.
///
/// `plain` is the literature's form: updates as they stand, from rising penalties.
class AugmentedLagrangian final : public ProjectedMethod {
 public:
  static constexpr MethodText kText = completed(
      {.name = "augmented-lagrangian",
       .title = "Harmonic balance with a penalty and updates of a multiplier",
       .limits =
           "On a rigid stop restitution 1 alone, and at impacts the error of x falls like 1/H: 10 % takes "
           "some 40 harmonics, 1 % some 300. Follows no curve in sweep.",
       .former = kOptionsOfClosure});

  struct Options {
    std::optional<int> harmonics = {};   ///< H >= 1 [-]
    std::optional<Scaled> penalty = {};  ///< rho > 0 [N/m], or times contact_stiffness_scale
    int max_updates = 150;               ///< of the multiplier [-]
    double tolerance = 1e-10;            ///< on the relative residual of the Lipschitz form [-]
    int max_iterations = 0;              ///< Newton steps; 0: not limited [-]
    bool plain = false;                  ///< as the literature does it

    void visit(auto&& field) {
      field("harmonics", harmonics, "[-]", kMeanings.harmonics);
      field("penalty", penalty, "[N/m]",
            "rho, 1e6 or 100x the contact's stiffness; auto: 32x the dynamic one near H, a spring's own");
      field("max_updates", max_updates, "[-]", "limit on updates of the multiplier, 1..100000");
      field("tolerance", tolerance, "[-]", kMeanings.tolerance);
      field("max_iterations", max_iterations, "[-]",
            "limit on Newton steps, asked for between updates; 0: none");
      field("plain", plain, "[-]",
            "true: the literature's form, updates not accelerated, from rising penalties");
    }
  };

  explicit AugmentedLagrangian(const Options& options);  ///< \throws InvalidOption

  [[nodiscard]] std::vector<OptionEcho> options() const override { return echo_options(options_); }
  /// The scene's; with updates of the multiplier a penalty replaces no spring.
  [[nodiscard]] RepresentedLaw law(const Problem& problem) const override;

 private:
  [[nodiscard]] HarmonicMethod preset(const Problem& problem) const override;

  Options options_;
};

/// Signorini's condition with c = rho, or a scene's spring behind it: the penalty asked for; else the
/// spring's stiffness; else, for a rigid stop, 32 times the highest dynamic stiffness kept.
ProjectedLaw augmented_law(const Problem& problem, const std::optional<Scaled>& penalty,
                           const ContactReceptance& receptance);

}  // namespace signorini
