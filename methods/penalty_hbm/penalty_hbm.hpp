#pragma once
// Penalty harmonic balance: the stop as a stiff unilateral spring, projected on the Fourier space.

#include <optional>

#include "methods/harmonic_balance/projected_method.hpp"

namespace signorini {

/// lambda = -P eps max(0, x - g) with x = x_f + C lambda, |n| <= H [shi2015, eq. 46-55, corrected]. A scene
/// whose stop is a spring is represented exactly; on a rigid one eps is a regularisation whose error
/// falls like eps^{-1/2}, and the law represented is restitution 1, whatever the scene asks.
///
/// They are solved by pivoting on samples, with more than some twenty harmonics by continuation from few of
/// them, and by Newton's method with the contact integral exact.
///
/// `plain`: the contact integral on 32 H samples, solved by Newton's method from the
/// contact-free response, or by `continuation=frequency` from where nothing touches; eps is a hundred times
/// the static stiffness of the contact. It sets what is left at `auto`.
class PenaltyHbm final : public FollowedMethod {
 public:
  static constexpr MethodText kText =
      completed({.name = "penalty-hbm",
                 .title = "Harmonic balance with a penalty spring for the stop",
                 .laws = "penalty; restitution 1 and massless by regularisation"});

  struct Options {
    HarmonicOptions common = {};
    std::optional<Scaled> penalty = {};  ///< eps > 0 [N/m], or times contact_stiffness_scale
    ComplementaritySolver solver = ComplementaritySolver::automatic;

    void visit(auto&& field) {
      common.visit(
          field, [&] { field("penalty", penalty, "[N/m]", kMeanings.penalty); },
          [&] { field("solver", solver, "[-]", kMeanings.solver); });
    }
  };

  explicit PenaltyHbm(const Options& options);  ///< \throws InvalidOption

  [[nodiscard]] std::vector<OptionEcho> options() const override { return echo_options(options_); }

 private:
  [[nodiscard]] HarmonicMethod preset(const Problem& problem) const override;

  Options options_;
};

}  // namespace signorini
