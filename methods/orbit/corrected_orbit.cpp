#include "methods/orbit/corrected_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <optional>
#include <utility>

#include "methods/discretisation/fourier_series.hpp"
#include "methods/linear_flow/shared_modes.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

// Instants at which two orbits are compared.
constexpr int kComparedInstants = 1024;
// Rate of the corrections beyond which they are not trusted to converge.
constexpr double kSlowestCorrection = 0.5;
// Part of the other terms of the bar below which a smaller defect tells
// nothing.
constexpr double kNegligible = 0.05;
constexpr double kBarSafety = 2.0;
constexpr int kFewestShifted = 25;
// Defects below are rounding, and so is what they change.
constexpr double kTellingDefect = 1e-13;
// Displacements by which the amplification is measured, relative to x: as large
// as what is left, within these.
constexpr double kLeastProbe = 1e-10, kLargestProbe = 1e-6;
constexpr int kProbes = 4;
// Harmonics of the response to a change of K that are looked at for resonances.
constexpr int kResonanceHarmonics = 32;

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

/// The size of x about its mean in the root mean square over time and contacts
/// [m].
double fluctuation(const Eigen::MatrixXd& x) {
  return std::sqrt((x.rowwise() - x.colwise().mean()).array().square().mean());
}

bool same_sequence(const ExactTrajectory& a, const ExactTrajectory& b) {
  const auto& first = a.orbit().events;
  const auto& second = b.orbit().events;
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const SequenceEvent& e, const SequenceEvent& f) {
                      return e.kind == f.kind && e.contact == f.contact && e.closed == f.closed;
                    });
}

/// What a correction by the first `added` harmonics of these displacements may leave of them [m].
double left_by_correction(const Eigen::MatrixXcd& missing, Eigen::Index added) {
  constexpr double kTypicalRate = 0.1;
  return kTypicalRate * series_norm(missing.topRows(added)) + series_norm(missing, added);
}

/// The space with more vectors to check with, where the bound of those that there are is above `wanted` [m];
/// and with those to solve on that a correction by `added` harmonics leaves less of. Whether there is a
/// change.
bool grow_for(ContactSpace& space, double base, const Eigen::MatrixXcd& force, double wanted,
              Eigen::Index added) {
  if (!(space.bound_size(base, force) > wanted)) return false;
  space = space.grown_for(base, {{.force = force, .tolerance = wanted}});
  const ContactSpace other = space.solved_on_lowest();
  if (left_by_correction(other.missing(base, force), added) <
      left_by_correction(space.missing(base, force), added))
    space = other;
  return true;
}

/// One deferred correction of a scene.
class Correction {
 public:
  Correction(const Problem& problem, const ContactSpace& space, const OrbitCorrectionSettings& settings)
      : problem_(problem),
        space_(space),
        settings_(settings),
        model_(space.small()),
        base_(problem.base_frequency()),
        shared_(std::make_shared<SharedModes>()) {}

  CorrectedOrbit run(ExactOrbit first) {
    result_.orbit = std::move(first);
    for (int correction = 0;; ++correction) {
      if (!result_.orbit.certified()) return refused("no admissible orbit: " + result_.orbit.reason);
      if (!measure()) return refused("the motion between events is not known as a sum of modes");
      if (correction > 0 && enough()) break;
      if (correction == settings_.corrections || (correction > 1 && rate() > kSlowestCorrection)) break;
      correct();
    }
    if (!enough() && rate() > kSlowestCorrection)
      return refused("the corrections do not converge: more vectors are needed");
    if (!settled_) return refused("the last correction changed the sequence of events");
    if (!probe())
      return refused(
          "displacements as small as what is left change the "
          "sequence of events");
    conclude();
    return std::move(result_);
  }

 private:
  CorrectedOrbit refused(std::string why) {
    result_.refusal = std::move(why);
    return std::move(result_);
  }

  /// Defect of the present orbit, and by how much it has changed. False without
  /// its force.
  bool measure() {
    const ExactTrajectory& orbit = *result_.orbit.trajectory;
    const int order = problem_.subharmonic, harmonics = settings_.harmonics * order;
    const Eigen::MatrixXcd force = orbit.force_spectrum(harmonics);
    if (force.size() == 0) return false;
    const Eigen::MatrixXd x = orbit.sample(kComparedInstants * order).x;
    size_ = fluctuation(x);
    if (!(size_ > 0.0)) size_ = 1.0;
    const Eigen::MatrixXcd solved = contact_response(model_, base_, force);
    const double wanted = std::max(settings_.tolerance, kNegligible * rounding(x)) * size_;
    changed_ = grow_for(space_, base_, force, wanted, most_shifted()) || changed_;
    result_.vectors = space_.whole().vectors();
    missing_ = space_.missing(base_, force);
    Eigen::MatrixXcd defect = contact_response(space_.whole(), base_, force) - solved;
    if (added_.rows() > 0) defect.topRows(added_.rows()) -= added_;
    if (!result_.defects.empty()) {
      const double change = std::sqrt((x - x_).array().square().mean()) / size_;
      if (result_.defects.back() > kTellingDefect)
        result_.amplification = std::max(result_.amplification, change / result_.defects.back());
    }
    result_.peak = sample_series(defect, 2 * harmonics).cwiseAbs().maxCoeff() / size_;
    result_.tail = beyond(defect) / size_;
    const Eigen::MatrixXcd bound = space_.bound(base_, force).cast<std::complex<double>>();
    result_.outside = (series_norm(bound) + beyond(bound)) / size_;
    result_.rounding = rounding(x);
    if (added_.rows() == 0) shifted_ = shifted();
    result_.defects.push_back(series_norm(defect.topRows(shifted_)) / size_);
    result_.unshifted = series_norm(defect, shifted_) / size_;
    x_ = x;
    return true;
  }

  /// What the rounding of K's factors does to x.
  [[nodiscard]] double rounding(const Eigen::MatrixXd& x) const {
    return space_.rounding() /
           space_.distance_from_resonance(base_, kResonanceHarmonics * problem_.subharmonic) *
           std::sqrt(x.array().square().mean()) / size_;
  }

  /// The next orbit, from the present one.
  void correct() {
    added_ = missing_.topRows(shifted_);
    if (std::exchange(changed_, false)) {
      model_ = space_.small();
      shared_ = std::make_shared<SharedModes>();
    }
    OrbitFinder finder(problem_, displaced(model_, added_, base_), shared_);
    const std::shared_ptr<const ExactTrajectory> before = result_.orbit.trajectory;
    OrbitSearch found = finder.find(before->orbit(), settings_.search);
    result_.iterations += found.iterations;
    result_.orbit = std::move(found.orbit);
    settled_ = result_.orbit.trajectory && same_sequence(*before, *result_.orbit.trajectory);
  }

  /// How much more than themselves displacements change x. The first is x
  /// itself, as an error of the compliance would be; each further one is what
  /// the one before has changed, so that they turn to where x answers most.
  /// False where one of them changes the events.
  bool probe() {
    const Eigen::Index instants = x_.rows();
    const double least = std::clamp(result_.defects.back() + rest(), kLeastProbe, kLargestProbe);
    Eigen::MatrixXd change = x_.rowwise() - x_.colwise().mean();
    for (int k = 0; k < kProbes; ++k) {
      Eigen::MatrixXcd moved = force_spectrum(change, {}, problem_.period(), static_cast<int>(shifted_) - 1);
      const double norm = series_norm(moved);
      if (!(norm > 0.0)) return true;
      moved *= least * size_ / norm;
      OrbitFinder finder(problem_, displaced(model_, added_ + moved, base_), shared_);
      const OrbitSearch found = finder.find(result_.orbit.trajectory->orbit(), settings_.search);
      result_.iterations += found.iterations;
      if (!found.orbit.certified() || !same_sequence(*found.orbit.trajectory, *result_.orbit.trajectory))
        return false;
      change = found.orbit.trajectory->sample(static_cast<int>(instants)).x - x_;
      const double ratio = std::sqrt(change.array().square().mean()) / (least * size_);
      result_.amplification = std::max(result_.amplification, ratio);
    }
    return true;
  }

  [[nodiscard]] Eigen::Index most_shifted() const {
    return std::min(settings_.shifted, settings_.harmonics) * problem_.subharmonic + 1;
  }

  /// Harmonics that are added, the constant included: so many that the others
  /// are below the rest of the bar.
  [[nodiscard]] Eigen::Index shifted() const {
    const auto most = std::min<Eigen::Index>(settings_.shifted * problem_.subharmonic + 1, missing_.rows());
    const double least = std::max(settings_.tolerance, result_.tail + result_.outside + result_.rounding);
    Eigen::Index count = std::min<Eigen::Index>(kFewestShifted, most);
    while (count < most && series_norm(missing_, count) > least * size_) count = std::min(2 * count, most);
    return count;
  }

  /// How the last defect compares with the one before.
  [[nodiscard]] double rate() const {
    const std::size_t count = result_.defects.size();
    if (count < 2 || result_.defects[count - 2] == 0.0) return 0.0;
    return result_.defects[count - 1] / result_.defects[count - 2];
  }

  /// What corrections do not reduce.
  [[nodiscard]] double rest() const {
    return result_.unshifted + result_.tail + result_.outside + result_.rounding;
  }

  [[nodiscard]] bool enough() const {
    const double defect = result_.defects.back();
    return kBarSafety * result_.amplification * defect <= settings_.tolerance ||
           defect <= kNegligible * rest();
  }

  void conclude() {
    const double fallen = 1.0 - std::min(rate(), kSlowestCorrection);
    const double own = result_.orbit.error_bar * scale() / size_;
    result_.bar = kBarSafety * result_.amplification * (result_.defects.back() / fallen + rest()) + own;
  }

  /// X, in which the orbit's own error bar is.
  [[nodiscard]] double scale() const { return result_.orbit.trajectory->scales().displacement; }

  const Problem& problem_;
  ContactSpace space_;
  const OrbitCorrectionSettings& settings_;
  ContactReduction model_;  // that the present orbit is one of
  bool changed_ = false;    // whether the space has other vectors to solve on since
  double base_, size_ = 1.0;
  Eigen::Index shifted_ = 0;  // harmonics added
  std::shared_ptr<SharedModes> shared_;
  Eigen::MatrixXcd missing_, added_;  // of the present orbit, and in it
  Eigen::MatrixXd x_;
  bool settled_ = true;
  CorrectedOrbit result_;
};

}  // namespace

CondensedStructure displaced(const ContactReduction& reduction, const Eigen::MatrixXcd& added, double base) {
  CondensedStructure result = condensed(reduction);
  std::vector<double> rates;
  for (Eigen::Index n = 0; n < added.rows(); ++n) rates.push_back(static_cast<double>(n) * base);
  std::vector<Eigen::Index> column;  // of the load's harmonics
  for (const double rate : reduction.rates) {
    const auto n = static_cast<Eigen::Index>(std::lround(rate / base));
    while (static_cast<Eigen::Index>(rates.size()) <= n)
      rates.push_back(static_cast<double>(rates.size()) * base);
    rates[static_cast<std::size_t>(n)] = rate;  // as it is, to the last digit
    column.push_back(n);
  }
  const auto count = static_cast<Eigen::Index>(rates.size());
  result.load = Eigen::MatrixXcd::Zero(reduction.vectors(), count);
  result.shift = Eigen::MatrixXcd::Zero(reduction.contacts(), count);
  for (std::size_t h = 0; h < column.size(); ++h) {
    result.load.col(column[h]) = reduction.load.col(static_cast<Eigen::Index>(h));
    result.shift.col(column[h]) = reduction.shift.col(static_cast<Eigen::Index>(h));
  }
  for (Eigen::Index n = 0; n < added.rows(); ++n) {
    const std::complex<double> relaxed(1.0, result.relaxation * rates[static_cast<std::size_t>(n)]);
    result.shift.col(n) += (n == 0 ? 1.0 : 2.0) * relaxed * added.row(n).transpose();
  }
  result.rates = std::move(rates);
  return result;
}

CorrectedOrbit correct_orbit(const Problem& problem, const ContactSpace& space, ExactOrbit first,
                             const OrbitCorrectionSettings& settings) {
  return Correction(problem, space, settings).run(std::move(first));
}

}  // namespace signorini
