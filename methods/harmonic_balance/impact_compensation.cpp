#include "methods/harmonic_balance/impact_compensation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <utility>

#include "methods/complementarity/series_impacts.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

constexpr int kRounds = 30;
constexpr int kSlowRounds = 4;   // full steps that do not halve the defect, after which it is given up
constexpr int kStepLengths = 6;  // lengths of a step towards the impacts wanted: 1, 1/2, ..., 1/32
// A defect that no longer falls is rounding if it is this small already, relative to the motion.
constexpr double kDefectRounding = 1e-7;
// X may pass a stop by so much of the motion: ripple of the force of other contacts that last.
constexpr double kPassed = 1e-3;
constexpr int kInstantsPerHarmonic = 8;

/// A solution of the projected equations to begin with, and the stops that belong to it.
struct ShiftedSeries {
  Eigen::MatrixXcd lambda;
  StopShifts shifts;
};

/// The series with its impacts moved by `share` of the way to `wanted`. Each keeps its shape: an episode that
/// moves by tau and grows by f has the coefficients f e^{-2 pi i n tau} lambda_n.
ShiftedSeries with_impacts_moved(const ProjectedEquations& equations, const ContactEpisodes& episodes,
                                 const Impacts& wanted, double share) {
  const auto count = static_cast<Eigen::Index>(episodes.impacts.size());
  const auto impact = [&](Eigen::Index k) -> const ContactEpisode& {
    return episodes.impacts[static_cast<std::size_t>(k)];
  };
  Eigen::VectorXd way(count);     // tau, share of the period
  Eigen::VectorXd growth(count);  // f
  ShiftedSeries moved{episodes.lasting_force,
                      StopShifts(static_cast<std::size_t>(equations.receptance.contacts()))};
  for (Eigen::Index k = 0; k < count; ++k) {
    way[k] = share * (wanted(0, k) - impact(k).centre);
    growth[k] = 1.0 + share * (wanted(1, k) / impact(k).force - 1.0);
    const Complex unit = std::polar(1.0, -kTwoPi * share * (wanted(0, k) - impact(k).centre));
    Complex factor = growth[k];
    for (Eigen::Index n = 0; n < moved.lambda.rows(); ++n, factor *= unit)
      moved.lambda(n, impact(k).contact) += factor * impact(k).lambda[n];
  }
  const Eigen::MatrixXcd x = contact_motion(equations.receptance, moved.lambda);
  // A shift of nothing keeps the stop in its place where contact lasts.
  for (const ContactEpisode& other : episodes.lasting)
    moved.shifts[static_cast<std::size_t>(other.contact)].push_back(
        {other.middle(), other.width(), 0.0, 0.0});
  for (Eigen::Index k = 0; k < count; ++k) {
    // y at the centre is to grow as the force does, in value and slope; what the moved series alone lacks of
    // that, c times the shift must give. The shift is stored at the middle of the episode.
    const int contact = impact(k).contact;
    const double constant = equations.law.constant[contact];
    const Jet y = trigonometric_jet(augmented_multiplier(equations, contact, x, moved.lambda),
                                    impact(k).centre + way[k]);
    const double distance = (growth[k] * impact(k).load.value - y.value) / constant;
    const double speed = (growth[k] * impact(k).load.slope - y.slope) / constant;
    moved.shifts[static_cast<std::size_t>(contact)].push_back(
        {impact(k).middle() + way[k], impact(k).width(),
         distance + speed * (impact(k).middle() - impact(k).centre), speed});
  }
  return moved;
}

double largest_shift(const ContactEpisodes& episodes, const StopShifts& shifts) {
  double distance = 0.0;
  for (const ContactEpisode& impact : episodes.impacts) {
    const auto& stop = shifts[static_cast<std::size_t>(impact.contact)];
    distance = std::max(distance, std::abs(shift_at(stop, impact.centre).at(impact.centre)));
  }
  return distance;
}

/// Whether X stays before every stop that no contact of some length touches. Impacts that solve their
/// equations through a stop are no motion, and no orbit is near.
bool stays_before_stops(const ImpactEquations& law, const Impacts& impacts, const ContactEpisodes& episodes,
                        const ContactReceptance& receptance) {
  for (int c = 0; c < receptance.contacts(); ++c) {
    const auto touches = [&](const ContactEpisode& episode) { return episode.contact == c; };
    if (std::ranges::any_of(episodes.lasting, touches)) continue;
    if (law.penetration(impacts, c, kInstantsPerHarmonic * receptance.harmonics()) >
        kPassed * episodes.motion)
      return false;
  }
  return true;
}

/// Whether the defect of the law of impact is small enough, and whether it still falls.
class DefectHistory {
 public:
  /// \param tolerance  relative to the motion
  explicit DefectHistory(double tolerance) : tolerance_(tolerance) {}

  [[nodiscard]] bool is_small(double defect, double motion) const {
    return defect <= tolerance_ * motion || (defect <= kDefectRounding * motion && defect >= 0.5 * least_);
  }

  /// Takes the defect down; true once full steps have not halved it for too often. Shortened steps may not.
  [[nodiscard]] bool falls_too_slowly(double defect, bool full_step) {
    if (full_step && defect > 0.5 * least_ && ++slow_rounds_ == kSlowRounds) return true;
    least_ = std::min(least_, defect);
    return false;
  }

 private:
  double tolerance_;
  double least_ = std::numeric_limits<double>::infinity();
  int slow_rounds_ = 0;
};

}  // namespace

CompensatedImpacts compensate_impacts(const PeriodicGreenFunction& response,
                                      const ProjectedEquations& equations, const Eigen::MatrixXcd& lambda,
                                      const StopShifts& shifts, const ExactProjectionSettings& settings) {
  ExactProjection series = project_exactly(equations, lambda, settings, shifts);
  CompensatedImpacts result{.exact = series.converged, .iterations = series.iterations, .shifts = shifts};
  // Where the exact equations have no solution near by, the sampled one still says where the impacts are.
  if (!series.converged) series.lambda = lambda;
  DefectHistory history(settings.tolerance);
  bool full_step = false;
  for (int round = 0; round < kRounds && std::chrono::steady_clock::now() <= settings.deadline; ++round) {
    const ContactEpisodes episodes =
        contact_episodes(equations, response, series.lambda, result.shifts, settings.samples);
    const ImpactEquations law(response, equations.gap, episodes.impacts,
                              contact_motion(equations.receptance, episodes.lasting_force));
    const Impacts present = impacts_of(episodes.impacts);
    result.impacts = static_cast<int>(episodes.impacts.size());
    const double defect = result.impacts > 0 ? law.residual(present).lpNorm<Eigen::Infinity>() : 0.0;
    if (history.is_small(defect, episodes.motion) && !episodes.lasting_is_shifted) {
      if (result.impacts > 0 && !stays_before_stops(law, present, episodes, equations.receptance)) break;
      result.converged = series.converged;
      if (!result.shifts.empty()) result.largest = largest_shift(episodes, result.shifts);
      result.series = std::move(series);
      break;
    }
    if (history.falls_too_slowly(defect, full_step)) break;
    const std::optional<Impacts> wanted =
        law.solve(present, settings.tolerance * episodes.motion, kDefectRounding * episodes.motion);
    if (!wanted) break;
    // Far from the answer the projected equations may lose an impact on the way; a shorter step keeps it.
    double share = 1.0;
    ExactProjection next;
    for (int trial = 0; trial < kStepLengths && !next.converged; ++trial, share *= 0.5) {
      ShiftedSeries guess = with_impacts_moved(equations, episodes, *wanted, share);
      next = project_exactly(equations, guess.lambda, settings, guess.shifts);
      result.iterations += next.iterations;
      full_step = trial == 0;
      if (next.converged) result.shifts = std::move(guess.shifts);
    }
    if (!next.converged) break;
    if (!next.condition) next.condition = series.condition;  // there already: no step was needed
    series = std::move(next);
  }
  return result;
}

std::optional<PeriodicGreenFunction> response_to_impacts(const Problem& problem,
                                                         const ContactReceptance& receptance, int beyond) {
  if (!std::holds_alternative<Restitution>(problem.law)) return std::nullopt;
  const int harmonics = receptance.harmonics();
  const PeriodicGreenFunction kept(receptance);
  const auto has_mass = [](const PeriodicGreenFunction& response, int contacts, int from) {
    for (int c = 0; c < contacts; ++c) {
      if (response.is_mass_beyond(c, from)) return true;
    }
    return false;
  };
  // A look at the harmonics at hand spares most structures with higher modes the search for more.
  if (!has_mass(kept, receptance.contacts(), harmonics - std::max(1, harmonics / 8))) return std::nullopt;
  try {
    PeriodicGreenFunction extended(fourier_receptance(problem, beyond));
    if (!has_mass(extended, receptance.contacts(), harmonics)) return std::nullopt;
    return extended;
  } catch (const SingularStiffness&) {
    return std::nullopt;  // an undamped mode answers to a harmonic beyond H
  }
}

}  // namespace signorini
