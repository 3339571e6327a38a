#include "methods/harmonic_balance/impact_compensation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

// An impact appears spread over a third of 1/H with the methods' own constants, up to 2.5 with soft ones.
constexpr double kLongestImpact = 2.5;
constexpr double kLongestShare = 0.25;
// Contacts nearer than one ripple of the series are one.
constexpr double kRipple = 1.0;
constexpr int kRounds = 30;
constexpr int kStalled = 4;  // whole steps that do not halve the defect, after which it is given up
constexpr int kHalvings = 6;
// A defect that no longer falls is rounding if it is this small already.
constexpr double kSettled = 1e-7;

/// Contact without a break, or with breaks that the series cannot tell from none.
struct Episode {
  int contact = 0;
  std::vector<ContactInterval> intervals = {};
  bool impact = false;
  double centre = 0.0;           ///< of the force, share of the period [-]
  double force = 0.0;            ///< its mean over the period, J / T > 0 [N]
  Jet load = {};                 ///< y at the centre, shift included [N]
  Eigen::VectorXcd lambda = {};  ///< its part of lambda, n = 0..H [N]

  [[nodiscard]] double width() const { return intervals.back().end - intervals.front().begin; }
  [[nodiscard]] double middle() const { return 0.5 * (intervals.back().end + intervals.front().begin); }
};

/// Instants (shares of the period) and mean forces J / T of impacts.
struct Impulses {
  Eigen::VectorXd time;
  Eigen::VectorXd force;
};

std::vector<Episode> episodes_of(std::vector<ContactInterval> intervals, int contact, int harmonics) {
  std::vector<Episode> episodes;
  const double ripple = kRipple / harmonics;
  for (const ContactInterval& interval : intervals) {
    if (!episodes.empty() && interval.begin - episodes.back().intervals.back().end < ripple) {
      episodes.back().intervals.push_back(interval);
    } else {
      episodes.push_back({.contact = contact, .intervals = {interval}});
    }
  }
  if (episodes.size() > 1) {
    Episode& last = episodes.back();
    Episode& first = episodes.front();
    if (first.intervals.front().begin + 1.0 - last.intervals.back().end < ripple) {
      for (const ContactInterval& interval : first.intervals)
        last.intervals.push_back({interval.begin + 1.0, interval.end + 1.0});
      episodes.erase(episodes.begin());
    }
  }
  return episodes;
}

/// Integral and first moment about `origin` of a function over an interval, by Gauss' rule on panels that a
/// polynomial of degree H cannot bend much in.
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

/// A solution of the projected equations taken apart into impacts and the rest.
class Parts {
 public:
  Parts(const PeriodicGreenFunction& response, const ContactReceptance& receptance,
        const Eigen::VectorXd& gap, const ProjectedLaw& law, const Eigen::MatrixXcd& lambda,
        const StopShifts& shifts, int samples)
      : response_(response), receptance_(receptance), gap_(gap), law_(law) {
    x_ = contact_motion(receptance, lambda);
    rest_ = Eigen::MatrixXcd::Zero(lambda.rows(), lambda.cols());
    const std::vector<StopShift> none;
    for (int c = 0; c < receptance.contacts(); ++c) {
      const auto& stop = shifts.empty() ? none : shifts[static_cast<std::size_t>(c)];
      const Eigen::VectorXcd y = load(c, x_, lambda);
      for (Episode& episode :
           episodes_of(positive_intervals(y, samples, stop, law.constant[c]), c, harmonics())) {
        measure(episode, y, stop);
        if (!episode.impact) rest_.col(c) += episode.lambda;
        const StopShift shift = shift_at(stop, episode.middle());
        if (!episode.impact && (shift.distance != 0.0 || shift.speed != 0.0)) stale_ = true;
        (episode.impact ? impacts_ : others_).push_back(std::move(episode));
      }
    }
    rest_motion_ = contact_motion(receptance, rest_);
  }

  [[nodiscard]] int impacts() const { return static_cast<int>(impacts_.size()); }
  /// Root mean square of x [m].
  [[nodiscard]] double scale() const {
    return std::sqrt(x_.row(0).squaredNorm() + 2.0 * x_.bottomRows(x_.rows() - 1).squaredNorm());
  }

  /// Whether the stop is moved for a contact that is no impact.
  [[nodiscard]] bool stale() const { return stale_; }

  [[nodiscard]] Impulses impulses() const {
    Impulses found{Eigen::VectorXd(impacts()), Eigen::VectorXd(impacts())};
    for (int k = 0; k < impacts(); ++k) {
      found.time[k] = impact(k).centre;
      found.force[k] = impact(k).force;
    }
    return found;
  }

  /// X(t_k) - g and X'(t_k) T / (2 pi) for every impact, [m].
  [[nodiscard]] Eigen::VectorXd defect(const Impulses& p) const {
    Eigen::VectorXd result(2 * impacts());
    for (int k = 0; k < impacts(); ++k) {
      const int c = impact(k).contact;
      Jet x = trigonometric_jet(rest_motion_.col(c), p.time[k]);
      for (int l = 0; l < impacts(); ++l) {
        const Jet g = response_.at(c, impact(l).contact, l == k ? 0.0 : p.time[k] - p.time[l]);
        x.value -= p.force[l] * g.value;
        x.slope -= p.force[l] * g.slope;
      }
      result[2 * k] = x.value - gap_[c];
      result[2 * k + 1] = x.slope / kTwoPi;
    }
    return result;
  }

  /// Instants and impulses without defect, by Newton from those of the series.
  [[nodiscard]] std::optional<Impulses> settled(double tolerance) const {
    constexpr int kSteps = 50;
    Impulses p = impulses();
    Eigen::VectorXd f = defect(p);
    for (int step = 0; step < kSteps; ++step) {
      if (f.lpNorm<Eigen::Infinity>() <= tolerance) return p;
      const Eigen::VectorXd d = jacobian(p).partialPivLu().solve(f);
      if (!d.allFinite()) return std::nullopt;
      bool descended = false;
      for (double length = 1.0; length > 1e-3 && !descended; length *= 0.5) {
        Impulses trial = p;
        for (int k = 0; k < impacts(); ++k) {
          trial.time[k] -= length * d[2 * k];
          trial.force[k] -= length * d[2 * k + 1];
        }
        if (!(trial.force.minCoeff() > 0.0)) continue;
        const Eigen::VectorXd g = defect(trial);
        if (!(g.norm() < (1.0 - 1e-4 * length) * f.norm())) continue;
        p = trial;
        f = g;
        descended = true;
      }
      if (!descended) break;
    }
    if (f.lpNorm<Eigen::Infinity>() <= kSettled * scale()) return p;
    return std::nullopt;
  }

  /// The series with its impacts moved by `share` of the way to `target`, each keeping its shape.
  [[nodiscard]] std::pair<Eigen::MatrixXcd, StopShifts> moved(const Impulses& target, double share) const {
    Eigen::MatrixXcd lambda = rest_;
    for (int k = 0; k < impacts(); ++k) {
      const Complex unit = std::polar(1.0, -kTwoPi * share * (target.time[k] - impact(k).centre));
      Complex factor = growth(target, share, k);
      for (Eigen::Index n = 0; n < lambda.rows(); ++n, factor *= unit)
        lambda(n, impact(k).contact) += factor * impact(k).lambda[n];
    }
    const Eigen::MatrixXcd x = contact_motion(receptance_, lambda);
    StopShifts shifts(static_cast<std::size_t>(receptance_.contacts()));
    for (const Episode& other : others_)
      shifts[static_cast<std::size_t>(other.contact)].push_back({other.middle(), other.width(), 0.0, 0.0});
    for (int k = 0; k < impacts(); ++k) {
      // y at the centre is to grow as the force does; what the series alone lacks, the stop must give.
      const Episode& here = impact(k);
      const double way = share * (target.time[k] - here.centre);
      const Jet y = trigonometric_jet(load(here.contact, x, lambda), here.centre + way);
      const double factor = growth(target, share, k);
      const double distance = (factor * here.load.value - y.value) / law_.constant[here.contact];
      const double speed = (factor * here.load.slope - y.slope) / law_.constant[here.contact];
      shifts[static_cast<std::size_t>(here.contact)].push_back(
          {here.middle() + way, here.width(), distance + speed * (here.middle() - here.centre), speed});
    }
    return {std::move(lambda), std::move(shifts)};
  }

  /// The largest distance of a stop from its place while an impact acts [m].
  [[nodiscard]] double largest(const StopShifts& shifts) const {
    double distance = 0.0;
    for (const Episode& episode : impacts_) {
      const auto& stop = shifts[static_cast<std::size_t>(episode.contact)];
      distance = std::max(distance, std::abs(shift_at(stop, episode.centre).at(episode.centre)));
    }
    return distance;
  }

 private:
  [[nodiscard]] int harmonics() const { return receptance_.harmonics(); }
  [[nodiscard]] const Episode& impact(int k) const { return impacts_[static_cast<std::size_t>(k)]; }

  [[nodiscard]] double growth(const Impulses& target, double share, int k) const {
    return 1.0 + share * (target.force[k] / impact(k).force - 1.0);
  }

  /// y = c (x - g) - relief lambda of one contact, its stop in its place.
  [[nodiscard]] Eigen::VectorXcd load(int contact, const Eigen::MatrixXcd& x,
                                      const Eigen::MatrixXcd& lambda) const {
    Eigen::VectorXcd y = law_.constant[contact] * x.col(contact) - law_.relief[contact] * lambda.col(contact);
    y[0] -= law_.constant[contact] * gap_[contact];
    return y;
  }

  void measure(Episode& episode, const Eigen::VectorXcd& y, const std::vector<StopShift>& stop) const {
    const double longest = std::min(kLongestImpact / harmonics(), kLongestShare);
    const int c = episode.contact;
    // All of lambda comes from y: where lambda only nearly solves the equations, what is left over is
    // dropped.
    episode.lambda = -ContactIndicator(episode.intervals, harmonics()).restrict(y);
    for (const ContactInterval& interval : episode.intervals) {
      if (!stop.empty()) episode.lambda -= law_.constant[c] * shift_spectrum(interval, stop, harmonics());
    }
    if (episode.width() > longest || !response_.is_mass_beyond(c, harmonics())) return;
    episode.impact = true;
    const double middle = episode.middle();
    const auto pressure = [&](double t) {
      return trigonometric_jet(y, t).value + law_.constant[c] * shift_at(stop, t).at(t);
    };
    double moment = 0.0;
    for (const ContactInterval& interval : episode.intervals) {
      const auto [sum, first] = moments(pressure, interval, middle, harmonics());
      episode.force += sum;
      moment += first;
    }
    episode.centre = middle + moment / episode.force;
    const StopShift shift = shift_at(stop, episode.centre);
    episode.load = trigonometric_jet(y, episode.centre);
    episode.load.value += law_.constant[c] * shift.at(episode.centre);
    episode.load.slope += law_.constant[c] * shift.speed;
  }

  /// Of the defect with respect to (time, force) of each impact.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Impulses& p) const {
    Eigen::MatrixXd matrix(2 * impacts(), 2 * impacts());
    for (int k = 0; k < impacts(); ++k) {
      const int c = impact(k).contact;
      const Jet x = trigonometric_jet(rest_motion_.col(c), p.time[k]);
      double rate = x.slope;
      double change = x.curvature;
      for (int l = 0; l < impacts(); ++l) {
        const Jet g = response_.at(c, impact(l).contact, l == k ? 0.0 : p.time[k] - p.time[l]);
        matrix(2 * k, 2 * l + 1) = -g.value;
        matrix(2 * k + 1, 2 * l + 1) = -g.slope / kTwoPi;
        if (l == k) continue;
        matrix(2 * k, 2 * l) = p.force[l] * g.slope;
        matrix(2 * k + 1, 2 * l) = p.force[l] * g.curvature / kTwoPi;
        rate -= p.force[l] * g.slope;
        change -= p.force[l] * g.curvature;
      }
      matrix(2 * k, 2 * k) = rate;
      matrix(2 * k + 1, 2 * k) = change / kTwoPi;
    }
    return matrix;
  }

  const PeriodicGreenFunction& response_;
  const ContactReceptance& receptance_;
  const Eigen::VectorXd& gap_;
  const ProjectedLaw& law_;
  Eigen::MatrixXcd x_;
  Eigen::MatrixXcd rest_;         // lambda outside impacts
  Eigen::MatrixXcd rest_motion_;  // x_f + C rest
  std::vector<Episode> impacts_;
  std::vector<Episode> others_;
  bool stale_ = false;
};

}  // namespace

ImpactCompensation::ImpactCompensation(ContactReceptance extended) : response_(std::move(extended)) {}

ImpactCompensation::Result ImpactCompensation::operator()(const ContactReceptance& receptance,
                                                          const Eigen::VectorXd& gap, const ProjectedLaw& law,
                                                          const Eigen::MatrixXcd& lambda,
                                                          const StopShifts& shifts, int samples,
                                                          double tolerance, const Start& start) const {
  ExactProjection series = project_exactly(receptance, gap, law, lambda, samples, tolerance, shifts, start);
  Result result{.exact = series.converged, .iterations = series.iterations, .shifts = shifts};
  // Where the exact equations have no solution near by, the sampled one still says where the impacts are.
  if (!series.converged) series.lambda = lambda;
  double least = std::numeric_limits<double>::infinity();
  int stalled = 0;
  bool whole = false;  // the last step went all the way
  for (int round = 0; round < kRounds && !start.expired(); ++round) {
    const Parts parts(response_, receptance, gap, law, series.lambda, result.shifts, samples);
    result.impacts = parts.impacts();
    const double defect =
        parts.impacts() > 0 ? parts.defect(parts.impulses()).lpNorm<Eigen::Infinity>() : 0.0;
    const double goal = tolerance * parts.scale();
    const bool small = defect <= goal || (defect <= kSettled * parts.scale() && defect >= 0.5 * least);
    if (small && !parts.stale()) {
      result.converged = series.converged;
      result.series = std::move(series);
      if (!result.shifts.empty()) result.largest = parts.largest(result.shifts);
      break;
    }
    if (whole && defect > 0.5 * least && ++stalled == kStalled) break;
    least = std::min(least, defect);
    const std::optional<Impulses> target = parts.settled(goal);
    if (!target) break;
    double share = 1.0;
    ExactProjection next;
    for (int k = 0; k < kHalvings && !next.converged; ++k, share *= 0.5) {
      auto [guess, moved] = parts.moved(*target, share);
      next = project_exactly(receptance, gap, law, guess, samples, tolerance, moved, start);
      result.iterations += next.iterations;
      whole = k == 0;
      if (next.converged) result.shifts = std::move(moved);
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
