#pragma once
// Hat functions in time: one linear complementarity problem for the whole period.

#include <array>
#include <optional>
#include <string_view>

#include "methods/curve.hpp"
#include "methods/hat_functions/hat_contact.hpp"
#include "methods/method.hpp"

namespace signorini {

/// Periodic hat functions on N nodes reduce the structure to x = x_f + C (*) lambda at the nodes. With
/// restitution = scene, complementarity is imposed on
///
///     w_k = g - (x_{k+1} + e x_{k-1}) / (1 + e) >= 0,  -lambda_k >= 0,  w_k lambda_k = 0,
///
/// the periodic form of the Paoli-Schatzman scheme [paoli2002]: it represents Newton's restitution e and
/// converges at first order. With restitution = none it is imposed on g - x_k at the nodes, the source
/// paper's form [shi2015, eq. 5-8, corrected], which determines no impact law: kept for comparison.
/// A spring stop adds its compliance to w; massless contacts and springs need no restitution.
///
/// A grid dissipates or feeds the motion at impacts, at a rate that falls with N; without damping enough to
/// outweigh it no periodic motion need exist on the grid, and the path of pivots ends on a ray. So with
/// samples = auto grids of 256, 1024 and 4096 nodes are tried until two agree within 5 %; an answer that they
/// contradict is not claimed (docs/decisions/0014).
///
/// `scheme = bdf2`, for massless and spring stops: backward differences of second order. With solver = auto
/// the structure is reduced to what its contacts feel and marched to its period (`marched_contact`), which
/// takes hundreds of contacts that stay closed, where paths of pivots end nowhere.
///
/// `plain`: the source paper's problem, complementarity on the nodal gaps, by one path of pivots (Lemke's
/// method) without restarts or marching. It sets what is left at `auto`.
class HatLcp final : public Method, public CurveMethod {
 public:
  using Scheme = HatScheme;
  enum class ImpactLaw { scene, none };

  static constexpr MethodText kText{
      .name = "hat-lcp",
      .title = "Hat functions in time, one linear complementarity problem per period",
      .laws = "restitution 0..1, penalty, massless; none: undetermined",
      .ladder = "samples=128|512|2048",
      .limits =
          "First order in the step: at impacts 1 % takes some 2000 nodes, 0.1 % ten times as many. On a "
          "coarse grid the equations of a lightly damped scene may have no solution.",
      .order = 1.0};

  struct Options {
    std::optional<int> samples = {};  ///< N >= 4 nodes per period [-]
    Scheme scheme = Scheme::galerkin;
    std::optional<ImpactLaw> restitution = {};
    ComplementaritySolver solver = ComplementaritySolver::automatic;
    double tolerance = 1e-10;  ///< on LcpResult::residual [-]
    int max_iterations = 0;    ///< pivots or Newton steps; 0: the solver's own limit [-]
    bool plain = false;

    void visit(auto&& field) {
      field(
          "samples", samples, "[-]",
          "nodes N per period, 4..10000000; auto: 256 or what the load needs, and four times as many, up to "
          "4096, until two grids agree");
      field("scheme", scheme, "[-]",
            "galerkin | nodal | backward (represents restitution 0) | bdf2 (massless and spring stops; "
            "marched) | consistent (galerkin with the contact force in hat functions too)");
      field("restitution", restitution, "[-]",
            "scene: the scene's law; none: nodal gaps, no impact law; auto: scene, none if plain or "
            "consistent");
      field("solver", solver, "[-]", "auto (pivoting with restarts; pivoting if plain) | pivoting | newton");
      field("tolerance", tolerance, "[-]", "relative complementarity residual accepted, in (0, 1e-2]");
      field("max_iterations", max_iterations, "[-]", "limit on pivots or Newton steps; 0: the solver's own");
      field("plain", plain, "[-]", "true: as the source paper does it; sets what is left at auto");
    }
  };

  explicit HatLcp(const Options& options);  ///< \throws InvalidOption

  [[nodiscard]] std::vector<OptionEcho> options() const override { return echo_options(options_); }
  [[nodiscard]] Support supports(const Problem& problem) const override;
  [[nodiscard]] RepresentedLaw law(const Problem& problem) const override;
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Problem& problem) const override;
  [[nodiscard]] const CurveMethod* curve() const override { return this; }
  /// Over the frequency of the load.
  [[nodiscard]] Support follows(const ParametrisedScene& scene) const override {
    return follows_frequency(*this, scene);
  }
  /// Of one grid, the one asked for or the first (hat_diagram): points of a curve are as many as its nodes.
  [[nodiscard]] BranchDiagram follow(const ParametrisedScene& scene,
                                     const CurveLimits& limits) const override;

 private:
  /// The impact law asked for.
  [[nodiscard]] ImpactLaw impact_law() const;
  /// Whether the form imposes the restitutions of a scene.
  [[nodiscard]] bool imposes_restitution() const;
  /// Those, if so.
  [[nodiscard]] NodalRestitution imposed_restitution(const Problem& problem) const;
  /// Nodes of the first grid; left to the method, sixteen per oscillation of the load, from 256 to 4096.
  [[nodiscard]] int first_samples(const Problem& problem) const;

  Options options_;
};

template <>
struct EnumNames<HatLcp::ImpactLaw> {
  static constexpr std::array<std::string_view, 2> values{"scene", "none"};
};

}  // namespace signorini
