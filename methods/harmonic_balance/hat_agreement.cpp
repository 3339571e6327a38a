#include "methods/harmonic_balance/hat_agreement.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <utility>

#include "methods/harmonic_balance/compensated_answer.hpp"
#include "methods/harmonic_balance/witness_grids.hpp"

namespace signorini {

HatAgreement compare_with_hat_functions(HarmonicSetup& setup, const Solution& series, const Start& start,
                                        Work& work) {
  HatAgreement agreement;
  if (!setup.hat_grids || setup.settings.limit > 0) return agreement;
  Resolutions& grids = *setup.hat_grids;
  grids.forget_from(0);  // preparing them is part of this solve
  for (std::size_t grid = 0; grid < grids.count(); ++grid) {
    const int nodes = grids.value(grid);
    if (!carries_harmonics(nodes, setup.receptance)) continue;
    agreement.asked = true;
    if (start.expired()) break;
    const Solution hat = grids.solve_at(grid, {.deadline = start.deadline});
    add_effort(hat.work, work);
    if (hat.verdict != Verdict::converged) continue;
    const std::string how = fmt::format("{} hat functions first, Newton from there", nodes);
    agreement.answer = compensated_from_motion(setup, *hat.trajectory, how, start, work);
    if (agreement.answer) break;
    if (series.verdict != Verdict::converged) continue;
    // The finest grid decides: coarser ones may share a wrong motion with the series (docs/decisions/0014).
    agreement.distance = relative_distance(*series.trajectory, *hat.trajectory, nodes);
  }
  if (start.expired()) agreement.distance.reset();  // the finest grid was not solved
  return agreement;
}

Solution claim_if_borne_out(Solution series, bool exact, const HatAgreement& agreement) {
  if (series.verdict != Verdict::converged) return series;
  series.message += "; impacts not compensated";
  if (!agreement.asked) return series;
  const bool borne_out = agreement.distance && near_by(*agreement.distance);
  if (borne_out && exact) return series;
  series.verdict = Verdict::not_converged;
  if (borne_out) {
    series.message += ", nor the contact integral exact";
  } else if (agreement.distance) {
    series.message += fmt::format(" and {:.2g} away from the motion on hat functions", *agreement.distance);
  } else {
    series.message += ", nor borne out by hat functions";
  }
  return series;
}

}  // namespace signorini
