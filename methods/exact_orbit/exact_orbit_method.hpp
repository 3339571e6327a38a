#pragma once
// Exact periodic orbits from a cold start: pivoting on a coarse grid, then Newton on the closed-form flow.

#include <optional>

#include "methods/curve.hpp"
#include "methods/method.hpp"

namespace signorini {

/// (1) Solves the scene coarsely on N nodes by pivoting: hat functions with the scene's own restitution,
/// spring or massless contact (`hat_contact`). (2) Reads the sequence of impacts and contacts off the answer
/// and polishes it to an exact orbit (`OrbitFinder`). Where that fails it marches some periods on the
/// closed-form flow from there and shoots, takes other covering vectors and finer grids, where the law is
/// conservative harmonic balance too (of several contacts before finer grids), and at the end shooting and
/// marching. Represents the scene's own law always.
///
/// Guarantee: a converged answer solves the equations of motion, the impact law and the periodicity to
/// `tolerance` (or to the round-off stated), does not penetrate, and pulls nowhere (1e-11 of the scales); its
/// message gives the error bar. Of several orbits it returns the first found: stable or not.
///
/// Structures of more than 300 coordinates (of more than 100 under ten springs) with massless contacts or
/// springs and proportional damping are solved on what their contacts feel (`find_reduced_orbit`) and
/// corrected to the orbit of all coordinates
/// (`correct_orbit`); without an error bar for that there is no answer. `samples`, `refinements` and
/// `restarts` do not matter then.
class ExactOrbitMethod final : public Method, public CurveMethod {
 public:
  static constexpr MethodText kText{
      .name = "exact-orbit",
      .title = "Coarse pivoting, then Newton on the exact flow between events",
      .laws = "restitution 0..1, penalty, massless",
      .ladder = "samples=64|256",
      .limits =
          "At most 300 coordinates, beyond that only massless contacts or springs with proportional damping. "
          "A coarse solve must show the sequence of events: it may fail near grazing and at many short "
          "contacts.",
      .starts = "samples=16|32|128|1024",
      .exact = true};

  struct Options {
    int samples = 64;          ///< N >= 8 nodes of the coarse solve per period, more where the load asks [-]
    int refinements = 2;       ///< grids of 4 N, 16 N ... tried after the first [-]
    int restarts = 4;          ///< other covering vectors tried on each grid but the last [-]
    double tolerance = 1e-12;  ///< on the residual of the orbit's equations [-]
    int max_iterations = 40;   ///< Newton steps of one polish [-]
    int marching = 200;        ///< periods marched, the first 32 before finer grids [-]

    void visit(auto&& field) {
      field("samples", samples, "[-]",
            "nodes N per period of the coarse solve, 8..100000; times 4 until they resolve the load");
      field("refinements", refinements, "[-]", "grids of 4 N, 16 N, ... tried where the first fails, 0..4");
      field("restarts", restarts, "[-]", "other covering vectors tried on each grid, 0..16");
      field("tolerance", tolerance, "[-]", "residual of the orbit's equations accepted, in [1e-14, 1e-6]");
      field("max_iterations", max_iterations, "[-]", "limit on the Newton steps of one polish, >= 1");
      field("marching", marching, "[-]",
            "periods marched where a coarse motion leads to no orbit, 32 before finer grids; 0: none");
    }
  };

  explicit ExactOrbitMethod(const Options& options);  ///< \throws InvalidOption

  [[nodiscard]] std::vector<OptionEcho> options() const override { return echo_options(options_); }
  [[nodiscard]] Support supports(const Problem& problem) const override;
  [[nodiscard]] RepresentedLaw law(const Problem& problem) const override;
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Problem& problem) const override;
  [[nodiscard]] const CurveMethod* curve() const override { return this; }
  /// Over any number of the scene; not where continuation_obstacle names a reason.
  [[nodiscard]] Support follows(const ParametrisedScene& scene) const override;
  /// Of exact orbits (exact_diagram).
  [[nodiscard]] BranchDiagram follow(const ParametrisedScene& scene,
                                     const CurveLimits& limits) const override;
  /// Of all kinds but branch points (bifurcation_curves).
  [[nodiscard]] std::optional<BranchDiagram> follow_bifurcations(const ScenePlane& plane, SpecialKind kind,
                                                                 const CurveLimits& limits) const override;

 private:
  Options options_;
};

}  // namespace signorini
