#include "methods/harmonic_balance/impact_compensation.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <utility>

#include "methods/complementarity/contact_episodes.hpp"
#include "methods/complementarity/impact_equations.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

constexpr int kRounds = 30;
constexpr int kSlowRounds = 4;   // full steps that do not halve the defect, after which it is given up
constexpr int kStepLengths = 6;  // lengths of a step towards the impacts wanted: 1, 1/2, ..., 1/32
// A defect that no longer falls is rounding if it is this small already, relative to the motion.
constexpr double kDefectRounding = 1e-7;

/// A solution of the projected equations to begin with, and the stops that belong to it.
struct ShiftedSeries {
  Eigen::MatrixXcd lambda;
  StopShifts shifts;
};

/// The series with its impacts moved by `share` of the way to `wanted`. Each keeps its shape: an episode that
/// moves by tau and grows by f has the coefficients f e^{-2 pi i n tau} lambda_n.
class ShiftedImpacts {
 public:
  ShiftedImpacts(const ProjectedEquations& equations, const ContactEpisodes& episodes, const Impacts& wanted,
                 double share)
      : equations_(equations), episodes_(episodes), wanted_(wanted), share_(share) {}

  [[nodiscard]] ShiftedSeries series() const {
    Eigen::MatrixXcd lambda = moved_force();
    const Eigen::MatrixXcd x = contact_motion(equations_.receptance, lambda);
    StopShifts shifts(static_cast<std::size_t>(equations_.receptance.contacts()));
    // A shift of nothing keeps the stop in its place where contact lasts.
    for (const ContactEpisode& other : episodes_.lasting)
      shifts[static_cast<std::size_t>(other.contact)].push_back({other.middle(), other.width(), 0.0, 0.0});
    for (std::size_t k = 0; k < episodes_.impacts.size(); ++k) {
      const int contact = episodes_.impacts[k].contact;
      shifts[static_cast<std::size_t>(contact)].push_back(
          shift_for(k, augmented_multiplier(equations_, contact, x, lambda)));
    }
    return {std::move(lambda), std::move(shifts)};
  }

 private:
  /// tau, share of the period.
  [[nodiscard]] double way(std::size_t k) const {
    return share_ * (wanted_.time[static_cast<Eigen::Index>(k)] - episodes_.impacts[k].centre);
  }
  /// f.
  [[nodiscard]] double growth(std::size_t k) const {
    return 1.0 + share_ * (wanted_.force[static_cast<Eigen::Index>(k)] / episodes_.impacts[k].force - 1.0);
  }

  [[nodiscard]] Eigen::MatrixXcd moved_force() const {
    Eigen::MatrixXcd lambda = episodes_.lasting_force;
    for (std::size_t k = 0; k < episodes_.impacts.size(); ++k) {
      const ContactEpisode& impact = episodes_.impacts[k];
      const Complex unit =
          std::polar(1.0, -kTwoPi * share_ * (wanted_.time[static_cast<Eigen::Index>(k)] - impact.centre));
      Complex factor = growth(k);
      for (Eigen::Index n = 0; n < lambda.rows(); ++n, factor *= unit)
        lambda(n, impact.contact) += factor * impact.lambda[n];
    }
    return lambda;
  }

  /// y at the centre is to grow as the force does, in value and slope; what the moved series alone lacks of
  /// that, c times the shift must give. The shift is stored at the middle of the episode.
  [[nodiscard]] StopShift shift_for(std::size_t k, const Eigen::VectorXcd& y_of_series) const {
    const ContactEpisode& impact = episodes_.impacts[k];
    const double constant = equations_.law.constant[impact.contact];
    const Jet y = trigonometric_jet(y_of_series, impact.centre + way(k));
    const double distance = (growth(k) * impact.load.value - y.value) / constant;
    const double speed = (growth(k) * impact.load.slope - y.slope) / constant;
    return {impact.middle() + way(k), impact.width(), distance + speed * (impact.middle() - impact.centre),
            speed};
  }

  const ProjectedEquations& equations_;
  const ContactEpisodes& episodes_;
  const Impacts& wanted_;
  double share_;
};

double largest_shift(const ContactEpisodes& episodes, const StopShifts& shifts) {
  double distance = 0.0;
  for (const ContactEpisode& impact : episodes.impacts) {
    const auto& stop = shifts[static_cast<std::size_t>(impact.contact)];
    distance = std::max(distance, std::abs(shift_at(stop, impact.centre).at(impact.centre)));
  }
  return distance;
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

bool expired(const ExactProjectionSettings& settings) {
  return settings.deadline != std::chrono::steady_clock::time_point::max() &&
         std::chrono::steady_clock::now() > settings.deadline;
}

}  // namespace

ImpactCompensation::ImpactCompensation(ContactReceptance extended) : response_(std::move(extended)) {}

ImpactCompensation::Result ImpactCompensation::operator()(const ProjectedEquations& equations,
                                                          const Eigen::MatrixXcd& lambda,
                                                          const StopShifts& shifts,
                                                          const ExactProjectionSettings& settings) const {
  ExactProjection series = project_exactly(equations, lambda, settings, shifts);
  Result result{.exact = series.converged, .iterations = series.iterations, .shifts = shifts};
  // Where the exact equations have no solution near by, the sampled one still says where the impacts are.
  if (!series.converged) series.lambda = lambda;
  DefectHistory history(settings.tolerance);
  bool full_step = false;
  for (int round = 0; round < kRounds && !expired(settings); ++round) {
    const ContactEpisodes episodes =
        contact_episodes(equations, response_, series.lambda, result.shifts, settings.samples);
    const ImpactEquations law(response_, equations.gap, episodes.impacts,
                              contact_motion(equations.receptance, episodes.lasting_force));
    const Impacts present = impacts_of(episodes.impacts);
    result.impacts = static_cast<int>(episodes.impacts.size());
    const double defect = result.impacts > 0 ? law.residual(present).lpNorm<Eigen::Infinity>() : 0.0;
    if (history.is_small(defect, episodes.motion) && !episodes.lasting_is_shifted) {
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
      ShiftedSeries guess = ShiftedImpacts(equations, episodes, *wanted, share).series();
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

std::optional<ImpactCompensation> impact_compensation(const Problem& problem,
                                                      const ContactReceptance& receptance) {
  if (!std::holds_alternative<Restitution>(problem.law)) return std::nullopt;
  const int harmonics = receptance.harmonics();
  const PeriodicGreenFunction kept(receptance);
  const auto has_mass = [](const PeriodicGreenFunction& response, int contacts, int beyond) {
    for (int c = 0; c < contacts; ++c) {
      if (response.is_mass_beyond(c, beyond)) return true;
    }
    return false;
  };
  // A look at the harmonics at hand spares most structures with higher modes the search for more.
  if (!has_mass(kept, receptance.contacts(), harmonics - std::max(1, harmonics / 8))) return std::nullopt;
  try {
    ContactReceptance extended = fourier_receptance(problem, 2 * harmonics);
    if (!has_mass(PeriodicGreenFunction(extended), receptance.contacts(), harmonics)) return std::nullopt;
    return ImpactCompensation(std::move(extended));
  } catch (const SingularStiffness&) {
    return std::nullopt;  // an undamped mode answers to a harmonic beyond H
  }
}

}  // namespace signorini
