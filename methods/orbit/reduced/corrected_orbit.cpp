#include "methods/orbit/reduced/corrected_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <optional>
#include <utility>

#include "methods/discretisation/fourier_series.hpp"
#include "methods/linear_flow/shared_modes.hpp"
#include "methods/orbit/reduced/closing_orbit.hpp"
#include "methods/reduction/principal_directions.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

/// Root mean square over time and contacts of a series, n = first.., the
/// constant once [m].
double series_norm(const Eigen::MatrixXcd& series, Eigen::Index first = 0) {
  const Eigen::Index count = series.rows() - first;
  double sum = 2.0 * series.bottomRows(count).squaredNorm();
  if (first == 0) sum -= series.row(0).squaredNorm();
  return std::sqrt(std::max(0.0, sum) / static_cast<double>(series.cols()));
}

/// With coefficients that fall as 1 / n and faster, what lies beyond H is no
/// more than its last octave.
double beyond(const Eigen::MatrixXcd& series) { return series_norm(series, series.rows() / 2); }

/// How often each contact of the scene closes in a period, -1 of one that is closed throughout. Which of two
/// neighbours closes first within rounding is no difference between motions, nor where the period is cut
/// open.
std::vector<int> closings(const ExactTrajectory& orbit) {
  const OrbitGuess& path = orbit.orbit();
  std::vector<int> all(static_cast<std::size_t>(orbit.contact_count()), 0);
  const std::vector<int> counts = path.closings(), acting = orbit.acting_contacts();
  for (std::size_t j = 0; j < counts.size(); ++j) {
    const auto closed = [j](const SequenceEvent& event) { return bool{event.closed[j]}; };
    const bool throughout = path.start.closed[j] && std::ranges::all_of(path.events, closed);
    all[static_cast<std::size_t>(acting[j])] = throughout ? -1 : counts[j];
  }
  return all;
}

bool same_sequence(const ExactTrajectory& a, const ExactTrajectory& b) { return closings(a) == closings(b); }

/// One deferred correction of a scene.
class Correction {
 public:
  Correction(const Problem& problem, const ContactSpace& space, const OrbitCorrectionSettings& settings,
             Eigen::MatrixXcd added)
      : problem_(problem), space_(space), settings_(settings), added_(std::move(added)) {}

  CorrectedOrbit run(ExactOrbit first) {
    result_.orbit = std::move(first);
    if (result_.orbit.trajectory) closing_ = result_.orbit.trajectory->acting_contacts();
    for (int correction = 0;; ++correction) {
      if (!result_.orbit.certified()) return refused("no admissible orbit: " + result_.orbit.reason);
      if (!measure()) return refused("the motion between events is not known as a sum of modes");
      if (correction == 0 ? good_at_once() : correction == settings_.corrections || done()) break;
      correct();
    }
    if (result_.defects.size() > 1) {
      if (too_slow()) return refused("the corrections do not converge: more vectors are needed");
      if (!settled_) return refused("the last correction changed the sequence of events");
      if (!probe()) return refused("displacements as small as what is left change the sequence of events");
    }
    conclude();
    if (!std::isfinite(*result_.bar)) {
      result_.bar.reset();
      return refused("the error bar is not a number");
    }
    result_.space = std::move(space_);
    return std::move(result_);
  }

 private:
  CorrectedOrbit refused(std::string why) {
    result_.refusal = std::move(why);
    return std::move(result_);
  }

  /// Whether the first orbit needs no correction: what is left is no larger than what probes try, and the bar
  /// that they lead to is as small as is wanted, or no correction promises less.
  bool good_at_once() {
    return reducible() <= settings_.largest_probe && enough() && probe() && !too_slow() && enough();
  }

  [[nodiscard]] bool done() const { return settled_ && (enough() || rate() > settings_.slowest); }

  /// Defect of the present orbit, and by how much it has changed. False without its force.
  bool measure();
  /// How much more than themselves displacements as large as what is left change x. The first is x itself, as
  /// an error of the compliance would be; each further one is what the one before has changed, so that they
  /// turn to where x answers most. Without a correction the last one is the defect, and all tell the rate of
  /// corrections too. False where one changes the events.
  bool probe();

  /// What the rounding of K's factors does to x.
  [[nodiscard]] double rounding(const Eigen::MatrixXd& x) const {
    return space_.rounding() /
           space_.distance_from_resonance(base_, settings_.resonances * problem_.subharmonic) *
           std::sqrt(x.array().square().mean()) / size_;
  }

  /// The next orbit, from the present one.
  void correct() {
    before_ = reducible();
    added_ = missing_.topRows(shifted_);
    model_ = space_.small();
    shared_ = std::make_shared<SharedModes>();
    const std::shared_ptr<const ExactTrajectory> before = result_.orbit.trajectory;
    // From its events: the state is another model's.
    OrbitSearch found = find_closing_orbit(problem_, displaced(model_, added_, base_), closing_, *before,
                                           settings_.search, shared_);
    result_.iterations += found.iterations;
    result_.orbit = std::move(found.orbit);
    settled_ = result_.orbit.trajectory && same_sequence(*before, *result_.orbit.trajectory);
  }

  /// Harmonics that are added, the constant included: so many that the others are below the rest of the bar.
  [[nodiscard]] Eigen::Index shifted() const {
    const double least = std::max(settings_.left_by_solved * settings_.tolerance, fixed());
    return harmonics_to_add(missing_, least * size_, problem_.subharmonic, settings_);
  }

  /// How the last defect compares with the one before; without a correction, what probes say of the next.
  [[nodiscard]] double defect_rate() const {
    const std::size_t count = result_.defects.size();
    if (count < 2) return probed_rate_;
    if (result_.defects[count - 2] == 0.0) return 0.0;
    return result_.defects[count - 1] / result_.defects[count - 2];
  }
  /// The same of all that further corrections reduce.
  [[nodiscard]] double rate() const { return before_ > 0.0 ? reducible() / before_ : 0.0; }

  /// What corrections reduce: each has vectors that fit the force better.
  [[nodiscard]] double reducible() const { return result_.defects.back() + result_.unshifted + result_.tail; }
  /// What they do not.
  [[nodiscard]] double fixed() const { return result_.outside + result_.rounding; }
  [[nodiscard]] double rest() const { return result_.unshifted + result_.tail + fixed(); }
  [[nodiscard]] bool negligible_defect() const {
    const double defect = result_.defects.back();
    return defect <= std::max(settings_.rounding, settings_.negligible * rest()) ||
           settings_.safety * result_.amplification * defect <= settings_.negligible * settings_.tolerance;
  }

  /// What the next correction may leave: of what is not added, what its own vectors would.
  [[nodiscard]] double promised() const {
    return settings_.typical * result_.defects.back() + series_norm(missing_, shifted_) / size_;
  }

  [[nodiscard]] bool too_slow() const {
    return !(defect_rate() <= settings_.slowest) && !negligible_defect();
  }

  [[nodiscard]] bool enough() const {
    return settings_.safety * result_.amplification * reducible() <= settings_.tolerance ||
           reducible() <= settings_.negligible * fixed() || promised() > settings_.slowest * reducible();
  }

  void conclude() {
    const double fallen = 1.0 - std::min(defect_rate(), settings_.slowest);
    // The orbit's own error bar is in X.
    const double own = result_.orbit.error_bar * result_.orbit.trajectory->scales().displacement / size_;
    result_.bar = settings_.safety * result_.amplification * (result_.defects.back() / fallen + rest()) + own;
  }

  const Problem& problem_;
  ContactSpace space_;
  const OrbitCorrectionSettings& settings_;
  ContactReduction model_ = space_.small();  // that the present orbit is one of
  const double base_ = problem_.base_frequency();
  double size_ = 1.0;
  double applied_ = 0.0;      // displacement by which a correction changes the present orbit
  double before_ = 0.0;       // what corrections could reduce before the last one
  Eigen::Index shifted_ = 0;  // harmonics added
  std::vector<int> closing_;  // contacts that act in the orbits
  std::shared_ptr<SharedModes> shared_ = std::make_shared<SharedModes>();
  Eigen::MatrixXcd missing_, added_;  // of the present orbit, and in it
  Eigen::MatrixXcd defect_;           // of the present orbit, in the harmonics that are added
  double probed_rate_ = 0.0;
  Eigen::MatrixXd x_;
  bool settled_ = true;
  CorrectedOrbit result_;
};

bool Correction::measure() {
  const ExactTrajectory& orbit = *result_.orbit.trajectory;
  const int order = problem_.subharmonic, harmonics = settings_.harmonics * order;
  const Eigen::MatrixXcd force = orbit.force_spectrum(harmonics);
  if (force.size() == 0) return false;
  const Eigen::MatrixXd x = orbit.sample(settings_.instants * order).x;
  size_ = size_about_mean(x);
  const double wanted = settings_.negligible * std::max(settings_.tolerance, rounding(x)) * size_;
  Eigen::VectorXd bound = space_.bound(base_, force);
  if (root_mean_square(bound) > wanted) {
    space_ = space_.grown_for(base_, {{.force = force, .tolerance = wanted}});
    bound = space_.bound(base_, force);
  }
  space_ = space_.solved_for(base_, force, settings_.left_by_solved * settings_.tolerance * size_);
  result_.vectors = space_.whole().vectors();
  result_.solved = model_.vectors();
  const Eigen::MatrixXcd whole = contact_response(space_.whole(), base_, force);
  missing_ = whole - contact_response(space_.small(), base_, force);
  Eigen::MatrixXcd defect = whole - contact_response(model_, base_, force);
  if (added_.rows() > 0) defect.topRows(added_.rows()) -= added_;
  if (!result_.defects.empty()) {
    const double change = std::sqrt((x - x_).array().square().mean()) / size_;
    if (applied_ > settings_.rounding)
      result_.amplification = std::max(result_.amplification, change / applied_);
  }
  result_.peak = sample_series(defect, 2 * harmonics).cwiseAbs().maxCoeff() / size_;
  result_.tail = beyond(defect) / size_;
  result_.outside = (root_mean_square(bound) + beyond(bound.cast<std::complex<double>>())) / size_;
  result_.rounding = rounding(x);
  if (result_.defects.empty()) {
    shifted_ = std::max(added_.rows(), shifted());
    added_.conservativeResizeLike(Eigen::MatrixXcd::Zero(shifted_, force.cols()));
  }
  defect_ = defect.topRows(shifted_);
  result_.defects.push_back(series_norm(defect_) / size_);
  result_.unshifted = series_norm(defect, shifted_) / size_;
  // A correction takes away all but what its own vectors leave in the harmonics that are not added.
  const Eigen::Index others = defect.rows() - shifted_;
  defect.bottomRows(others) -= missing_.bottomRows(others);
  applied_ = series_norm(defect) / size_;
  x_ = x;
  return true;
}

bool Correction::probe() {
  const ExactTrajectory& orbit = *result_.orbit.trajectory;
  const double length =
      std::clamp(result_.defects.back() + rest(), settings_.least_probe, settings_.largest_probe) * size_;
  const bool uncorrected = result_.defects.size() == 1;
  const int harmonics = static_cast<int>(added_.rows()) - 1;
  Eigen::MatrixXd change = x_.rowwise() - x_.colwise().mean();
  for (int k = 0; k < settings_.probes + (uncorrected ? 1 : 0); ++k) {
    Eigen::MatrixXcd moved =
        k < settings_.probes ? force_spectrum(change, {}, problem_.period(), harmonics) : defect_;
    const double norm = series_norm(moved);
    if (norm == 0.0) continue;
    if (!std::isfinite(norm)) return false;
    moved *= length / norm;
    const CondensedStructure structure = displaced(model_, added_ + moved, base_);
    OrbitFinder finder(problem_, with_open_contacts(structure, closing_), shared_);
    const OrbitSearch found = finder.find(orbit.orbit(), settings_.search);
    result_.iterations += found.iterations;
    if (!found.orbit.certified() || !same_sequence(*found.orbit.trajectory, orbit)) return false;
    if (uncorrected) {
      const Eigen::MatrixXcd force = found.orbit.trajectory->force_spectrum(harmonics);
      if (force.size() == 0) return false;
      // The misfit under the orbit's own force is what was added and what is left.
      const Eigen::MatrixXcd misfit =
          contact_response(space_.whole(), base_, force) - contact_response(model_, base_, force);
      probed_rate_ = std::max(probed_rate_, series_norm(misfit - added_ - defect_) / length);
    }
    change = found.orbit.trajectory->sample(static_cast<int>(x_.rows())).x - x_;
    result_.amplification =
        std::max(result_.amplification, std::sqrt(change.array().square().mean()) / length);
  }
  return true;
}

}  // namespace

double size_about_mean(const Eigen::MatrixXd& x) {
  const double size = std::sqrt((x.rowwise() - x.colwise().mean()).array().square().mean());
  return size > 0.0 ? size : 1.0;
}

CondensedStructure displaced(const ContactReduction& reduction, const Eigen::MatrixXcd& added, double base) {
  CondensedStructure result = condensed(reduction);
  const auto harmonic = [base](double rate) { return static_cast<Eigen::Index>(std::lround(rate / base)); };
  Eigen::Index count = added.rows();
  for (const double rate : reduction.rates) count = std::max(count, harmonic(rate) + 1);
  std::vector<double> rates;
  for (Eigen::Index n = 0; n < count; ++n) rates.push_back(static_cast<double>(n) * base);
  result.load = Eigen::MatrixXcd::Zero(reduction.vectors(), count);
  result.shift = Eigen::MatrixXcd::Zero(reduction.contacts(), count);
  for (std::size_t h = 0; h < reduction.rates.size(); ++h) {
    const Eigen::Index n = harmonic(reduction.rates[h]);
    rates[static_cast<std::size_t>(n)] = reduction.rates[h];  // as it is, to the last digit
    result.load.col(n) = reduction.load.col(static_cast<Eigen::Index>(h));
    result.shift.col(n) = reduction.shift.col(static_cast<Eigen::Index>(h));
  }
  for (Eigen::Index n = 0; n < added.rows(); ++n) {
    const double factor = n == 0 ? 1.0 : 2.0, rate = rates[static_cast<std::size_t>(n)];
    for (Eigen::Index j = 0; j < added.cols(); ++j)
      result.shift(j, n) += factor * std::complex<double>(1.0, result.relaxation[j] * rate) * added(n, j);
  }
  result.rates = std::move(rates);
  return result;
}

Eigen::Index harmonics_to_add(const Eigen::MatrixXcd& missing, double least, int order,
                              const OrbitCorrectionSettings& settings) {
  const auto most = std::min<Eigen::Index>(settings.shifted * order + 1, missing.rows());
  Eigen::Index count = std::min<Eigen::Index>(settings.fewest_shifted, most);
  while (count < most && series_norm(missing, count) > least) count = std::min(2 * count, most);
  return count;
}

CorrectedOrbit correct_orbit(const Problem& problem, const ContactSpace& space, ExactOrbit first,
                             const OrbitCorrectionSettings& settings, Eigen::MatrixXcd added) {
  return Correction(problem, space, settings, std::move(added)).run(std::move(first));
}

}  // namespace signorini
