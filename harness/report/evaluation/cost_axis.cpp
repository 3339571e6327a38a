#include "harness/report/evaluation/cost_axis.hpp"

#include <array>

namespace signorini {

namespace {

std::optional<double> as_double(const std::optional<long>& count) {
  if (!count) return std::nullopt;
  return static_cast<double>(*count);
}

}  // namespace

const CostAxis& time_axis() {
  static const CostAxis axis{"time", "s", [](const Record& record) -> std::optional<double> {
                               if (!record.seconds) return std::nullopt;
                               return record.seconds->median;
                             }};
  return axis;
}

std::span<const CostAxis> work_axes() {
  static const std::array<CostAxis, 5> axes{
      CostAxis{"pivots", "", [](const Record& r) { return as_double(r.work.counts.pivots); }},
      CostAxis{"iterations", "", [](const Record& r) { return as_double(r.work.counts.iterations); }},
      CostAxis{"right-hand sides", "",
               [](const Record& r) { return as_double(r.work.counts.rhs_evaluations); }},
      CostAxis{"factorisations", "", [](const Record& r) { return as_double(r.work.counts.factorisations); }},
      CostAxis{"unknowns", "", [](const Record& r) { return as_double(r.work.counts.unknowns); }}};
  return axes;
}

}  // namespace signorini
