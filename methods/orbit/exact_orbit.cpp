#include "methods/orbit/exact_orbit.hpp"

#include <exception>
#include <functional>
#include <string>
#include <utility>

#include "methods/periodic_motion/period_map.hpp"
#include "methods/structure/rigid_motions.hpp"

namespace signorini {

namespace {

// The motion from the same state as one that touches nothing: contacts of a part that rests beside its stop
// may be rounding.
OrbitGuess untouched(OrbitGuess guess) {
  guess.events.clear();
  guess.start.closed.assign(guess.start.closed.size(), false);
  return guess;
}

}  // namespace

class OrbitFinder::Search {
 public:
  Search(const std::shared_ptr<OrbitModel>& model, const SearchOptions& options)
      : model_(model), options_(options) {}

  OrbitSearch run(const OrbitGuess& guess) {
    if (attempt(guess) || rounds(guess.start)) return std::move(result_);
    FlowState marched = guess.start;
    const std::function<bool()> further[] = {[&] { return march(marched, options_.followed); },
                                             [&] { return shoot(guess.start); },
                                             [&] { return march(marched, options_.marched); }};
    for (const auto& follow : further) {
      try {
        if (follow()) break;
      } catch (const std::exception&) {  // FlowError: the time is up, or there is nothing to follow
      }
    }
    return std::move(result_);
  }

  // The first motion tried that touches nothing, if there is one.
  [[nodiscard]] const std::optional<OrbitGuess>& free() const { return free_; }

 private:
  // True if the search has come to its end: an orbit is found, contacts close that were taken for open, or
  // the time is up.
  bool attempt(const OrbitGuess& guess) {
    if (options_.expired()) return true;
    if (!free_ && !touches(guess)) free_ = guess;
    ExactOrbit orbit;
    // More is rattling that the flow does not resolve; the work of the dense equations grows with their cube.
    if (guess.events.size() <= kMostEvents) {
      PolishOptions polish = options_.polish;
      polish.expired = options_.expired;
      orbit = polish_sequence(model_, guess, polish);
    } else {
      orbit.reason = std::to_string(guess.events.size()) + " events in a period are more than a polish takes";
    }
    ++result_.attempts;
    result_.iterations += orbit.iterations;
    last_ = orbit.trajectory ? std::optional(orbit.trajectory->orbit().start) : std::nullopt;
    // Another sequence of the same contacts does not help where others close.
    const bool reached = !orbit.admissibility.reached.empty();
    const bool done = orbit.certified() || reached;
    // OrbitOutcome lists its values from an orbit to what tells least of one.
    if (result_.attempts == 1 || reached || orbit.outcome < result_.orbit.outcome)
      result_.orbit = std::move(orbit);
    return done;
  }

  [[nodiscard]] EventFlow modal_flow() const {
    return {model_->dynamics, 1e-11, options_.expired, Integrator::modal};
  }

  // Sequences met by the flow, each from the state that the last attempt left.
  bool rounds(const FlowState& from) {
    FlowState start = from;
    for (int round = 0; round < options_.rounds; ++round) {
      FlowState end;
      const auto sequence = simulated_sequence(*model_, start, options_.expired, &end);
      if (sequence && attempt(*sequence)) return true;
      if (sequence && last_) {
        start = *last_;
      } else if (end.state.u.size() > 0) {
        start = end;  // one period on: what the flow itself makes of the state
        start.time = from.time;
      } else {
        return false;
      }
    }
    return false;
  }

  // Newton's method on the stroboscopic map, where the sequence is free to change.
  bool shoot(const FlowState& from) {
    // Each event costs a product of 2 Nd x 2 Nd matrices for the derivative of the map, and each Newton step
    // several periods. Beyond so many coordinates that is worth it only where the caller has asked for the
    // last resort, marching, too.
    constexpr int kMany = 16;
    if (options_.shootings == 0 || (options_.marched == 0 && model_->dynamics.size() > kMany)) return false;
    EventFlow flow = modal_flow();
    PeriodMap map(flow);
    const auto order = static_cast<int>(model_->period / model_->dynamics.structure().forcing_period + 0.5);
    const FixedPoint orbit = find_fixed_point(
        map, flow.place(from.time, from.state), order,
        {.accepted = 1e-9, .max_iterations = options_.shootings, .max_halvings = 8, .largest_step = 1e3},
        options_.expired);
    result_.iterations += orbit.iterations;
    return rounds(orbit.start);
  }

  // Sequences met on the way to an attractor; `from` is left where the last burst ended.
  bool march(FlowState& from, int periods) {
    constexpr int kBurst = 8;  // periods between two attempts
    if (periods == 0) return false;
    EventFlow flow = modal_flow();
    const double section = from.time;
    FlowState state = flow.place(section, from.state);
    for (int marched = 0; marched < periods; marched += kBurst) {
      FlowRecord record;
      flow.advance(state, kBurst * model_->period, record);
      state.time = section;
      from = state;
      const auto sequence = simulated_sequence(*model_, from, options_.expired);
      if (sequence && attempt(*sequence)) return true;
    }
    return false;
  }

  std::shared_ptr<OrbitModel> model_;
  const SearchOptions& options_;
  OrbitSearch result_;
  std::optional<FlowState> last_;  // section state of the last equations solved
  std::optional<OrbitGuess> free_;
};

OrbitFinder::OrbitFinder(const Problem& problem) {
  const std::optional<Problem> held = with_idle_parts_held(problem);
  idle_parts_held_ = held.has_value();
  model_ = std::make_shared<OrbitModel>(held.value_or(problem));
}

OrbitFinder::OrbitFinder(const Problem& problem, CondensedStructure condensed,
                         std::shared_ptr<SharedModes> shared)
    : model_(std::make_shared<OrbitModel>(ContactDynamics(problem, std::move(condensed)), problem.period(),
                                          FlowForm::automatic, std::move(shared))) {}

OrbitSearch OrbitFinder::find(const OrbitGuess& guess, const SearchOptions& options) {
  const auto member = [&](const OrbitGuess& near) {
    return polish_free_member(model_, near, options.polish);
  };
  if (options.free_families == FreeFamilies::first)
    if (ExactOrbit found = member(guess); found.certified())
      return {.orbit = std::move(found), .attempts = 1};
  Search search(model_, options);
  OrbitSearch result = search.run(guess);
  if (idle_parts_held_ && result.orbit.certified())
    result.orbit.multipliers = {.undefined = "a free part that no contact meets may be anywhere"};
  if (result.orbit.certified() || options.free_families != FreeFamilies::last) return result;
  std::optional<OrbitGuess> free = search.free();
  if (!free && result.orbit.trajectory) free = untouched(result.orbit.trajectory->orbit());
  if (!free) return result;
  if (ExactOrbit found = member(*free); found.certified()) result.orbit = std::move(found);
  return result;
}

OrbitSearch OrbitFinder::find(const Trajectory& trajectory, const SearchOptions& options) {
  OrbitSearch result;
  try {
    if (const auto guess = orbit_guess(*model_, trajectory, options.expired)) return find(*guess, options);
    result.orbit.reason = "the structure has no unique response to the contact force";
  } catch (const std::runtime_error& error) {  // a flow that cannot be formed; the time is up
    result.orbit.reason = error.what();
  }
  return result;
}

}  // namespace signorini
