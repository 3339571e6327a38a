#pragma once
// Fourier Lipschitz harmonic balance: Signorini's condition as one Lipschitz equation, projected.

#include <optional>
#include <string_view>

#include "methods/complementarity/projected_law.hpp"
#include "methods/curve.hpp"
#include "methods/harmonic_balance/harmonic_options.hpp"
#include "methods/method.hpp"
#include "methods/solvers/lcp/complementarity_solver.hpp"

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
class FourierLipschitz final : public Method, public CurveMethod {
 public:
  static constexpr std::string_view kName = "fourier-lipschitz";
  static constexpr std::string_view kTitle =
      "Harmonic balance on the Lipschitz form of Signorini's condition";
  static constexpr std::string_view kLaws = "restitution 1; penalty; massless";
  static constexpr std::string_view kLimits =
      "On a rigid stop restitution 1 alone, and at impacts the error of x falls like 1/H: 10 % takes some 40 "
      "harmonics, 1 % some 300. With few harmonics some series rattle, near no motion.";
  static constexpr std::string_view kLadder = "harmonics=10|40|160";
  static constexpr double kOrder = 1.0;  ///< of x in the ladder, with impacts [-]

  struct Options {
    HarmonicOptions common = {};
    std::optional<double> c = {};  ///< > 0, times contact_stiffness_scale [-]
    ComplementaritySolver solver = ComplementaritySolver::automatic;

    static constexpr auto kFormer = kOptionsOfClosure;

    void visit(auto&& field) {
      const auto law = [&] {
        field(
            "c", c, "[-]",
            "constant c > 0 times the contact's stiffness; auto: 4x the dynamic one near H, in series with a "
            "spring of the scene; plain 1x the static one");
      };
      const auto own_solver = [&] {
        field("solver", solver, "[-]", "auto (pivoting with restarts; newton if plain) | pivoting | newton");
      };
      common.visit(field, law, own_solver);
    }
  };

  explicit FourierLipschitz(const Options& options);  ///< \throws InvalidOption

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
