#pragma once
// Alternating frequency/time harmonic balance, Newton-Krylov in the frequency domain.

#include <array>
#include <optional>
#include <string_view>

#include "methods/complementarity/projected_law.hpp"
#include "methods/curve.hpp"
#include "methods/harmonic_balance/harmonic_options.hpp"
#include "methods/method.hpp"

namespace signorini {

/// Finds the harmonics of the contact force from R(lambda) = lambda + P max(0, y) = 0, where
/// y = c (x - g) - lambda (dynamic Lagrangians, DLFT [nacivet2003]) or y = eps (x - g) (penalty),
/// x = x_f + C lambda. Every residual and Jacobian-vector product goes harmonics -> inverse FFT ->
/// contact law in time -> FFT -> harmonics; no matrix in time or frequency is formed. The equations are
/// those of fourier-lipschitz and penalty-hbm; what differs is the solver. They represent restitution 1.
///
/// Globalisation: Newton with GMRES, a harmonic-wise preconditioner and a line search; where that fails, the
/// gap homotopy of the same equations on the same samples is followed by pivoting
/// (complementarity_solver.hpp), and Newton finishes. With more than some twenty harmonics this is done for
/// few of them, and continued to all.
///
/// `plain`: alternating frequency/time on 32 H samples and Newton from the contact-free response, or by
/// `continuation=frequency` from where nothing touches, with the constants of fourier-lipschitz and
/// penalty-hbm, without homotopy. It sets what is left at `auto`.
class AftHbm final : public Method, public CurveMethod {
 public:
  enum class ContactLaw { dlft, penalty };

  static constexpr std::string_view kName = "aft-hbm";
  static constexpr std::string_view kTitle = "Alternating frequency/time harmonic balance, Newton-Krylov";
  static constexpr std::string_view kLaws = "restitution 1; penalty; massless";
  static constexpr std::string_view kLimits =
      "On a rigid stop restitution 1 alone, and at impacts the error of x falls like 1/H: 10 % takes some 40 "
      "harmonics, 1 % some 300. With few harmonics some series rattle, near no motion.";
  static constexpr std::string_view kLadder = "harmonics=10|40|160";
  static constexpr double kOrder = 1.0;  ///< of x in the ladder, with impacts [-]

  /// With this value of an option, the equations are those of this method.
  static constexpr std::array<std::array<std::string_view, 3>, 2> kSameEquations{
      {{"law", "dlft", "fourier-lipschitz"}, {"law", "penalty", "penalty-hbm"}}};

  struct Options {
    HarmonicOptions common = {};
    ContactLaw law = ContactLaw::dlft;
    std::optional<double> c = {};        ///< of dlft: > 0, times contact_stiffness_scale [-]
    std::optional<Scaled> penalty = {};  ///< of penalty: eps > 0 [N/m], or times contact_stiffness_scale
    std::optional<bool> homotopy = {};   ///< false: Newton alone

    static constexpr auto kFormer = kOptionsOfClosure;

    void visit(auto&& field) {
      const auto contact_law = [&] {
        field("law", law, "[-]", "dlft (dynamic Lagrangian) | penalty");
        field(
            "c", c, "[-]",
            "dlft: constant c > 0 times the contact's stiffness; auto: 4x the dynamic one near H, in series "
            "with a spring of the scene; plain 1x the static one");
        field(
            "penalty", penalty, "[N/m]",
            "penalty: stiffness of the stop, 1e6 or 100x; auto: the scene's, else 8x the dynamic one near H, "
            "stiffer if massless; plain 100x the static one");
      };
      const auto solver = [&] {
        field("homotopy", homotopy, "[-]",
              "follow the gap homotopy where Newton fails: true | false; auto: unless plain");
      };
      common.visit(field, contact_law, solver);
    }
  };

  explicit AftHbm(const Options& options);  ///< \throws InvalidOption

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

template <>
struct EnumNames<AftHbm::ContactLaw> {
  static constexpr std::array<std::string_view, 2> values{"dlft", "penalty"};
};

}  // namespace signorini
