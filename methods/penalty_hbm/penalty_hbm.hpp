#pragma once
// Penalty harmonic balance: the stop as a stiff unilateral spring, projected on the Fourier space.

#include <optional>
#include <string_view>

#include "methods/complementarity/projected_law.hpp"
#include "methods/curve.hpp"
#include "methods/harmonic_balance/harmonic_options.hpp"
#include "methods/method.hpp"
#include "methods/solvers/lcp/complementarity_solver.hpp"

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
class PenaltyHbm final : public Method, public CurveMethod {
 public:
  static constexpr std::string_view kName = "penalty-hbm";
  static constexpr std::string_view kTitle = "Harmonic balance with a penalty spring for the stop";
  static constexpr std::string_view kLaws = "penalty; restitution 1 and massless by regularisation";
  static constexpr std::string_view kLimits =
      "On a rigid stop restitution 1 alone, and at impacts the error of x falls like 1/H: 10 % takes some 40 "
      "harmonics, 1 % some 300. With few harmonics some series rattle, near no motion.";
  static constexpr std::string_view kLadder = "harmonics=10|40|160";
  static constexpr double kOrder = 1.0;  ///< of x in the ladder, with impacts [-]

  struct Options {
    HarmonicOptions common = {};
    std::optional<Scaled> penalty = {};  ///< eps > 0 [N/m], or times contact_stiffness_scale
    ComplementaritySolver solver = ComplementaritySolver::automatic;

    static constexpr auto kFormer = kOptionsOfClosure;

    void visit(auto&& field) {
      const auto law = [&] {
        field("penalty", penalty, "[N/m]",
              "stiffness of the stop, 1e6 or 100x the contact's; auto: the scene's, else 8x the dynamic one "
              "near H, stiffer if massless; plain 100x the static one");
      };
      const auto own_solver = [&] {
        field("solver", solver, "[-]", "auto (pivoting with restarts; newton if plain) | pivoting | newton");
      };
      common.visit(field, law, own_solver);
    }
  };

  explicit PenaltyHbm(const Options& options);  ///< \throws InvalidOption

  [[nodiscard]] std::vector<OptionEcho> options() const override { return echo_options(options_); }
  [[nodiscard]] Support supports(const Problem& problem) const override;
  [[nodiscard]] RepresentedLaw law(const Problem& problem) const override;
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Problem& problem) const override;
  [[nodiscard]] const CurveMethod* curve() const override { return this; }
  /// Over the frequency of the load.
  [[nodiscard]] Support follows(const ParametrisedScene& scene) const override {
    return follows_frequency(*this, scene);
  }
  /// Of the equations above, with the harmonics asked for or the first number (series_diagram).
  [[nodiscard]] BranchDiagram follow(const ParametrisedScene& scene,
                                     const CurveLimits& limits) const override;

 private:
  [[nodiscard]] LawAt law_at(const Problem& problem) const;

  Options options_;
};

}  // namespace signorini
