#include "methods/complementarity/contact_episodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace signorini {

namespace {

// An impact appears spread over a third of 1/H with the methods' own constants, up to 2.5 with soft ones.
constexpr double kLongestImpact = 2.5;
constexpr double kLongestShare = 0.25;
// Contacts nearer than one ripple of the series are one.
constexpr double kRipple = 1.0;

/// Integral and first moment about `origin` of a function over an interval, by Gauss' rule of eight nodes on
/// panels of half a ripple, in which a polynomial of degree H cannot bend much.
template <class Function>
std::pair<double, double> moments(const Function& function, const ContactInterval& interval, double origin,
                                  int harmonics) {
  constexpr std::array<double, 4> kNodes{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                         0.9602898564975363};
  constexpr std::array<double, 4> kWeights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                           0.1012285362903763};
  const double length = interval.end - interval.begin;
  const int panels = std::max(1, static_cast<int>(std::ceil(2.0 * length * harmonics)));
  const double half = 0.5 * length / panels;
  double sum = 0.0;
  double moment = 0.0;
  for (int p = 0; p < panels; ++p) {
    const double middle = interval.begin + (2 * p + 1) * half;
    for (std::size_t k = 0; k < kNodes.size(); ++k) {
      for (const double side : {-1.0, 1.0}) {
        const double t = middle + side * half * kNodes[k];
        const double weighted = half * kWeights[k] * function(t);
        sum += weighted;
        moment += weighted * (t - origin);
      }
    }
  }
  return {sum, moment};
}

/// The part of lambda that the episode's intervals make, -P chi y with the stop in its place. All of lambda
/// comes from y: where lambda only nearly solves the equations, what is left over is dropped.
Eigen::VectorXcd force_of(const ContactEpisode& episode, const Eigen::VectorXcd& y,
                          const std::vector<StopShift>& stop, double constant) {
  const int harmonics = static_cast<int>(y.size()) - 1;
  Eigen::VectorXcd lambda = -ContactIndicator(episode.intervals, harmonics).restrict(y);
  for (const ContactInterval& interval : episode.intervals) {
    if (!stop.empty()) lambda -= constant * shift_spectrum(interval, stop, harmonics);
  }
  return lambda;
}

/// Centre and mean of the unprojected force max(0, y) of an impact, and y there.
void measure_impact(ContactEpisode& episode, const Eigen::VectorXcd& y, const std::vector<StopShift>& stop,
                    double constant) {
  const double middle = episode.middle();
  const auto pressure = [&](double t) {
    return trigonometric_jet(y, t).value + constant * shift_at(stop, t).at(t);
  };
  double moment = 0.0;
  for (const ContactInterval& interval : episode.intervals) {
    const auto [sum, first] = moments(pressure, interval, middle, static_cast<int>(y.size()) - 1);
    episode.force += sum;
    moment += first;
  }
  episode.centre = middle + moment / episode.force;
  const StopShift shift = shift_at(stop, episode.centre);
  episode.load = trigonometric_jet(y, episode.centre);
  episode.load.value += constant * shift.at(episode.centre);
  episode.load.slope += constant * shift.speed;
}

}  // namespace

Eigen::VectorXcd augmented_multiplier(const ProjectedEquations& equations, int contact,
                                      const Eigen::MatrixXcd& x, const Eigen::MatrixXcd& lambda) {
  const ProjectedLaw& law = equations.law;
  Eigen::VectorXcd y =
      law.constant[contact] * x.col(contact) - law.multiplier_weight[contact] * lambda.col(contact);
  y[0] -= law.constant[contact] * equations.gap[contact];
  return y;
}

ContactEpisodes contact_episodes(const ProjectedEquations& equations, const PeriodicGreenFunction& response,
                                 const Eigen::MatrixXcd& lambda, const StopShifts& shifts, int samples) {
  const int harmonics = equations.receptance.harmonics();
  const double longest = std::min(kLongestImpact / harmonics, kLongestShare);
  const Eigen::MatrixXcd x = contact_motion(equations.receptance, lambda);
  const std::vector<StopShift> none;
  ContactEpisodes found;
  found.motion = std::sqrt(x.row(0).squaredNorm() + 2.0 * x.bottomRows(x.rows() - 1).squaredNorm());
  found.lasting_force = Eigen::MatrixXcd::Zero(lambda.rows(), lambda.cols());
  for (int c = 0; c < equations.receptance.contacts(); ++c) {
    const auto& stop = shifts.empty() ? none : shifts[static_cast<std::size_t>(c)];
    const double constant = equations.law.constant[c];
    const Eigen::VectorXcd y = augmented_multiplier(equations, c, x, lambda);
    const auto intervals = positive_intervals(y, samples, stop, constant);
    for (std::vector<ContactInterval>& phase : contact_phases(intervals, kRipple / harmonics)) {
      ContactEpisode episode{.contact = c, .intervals = std::move(phase)};
      episode.lambda = force_of(episode, y, stop, constant);
      episode.impact = episode.width() <= longest && response.is_mass_beyond(c, harmonics);
      if (episode.impact) {
        measure_impact(episode, y, stop, constant);
        found.impacts.push_back(std::move(episode));
        continue;
      }
      found.lasting_force.col(c) += episode.lambda;
      const StopShift shift = shift_at(stop, episode.middle());
      if (shift.distance != 0.0 || shift.speed != 0.0) found.lasting_is_shifted = true;
      found.lasting.push_back(std::move(episode));
    }
  }
  return found;
}

}  // namespace signorini
