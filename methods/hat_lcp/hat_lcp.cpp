#include "methods/hat_lcp/hat_lcp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "methods/hat_functions/continuation/hat_diagram.hpp"

namespace signorini {

HatLcp::HatLcp(const Options& options) : options_(options) {
  require_option(!options_.samples || (*options_.samples >= 4 && *options_.samples <= 10000000), "samples",
                 options_.samples, "must be from 4 to 10000000, or auto");
  require_option(options_.tolerance > 0.0 && options_.tolerance <= 1e-2, "tolerance", options_.tolerance,
                 "must be in (0, 1e-2]");
  const bool of_the_scene = options_.restitution == ImpactLaw::scene;
  require_option(!of_the_scene || options_.scheme != Scheme::consistent, "restitution", options_.restitution,
                 "must be none or auto if scheme = consistent");
  require_option(options_.max_iterations >= 0, "max_iterations", options_.max_iterations,
                 "must be 0 or more");
}

HatLcp::ImpactLaw HatLcp::impact_law() const {
  const bool none = options_.plain || options_.scheme == Scheme::consistent;
  return options_.restitution.value_or(none ? ImpactLaw::none : ImpactLaw::scene);
}

int HatLcp::first_samples(const Problem& problem) const {
  return options_.samples ? *options_.samples : coarsest_hat_grid(problem);
}

Support HatLcp::supports(const Problem& problem) const {
  if (options_.scheme == Scheme::bdf2 && has_impacts(problem))
    return {false, "scheme = bdf2 represents no impact law: massless contacts and spring stops only"};
  const bool open = has_impacts(problem) && !imposes_restitution() && options_.scheme != Scheme::backward;
  const auto has_another_law = [](const Contact& contact) {
    return !std::holds_alternative<Restitution>(contact.law);
  };
  if (open && std::ranges::any_of(problem.contacts, has_another_law))
    return {false,
            "restitution = none leaves the law of rigid contacts open, but others have one of their own"};
  return grid_support(problem, first_samples(problem));
}

RepresentedLaw HatLcp::law(const Problem& problem) const {
  if (options_.scheme == Scheme::backward) return with_restitution(problem, 0.0);
  if (has_impacts(problem) && impact_law() == ImpactLaw::none) return Undetermined{};
  return as_represented(problem.law());
}

bool HatLcp::imposes_restitution() const {
  return impact_law() == ImpactLaw::scene && options_.scheme != Scheme::backward;
}

NodalRestitution HatLcp::imposed_restitution(const Problem& problem) const {
  return imposes_restitution() ? scene_restitution(problem) : NodalRestitution{};
}

std::unique_ptr<PreparedMethod> HatLcp::prepare(const Problem& problem) const {
  NodalRestitution restitution = imposed_restitution(problem);
  const bool one_path = options_.plain && options_.solver == ComplementaritySolver::automatic;
  const HatSettings settings{.samples = first_samples(problem),
                             .scheme = options_.scheme,
                             .solver = one_path ? ComplementaritySolver::pivoting : options_.solver,
                             .tolerance = options_.tolerance,
                             .max_iterations = options_.max_iterations};
  const bool refines =
      problem.contact_count() > 0 && !options_.samples && !options_.plain && settings.way_is_open();
  if (!refines) return hat_contact(problem, settings, std::move(restitution));
  return refined_hat_contact(problem, settings, std::move(restitution));
}

BranchDiagram HatLcp::follow(const ParametrisedScene& scene, const CurveLimits& limits) const {
  const Problem problem = scene.at(scene.from);
  HatFamily family{curve_family(problem, scene.from, scene.to)};
  family.samples = first_samples(problem);
  family.scheme = options_.scheme;
  family.restitution = imposed_restitution(problem);
  Options one_grid = options_;
  one_grid.samples = family.samples;
  BranchDiagram diagram = hat_diagram(family, scene, HatLcp(one_grid), limits);
  if (!options_.samples && !diagram.branches.empty())
    diagram.notes.push_back(fmt::format(
        "its curve stands on {} nodes; a solve goes on to finer grids until two agree", family.samples));
  return diagram;
}

}  // namespace signorini
