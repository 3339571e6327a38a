#include "harness/orbits/answer_starts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "harness/judge/motion.hpp"
#include "harness/plan/selection.hpp"
#include "harness/records/record.hpp"
#include "methods/hat_functions/hat_contact.hpp"
#include "methods/linear_flow/contact_dynamics.hpp"
#include "methods/periodic_motion/periodic_motion.hpp"
#include "methods/refinement.hpp"
#include "methods/structure/condensation.hpp"

namespace signorini {

namespace {

/// A single solve gives up after this long: of a method, on a coarse grid [s].
constexpr double kMethodSeconds = 10.0;
constexpr double kGridSeconds = 2.0;

/// The orbit behind an answer of a method, at the answer's own order.
void polish_answer(const Problem& problem, const Trajectory& answer, Deadline deadline,
                   OrbitCandidate& candidate) {
  const SampledAnswer sampled = sample_answer(problem, answer);
  if (!sampled.defect.empty()) {
    candidate.reason = sampled.defect;
    return;
  }
  candidate.order = sampled.motion.order;
  const Problem same_order = with_subharmonic(problem, candidate.order);
  OrbitFinder finder(same_order);
  const OrbitSearch search = finder.find(answer, search_until(deadline));
  take_search(search, candidate);
  if (!candidate.orbit) return;
  const Motion orbit = sample_motion(same_order, *search.orbit.trajectory);
  candidate.near = distance(sampled.motion, orbit).x_l2.value_or(0.0) <= kNearOrbit;
}

/// The orbit behind what a method or the flow returned.
void take_answer(const Problem& problem, const Solution& solution, Deadline deadline,
                 OrbitCandidate& candidate) {
  if (solution.verdict != Verdict::converged || !solution.trajectory) {
    candidate.reason = "the method did not converge";
    return;
  }
  polish_answer(problem, *solution.trajectory, deadline, candidate);
}

/// A method with one set of options; none if it does not apply or represents another law.
std::optional<CandidateUnit> cold_start(const Problem& problem, const MethodChoice& choice, int order) {
  const std::unique_ptr<Method> probe = choice.make();
  const Problem at = with_subharmonic(problem, order);
  if (!probe->supports(at).ok || !law_matches(probe->law(at), problem.law)) return std::nullopt;
  return CandidateUnit{
      choice.label(), [&problem, choice, order](const CandidateUnit::Deliver& deliver, Deadline deadline) {
        OrbitCandidate candidate{
            .origin = OrbitCandidate::Origin::method, .source = choice.label(), .order = order};
        // Exceptions of the method leave the unit: its process ends, and the parent takes note.
        const Problem at = with_subharmonic(problem, order);
        const Deadline limit = std::min(deadline, deadline_after(kMethodSeconds));
        const std::unique_ptr<Method> method = choice.make();
        const Solution solution = method->prepare(at)->solve({.guess = {}, .deadline = limit});
        take_answer(at, solution, limit, candidate);
        deliver(candidate);
      }};
}

/// Default options, the ladder, and the method's further starts; settings that come to the same options once.
std::vector<MethodChoice> cold_choices(const MethodEntry& entry) {
  std::vector<Settings> settings{{}};
  for (Settings& rung : ladder_of(entry)) settings.push_back(std::move(rung));
  if (!entry.starts.empty()) {
    for (Settings& start : expand_settings(entry.starts)) settings.push_back(std::move(start));
  }
  std::vector<MethodChoice> choices;
  std::vector<std::vector<OptionValue>> known;
  for (Settings& one : settings) {
    std::vector<OptionValue> values;
    for (const OptionEcho& option : entry.make(one)->options()) values.push_back(option.value);
    if (std::find(known.begin(), known.end(), values) != known.end()) continue;
    known.push_back(std::move(values));
    choices.push_back({&entry, std::move(one)});
  }
  return choices;
}

/// One coarse grid, pivoted along the covering vector number `turn`.
OrbitCandidate grid_candidate(const Problem& problem, int per_period, int turn, Deadline deadline) {
  OrbitCandidate candidate{.origin = OrbitCandidate::Origin::grid,
                           .source = fmt::format("coarse grid {}, cover {}", per_period, turn),
                           .order = problem.subharmonic};
  std::optional<double> restitution;
  if (const auto* law = std::get_if<Restitution>(&problem.law)) restitution = law->e;
  const HatSettings settings{.samples = per_period * problem.subharmonic,
                             .solver = ComplementaritySolver::pivoting,
                             .cover_amplitude = turn < 4 ? 0.4 : 0.8,
                             .cover_phase = 0.5 * std::numbers::pi * (turn + 0.3)};
  const Solution solution =
      hat_contact(problem, settings, restitution)->solve({.guess = {}, .deadline = deadline});
  if (solution.trajectory) {
    polish_answer(problem, *solution.trajectory, deadline, candidate);
  } else {
    candidate.reason = "the coarse grid has no solution";
  }
  return candidate;
}

}  // namespace

CandidateUnit from_rest(const Problem& problem) {
  return {"from rest", [&problem](const CandidateUnit::Deliver& deliver, Deadline deadline) {
            OrbitCandidate candidate{.origin = OrbitCandidate::Origin::rest, .source = "from rest"};
            if (flow_obstacle(problem).empty()) {
              PeriodicMotionOptions options = marching_options();
              options.integrator = Integrator::modal;
              const ContactDynamics dynamics(problem);
              const Solution motion =
                  find_periodic_motion(problem, dynamics, options, {.guess = {}, .deadline = deadline});
              take_answer(problem, motion, deadline, candidate);
            } else {
              candidate.reason = "time marching does not apply";
            }
            deliver(candidate);
          }};
}

std::vector<CandidateUnit> cold_starts(const Problem& problem, int order,
                                       std::span<const MethodEntry> catalogue) {
  std::vector<CandidateUnit> units;
  for (const MethodEntry& entry : catalogue) {
    for (const MethodChoice& choice : cold_choices(entry)) {
      if (auto unit = cold_start(problem, choice, order)) units.push_back(std::move(*unit));
    }
  }
  return units;
}

CandidateUnit coarse_grids(const Problem& problem, int order) {
  return {
      "coarse grids", [&problem, order](const CandidateUnit::Deliver& deliver, Deadline deadline) {
        const Problem at = with_subharmonic(problem, order);
        for (const int per_period : {48, 112}) {
          for (int turn = 0; turn < 6; ++turn) {
            if (Deadline::clock::now() > deadline) return;
            deliver(grid_candidate(at, per_period, turn, std::min(deadline, deadline_after(kGridSeconds))));
          }
        }
      }};
}

}  // namespace signorini
