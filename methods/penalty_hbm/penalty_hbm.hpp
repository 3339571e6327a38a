#pragma once
// Penalty harmonic balance: the stop as a stiff unilateral spring, projected on the Fourier space.

#include <optional>
#include <string_view>

#include "methods/complementarity/projected_law.hpp"
#include "methods/method.hpp"
#include "methods/solvers/complementarity_solver.hpp"

namespace signorini {

/// lambda = -P eps max(0, x - g) with x = x_f + C lambda, |n| <= H (seed eq. 46-55, corrected). A scene
/// whose stop is a spring is represented exactly; on a rigid one eps is a regularisation whose error
/// falls like eps^{-1/2}, and the law represented is restitution 1. There impacts are compensated
/// (impact_compensation.hpp), which takes back both the truncation and the penetration of the spring.
///
/// `plain`: the equations alone, the contact integral on 32 H samples, solved by Newton's method from the
/// contact-free response. It sets what is left at `auto`.
class PenaltyHbm final : public Method {
 public:
  static constexpr std::string_view kName = "penalty-hbm";
  static constexpr std::string_view kTitle = "Harmonic balance with a penalty spring for the stop";
  static constexpr std::string_view kLaws = "penalty; restitution 1 and massless by regularisation";
  static constexpr std::string_view kLadder = "harmonics=10|40|160";
  static constexpr double kOrder = 1.0;  ///< of x in the ladder, with impacts [-]

  struct Options {
    std::optional<int> harmonics = {};   ///< H >= 1 [-]
    std::optional<int> samples = {};     ///< N >= 2 H + 1 [-]
    std::optional<Scaled> penalty = {};  ///< eps > 0 [N/m], or times contact_stiffness_scale
    std::optional<Quadrature> quadrature = {};
    std::optional<bool> compensate = {};
    ComplementaritySolver solver = ComplementaritySolver::automatic;
    double tolerance = 1e-10;  ///< on LcpResult::residual [-]
    int max_iterations = 0;    ///< pivots or Newton steps; 0: the solver's own limit [-]
    bool plain = false;

    void visit(auto&& field) {
      field("harmonics", harmonics, "[-]",
            "highest harmonic H kept, 1..100000; auto: 20, where that fails twice as many, up to 160");
      field("samples", samples, "[-]",
            "N per period, >= 2 H + 1; auto: no grid beyond 20 harmonics, else 8 H or finer (sampled: 32 H)");
      field("penalty", penalty, "[N/m]",
            "stiffness of the stop, 1e6 or 100x the contact's; auto: the scene's, else 8x (compensated 64x) "
            "the "
            "dynamic one near H, stiffer if massless");
      field("quadrature", quadrature, "[-]",
            "exact: contact integral between its edges | sampled: on the N samples; auto: exact, sampled if "
            "plain");
      field("compensate", compensate, "[-]",
            "impacts right with all harmonics, the integral being exact: true | false; auto: unless plain");
      field("solver", solver, "[-]", "auto (pivoting with restarts; newton if plain) | pivoting | newton");
      field("tolerance", tolerance, "[-]", "relative complementarity residual accepted, in (0, 1e-2]");
      field("max_iterations", max_iterations, "[-]", "limit on pivots or Newton steps; 0: the solver's own");
      field("plain", plain, "[-]", "true: as the literature does it; sets what is left at auto");
    }
  };

  explicit PenaltyHbm(const Options& options);  ///< \throws InvalidOption

  [[nodiscard]] std::vector<OptionEcho> options() const override { return echo_options(options_); }
  [[nodiscard]] Support supports(const Problem& problem) const override;
  [[nodiscard]] RepresentedLaw law(const Problem& problem) const override;
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Problem& problem) const override;

 private:
  Options options_;
};

}  // namespace signorini
