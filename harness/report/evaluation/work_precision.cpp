#include "harness/report/evaluation/work_precision.hpp"

#include <algorithm>

#include "harness/statistics.hpp"

namespace signorini {

const CostAxis& time_axis() {
  static const CostAxis axis{
      "time", [](const CaseResult& result) -> std::optional<double> { return result.seconds; }};
  return axis;
}

std::span<const CostAxis> work_axes() {
  using Cost = std::optional<double>;
  static const std::array<CostAxis, 5> axes{
      {{"pivots", [](const CaseResult& r) -> Cost { return r.work.pivots; }},
       {"iterations", [](const CaseResult& r) -> Cost { return r.work.iterations; }},
       {"right-hand sides", [](const CaseResult& r) -> Cost { return r.work.rhs_evaluations; }},
       {"factorisations", [](const CaseResult& r) -> Cost { return r.work.factorisations; }},
       {"unknowns", [](const CaseResult& r) -> Cost { return r.work.unknowns; }}}};
  return axes;
}

std::vector<CurvePoint> pareto_curve(const ResolutionStudy& study, const CostAxis& axis) {
  std::vector<CurvePoint> points;
  for (const ScoredRun& run : study.runs) {
    const std::optional<double> cost = axis.cost(*run.result);
    if (run.error && cost) points.push_back({*cost, &run});
  }
  std::stable_sort(points.begin(), points.end(), [](const CurvePoint& a, const CurvePoint& b) {
    return a.cost != b.cost ? a.cost < b.cost : *a.run->error < *b.run->error;
  });
  std::vector<CurvePoint> curve;
  for (const CurvePoint& point : points) {
    const bool better = curve.empty() || (*point.run->error < *curve.back().run->error &&
                                          !(point.run->bounded && curve.back().run->bounded));
    if (better) curve.push_back(point);
  }
  return curve;
}

CurvePoint cost_to_error(const ResolutionStudy& study, const CostAxis& axis, double error) {
  for (const CurvePoint& point : pareto_curve(study, axis)) {
    if (*point.run->error <= error) return point;
  }
  return {kNeverReached, nullptr};
}

const ScoredRun* reaching_run(const ResolutionStudy& study, double error) {
  if (const ScoredRun* cheapest = cost_to_error(study, time_axis(), error).run) return cheapest;
  const auto first = std::ranges::find_if(
      study.runs, [&](const ScoredRun& run) { return run.error && *run.error <= error; });
  return first == study.runs.end() ? nullptr : &*first;
}

void Reach::add(const ResolutionStudy& study, double error) {
  if (const ScoredRun* run = reaching_run(study, error)) {
    ++scenes;
    if (const auto is_stable = run->result->outcome.stable) ++(*is_stable ? stable : unstable);
  }
  seconds.push_back(cost_to_error(study, time_axis(), error).cost);
}

double Reach::median_seconds() const { return seconds.empty() ? kNeverReached : median(seconds); }

}  // namespace signorini
