// Branches of exact orbits by arc length beside steps of the frequency, in one run: points a second with
// their stability, and how many of them are unstable or beyond a fold, where steps do not come. Figures of a
// Release build on a quiet machine are the only ones that count; run as
// `build/release/tests/branch_benchmark`.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include "harness/plan/plan.hpp"
#include "harness/sweep/branch_response.hpp"

namespace signorini {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::time_point from) { return std::chrono::duration<double>(Clock::now() - from).count(); }

struct Response {
  const char* scene;
  double from, to;
  int branches;
};

void measure(const Response& response) {
  const Scene scene = read_scene(find_scene(response.scene));
  auto start = Clock::now();
  const BranchDiagram diagram = exact_branches(over_frequency(scene.problem, response.from, response.to),
                                               {.max_branches = response.branches, .timeout = 300.0});
  const double along = seconds(start);
  long points = 0, unstable = 0;
  for (const Branch& branch : diagram.branches) {
    points += static_cast<long>(branch.points.size());
    unstable += std::count_if(branch.points.begin(), branch.points.end(), [](const BranchPoint& point) {
      return point.stability != OrbitStability::stable;
    });
  }
  std::printf("%-20s by arc length %5ld points on %3zu branches, %5ld not stable, %8.3f s, %7.0f points/s\n",
              response.scene, points, diagram.branches.size(), unstable, along,
              static_cast<double>(points) / along);
  const int steps = static_cast<int>(std::clamp(points, 20L, 100L));
  start = Clock::now();
  const auto natural = frequency_response(scene, {&find_method(kFollowedByArcLength), {}},
                                          {.from = response.from, .to = response.to, .points = steps},
                                          {.timeout = 30.0, .certified = true});
  const double stepped = seconds(start);
  const auto solved = std::count_if(natural.begin(), natural.end(), [](const SweepPoint& point) {
    return point.status == Status::converged;
  });
  std::printf("%-20s by steps      %5ld of %d points, %8.3f s, %7.0f points/s\n", "",
              static_cast<long>(solved), steps, stepped, static_cast<double>(solved) / stepped);
}

}  // namespace
}  // namespace signorini

int main() {
  for (const signorini::Response& response :
       {signorini::Response{"sdof-stop", 1.5, 4.5, 60}, signorini::Response{"sdof-stop-e05", 1.5, 4.5, 60},
        signorini::Response{"sdof-penalty-stiff", 0.6, 2.0, 60},
        signorini::Response{"chain3-massless", 0.7, 2.0, 20},
        signorini::Response{"chain10-stop", 0.2, 0.4, 6},
        signorini::Response{"beam20-three-stops", 3.5, 5.5, 6}})
    signorini::measure(response);
}
