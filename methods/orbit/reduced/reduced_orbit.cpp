#include "methods/orbit/reduced/reduced_orbit.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "methods/discretisation/trajectories.hpp"
#include "methods/marching/periodic_march.hpp"
#include "methods/orbit/reduced/closing_orbit.hpp"
#include "methods/reduction/reduced_problem.hpp"
#include "methods/structure/periodic_response.hpp"
#include "problems/matrix_properties.hpp"

namespace signorini {

namespace {

constexpr const char* kHarmonicBalance = "harmonic balance";

/// On the vectors that a space solves on, or on those that the force of the motion needs.
ReducedOrbit orbit_near(const Problem& problem, const ContactSpace& given, const Trajectory& motion,
                        const OrbitCorrectionSettings& settings, bool chosen) {
  constexpr int kInstants = 512;
  const int order = problem.subharmonic;
  const double base = problem.base_frequency();
  const Eigen::MatrixXcd force = force_spectrum(motion, settings.shifted * order);
  const double left =
      settings.left_by_solved * settings.tolerance * size_about_mean(motion.sample(kInstants * order).x);
  std::optional<ContactSpace> own;
  if (chosen) own = given.solved_for(base, force, left);
  const ContactSpace& space = own ? *own : given;
  // What the vectors miss of the response to this force is added from the start: without it the motion is
  // none of theirs, and contacts that touch briefly would come and go in another order.
  Eigen::MatrixXcd added = space.missing(base, force);
  added.conservativeResize(harmonics_to_add(added, left, order, settings), Eigen::NoChange);
  ReducedOrbit result{.corrected = {}, .start = "the motion given"};
  result.corrected.solved = space.small().vectors();
  std::vector<int> closing = pushing_contacts(motion);
  OrbitSearch found =
      find_closing_orbit(problem, displaced(space.small(), added, base), closing, motion, settings.search);
  result.iterations = found.iterations;
  result.corrected.orbit = std::move(found.orbit);
  if (!result.corrected.orbit.certified()) return result;
  result.corrected =
      correct_orbit(problem, space, std::move(result.corrected.orbit), settings, std::move(added));
  result.iterations += result.corrected.iterations;
  return result;
}

}  // namespace

std::string reduction_obstacle(const Problem& problem) {
  if (problem.contacts.empty()) return "there is no contact whose motion it would be";
  if (std::string obstacle = march_obstacle(problem); !obstacle.empty()) return obstacle;
  const auto damping = proportional_damping(*problem.structure);
  if (!damping) return "the damping is not proportional to mass and stiffness";
  if (damping->beta > 0.0 && std::holds_alternative<MixedLaws>(problem.law())) return kMixedRelaxing;
  return {};
}

bool prefers_reduction(const Problem& problem) {
  constexpr int kManySprings = 10, kMostSprung = 100;
  const bool sprung = std::holds_alternative<Penalty>(problem.law()) &&
                      problem.contact_count() >= kManySprings && problem.size() > kMostSprung;
  return (sprung || problem.size() > kMostInDenseFlow) && reduction_obstacle(problem).empty();
}

std::string ReducedOrbit::reason() const {
  const ExactOrbit& orbit = corrected.orbit;
  return corrected.refusal.empty() ? describe(orbit.outcome) + ", " + orbit.reason : corrected.refusal;
}

ReducedOrbit find_reduced_orbit(const Problem& problem, const ContactSpace& space,
                                const OrbitCorrectionSettings& settings, const OtherStart& harmonic_balance) {
  constexpr std::array kFiner{1, 4, 16};  // grids than the first
  OrbitCorrectionSettings quick = settings;
  quick.search.rounds = 1;
  quick.search.shootings = quick.search.marched = 0;
  ReducedOrbit result;
  FailedAttempts failed;
  long iterations = 0;
  // True if the search has come to its end.
  const auto attempt = [&](const std::string& name, const std::string& start, const Trajectory& motion,
                           const OrbitCorrectionSettings& effort) {
    result = polish_reduced_orbit(problem, space, motion, effort);
    result.start = start;
    iterations += result.iterations;
    if (result.corrected.bar) return true;
    failed.note(name, result.reason());
    return settings.search.expired();
  };
  bool done = false;
  if (harmonic_balance) {
    const Solution series = harmonic_balance();
    if (series.verdict == Verdict::converged)
      done = attempt(kHarmonicBalance, kHarmonicBalance, *series.trajectory, quick);
    else
      failed.note(kHarmonicBalance, series.message);
  }
  PeriodicMarch marched;
  for (const int factor : kFiner) {
    if (done) break;
    const int nodes = factor * kMarchedPerPeriod * problem.subharmonic;
    ContactMarch march(space.small(), march_grid(problem, nodes));
    marched = factor == 1 ? march_to_periodic_motion(march) : march_from(march, marched.state);
    iterations += marched.newton_steps;
    const NodalTrajectory motion(problem.period(), std::move(marched.motion), std::move(marched.force));
    done = attempt(fmt::format("N = {}", nodes), "marching, " + std::string(describe(marched.by)), motion,
                   factor == kFiner.back() ? settings : quick);
  }
  result.iterations = iterations;
  result.failed = std::move(failed);
  return result;
}

ReducedOrbit polish_reduced_orbit(const Problem& problem, const ContactSpace& space, const Trajectory& motion,
                                  const OrbitCorrectionSettings& settings) {
  return orbit_near(problem, space, motion, settings, !space.small_is_given());
}

ReducedOrbit continue_reduced_orbit(const Problem& problem, const ContactSpace& space,
                                    const Trajectory& motion, const OrbitCorrectionSettings& settings) {
  return orbit_near(problem, space, motion, settings, false);
}

}  // namespace signorini
