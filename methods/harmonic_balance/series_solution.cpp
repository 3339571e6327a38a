#include "methods/harmonic_balance/series_solution.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "methods/complementarity/energy_identity.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

FourierTrajectory::Data series_data(const ProjectedEquations& equations, Eigen::MatrixXcd lambda) {
  Eigen::MatrixXcd x = contact_motion(equations.receptance, lambda);
  return {equations.receptance.period, std::move(x),
          std::move(lambda),           equations.gap,
          equations.law.constant,      equations.law.multiplier_weight};
}

Solution exact_solution(const ProjectedEquations& equations, const ExactProjection& solved,
                        const std::string& how) {
  FourierTrajectory::Data data = series_data(equations, solved.lambda);
  const double ratio = net_work_ratio(data.x, data.lambda);
  return {.verdict = Verdict::converged,
          .message = fmt::format("{}; contact integral exact, net contact work {:.1e} of that exchanged", how,
                                 ratio),
          .trajectory = std::make_shared<FourierTrajectory>(std::move(data)),
          .residual = solved.residual,
          .condition = solved.condition};
}

Solution contact_free_response(const ContactReceptance& receptance) {
  FourierTrajectory::Data data;
  data.period = receptance.period;
  data.x = receptance.free_response;
  data.lambda = data.x;  // no columns: there is no contact
  return {.verdict = Verdict::converged,
          .message = "no contact in the scene: linear response",
          .trajectory = std::make_shared<FourierTrajectory>(std::move(data)),
          .work = {.unknowns = 0},
          .residual = 0.0};
}

}  // namespace signorini
