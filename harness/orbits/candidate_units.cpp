#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <stdexcept>
#include <utility>

#include "harness/judge/measures/motion.hpp"
#include "harness/orbits/orbit_candidate.hpp"
#include "harness/plan/plan.hpp"
#include "methods/flow/flow.hpp"
#include "methods/hat_functions/hat_contact.hpp"
#include "methods/periodic_motion/periodic_motion.hpp"
#include "methods/refinement.hpp"
#include "methods/structure/bases/condensation.hpp"

namespace signorini {

namespace {

/// A single solve gives up after this long: of a method; on a coarse grid, or from a random state [s].
constexpr double kMethodSeconds = 10.0, kShortSeconds = 2.0;

/// Takes over the orbit of a search, or the reason why it found none.
void take_search(const OrbitSearch& search, OrbitCandidate& candidate) {
  if (search.orbit.certified()) {
    candidate.orbit = search.orbit.trajectory->orbit();
  } else {
    candidate.reason = describe(search.orbit.outcome);
  }
}

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

/// A method with one set of options; none if it does not apply or represents another law. A solve ends after
/// ten seconds.
std::optional<CandidateUnit> cold_start(const Problem& problem, const MethodChoice& choice, int order) {
  const std::unique_ptr<Method> probe = choice.make();
  const Problem at = with_subharmonic(problem, order);
  if (!probe->supports(at).ok || !law_matches(probe->law(at), problem.law())) return std::nullopt;
  return CandidateUnit{
      choice.label(), [&problem, choice, order](const CandidateUnit::Deliver& deliver, Deadline deadline) {
        OrbitCandidate candidate{
            .origin = OrbitCandidate::Origin::method, .source = choice.label(), .order = order};
        const Problem at = with_subharmonic(problem, order);
        const Deadline limit = Deadline::first_of(deadline, Deadline::after(kMethodSeconds));
        const std::unique_ptr<Method> method = choice.make();
        try {
          const Solution solution = method->prepare(at)->solve({.guess = {}, .deadline = limit});
          take_answer(at, solution, limit, candidate);
        } catch (const std::runtime_error& error) {  // a resonance, or a mean load that nothing balances
          candidate.reason = error.what();
        }  // What else a method throws leaves the unit: its process ends, and the parent takes note.
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
    if (std::ranges::count(known, values) > 0) continue;
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
  const HatSettings settings{.samples = per_period * problem.subharmonic,
                             .solver = ComplementaritySolver::pivoting,
                             .cover_amplitude = turn < 4 ? 0.4 : 0.8,
                             .cover_phase = 0.5 * std::numbers::pi * (turn + 0.3)};
  const Solution solution =
      hat_contact(problem, settings, scene_restitution(problem))->solve({.guess = {}, .deadline = deadline});
  if (solution.trajectory) {
    polish_answer(problem, *solution.trajectory, deadline, candidate);
  } else {
    candidate.reason = "the coarse grid has no solution";
  }
  return candidate;
}

/// Marching from rest on the closed-form flow, of any order.
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

/// Hat functions on two coarse grids along waved covering vectors (HatSettings::cover_amplitude), which lead
/// a pivoting method to different solutions. A solve ends after two seconds.
CandidateUnit coarse_grids(const Problem& problem, int order) {
  return {"coarse grids", [&problem, order](const CandidateUnit::Deliver& deliver, Deadline deadline) {
            const Problem at = with_subharmonic(problem, order);
            for (const int per_period : {48, 112}) {
              for (int turn = 0; turn < 6; ++turn) {
                if (deadline.passed()) return;
                deliver(grid_candidate(at, per_period, turn,
                                       Deadline::first_of(deadline, Deadline::after(kShortSeconds))));
              }
            }
          }};
}

/// Uniform in [0, 1), the same on every platform.
double uniform(std::mt19937_64& generator) { return static_cast<double>(generator() >> 11U) * 0x1p-53; }

/// A random state after a transient.
FlowState settled_state(OrbitModel& model, std::mt19937_64& generator, const SearchOptions& options) {
  EventFlow flow(model.dynamics, 1e-9, options.expired, Integrator::modal);
  FlowState start = random_state(flow, generator);
  const auto transient = static_cast<int>(21.0 * uniform(generator));  // [forcing periods]
  if (transient > 0) {
    FlowRecord record;
    const double time = start.time;
    flow.advance(start, transient * model.dynamics.structure().forcing_period, record);
    start.time = time;
  }
  return start;
}

OrbitCandidate search_from_state(const Problem& at, int number, unsigned seed, Deadline deadline) {
  OrbitCandidate candidate{.origin = OrbitCandidate::Origin::state,
                           .source = fmt::format("random state {}", number),
                           .order = at.subharmonic};
  std::seed_seq seeds{seed, static_cast<unsigned>(at.subharmonic), static_cast<unsigned>(number)};
  std::mt19937_64 generator(seeds);
  const SearchOptions options = search_until(Deadline::first_of(deadline, Deadline::after(kShortSeconds)));
  OrbitFinder finder(at);
  try {
    const FlowState start = settled_state(*finder.model(), generator, options);
    const auto sequence = simulated_sequence(*finder.model(), start, options.expired);
    const OrbitGuess guess = sequence.value_or(OrbitGuess{.start = start, .events = {}, .origin = "a state"});
    take_search(finder.find(guess, options), candidate);
  } catch (const std::exception& error) {  // FlowError, IntegrationError: this state leads nowhere
    candidate.reason = error.what();
  }
  return candidate;
}

/// Random states `first` to `last` - 1 at period `order` forcing periods, one search each: displacements and
/// velocities uniform within a magnitude that is log-uniform in 0.1 to 10 scales of the motion, at a random
/// phase of the forcing, followed for 0 to 20 periods before the search takes over. Each has a generator of
/// its own, seeded with (seed, order, number): a state does not depend on which others are drawn. A search
/// ends after two seconds.
CandidateUnit random_states(const Problem& problem, int order, int first, int last, unsigned seed) {
  return {fmt::format("random states {}..{}", first, last - 1),
          [&problem, order, first, last, seed](const CandidateUnit::Deliver& deliver, Deadline deadline) {
            const Problem at = with_subharmonic(problem, order);
            for (int number = first; number < last && !deadline.passed(); ++number)
              deliver(search_from_state(at, number, seed, deadline));
          }};
}

}  // namespace

SearchOptions search_until(Deadline deadline) {
  SearchOptions options;
  options.free_families = FreeFamilies::last;
  options.expired = [deadline] { return deadline.passed(); };
  return options;
}

FlowState random_state(const EventFlow& flow, std::mt19937_64& generator) {
  const ContactDynamics& dynamics = flow.dynamics();
  const double size = std::pow(10.0, 2.0 * uniform(generator) - 1.0);
  State state = dynamics.at_rest();
  for (double& u : state.u) u = size * dynamics.scales().displacement * (2.0 * uniform(generator) - 1.0);
  for (double& v : state.v) v = size * dynamics.scales().velocity * (2.0 * uniform(generator) - 1.0);
  return flow.place(dynamics.structure().forcing_period * uniform(generator), state);
}

FlowState random_state(const EventFlow& flow, unsigned seed, int number) {
  std::seed_seq seeds{seed, static_cast<unsigned>(number)};
  std::mt19937_64 generator(seeds);
  return random_state(flow, generator);
}

EventFlow placing_flow(const ContactDynamics& dynamics) { return {dynamics, 1e-10, {}, Integrator::modal}; }

std::vector<CandidateUnit> candidate_units(const Problem& problem, int order, int starts, unsigned seed,
                                           std::span<const MethodEntry> catalogue) {
  // Random states of one process: small enough that a crash or a time limit costs little.
  constexpr int kStatesPerUnit = 8;
  std::vector<CandidateUnit> units;
  if (order == 1) units.push_back(from_rest(problem));
  for (const MethodEntry& entry : catalogue)
    for (const MethodChoice& choice : cold_choices(entry))
      if (auto unit = cold_start(problem, choice, order)) units.push_back(std::move(*unit));
  units.push_back(coarse_grids(problem, order));
  for (int first = 0; first < starts; first += kStatesPerUnit)
    units.push_back(random_states(problem, order, first, std::min(starts, first + kStatesPerUnit), seed));
  return units;
}

}  // namespace signorini
