#include "harness/orbits/orbit_search.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "harness/interrupt.hpp"
#include "harness/isolation/isolation.hpp"
#include "harness/judge/exact_certificate.hpp"
#include "harness/judge/orbit.hpp"
#include "harness/orbits/listed_motion.hpp"
#include "harness/records/json_fields.hpp"
#include "harness/records/record.hpp"
#include "harness/text/json.hpp"
#include "methods/orbit/reduced/reduced_orbit.hpp"
#include "methods/structure/bases/condensation.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kSearchProcesses = 2;
/// Instants per forcing period on which orbits are compared; exact orbits need no more.
constexpr int kCompared = 512;

/// The events of the first `period` of an orbit that repeats after it.
OrbitGuess first_period(OrbitGuess orbit, double period) {
  const double end = orbit.start.time + period;
  std::erase_if(orbit.events, [end](const SequenceEvent& event) { return event.time >= end; });
  return orbit;
}

/// A motion without the place of what it does not touch. Of a family of motions in which free parts may be
/// anywhere one is told: those that agree in all else differ by a motion that no force holds in its place.
/// What moves less than rounding of its place and its gap is at rest.
Motion without_place(Motion motion, const Problem& problem) {
  constexpr double kRounding = 1e-12;  // of the place, or the gap
  std::vector<bool> touched(static_cast<std::size_t>(motion.samples.x.cols()), false);
  for (const Impulse& impulse : motion.impulses) touched[static_cast<std::size_t>(impulse.contact)] = true;
  for (Eigen::Index j = 0; j < motion.samples.x.cols(); ++j) {
    if (touched[static_cast<std::size_t>(j)] || !motion.samples.force.col(j).isZero(0.0)) continue;
    auto x = motion.samples.x.col(j);
    const double gap = std::abs(problem.contacts[static_cast<std::size_t>(j)].gap);
    const double rest = kRounding * std::max(gap, x.cwiseAbs().maxCoeff());
    x.array() -= x.mean();
    if (x.cwiseAbs().maxCoeff() <= rest) x.setZero();
  }
  return motion;
}

class OrbitCollection {
 public:
  OrbitCollection(const Problem& problem, const OrbitPolisher& polish, Deadline deadline)
      : problem_(problem), polish_(polish ? polish : exact_orbits()), deadline_(deadline) {}

  void add(const OrbitCandidate& candidate) {
    ++result.searches;
    if (!candidate.orbit) {
      ++result.failures[candidate.reason];
      return;
    }
    const OrbitSearch search = solve(*candidate.orbit, candidate.order);
    if (!search.orbit.certified()) {
      ++result.failures[describe(search.orbit.outcome)];
      return;
    }
    const Motion motion = compared(*search.orbit.trajectory);
    for (std::size_t i = 0; i < motions_.size(); ++i)
      if (same_orbit(motion, motions_[i])) return credit(result.orbits[i], candidate);
    for (const auto& [refused, reason] : refused_) {
      if (!same_orbit(motion, refused)) continue;
      ++result.failures[reason];
      return;
    }
    take_new(search, motion, candidate);
  }

  /// The orbit of a large structure that is reached from rest, corrected; its polish has certified it.
  void add_large(CertifiedOrbit checked) {
    ++result.searches;
    if (!checked.motion) {
      ++result.failures[checked.reason];
      return;
    }
    keep(problem_.subharmonic, std::move(checked), {.origin = OrbitCandidate::Origin::rest});
  }

  SceneOrbits result;

 private:
  [[nodiscard]] Motion compared(const Trajectory& orbit) const {
    return without_place(sample_motion(problem_, orbit, kCompared), problem_);
  }

  OrbitSearch solve(const OrbitGuess& guess, int order) {
    std::unique_ptr<OrbitFinder>& finder = finders_[order];
    if (!finder) finder = std::make_unique<OrbitFinder>(with_subharmonic(problem_, order));
    SearchOptions options;
    options.rounds = 0;
    options.shootings = 0;
    options.free_families = FreeFamilies::first;
    return finder->find(guess, options);
  }

  void take_new(const OrbitSearch& search, const Motion& motion, const OrbitCandidate& candidate) {
    const int order = least_order(motion);
    OrbitSearch least = search;
    if (order < candidate.order) {
      const double period = order * motion.forcing_period;
      least = solve(first_period(search.orbit.trajectory->orbit(), period), order);
    }
    CertifiedOrbit checked{.reason = "the orbit does not close after its least period"};
    if (least.orbit.certified()) {
      checked = polish_(with_subharmonic(problem_, order), *least.orbit.trajectory, {}, deadline_);
    }
    if (!checked.motion) {
      ++result.failures[checked.reason];
      refused_.emplace_back(motion, checked.reason);
      return;
    }
    keep(order, std::move(checked), candidate);
  }

  void keep(int order, CertifiedOrbit checked, const OrbitCandidate& candidate) {
    FoundOrbit found = describe_orbit(problem_, order, std::move(checked));
    motions_.push_back(compared(*found.certified.motion));
    credit(found, candidate);
    result.orbits.push_back(std::move(found));
  }

  static void credit(FoundOrbit& orbit, const OrbitCandidate& candidate) {
    ++orbit.starts;
    if (candidate.origin == OrbitCandidate::Origin::rest) orbit.from_rest = true;
    if (candidate.origin == OrbitCandidate::Origin::method && candidate.near &&
        std::ranges::count(orbit.cold, candidate.source) == 0)
      orbit.cold.push_back(candidate.source);
  }

  const Problem& problem_;
  OrbitPolisher polish_;
  Deadline deadline_;
  std::map<int, std::unique_ptr<OrbitFinder>> finders_;
  std::vector<Motion> motions_;  // of result.orbits
  std::vector<std::pair<Motion, std::string>> refused_;
};

/// Runs the units side by side and takes in what they found, in their order.
void run_units(const std::vector<CandidateUnit>& units, Deadline deadline, OrbitCollection& collection) {
  std::vector<IsolatedWork> work;
  for (const CandidateUnit& unit : units) {
    work.push_back([&unit, deadline](const LineSender& send) {
      // As many work beside it.
      const Deadline own = Deadline::first_of(deadline, Deadline::after(deadline.left() / kSearchProcesses));
      unit.work([&send](const OrbitCandidate& candidate) { send(json_line(to_json(candidate))); }, own);
    });
  }
  // Longer than any single search may take: only what hangs is ended by it.
  const std::vector<ChildEnd> ends =
      run_isolated_together(work, {.stage_seconds = {15.0}, .memory_mb = 2048}, kSearchProcesses);
  for (std::size_t i = 0; i < units.size(); ++i) {
    for (const std::string& line : ends[i].lines) collection.add(orbit_candidate_from_json(parse_json(line)));
    if (ends[i].kind != ChildEnd::Kind::finished && ends[i].kind != ChildEnd::Kind::interrupted)
      collection.result.losses[describe(ends[i])].push_back(units[i].name);
  }
}

}  // namespace

FoundOrbit describe_orbit(const Problem& problem, int order, CertifiedOrbit checked) {
  const Motion whole = sample_motion(problem, *checked.motion);
  return {.certified = std::move(checked),
          .fingerprint = fingerprint(whole),
          .order = order,
          .period = whole.period(),
          .amplitude = amplitude(whole)};
}

void sort_orbits(std::vector<FoundOrbit>& orbits) {
  const auto rank = [](const FoundOrbit& orbit) {
    return std::tuple(orbit.order, !orbit.certified.stable.value_or(false), -orbit.amplitude);
  };
  std::ranges::stable_sort(orbits, {}, rank);
}

int default_subharmonics(const Problem& problem) {
  return std::max(OrbitSearchOptions{}.subharmonics, problem.subharmonic);
}

int FoundOrbit::impacts() const {
  return static_cast<int>(
      std::ranges::count(certified.events, ContactEvent::Kind::impact, &OrbitEvent::kind));
}

int FoundOrbit::contact_phases() const {
  return static_cast<int>(std::ranges::count(certified.events, ContactEvent::Kind::open, &OrbitEvent::kind));
}

std::optional<double> FoundOrbit::largest_multiplier() const {
  if (!certified.floquet || certified.floquet->empty()) return std::nullopt;
  double largest = 0.0;
  for (const auto& [re, im] : *certified.floquet) largest = std::max(largest, std::hypot(re, im));
  return largest;
}

SceneOrbits find_all_orbits(const Problem& problem, const OrbitSearchOptions& options,
                            const OrbitPolisher& polish) {
  const Deadline deadline = Deadline::after(options.timeout, kSearchProcesses);
  OrbitCollection collection(problem, polish, deadline);
  if (prefers_reduction(problem)) collection.add_large(reduced_orbits()(problem, deadline));
  if (problem.size() > kMostInTime) {
    if (collection.result.orbits.empty()) collection.result.failures[flow_obstacle(problem)] = 1;
    return std::move(collection.result);
  }
  for (int order = 1; order <= options.subharmonics; ++order) {
    if (interrupted() || deadline.passed()) break;
    run_units(candidate_units(problem, order, options.starts, options.seed), deadline, collection);
  }
  collection.result.interrupted = interrupted();
  collection.result.expired = deadline.passed();
  sort_orbits(collection.result.orbits);
  return std::move(collection.result);
}

std::optional<FoundOrbit> certify_again(const Problem& problem, const FoundOrbit& kept, Deadline deadline,
                                        const OrbitPolisher& polish, std::span<const Certificate> confirmed) {
  const Problem at_order = with_subharmonic(problem, kept.order);
  const OrbitPolisher certify = polish ? polish : exact_orbits();
  const ListedMotion listed(at_order.period(), contact_events(kept.certified.events),
                            std::vector<bool>(problem.contacts.size(), false));
  CertifiedOrbit checked = certify(at_order, listed, confirmed, deadline);
  if (!checked.motion) return std::nullopt;
  FoundOrbit found = describe_orbit(problem, kept.order, std::move(checked));
  found.from_rest = kept.from_rest;  // not asked here
  return found;
}

}  // namespace signorini
