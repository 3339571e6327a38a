#include "methods/harmonic_balance/compensated_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "methods/complementarity/energy_identity.hpp"
#include "methods/complementarity/exact_quadrature.hpp"
#include "methods/harmonic_balance/sample_grids.hpp"
#include "methods/harmonic_balance/series_solution.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

using Compensated = ImpactCompensation::Result;

// Of a compensation that only leads to another, under the stiffer law.
constexpr double kIntermediateTolerance = 1e-4;

/// The law whose contacts are shorter and nearer to an impulse: the factor is on c alone, so that a penalty
/// law stays one.
ProjectedLaw stiffer_law(const HarmonicSetup& setup) {
  return {setup.settings.compensated_stiffness * setup.law.constant, setup.law.multiplier_weight};
}

/// Compensates under a law, from a force and the stops that belong to it.
Compensated compensate(const HarmonicSetup& setup, const ProjectedLaw& law, const Eigen::MatrixXcd& lambda,
                       const StopShifts& shifts, double tolerance, const Start& start) {
  const int samples = kResolvingSamples * std::max(setup.receptance.harmonics(), kFewestOnGrid);
  return (*setup.compensation)({setup.receptance, setup.gap, law}, lambda, shifts,
                               {.samples = samples, .tolerance = tolerance, .deadline = start.deadline});
}

/// The answer behind compensated impacts under one law, found as `how` says.
Solution answer_of(const HarmonicSetup& setup, const ProjectedLaw& law, const Compensated& found,
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
std::optional<Solution> under_stiffer_law(const HarmonicSetup& setup, const Compensated& near,
                                          const std::string& how, const Start& start, Work& work) {
  const double tolerance = setup.settings.tolerance;
  const ProjectedLaw law = stiffer_law(setup);
  const Compensated stiffer = compensate(setup, law, near.series.lambda, near.shifts, tolerance, start);
  count_iterations(stiffer.iterations, work);
  if (stiffer.converged && stiffer.impacts == near.impacts &&
      same_motion(setup, stiffer.series.lambda, near.series.lambda))
    return answer_of(setup, law, stiffer, how);
  const Compensated own = compensate(setup, setup.law, near.series.lambda, near.shifts, tolerance, start);
  count_iterations(own.iterations, work);
  if (!own.converged || own.impacts == 0) return std::nullopt;
  return answer_of(setup, setup.law, own, how);
}

}  // namespace

CompensatedSeries compensate_series(const HarmonicSetup& setup, const Solution& series, const Start& start,
                                    Work& work) {
  const HarmonicSettings& settings = setup.settings;
  const Eigen::MatrixXcd lambda = force_spectrum(*series.trajectory, setup.receptance.harmonics());
  // Under a limit the user counts steps of the equations asked for, and gets no others.
  const bool stiffens = settings.limit == 0 && settings.compensated_stiffness != 1.0;
  const Compensated found =
      compensate(setup, setup.law, lambda, {}, stiffens ? kIntermediateTolerance : settings.tolerance, start);
  const bool in_limit = settings.limit == 0 || steps_spent(work) + found.iterations <= settings.limit;
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
  if (!setup.compensation || setup.settings.limit > 0 || !start.guess) return std::nullopt;
  const StopShifts shifts = stop_shifts(*start.guess);
  if (static_cast<int>(shifts.size()) != setup.receptance.contacts()) return std::nullopt;
  const ProjectedLaw law = stiffer_law(setup);
  const Compensated found = compensate(setup, law, force_spectrum(*start.guess, setup.receptance.harmonics()),
                                       shifts, setup.settings.tolerance, start);
  count_iterations(found.iterations, work);
  if (!found.converged || found.impacts == 0) return std::nullopt;
  return answer_of(setup, law, found, "Newton from the guess");
}

std::optional<Solution> compensated_from_motion(const HarmonicSetup& setup, const Trajectory& motion,
                                                const std::string& how, const Start& start, Work& work) {
  const Compensated found = compensate(setup, setup.law, force_spectrum(motion, setup.receptance.harmonics()),
                                       {}, setup.settings.tolerance, start);
  count_iterations(found.iterations, work);
  if (!found.converged) return std::nullopt;
  if (found.impacts > 0) return under_stiffer_law(setup, found, how, start, work);
  return exact_solution(setup.equations(), found.series, how);
}

}  // namespace signorini
