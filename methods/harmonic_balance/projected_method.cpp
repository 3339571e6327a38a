#include "methods/harmonic_balance/projected_method.hpp"

#include <utility>

#include "methods/complementarity/projected_law.hpp"
#include "methods/harmonic_balance/continuation/series_diagram.hpp"

namespace signorini {

ProjectedMethod::ProjectedMethod(const HarmonicOptions& common, const std::optional<Scaled>& penalty)
    : common_(common), penalty_(penalty) {
  validate(common_);
  require_option(!penalty_ || penalty_->value > 0.0, "penalty", penalty_, "must be positive, or auto");
}

Support ProjectedMethod::supports(const Problem& problem) const {
  return supports_harmonics(problem, common_);
}

RepresentedLaw ProjectedMethod::law(const Problem& problem) const {
  return projected_method_law(problem, penalty_);
}

std::unique_ptr<PreparedMethod> ProjectedMethod::prepare(const Problem& problem) const {
  return prepare_harmonic_balance(problem, common_, [this](const Problem& solved) { return preset(solved); });
}

BranchDiagram FollowedMethod::follow(const ParametrisedScene& scene, const CurveLimits& limits) const {
  const Problem problem = scene.at(scene.from);
  return series_diagram(scene, *this, common(), preset(problem).law_at, limits);
}

HarmonicMethod by_complementarity(LawAt law, const HarmonicOptions& common, ComplementaritySolver solver) {
  return {.law_at = std::move(law),
          .grid_solver = lcp_grid_solver(lcp_settings(common, solver)),
          .solver_is_open = leaves_solver_open(common, solver)};
}

}  // namespace signorini
