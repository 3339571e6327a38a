#include "methods/harmonic_balance/compensated_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "methods/complementarity/exact_quadrature.hpp"
#include "methods/harmonic_balance/series_solution.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

// Of a compensation that only leads to another, under the stiffer law.
constexpr double kIntermediateTolerance = 1e-4;

/// The law whose contacts are shorter and nearer to an impulse: the factor is on c alone, so that a penalty
/// law stays one.
ProjectedLaw stiffer_law(const HarmonicSetup& setup) {
  return {setup.compensated_stiffness() * setup.law.constant, setup.law.multiplier_weight};
}

/// Compensates under a law, from a force and the stops that belong to it.
CompensatedImpacts compensate(const HarmonicSetup& setup, const ProjectedLaw& law,
                              const Eigen::MatrixXcd& lambda, const StopShifts& shifts, double tolerance,
                              const Start& start) {
  const int samples = kResolvingSamples * std::max(setup.receptance.harmonics(), kFewestOnGrid);
  return compensate_impacts(*setup.compensation, {setup.receptance, setup.gap, law}, lambda, shifts,
                            {.samples = samples, .tolerance = tolerance, .deadline = start.deadline});
}

/// The answer behind compensated impacts under one law, found as `how` says.
Solution answer_of(const HarmonicSetup& setup, const ProjectedLaw& law, const CompensatedImpacts& found,
                   const std::string& how) {
  FourierTrajectory::Data data = series_data({setup.receptance, setup.gap, law}, found.series.lambda);
  data.shifts = found.shifts;
  return {.verdict = Verdict::converged,
          .message =
              fmt::format("{}; {} impact{} compensated, stops moved by up to {:.1e}, net contact work {:.1e}",
                          how, found.impacts, found.impacts == 1 ? "" : "s", found.largest,
                          net_work_ratio(data.x, data.lambda)),
          .trajectory = std::make_shared<FourierTrajectory>(std::move(data)),
          .residual = found.series.residual,
          .condition = found.series.condition};
}

/// Whether two forces belong to the same motion.
bool same_motion(const HarmonicSetup& setup, const Eigen::MatrixXcd& force, const Eigen::MatrixXcd& other) {
  const Eigen::MatrixXcd x = contact_motion(setup.receptance, force);
  return near_by((contact_motion(setup.receptance, other) - x).norm() / x.norm());
}

/// The answer under the stiffer law behind impacts compensated at least nearly under the setup's own: taken
/// where Newton's method follows to the same number of impacts of the same motion; else the answer under the
/// setup's own law. Empty if that does not converge either.
std::optional<Solution> under_stiffer_law(const HarmonicSetup& setup, const CompensatedImpacts& near,
                                          const std::string& how, const Start& start, Work& work) {
  const double tolerance = setup.options.tolerance;
  const ProjectedLaw law = stiffer_law(setup);
  const CompensatedImpacts stiffer =
      compensate(setup, law, near.series.lambda, near.shifts, tolerance, start);
  count_iterations(stiffer.iterations, work);
  if (stiffer.converged && stiffer.impacts == near.impacts &&
      same_motion(setup, stiffer.series.lambda, near.series.lambda))
    return answer_of(setup, law, stiffer, how);
  const CompensatedImpacts own =
      compensate(setup, setup.law, near.series.lambda, near.shifts, tolerance, start);
  count_iterations(own.iterations, work);
  if (!own.converged || own.impacts == 0) return std::nullopt;
  return answer_of(setup, setup.law, own, how);
}

/// Whether a grid of so many nodes carries the harmonics of the setup, at four nodes each, and is not too
/// large.
bool carries_harmonics(int nodes, const ContactReceptance& receptance) {
  return nodes >= 4 * receptance.harmonics() &&
         static_cast<long>(nodes) * receptance.contacts() <= kMostHatUnknowns;
}

}  // namespace

CompensatedSeries compensate_series(const HarmonicSetup& setup, const Solution& series, const Start& start,
                                    Work& work) {
  const HarmonicOptions& options = setup.options;
  const Eigen::MatrixXcd lambda = force_spectrum(*series.trajectory, setup.receptance.harmonics());
  // Under a limit the user counts steps of the equations asked for, and gets no others.
  const bool stiffens = options.max_iterations == 0 && setup.compensated_stiffness() != 1.0;
  const CompensatedImpacts found =
      compensate(setup, setup.law, lambda, {}, stiffens ? kIntermediateTolerance : options.tolerance, start);
  const bool in_limit =
      options.max_iterations == 0 || steps_spent(work) + found.iterations <= options.max_iterations;
  if (in_limit) count_iterations(found.iterations, work);
  CompensatedSeries result{.exact = found.exact};
  if (found.converged && found.impacts == 0) {
    result.answer = series;
  } else if (found.converged && in_limit) {
    result.exact = true;
    result.answer = stiffens ? under_stiffer_law(setup, found, series.message, start, work)
                             : answer_of(setup, setup.law, found, series.message);
  }
  return result;
}

std::optional<Solution> compensated_from_guess(const HarmonicSetup& setup, const Start& start, Work& work) {
  if (!setup.compensation || setup.options.max_iterations > 0 || !start.guess) return std::nullopt;
  const StopShifts shifts = stop_shifts(*start.guess);
  if (static_cast<int>(shifts.size()) != setup.receptance.contacts()) return std::nullopt;
  const ProjectedLaw law = stiffer_law(setup);
  const CompensatedImpacts found =
      compensate(setup, law, force_spectrum(*start.guess, setup.receptance.harmonics()), shifts,
                 setup.options.tolerance, start);
  count_iterations(found.iterations, work);
  if (!found.converged || found.impacts == 0) return std::nullopt;
  return answer_of(setup, law, found, "Newton from the guess");
}

std::optional<Solution> compensated_from_motion(const HarmonicSetup& setup, const Trajectory& motion,
                                                const std::string& how, const Start& start, Work& work) {
  const CompensatedImpacts found =
      compensate(setup, setup.law, force_spectrum(motion, setup.receptance.harmonics()), {},
                 setup.options.tolerance, start);
  count_iterations(found.iterations, work);
  if (!found.converged) return std::nullopt;
  if (found.impacts > 0) return under_stiffer_law(setup, found, how, start, work);
  return exact_solution(setup.equations(), found.series, how);
}

HatAgreement compare_with_hat_functions(HarmonicSetup& setup, const Solution& series, const Start& start,
                                        Work& work) {
  HatAgreement agreement;
  if (!setup.hat_grids || setup.options.max_iterations > 0) return agreement;
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

Solution claim_if_borne_out(Solution series, bool exact, const HatAgreement& agreement, double nearest) {
  if (series.verdict != Verdict::converged) return series;
  series.message += "; impacts not compensated";
  if (!agreement.asked) return series;
  const bool borne_out = agreement.distance && *agreement.distance <= nearest;
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
