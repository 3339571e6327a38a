#include "harness/orbits/random_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <random>

#include "methods/flow/flow.hpp"

namespace signorini {

namespace {

constexpr int kLongestTransient = 20;  // [forcing periods]
/// A single search gives up after this long [s].
constexpr double kStateSeconds = 2.0;

/// Uniform in [0, 1), the same on every platform.
double uniform(std::mt19937_64& generator) { return static_cast<double>(generator() >> 11U) * 0x1p-53; }

/// A state of the scales of the motion, after a transient.
FlowState random_state(OrbitModel& model, std::mt19937_64& generator, const SearchOptions& options) {
  const ContactDynamics& dynamics = model.dynamics;
  const double size = std::pow(10.0, 2.0 * uniform(generator) - 1.0);
  State state{.u = Eigen::VectorXd(dynamics.size()), .v = Eigen::VectorXd(dynamics.size())};
  for (double& u : state.u) u = size * dynamics.scales().displacement * (2.0 * uniform(generator) - 1.0);
  for (double& v : state.v) v = size * dynamics.scales().velocity * (2.0 * uniform(generator) - 1.0);
  const double time = dynamics.structure().forcing_period * uniform(generator);
  const auto transient = static_cast<int>((kLongestTransient + 1) * uniform(generator));
  EventFlow flow(dynamics, 1e-9, options.expired, Integrator::modal);
  FlowState start = flow.place(time, state);
  if (transient > 0) {
    FlowRecord record;
    flow.advance(start, transient * dynamics.structure().forcing_period, record);
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
  const SearchOptions options = search_until(std::min(deadline, deadline_after(kStateSeconds)));
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

}  // namespace

CandidateUnit random_states(const Problem& problem, int order, int first, int last, unsigned seed) {
  return {fmt::format("random states {}..{}", first, last - 1),
          [&problem, order, first, last, seed](const CandidateUnit::Deliver& deliver, Deadline deadline) {
            const Problem at = with_subharmonic(problem, order);
            for (int number = first; number < last && Deadline::clock::now() <= deadline; ++number)
              deliver(search_from_state(at, number, seed, deadline));
          }};
}

}  // namespace signorini
