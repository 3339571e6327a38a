#include "methods/harmonic_balance/frequency_continuation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "methods/complementarity/forms.hpp"
#include "methods/harmonic_balance/series_solution.hpp"
#include "methods/solvers/homotopy.hpp"
#include "methods/structure/dynamic_stiffness.hpp"

namespace signorini {

namespace {

constexpr double kSearchRatio = 1.1;
constexpr int kSearchSteps = 32;
// Of the way from frequency to frequency.
constexpr PathSteps kFrequencySteps{
    .first = 1.0 / 16.0, .largest = 1.0 / 16.0, .smallest = 1.0 / 4096.0, .trials = 200};

bool nothing_touches(const Problem& problem, int samples) {
  try {
    // x_f has no harmonics but those of the load.
    const ContactReceptance receptance = fourier_receptance(problem, load_bandwidth(problem));
    const Eigen::VectorXd unit = Eigen::VectorXd::Ones(problem.contact_count());
    return free_penetration(receptance.free_response, contact_gaps(problem), unit, samples).maxCoeff() < 0.0;
  } catch (const SingularStiffness&) {
    return false;  // at a resonance without damping
  }
}

/// The point of a path that was solved last, and how the trial after it ended.
struct PathEnd {
  double share = 0.0;  // of the way, 1 at the scene's own frequency
  int points = 0;
  Eigen::MatrixXcd lambda;  // (H+1) x Nc [N]
  std::string last_failure = "limit on time or steps";
};

/// Solves the equations at a frequency from the forces at another one.
GridSolution solve_at(const HarmonicSetup& setup, double frequency, const Eigen::MatrixXcd& lambda,
                      const Start& budget, Work& work) {
  const Problem problem = at_frequency(*setup.problem, frequency);
  const int harmonics = setup.receptance.harmonics();
  try {
    const ContactReceptance receptance = fourier_receptance(problem, harmonics);
    const ProjectedLaw law = setup.method.law_at(receptance);
    return setup.method.grid_solver({receptance, setup.gap, law},
                                    setup.options.fixed_samples(harmonics).value(), lambda, budget, work);
  } catch (const SingularStiffness& error) {
    return {.message = error.what()};
  }
}

double frequency_on(double from, double to, double share) { return from + share * (to - from); }

PathEnd follow(const HarmonicSetup& setup, double from, const Start& budget, Work& work) {
  const double to = setup.problem->frequency;
  PathEnd end{.share = from == to ? 1.0 : 0.0,  // lambda = 0 solves the scene itself
              .lambda = Eigen::MatrixXcd::Zero(setup.receptance.harmonics() + 1, setup.gap.size())};
  const auto advance = [&](double step) {
    const double share = std::min(1.0, end.share + step);
    GridSolution point = solve_at(setup, frequency_on(from, to, share), end.lambda, budget, work);
    if (point.solved) {
      end.share = share;
      end.lambda = std::move(point.lambda);
      ++end.points;
    } else {
      end.last_failure = std::move(point.message);
    }
    return point.solved;
  };
  follow_path(
      kFrequencySteps, advance, [&] { return end.share >= 1.0; },
      [&] { return budget.expired() || is_spent(setup.options.max_iterations, work); });
  return end;
}

}  // namespace

std::vector<double> contact_free_frequencies(const Problem& problem, int samples, const Start& budget) {
  if (nothing_touches(problem, samples)) return {problem.frequency};
  std::vector<double> found;
  for (const double ratio : {1.0 / kSearchRatio, kSearchRatio}) {
    double frequency = problem.frequency;
    for (int k = 0; k < kSearchSteps && !budget.expired(); ++k) {
      frequency *= ratio;
      if (!nothing_touches(at_frequency(problem, frequency), samples)) continue;
      found.push_back(frequency);
      break;
    }
  }
  std::ranges::sort(found, {},
                    [&](double frequency) { return std::abs(std::log(frequency / problem.frequency)); });
  return found;
}

Solution continue_in_frequency(const HarmonicSetup& setup, const Start& start, Work& work) {
  const Problem& problem = *setup.problem;
  const int samples = setup.options.fixed_samples(setup.receptance.harmonics()).value();
  std::string ends;
  for (const double from : contact_free_frequencies(problem, samples, start)) {
    const PathEnd end = follow(setup, from, start, work);
    if (end.share < 1.0) {
      ends += fmt::format("{}from {:.4g} to {:.4g} rad/s, where it ends: {}", ends.empty() ? "" : "; ", from,
                          frequency_on(from, problem.frequency, end.share), end.last_failure);
      continue;
    }
    Solution solution = solve_on_grids(setup, start, work, end.lambda);
    solution.message =
        fmt::format("{} steps in frequency from {:.4g} rad/s, {}", end.points, from, solution.message);
    return solution;
  }
  if (ends.empty()) {
    const double widest = std::pow(kSearchRatio, kSearchSteps);
    ends = fmt::format("no frequency found from {:.3g} to {:.3g} rad/s at which nothing touches",
                       problem.frequency / widest, problem.frequency * widest);
  }
  return {.message = "continuation in frequency: " + ends};
}

}  // namespace signorini
