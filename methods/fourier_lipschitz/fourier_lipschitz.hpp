#pragma once
// Fourier Lipschitz harmonic balance: Signorini's condition as one Lipschitz equation, projected.

#include <optional>

#include "methods/harmonic_balance/projected_method.hpp"

namespace signorini {

/// lambda + P max(0, c (x - g) - lambda) = 0 with x = x_f + C lambda, |n| <= H [shi2015, eq. 14-23 and
/// 29-36, corrected], the same equations as DLFT [nacivet2003]. They represent restitution 1, whatever the
/// scene asks: the projected contact force does no net work (docs/theory.md, section 3). A stop that is a
/// spring k_p is represented exactly, the condition then being imposed on x + lambda / k_p.
///
/// They are solved by pivoting on samples, with more than some twenty harmonics by continuation from few of
/// them, and by Newton's method with the contact integral exact.
///
/// `plain`: the contact integral on 32 H samples, solved by the source paper's
/// semi-smooth Newton iteration from the contact-free response, or by `continuation=frequency` from where
/// nothing touches; c is the static stiffness of the contact. It sets what is left at `auto`: with
/// `plain=true,solver=pivoting` the literature's equations are solved from a cold start too.
class FourierLipschitz final : public FollowedMethod {
 public:
  static constexpr MethodText kText =
      completed({.name = "fourier-lipschitz",
                 .title = "Harmonic balance on the Lipschitz form of Signorini's condition"});

  struct Options {
    HarmonicOptions common = {};
    std::optional<double> c = {};  ///< > 0, times contact_stiffness_scale [-]
    ComplementaritySolver solver = ComplementaritySolver::automatic;

    void visit(auto&& field) {
      common.visit(
          field, [&] { field("c", c, "[-]", kMeanings.constant); },
          [&] { field("solver", solver, "[-]", kMeanings.solver); });
    }
  };

  explicit FourierLipschitz(const Options& options);  ///< \throws InvalidOption

  [[nodiscard]] std::vector<OptionEcho> options() const override { return echo_options(options_); }

 private:
  [[nodiscard]] HarmonicMethod preset(const Problem& problem) const override;

  Options options_;
};

}  // namespace signorini
