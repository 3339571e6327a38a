#include "methods/harmonic_balance/continuation/series_steps.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace signorini {

bool SeriesSteps::begin(const SeriesStart& start) {
  if (!series_.evaluate(start.x)) return false;
  here_ = series_station(curve_, start.tangent.normalized(), doublings_);
  if (start.crossed.size() == 0) return true;
  // In the plane of both branches along the direction in which the one that is left stands still: in z, whose
  // lengths differ from those of x.
  const Eigen::VectorXd left = curve_.lifted(start.crossed).normalized();
  const Eigen::VectorXd across = curve_.lifted(start.tangent);
  here_.tangent = (across - across.dot(left) * left).normalized();
  return true;
}

std::optional<SeriesStep> SeriesSteps::attempt() {
  outside_ = false;
  auto iterations = try_step();
  if (iterations && gains_contact()) {
    // The other side of the corner may be another branch.
    if (auto step = begin_contact()) return step;
    iterations = try_step();
  }
  if (!iterations) return refuse(0.4);
  if (!stop_where_contact_ceases()) return refuse(0.5);
  const auto target = this->target();
  const double planned = length_;
  if (target && !shorten_to(*target)) return outside_ ? std::nullopt : refuse(0.5);
  auto step = arrive(*iterations);
  if (!step) return refuse(0.5);
  step->leaves = target && target->leaves;
  if (target && !target->leaves) planned_ = planned;
  return step;
}

bool SeriesSteps::take(SeriesStep step) {
  curve_.follow(step.next.depths);
  if (!curve_.evaluate(step.next.z)) return false;
  here_ = std::move(step.next);
  const double longest =
      longest_step(limits_.step_share * kMethodSteps.longest, here_.x.head(series_.size()).norm());
  length_ = std::max(next_step(length_, step.iterations - 1, step.turn, longest), planned_);
  planned_ = 0.0;
  if (step.beginning) turn_along_depths(*step.beginning);
  return true;
}

bool SeriesSteps::repeats(int p) const {
  constexpr double kSame = 1e-7;  // in the units of the unknowns
  if (!(unrepeated_part(series_.x(), series_, p).norm() < kSame)) return false;
  for (Eigen::Index i = 0; i < curve_.count(); ++i) {
    ContactDepth later = curve_.depths()[static_cast<std::size_t>(i)];
    later.time += 1.0 / p;
    bool same = false;
    for (Eigen::Index j = 0; j < curve_.count(); ++j)
      same = same || (same_extremum(later, curve_.depths()[static_cast<std::size_t>(j)]) &&
                      std::abs(curve_.w()[i] - curve_.w()[j]) < kSame);
    if (!same) return false;
  }
  return true;
}

CurveStep SeriesSteps::whole_step() const {
  return {.x = here_.z, .tangent = here_.tangent, .length = length_};
}

// Newton steps to the end of the step, at which the curve is then evaluated.
std::optional<int> SeriesSteps::try_step() {
  curve_.follow(here_.depths);
  const auto iterations = correct(curve_, here_.z + length_ * here_.tangent, here_.tangent,
                                  {.iterations = 10, .tolerance = 2e-13});
  return iterations && (curve_.z() - here_.z).norm() <= kMethodSteps.far * length_ ? iterations
                                                                                   : std::nullopt;
}

// Where a step is refused: up to where a contact begins, if one does; else shorter.
std::optional<SeriesStep> SeriesSteps::refuse(double factor) {
  auto step = begin_contact();
  if (!step) shorten(factor);
  return step;
}

// Whether a contact presses once more often where the curve is evaluated than at the last point.
bool SeriesSteps::gains_contact() const {
  const std::vector<std::size_t> now = interval_counts(series_);
  return !std::equal(now.begin(), now.end(), here_.intervals.begin(), std::less_equal<>());
}

// Ends a step on which contacts cease where the first of them does.
bool SeriesSteps::stop_where_contact_ceases() {
  constexpr double kZero = 1e-9;  // of w
  ceasing_.reset();
  for (Eigen::Index tries = 0; tries <= curve_.count(); ++tries) {
    Eigen::Index least = 0;
    if (curve_.count() == 0 || curve_.w().minCoeff(&least) >= 0.0) return true;
    const auto depth = [least](DepthCurve& at) { return std::optional(at.w()[least]); };
    const double before = here_.z[series_.size() + least];
    const auto length = locate(curve_, whole_step(), depth, before, curve_.w()[least]);
    if (!length) return false;
    length_ = *length;
    ceasing_ = curve_.depth_here(least);
    if (curve_.w().minCoeff() > -kZero) return true;
  }
  return false;
}

bool SeriesSteps::shorten_to(const StepTarget& target) {
  constexpr double kAtBound = 1e-13;
  const double value = target.value / series_.family().frequency_unit;
  outside_ = target.leaves && std::abs(here_.x[series_.size()] - value) < kAtBound;
  if (outside_) return false;
  const auto length = length_to_parameter(curve_, whole_step(), curve_.z(), value);
  if (length) length_ = *length;
  ceasing_.reset();
  return length.has_value();
}

std::optional<StepTarget> SeriesSteps::target() const {
  return series_.family().target(limits_.at, here_.x, curve_.frequency());
}

// A branch of few unknown changes, as without contact, still has neighbours for points.
bool SeriesSteps::moves_too_far() const {
  return kMethodSteps.moves_too_far(series_.motion(), here_.motion,
                                    kMethodSteps.small * series_.family().displacement_unit);
}

// The step whose end the curve is evaluated at; empty where it may not be taken.
std::optional<SeriesStep> SeriesSteps::arrive(int iterations) {
  SeriesStep step{.next = {}, .length = length_, .iterations = iterations};
  const auto slope = next_slope(step.turn);
  if (!slope || moves_too_far()) return std::nullopt;
  step.next = series_station(curve_, *slope, doublings_);
  return step;
}

// The slope of the curve of x where it is evaluated; empty where the curve has turned too far.
std::optional<Eigen::VectorXd> SeriesSteps::next_slope(double& turn) {
  const auto tangent = tangent_of(curve_, here_.tangent);
  if (!tangent) return std::nullopt;
  turn = std::acos(std::clamp(tangent->dot(here_.tangent), -1.0, 1.0));
  if (turn > kMethodSteps.turned ||
      series_.family().turns_past(limits_.at, whole_step(), curve_.frequency(), *tangent))
    return std::nullopt;
  if (!ceasing_) return curve_.without_depths(*tangent).normalized();
  // Where a depth is zero all else stands still: on along the curve on which that contact is open.
  const Eigen::VectorXd slope = first_tangent(series_);
  return square_rate(series_, *ceasing_, slope) < 0.0 ? slope : Eigen::VectorXd(-slope);
}

// A step to where the next contact, or gap in one, begins.
std::optional<SeriesStep> SeriesSteps::begin_contact() {
  if (series_.family().integral != ContactIntegral::exact) return std::nullopt;
  curve_.follow(here_.depths);
  if (!curve_.evaluate(here_.z)) return std::nullopt;
  const double share = curve_.without_depths(here_.tangent).norm();
  for (const NascentContact& nascent :
       nascent_contacts(series_, here_.slope, kMethodSteps.far * length_ * share)) {
    const bool followed = std::any_of(here_.depths.begin(), here_.depths.end(),
                                      [&](const auto& depth) { return same_extremum(depth, nascent.depth); });
    if (followed) continue;
    if (auto step = begin_contact(nascent, nascent.distance / share)) return step;
  }
  return std::nullopt;
}

std::optional<SeriesStep> SeriesSteps::begin_contact(const NascentContact& nascent, double distance) {
  std::vector<ContactDepth> depths = here_.depths;
  depths.push_back(nascent.depth);
  curve_.follow(depths);
  const Eigen::Index last = series_.size() + curve_.count() - 1;  // place of the new depth
  const Eigen::VectorXd end = here_.z + distance * here_.tangent;
  Eigen::VectorXd predicted(last + 2);
  predicted << end.head(last), 0.0, end[last];
  if (!correct(curve_, predicted, Eigen::VectorXd::Unit(last + 2, last), {.iterations = 15}))
    return std::nullopt;
  const Eigen::VectorXd z = curve_.with_depths(series_.x(), curve_.w().head(curve_.count() - 1));
  const bool beyond = (z - here_.z).norm() > kMethodSteps.far * distance;
  if (beyond || !(here_.slope.dot(series_.x() - here_.x) > 0.0)) return std::nullopt;
  const ContactDepth beginning = curve_.depth_here(curve_.count() - 1);
  curve_.follow(here_.depths);
  if (!curve_.evaluate(z) || target()) return std::nullopt;
  ceasing_.reset();
  auto step = arrive(3);  // as after so many iterations: the length of a step stays about the same
  // Where the square falls again the contact began before.
  if (!step || !(square_rate(series_, beginning, step->next.slope) > 0.0)) return std::nullopt;
  length_ = step->length = here_.tangent.dot(z - here_.z);
  step->beginning = beginning;
  return step;
}

// Takes the depths of all contacts that begin here for unknowns, and the direction in which they grow: each
// square as fast as along the curve on which they are open.
void SeriesSteps::turn_along_depths(const ContactDepth& first) {
  std::vector<ContactDepth> beginning{first};
  for (const NascentContact& other : nascent_contacts(series_, here_.slope, 0.0))
    if (!same_extremum(first, other.depth)) beginning.push_back(other.depth);
  // Rounding may have the contact that begins for one that is there already, short as it is.
  std::vector<ContactDepth> followed;
  std::vector<double> w, rates;
  for (std::size_t i = 0; i < here_.depths.size(); ++i) {
    if (same_extremum(first, here_.depths[i])) continue;
    followed.push_back(here_.depths[i]);
    w.push_back(here_.z[series_.size() + static_cast<Eigen::Index>(i)]);
    rates.push_back(0.0);
  }
  for (const ContactDepth& depth : beginning) {
    followed.push_back(depth);
    w.push_back(0.0);
    rates.push_back(std::sqrt(std::max(0.0, square_rate(series_, depth, here_.slope))));
  }
  here_.depths = std::move(followed);
  curve_.follow(here_.depths);
  using Values = Eigen::Map<const Eigen::VectorXd>;
  here_.z = curve_.with_depths(here_.x, Values(w.data(), curve_.count()));
  here_.tangent =
      curve_.with_depths(Eigen::VectorXd::Zero(here_.x.size()), Values(rates.data(), curve_.count()))
          .normalized();
  length_ = kMethodSteps.first;
}

}  // namespace signorini
