// Branches of exact orbits by arc length beside steps of the frequency, in one run: processor time of a
// response with its stability, what the search for its beginnings costs, how many points are unstable or
// beyond a fold, where steps do not come; and how the time of a point grows with coordinates and events.
// Figures of a Release build on a quiet machine are the only ones that count; run as
// `build/release/tests/branch_benchmark [SCENE...]`.

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "harness/plan/plan.hpp"
#include "harness/sweep/branch_response.hpp"
#include "methods/continuation/arc_length.hpp"
#include "methods/orbit/continuation/curve.hpp"
#include "methods/orbit/family/extended_equations.hpp"
#include "methods/orbit/starts/one_impact_orbits.hpp"
#include "problems/assembly/chain.hpp"

namespace signorini {
namespace {

// Of this process and those that it has waited for.
double processor_seconds() {
  double sum = 0.0;
  for (const int whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(whose, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime})
      sum += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return sum;
}

template <class Work>
double seconds_of(const Work& work) {
  const double before = processor_seconds();
  work();
  return processor_seconds() - before;
}

struct Response {
  const char* scene;
  double from, to;
  int branches;
};

void by_arc_length(const Response& response, const ParametrisedScene& scene) {
  const MethodChoice exact{.entry = &exact_method()};
  BranchDiagram diagram;
  const double all =
      seconds_of([&] { diagram = branches_of(scene, exact, {.max_branches = response.branches}).value(); });
  // No branch at all: what is left is the search for their beginnings.
  const double search = seconds_of([&] { (void)branches_of(scene, exact, {.max_branches = 0}); });
  long points = 0, unstable = 0;
  for (const Branch& branch : diagram.branches) {
    points += static_cast<long>(branch.points.size());
    unstable += std::count_if(branch.points.begin(), branch.points.end(), [](const SolutionPoint& point) {
      return point.stability != OrbitStability::stable;
    });
  }
  const double along = all - search;
  std::printf(
      "%-20s by arc length %5ld points on %3zu branches, %5ld not stable, %8.3f s, of 200 points %8.3f s, "
      "%6.0f points/s; to find their beginnings %8.3f s\n",
      response.scene, points, diagram.branches.size(), unstable, along,
      200.0 * along / static_cast<double>(points), static_cast<double>(points) / along, search);
}

void by_steps(const Response& response, const Scene& scene) {
  constexpr int kSteps = 200;
  std::vector<SweepPoint> steps;
  const double time = seconds_of([&] {
    steps = frequency_response(scene, {&exact_method(), {}},
                               {.from = response.from, .to = response.to, .points = kSteps},
                               {.timeout = 30.0, .certified = true});
  });
  const auto solved = std::count_if(
      steps.begin(), steps.end(), [](const SweepPoint& point) { return point.status == Status::converged; });
  std::printf("%-20s by steps      %5ld of %d points, %39s %8.3f s, %26s %6.0f points/s\n", "",
              static_cast<long>(solved), kSteps, "", time, "", static_cast<double>(solved) / time);
}

void measure(const Response& response) {
  const Scene scene = read_scene(find_scene(response.scene));
  by_arc_length(response, over_frequency(scene.problem, response.from, response.to));
  by_steps(response, scene);
}

// Milliseconds of a point of the orbits of one impact of a chain, passed `times` times a period; the points
// of one branch, of which there are some hundred.
double time_of_point(int masses, int times) {
  Chain chain;
  for (int i = 0; i < masses; ++i) {
    chain.masses.push_back(1.0);
    chain.springs.push_back(1.0);
    chain.dampers.push_back(0.05);
  }
  Problem problem;
  problem.structure = std::make_shared<const Structure>(assemble(chain));
  problem.frequency = 2.2;
  problem.force = {{.dof = masses - 1, .harmonic = 1, .cos = 1.0}};
  problem.contacts = {{.normal = {{masses - 1, 1.0}}, .gap = 0.2}};
  problem.set_law(Restitution{0.8});
  OrbitFamily family(over_frequency(problem, 1.0, 3.0));
  double time = 0.0;
  std::size_t points = 0;
  for (const SequencedOrbit& one : one_impact_orbits(family, 2.2, 0, 1)) {
    const SequencedOrbit orbit = repeated(one, times);
    ExtendedEquations equations(family, orbit);
    if (!equations.evaluate(orbit.x)) continue;
    const Eigen::VectorXd tangent = first_tangent(equations);
    time += seconds_of([&] {
      for (const double sign : {1.0, -1.0})
        points += trace_curve(family, {.orbit = orbit, .tangent = sign * tangent, .origin = "here"},
                              {.max_points = 100, .step_share = 0.02 / kOrbitSteps.longest})
                      .branch.points.size();
    });
  }
  return points == 0 ? 0.0 : 1e3 * time / static_cast<double>(points);
}

void growth() {
  std::printf("time of a point with its multipliers and guards\n");
  for (const int masses : {1, 2, 4, 8, 16, 32})
    std::printf("  %3d coordinates, 1 impact   %8.3f ms\n", masses, time_of_point(masses, 1));
  for (const int times : {1, 3, 9, 27})  // odd: an even period is compared with its half
    std::printf("    1 coordinate,  %2d impacts %8.3f ms\n", times, time_of_point(1, times));
}

}  // namespace
}  // namespace signorini

// Of the scenes named, or of all, and then how the time of a point grows.
int main(int count, char** words) {
  const std::vector<std::string> named(words + 1, words + count);
  for (const signorini::Response& response :
       {signorini::Response{"sdof-stop", 1.5, 4.5, 60}, signorini::Response{"sdof-stop-e05", 1.5, 4.5, 60},
        signorini::Response{"sdof-penalty-stiff", 0.6, 2.0, 60},
        signorini::Response{"chain3-massless", 0.7, 2.0, 20},
        signorini::Response{"chain10-stop", 0.2, 0.4, 6},
        signorini::Response{"beam20-three-stops", 3.5, 5.5, 6}}) {
    if (named.empty() || std::find(named.begin(), named.end(), response.scene) != named.end())
      signorini::measure(response);
  }
  if (named.empty()) signorini::growth();
}
