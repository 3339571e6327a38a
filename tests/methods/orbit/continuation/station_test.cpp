// Dips of guards between two points of a branch: a stop is put where both points clear it and the motions
// between them do not.

#include "methods/orbit/continuation/station.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <random>

#include "methods/orbit/continuation/branch_section.hpp"
#include "methods/orbit/continuation/curve.hpp"
#include "problems/assembly/chain.hpp"
#include "tests/methods/orbit/continuation/diagrams.hpp"

namespace signorini::station_test {
namespace {

// A chain of two or three masses with three harmonics of load; a rigid stop or a spring on its last mass, and
// one far away on its first.
Problem watched_chain(std::mt19937& random, int number) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Chain chain;
  const int masses = 2 + number % 2;
  for (int i = 0; i < masses; ++i) {
    chain.masses.push_back(0.5 + share(random));
    chain.springs.push_back(0.8 + 1.6 * share(random));
    chain.dampers.push_back(0.05 + 0.1 * share(random));
  }
  Problem problem;
  problem.structure = std::make_shared<const Structure>(assemble(chain));
  for (int harmonic = 1; harmonic <= 3; ++harmonic)
    problem.force.push_back({.dof = masses - 1,
                             .harmonic = harmonic,
                             .cos = 1.0 / (harmonic * harmonic),
                             .sin = share(random) - 0.5});
  problem.contacts = {{.normal = {{masses - 1, 1.0}}, .gap = 0.1 + share(random)},
                      {.normal = {{0, number % 4 < 2 ? 1.0 : -1.0}}, .gap = 1e3}};
  if (number % 3 == 2)
    problem.set_law(Penalty{.stiffness = {30.0, 30.0}});
  else
    problem.set_law(Restitution{0.3 + 0.7 * share(random)});
  return problem;
}

// From the second point of a branch towards the third.
TracedCurve traced(OrbitFamily& family, const OrbitBranch& branch) {
  const SequencedOrbit first = orbit_of(family, branch, 1), second = orbit_of(family, branch, 2);
  ExtendedEquations equations(family, first);
  if (first.x.size() != second.x.size() || !equations.evaluate(first.x))
    return {.branch = {}, .rejected = "not the same"};
  Eigen::VectorXd tangent = first_tangent(equations);
  if (tangent.dot(second.x - first.x) < 0.0) tangent = -tangent;
  return trace_curve(family, {.orbit = first, .tangent = tangent, .origin = "here"}, {.max_points = 60});
}

// The largest displacement of the watched contact on a step of length h beyond a point, and its share of the
// step, by bisection of nothing but samples.
struct Peak {
  double height = -1e300;
  double parameter = 0.0;
};
Peak peak_after(OrbitFamily& family, const OrbitBranch& branch, std::size_t i) {
  constexpr int kSamples = 32;
  const SequencedOrbit first = orbit_of(family, branch, i), second = orbit_of(family, branch, i + 1);
  Peak peak;
  if (first.x.size() != second.x.size() || first.section != second.section) return peak;
  const Eigen::VectorXd chord = second.x - first.x;
  ExtendedEquations equations(family, first);
  for (int k = 1; k < kSamples; ++k) {
    if (!correct(equations, first.x + k / double{kSamples} * chord, chord.normalized())) continue;
    const double height = survey(equations).highest[1];
    if (height > peak.height) peak = {.height = height, .parameter = equations.parameter()};
  }
  return peak;
}

// At each point of a branch where the watched contact comes nearest, its stop is put just beyond: the branch
// must end there.
TEST(HiddenViolation, IsFoundWhereverAStopLiesBetweenThePeaksOfThePointsAndThatBetweenThem) {
  constexpr double kFrom = 0.5, kTo = 2.5;
  std::mt19937 random(20261124);
  int hidden = 0, found = 0;
  for (int number = 0; number < 24; ++number) {
    Problem problem = watched_chain(random, number);
    problem.frequency = kFrom;
    OrbitFamily far(over_frequency(problem, kFrom, kTo),
                    {.displacement = 1.0, .velocity = 1.5, .parameter = (kTo - kFrom) / 3.0});
    const OrbitDiagram diagram =
        trace_diagram(far, {contact_free_orbit(far, kTo).value()}, {.max_branches = 4, .max_points = 60});
    for (const OrbitBranch& branch : diagram.branches) {
      if (branch.points.size() < 4) continue;
      const TracedCurve open = traced(far, branch);
      const std::vector<SolutionPoint>& points = open.branch.points;
      for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const double here = std::max(points[i].x_max[1], points[i + 1].x_max[1]);
        const Peak peak = peak_after(far, open.branch, i);
        const bool cleared_before = std::all_of(points.begin(), points.begin() + static_cast<long>(i),
                                                [&](const auto& point) { return point.x_max[1] < here; });
        if (peak.height < here + 1e-8 || !cleared_before) continue;
        problem.contacts[1].gap = here + 1e-3 * (peak.height - here);
        OrbitFamily near(over_frequency(problem, kFrom, kTo), far.units());
        const TracedCurve stopped = traced(near, branch);
        ++hidden;
        const bool ends =
            stopped.guard && stopped.guard->kind == GuardKind::clearance && stopped.guard->index == 1;
        const double low = std::min(points[i].parameter, points[i + 1].parameter);
        const double high = std::max(points[i].parameter, points[i + 1].parameter);
        const double end = stopped.branch.points.back().parameter;
        if (ends && end >= low - 1e-6 && end <= high + 1e-6)
          ++found;
        else
          ADD_FAILURE() << fmt::format("scene {}, {}: {:.1e} past the stop at {:.9g}, {} at {:.9g}", number,
                                       branch.sequence, peak.height - problem.contacts[1].gap, peak.parameter,
                                       stopped.branch.ended, end);
      }
    }
  }
  fmt::print("{} dips between two points, {} found\n", hidden, found);
  EXPECT_GE(hidden, 30);
}

}  // namespace
}  // namespace signorini::station_test
