#include "harness/orbits/orbit_candidates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "harness/judge/certificate.hpp"
#include "harness/judge/motion.hpp"
#include "harness/plan/selection.hpp"
#include "harness/records/record.hpp"
#include "harness/records/sampled_trajectory.hpp"
#include "methods/event_driven/event_driven.hpp"
#include "methods/flow/flow.hpp"
#include "methods/hat_functions/hat_contact.hpp"

namespace signorini {

namespace {

using Clock = std::chrono::steady_clock;
using Deliver = CandidateUnit::Deliver;
using Origin = OrbitCandidate::Origin;

/// Random states of one process: small enough that a crash or a time limit costs little.
constexpr int kStatesPerUnit = 8;
constexpr int kLongestTransient = 20;
/// A single search from a random state gives up after this long [s].
constexpr double kStateSeconds = 2.0;
constexpr double kMethodSeconds = 10.0;

SteadyTime no_later(SteadyTime deadline, double seconds) {
  return std::min(deadline, Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                               std::chrono::duration<double>(seconds)));
}

SearchOptions search_options(SteadyTime deadline) {
  SearchOptions options;
  options.expired = [deadline] { return Clock::now() > deadline; };
  return options;
}

/// Fills in what a search found.
void take_search(const OrbitSearch& search, OrbitCandidate& candidate) {
  if (search.orbit.certified()) {
    candidate.orbit = search.orbit.trajectory->orbit();
  } else {
    candidate.reason = describe(search.orbit.outcome);
  }
}

/// The orbit behind an answer of a method, at the answer's own order.
void polish_answer(const Problem& problem, const Trajectory& answer, SteadyTime deadline,
                   OrbitCandidate& candidate) {
  const SampledAnswer sampled = sample_answer(problem, answer);
  if (!sampled.defect.empty()) {
    candidate.reason = sampled.defect;
    return;
  }
  candidate.order = sampled.motion.order;
  const Problem same_order = with_subharmonic(problem, candidate.order);
  OrbitFinder finder(same_order);
  const OrbitSearch search = finder.find(answer, search_options(deadline));
  take_search(search, candidate);
  if (!candidate.orbit) return;
  const Motion orbit = sample_motion(same_order, *search.orbit.trajectory);
  candidate.near = distance(sampled.motion, orbit).x_l2.value_or(0.0) <= kNearOrbit;
}

/// One cold solve. Exceptions of the method leave it: the parent takes note.
void solve_cold(const Problem& problem, const Method& method, SteadyTime deadline,
                OrbitCandidate& candidate) {
  const Solution solution = method.prepare(problem)->solve({.guess = {}, .deadline = deadline});
  if (solution.verdict != Verdict::converged || !solution.trajectory) {
    candidate.reason = "the method did not converge";
    return;
  }
  polish_answer(problem, *solution.trajectory, deadline, candidate);
}

CandidateUnit from_rest(const Problem& problem) {
  return {"from rest", [&problem](const Deliver& deliver, SteadyTime deadline) {
            OrbitCandidate candidate{.origin = Origin::rest, .source = "from rest"};
            EventDriven::Options options;
            options.tolerance = 1e-11;
            options.flow = Integrator::modal;
            options.max_iterations = 20000;
            const EventDriven method(options);
            if (!method.supports(problem).ok) {
              candidate.reason = "time marching does not apply";
            } else {
              solve_cold(problem, method, deadline, candidate);
            }
            deliver(candidate);
          }};
}

/// A method with one set of options; none if it does not apply or represents another law.
std::optional<CandidateUnit> cold_start(const Problem& problem, const MethodChoice& choice, int order) {
  const std::unique_ptr<Method> probe = choice.make();
  const Problem at = with_subharmonic(problem, order);
  if (!probe->supports(at).ok || !law_matches(probe->law(at), problem.law)) return std::nullopt;
  return CandidateUnit{
      choice.label(), [&problem, choice, order](const Deliver& deliver, SteadyTime deadline) {
        OrbitCandidate candidate{.origin = Origin::method, .source = choice.label(), .order = order};
        solve_cold(with_subharmonic(problem, order), *choice.make(), no_later(deadline, kMethodSeconds),
                   candidate);
        deliver(candidate);
      }};
}

/// Default options, the ladder, and for exact-orbit more grids; settings that come to the same options once.
std::vector<MethodChoice> cold_choices(const MethodEntry& entry) {
  std::vector<Settings> settings{{}};
  for (Settings& rung : ladder_of(entry)) settings.push_back(std::move(rung));
  if (entry.name == "exact-orbit") {
    for (Settings& grid : expand_settings("samples=16|32|128|1024")) settings.push_back(std::move(grid));
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

CandidateUnit coarse_grids(const Problem& problem, int order) {
  return {"coarse grids", [&problem, order](const Deliver& deliver, SteadyTime deadline) {
            const Problem at = with_subharmonic(problem, order);
            std::optional<double> restitution;
            if (const auto* law = std::get_if<Restitution>(&at.law)) restitution = law->e;
            for (const int per_period : {48, 112}) {
              for (int turn = 0; turn < 6; ++turn) {
                if (Clock::now() > deadline) return;
                const HatSettings settings{.samples = per_period * order,
                                           .solver = ComplementaritySolver::pivoting,
                                           .cover_amplitude = turn < 4 ? 0.4 : 0.8,
                                           .cover_phase = 0.5 * std::numbers::pi * (turn + 0.3)};
                OrbitCandidate candidate{.origin = Origin::grid,
                                         .source = fmt::format("coarse grid {}, cover {}", per_period, turn),
                                         .order = order};
                const SteadyTime limit = no_later(deadline, kStateSeconds);
                const Solution solution =
                    hat_contact(at, settings, restitution)->solve({.guess = {}, .deadline = limit});
                if (solution.trajectory) {
                  polish_answer(at, *solution.trajectory, limit, candidate);
                } else {
                  candidate.reason = "the coarse grid has no solution";
                }
                deliver(candidate);
              }
            }
          }};
}

/// Uniform in [0, 1), the same on every platform.
double uniform(std::mt19937_64& generator) { return static_cast<double>(generator() >> 11U) * 0x1p-53; }

/// A state of the scales of the motion, after a transient.
FlowState random_state(OrbitModel& model, std::mt19937_64& generator, const SearchOptions& options) {
  const ContactDynamics& dynamics = model.dynamics;
  const double size = std::pow(10.0, 2.0 * uniform(generator) - 1.0);
  State state{.u = Eigen::VectorXd(dynamics.size()), .v = Eigen::VectorXd(dynamics.size())};
  for (double& u : state.u) u = size * dynamics.scales().displacement * (2.0 * uniform(generator) - 1.0);
  for (double& v : state.v) v = size * dynamics.scales().velocity * (2.0 * uniform(generator) - 1.0);
  const double time = dynamics.forcing_period() * uniform(generator);
  const auto transient = static_cast<int>((kLongestTransient + 1) * uniform(generator));
  EventFlow flow(dynamics, 1e-9, options.expired, Integrator::modal);
  FlowState start = flow.place(time, state);
  if (transient > 0) {
    FlowRecord record;
    flow.advance(start, transient * dynamics.forcing_period(), record);
    start.time = time;
  }
  return start;
}

OrbitCandidate search_from_state(const Problem& at, int number, unsigned seed, SteadyTime deadline) {
  OrbitCandidate candidate{
      .origin = Origin::state, .source = fmt::format("random state {}", number), .order = at.subharmonic};
  std::seed_seq seeds{seed, static_cast<unsigned>(at.subharmonic), static_cast<unsigned>(number)};
  std::mt19937_64 generator(seeds);
  const SearchOptions options = search_options(no_later(deadline, kStateSeconds));
  OrbitFinder finder(at);
  try {
    const FlowState start = random_state(*finder.model(), generator, options);
    const auto sequence = simulated_sequence(*finder.model(), start, options.expired);
    const OrbitGuess guess = sequence.value_or(OrbitGuess{.start = start, .events = {}, .origin = "a state"});
    take_search(finder.find(guess, options), candidate);
  } catch (const std::exception& error) {  // FlowError, IntegrationError: this state leads nowhere
    candidate.reason = error.what();
  }
  return candidate;
}

CandidateUnit random_states(const Problem& problem, int order, int first, int last, unsigned seed) {
  return {fmt::format("random states {}..{}", first, last - 1),
          [&problem, order, first, last, seed](const Deliver& deliver, SteadyTime deadline) {
            const Problem at = with_subharmonic(problem, order);
            for (int number = first; number < last && Clock::now() <= deadline; ++number)
              deliver(search_from_state(at, number, seed, deadline));
          }};
}

using Json = nlohmann::ordered_json;

Json list(const Eigen::VectorXd& values) { return std::vector<double>(values.begin(), values.end()); }

Eigen::VectorXd vector(const Json& json) {
  const auto values = json.get<std::vector<double>>();
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Json guess_to_json(const OrbitGuess& guess) {
  Json events = Json::array();
  for (const SequenceEvent& event : guess.events) {
    events.push_back({{"kind", static_cast<int>(event.kind)},
                      {"contact", event.contact},
                      {"time", event.time},
                      {"pushed", event.pushed},
                      {"restitution", event.restitution},
                      {"closed", event.closed}});
  }
  return {{"time", guess.start.time},     {"u", list(guess.start.state.u)}, {"v", list(guess.start.state.v)},
          {"closed", guess.start.closed}, {"events", std::move(events)},    {"origin", guess.origin}};
}

OrbitGuess guess_from_json(const Json& json) {
  OrbitGuess guess{.start = {.time = json.at("time"),
                             .state = {.u = vector(json.at("u")), .v = vector(json.at("v"))},
                             .closed = json.at("closed").get<std::vector<bool>>()},
                   .events = {},
                   .origin = json.at("origin")};
  for (const Json& event : json.at("events")) {
    guess.events.push_back({.kind = static_cast<ContactEvent::Kind>(event.at("kind").get<int>()),
                            .contact = event.at("contact"),
                            .time = event.at("time"),
                            .pushed = event.at("pushed").get<std::vector<int>>(),
                            .restitution = event.at("restitution").get<std::vector<double>>(),
                            .closed = event.at("closed").get<std::vector<bool>>()});
  }
  return guess;
}

}  // namespace

Json to_json(const OrbitCandidate& candidate) {
  Json json{{"origin", static_cast<int>(candidate.origin)},
            {"source", candidate.source},
            {"order", candidate.order},
            {"near", candidate.near},
            {"reason", candidate.reason}};
  if (candidate.orbit) json["orbit"] = guess_to_json(*candidate.orbit);
  return json;
}

OrbitCandidate orbit_candidate_from_json(const Json& json) {
  try {
    OrbitCandidate candidate{.origin = static_cast<Origin>(json.at("origin").get<int>()),
                             .source = json.at("source"),
                             .order = json.at("order"),
                             .near = json.at("near"),
                             .orbit = {},
                             .reason = json.at("reason")};
    if (json.contains("orbit")) candidate.orbit = guess_from_json(json["orbit"]);
    return candidate;
  } catch (const nlohmann::json::exception& error) {
    throw BadRecord(error.what());
  }
}

std::vector<CandidateUnit> candidate_units(const Problem& problem, int order, int starts, unsigned seed,
                                           std::span<const MethodEntry> catalogue) {
  std::vector<CandidateUnit> units;
  if (order == 1) units.push_back(from_rest(problem));
  for (const MethodEntry& entry : catalogue) {
    for (const MethodChoice& choice : cold_choices(entry)) {
      if (auto unit = cold_start(problem, choice, order)) units.push_back(std::move(*unit));
    }
  }
  units.push_back(coarse_grids(problem, order));
  for (int first = 0; first < starts; first += kStatesPerUnit)
    units.push_back(random_states(problem, order, first, std::min(starts, first + kStatesPerUnit), seed));
  return units;
}

}  // namespace signorini
