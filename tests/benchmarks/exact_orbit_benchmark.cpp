// Cold solves of exact-orbit beside event-driven marching on the same scenes, in one run. Figures of a
// Release build on a quiet machine are the only ones that count; run as
// `build/release/tests/exact_orbit_benchmark`.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "methods/event_driven/event_driven.hpp"
#include "methods/exact_orbit/exact_orbit_method.hpp"
#include "methods/linear_flow/linear_flow.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/population.hpp"

namespace signorini {
namespace {

using Clock = std::chrono::steady_clock;

double microseconds(Clock::time_point from) {
  return std::chrono::duration<double, std::micro>(Clock::now() - from).count();
}

/// Fastest of some set-ups and solves from cold [us]; `solution` receives the last.
template <class M>
double time_cold(const Problem& problem, const typename M::Options& options, int repetitions,
                 Solution& solution) {
  const M method(options);
  double best = 1e300;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = Clock::now();
    solution = method.prepare(problem)->solve({});
    best = std::min(best, microseconds(start));
  }
  return best;
}

struct Column {
  std::string name;
  std::vector<double> times;
  int solved = 0;

  void add(double time, const Solution& solution) {
    if (solution.verdict != Verdict::converged) return;
    ++solved;
    times.push_back(time);
  }
  void print(std::size_t scenes) {
    std::sort(times.begin(), times.end());
    if (times.empty()) return;
    std::printf("  %-34s %3d of %zu solved, median %9.1f us, 90 %% %9.1f us, worst %9.1f us\n", name.c_str(),
                solved, scenes, times[times.size() / 2], times[times.size() * 9 / 10], times.back());
  }
};

/// One-mass scenes of one damping ratio: m = k = F = 1, restitutions 0.3, 0.5, 0.8 and 1.
std::vector<Problem> scenes_of(double ratio) {
  constexpr double kRestitutions[] = {0.3, 0.5, 0.8, 1.0};
  std::vector<Problem> scenes;
  for (test::ImpactOscillator& oscillator : test::contact_population(100)) {
    oscillator.damping = 2.0 * ratio;
    oscillator.restitution = kRestitutions[scenes.size() % 4];
    scenes.push_back(test::to_problem(oscillator));
  }
  return scenes;
}

void compare(double ratio) {
  const std::vector<Problem> scenes = scenes_of(ratio);
  Column exact{.name = "exact-orbit", .times = {}},
      modal{.name = "event-driven[flow=modal] 1e-11", .times = {}},
      cvode{.name = "event-driven[flow=cvode] 1e-6", .times = {}};
  std::vector<double> ratios;
  for (const Problem& problem : scenes) {
    Solution a, b, c;
    const double t_exact = time_cold<ExactOrbitMethod>(problem, {}, 5, a);
    const double t_modal = time_cold<EventDriven>(
        problem, {.tolerance = 1e-12, .flow = Integrator::modal, .max_iterations = 2000}, 1, b);
    const double t_cvode = time_cold<EventDriven>(problem, {.tolerance = 1e-6, .max_iterations = 2000}, 1, c);
    exact.add(t_exact, a);
    modal.add(t_modal, b);
    cvode.add(t_cvode, c);
    if (a.verdict == Verdict::converged && b.verdict == Verdict::converged)
      ratios.push_back(t_modal / t_exact);
  }
  std::printf("damping ratio %g\n", ratio);
  exact.print(scenes.size());
  modal.print(scenes.size());
  cvode.print(scenes.size());
  std::sort(ratios.begin(), ratios.end());
  if (!ratios.empty())
    std::printf("  modal marching over exact-orbit, where both solve: median %.1f\n",
                ratios[ratios.size() / 2]);
}

void evaluation() {
  constexpr int kTimes = 1000000;
  const Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  const ContactDynamics dynamics(problem);
  LinearFlows flows(dynamics);
  const std::unique_ptr<LinearArc> arc = flows.of({false}).arc();
  arc->start(0.0, {.u = Eigen::VectorXd::Ones(1), .v = Eigen::VectorXd::Ones(1)});
  double sum = 0.0;
  const auto start = Clock::now();
  for (int i = 0; i < kTimes; ++i) sum += arc->displacement(0, 1e-6 * i) + arc->displacement(0, 1e-6 * i, 1);
  std::printf("one evaluation of x and x' of one mass: %.3f us (%.3g)\n", microseconds(start) / kTimes, sum);
}

}  // namespace
}  // namespace signorini

int main() {
  signorini::evaluation();
  for (const double ratio : {0.05, 0.01}) signorini::compare(ratio);
}
