#include "harness/report/evaluation/work_precision.hpp"

#include <algorithm>

namespace signorini {

std::vector<CurvePoint> pareto_curve(const Ladder& ladder, const CostAxis& axis) {
  std::vector<CurvePoint> runs;
  for (const Rung& rung : ladder.rungs) {
    const std::optional<double> cost = axis.cost(*rung.record);
    if (rung.error && cost) runs.push_back({*cost, &rung});
  }
  std::stable_sort(runs.begin(), runs.end(), [](const CurvePoint& a, const CurvePoint& b) {
    return a.cost != b.cost ? a.cost < b.cost : *a.rung->error < *b.rung->error;
  });
  std::vector<CurvePoint> curve;
  for (const CurvePoint& run : runs) {
    const bool better = curve.empty() || (*run.rung->error < *curve.back().rung->error &&
                                          !(run.rung->bounded && curve.back().rung->bounded));
    if (better) curve.push_back(run);
  }
  return curve;
}

CurvePoint cost_to_error(const Ladder& ladder, const CostAxis& axis, double error) {
  for (const CurvePoint& point : pareto_curve(ladder, axis)) {
    if (*point.rung->error <= error) return point;
  }
  return {kNeverReached, nullptr};
}

}  // namespace signorini
