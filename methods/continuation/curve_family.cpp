#include "methods/continuation/curve_family.hpp"

#include <algorithm>

#include "methods/refinement.hpp"

namespace signorini {

std::optional<StepTarget> CurveFamily::target(const std::vector<double>& values, const Eigen::VectorXd& x,
                                              double end) const {
  return first_target(values, low, high, x[x.size() - 1] * frequency_unit, end);
}

bool CurveFamily::turns_past(const std::vector<double>& values, const CurveStep& step, double end,
                             const Eigen::VectorXd& tangent) const {
  constexpr double kShortest = 1e-5;
  const Eigen::Index last = tangent.size() - 1;
  const double rate = step.length * frequency_unit;
  return step.length > kShortest &&
         signorini::turns_past(values, low, high, {step.x[last] * frequency_unit, rate * step.tangent[last]},
                               {end, rate * tangent[last] / tangent.dot(step.tangent)});
}

CurveFamily curve_family(const Problem& problem, double from, double to) {
  CurveFamily family{.problem = at_frequency(problem, 0.5 * (from + to)),
                     .low = std::min(from, to),
                     .high = std::max(from, to)};
  family.frequency_unit = (family.high - family.low) / 3.0;
  if (problem.contact_count() == 0) return family;
  family.displacement_unit =
      std::max(contact_gaps(problem).cwiseAbs().maxCoeff(), static_deflection(family.problem));
  if (!(family.displacement_unit > 0.0)) family.displacement_unit = 1.0;
  return family;
}

}  // namespace signorini
