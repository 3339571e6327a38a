#include "methods/complementarity/series_impacts.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "methods/discretisation/gauss_rule.hpp"
#include "methods/solvers/constants.hpp"
#include "methods/solvers/newton_krylov.hpp"

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
  const double length = interval.end - interval.begin;
  const int panels = std::max(1, static_cast<int>(std::ceil(2.0 * length * harmonics)));
  const double half = 0.5 * length / panels;
  double sum = 0.0;
  double moment = 0.0;
  for (int p = 0; p < panels; ++p) {
    const double middle = interval.begin + (2 * p + 1) * half;
    for (std::size_t k = 0; k < kGaussNodes.size(); ++k) {
      for (const double side : {-1.0, 1.0}) {
        const double t = middle + side * half * kGaussNodes[k];
        const double weighted = half * kGaussWeights[k] * function(t);
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

/// ImpactEquations as a JacobianSystem in the instant and force of each impact, alternating. A point at which
/// an impact pulls is outside their domain: its residual is no number, which no step is taken to.
class ImpactSystem {
 public:
  explicit ImpactSystem(const ImpactEquations& equations) : equations_(equations) {}

  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& v) {
    at_ = v.reshaped(2, v.size() / 2);
    if ((at_.row(1).array() > 0.0).all()) return equations_.residual(at_);
    return Eigen::VectorXd::Constant(v.size(), std::numeric_limits<double>::quiet_NaN());
  }
  [[nodiscard]] KrylovSolve solve_jacobian(const Eigen::VectorXd& r) const {
    return {.x = equations_.jacobian(at_).partialPivLu().solve(r)};
  }
  [[nodiscard]] double error(const Eigen::VectorXd& /*v*/, const Eigen::VectorXd& r) const {
    return r.lpNorm<Eigen::Infinity>();
  }

 private:
  const ImpactEquations& equations_;
  Impacts at_;
};

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

Impacts impacts_of(const std::vector<ContactEpisode>& episodes) {
  const auto count = static_cast<Eigen::Index>(episodes.size());
  Impacts impacts(2, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const ContactEpisode& episode = episodes[static_cast<std::size_t>(k)];
    impacts.col(k) << episode.centre, episode.force;
  }
  return impacts;
}

ImpactEquations::ImpactEquations(const PeriodicGreenFunction& response, const Eigen::VectorXd& gap,
                                 const std::vector<ContactEpisode>& impacts, Eigen::MatrixXcd lasting_motion)
    : response_(response), gap_(gap), impacts_(impacts), lasting_motion_(std::move(lasting_motion)) {}

Eigen::VectorXd ImpactEquations::residual(const Impacts& p) const {
  Eigen::VectorXd result(2 * count());
  for (int k = 0; k < count(); ++k) {
    const int c = contact(k);
    Jet x = trigonometric_jet(lasting_motion_.col(c), p(0, k));
    for (int l = 0; l < count(); ++l) {
      // The kink of an impact's own response lies exactly at its instant: turn 0, the mean of both sides.
      const Jet g = response_.at(c, contact(l), l == k ? 0.0 : p(0, k) - p(0, l));
      x.value -= p(1, l) * g.value;
      x.slope -= p(1, l) * g.slope;
    }
    result[2 * k] = x.value - gap_[c];
    result[2 * k + 1] = x.slope / kTwoPi;
  }
  return result;
}

Eigen::MatrixXd ImpactEquations::jacobian(const Impacts& p) const {
  Eigen::MatrixXd matrix(2 * count(), 2 * count());
  for (int k = 0; k < count(); ++k) {
    const int c = contact(k);
    const Jet x = trigonometric_jet(lasting_motion_.col(c), p(0, k));
    // dX(t_k) / dt_k, at which the impact's own response moves along and does not count.
    double rate = x.slope;
    double change = x.curvature;
    for (int l = 0; l < count(); ++l) {
      const Jet g = response_.at(c, contact(l), l == k ? 0.0 : p(0, k) - p(0, l));
      matrix(2 * k, 2 * l + 1) = -g.value;
      matrix(2 * k + 1, 2 * l + 1) = -g.slope / kTwoPi;
      if (l == k) continue;
      matrix(2 * k, 2 * l) = p(1, l) * g.slope;
      matrix(2 * k + 1, 2 * l) = p(1, l) * g.curvature / kTwoPi;
      rate -= p(1, l) * g.slope;
      change -= p(1, l) * g.curvature;
    }
    matrix(2 * k, 2 * k) = rate;
    matrix(2 * k + 1, 2 * k) = change / kTwoPi;
  }
  return matrix;
}

double ImpactEquations::penetration(const Impacts& p, int contact, int instants) const {
  double deepest = 0.0;
  for (int i = 0; i < instants; ++i) {
    const double turn = static_cast<double>(i) / instants;
    double x = trigonometric_jet(lasting_motion_.col(contact), turn).value;
    for (int l = 0; l < count(); ++l)
      x -= p(1, l) * response_.at(contact, this->contact(l), turn - p(0, l)).value;
    deepest = std::max(deepest, x - gap_[contact]);
  }
  return deepest;
}

std::optional<Impacts> ImpactEquations::solve(const Impacts& from, double tolerance, double rounding) const {
  ImpactSystem system(*this);
  const NewtonKrylovResult newton =
      solve_newton_krylov(system, from.reshaped(), tolerance, {.max_steps = 50, .max_halvings = 9});
  if (newton.end == NewtonEnd::singular || !(newton.residual <= std::max(tolerance, rounding)))
    return std::nullopt;
  return newton.unknowns.reshaped(2, from.cols());
}

}  // namespace signorini
