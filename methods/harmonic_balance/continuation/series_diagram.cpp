#include "methods/harmonic_balance/continuation/series_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include "methods/continuation/arc_length.hpp"
#include "methods/continuation/method_diagram.hpp"
#include "methods/discretisation/fourier_series.hpp"
#include "methods/harmonic_balance/continuation/series_point.hpp"
#include "methods/harmonic_balance/continuation/series_steps.hpp"
#include "methods/harmonic_balance/continuation/series_symmetry.hpp"
#include "methods/harmonic_balance/series_solution.hpp"
#include "methods/structure/mean_balance.hpp"

namespace signorini {

namespace {

/// Harmonics of a curve where that is left to the method. A branch of the impact oscillator takes a minute
/// with 80, seconds with 40.
constexpr int kMostFollowed = 40;

/// Unknowns up to which a Jacobian is factorised at each point.
constexpr Eigen::Index kMostUnknowns = 3000;

std::vector<int> prime_factors(int n) {
  std::vector<int> factors;
  for (int p = 2; p <= n; ++p) {
    if (n % p != 0) continue;
    factors.push_back(p);
    while (n % p == 0) n /= p;
  }
  return factors;
}

/// Follows a curve by the steps of SeriesSteps, both folds and gains or losses of contact included; its
/// unknowns are labelled by their intervals of contact.
///
/// Located on each step, to rounding of the method's own equations: folds (the frequency's component of the
/// tangent is zero), branch points (det [R_x; tangent^T]), period doublings (doubled_jacobian), and where a
/// contact begins to press or ceases to. Doublings and branch points are starts of other curves.
///
/// Where steps fall below the shortest the branch has broken: `ended` says at which frequency. A motion of
/// several periods ends where it becomes one of a smaller period.
class SeriesTracer final : public CurveTracer<SeriesStart> {
 public:
  /// \param followed   may end the curve
  /// \param doublings  whether these are looked for
  SeriesTracer(const SeriesFamily& family, const SeriesStart& start, const CurveLimits& limits,
               const FollowedCurves& followed, bool doublings)
      : CurveTracer(start, limits, followed),
        steps_(family, start.multiple, limits, doublings),
        series_(steps_.series()) {
    result().branch.sequence = fmt::format("order {}, {} harmonics", series_.order(), series_.harmonics());
  }

  /// Unknowns where a motion without contact first touches.
  [[nodiscard]] const std::vector<Eigen::VectorXd>& grazings() const { return grazings_; }

 private:
  [[nodiscard]] const SeriesStation& station() const { return steps_.here(); }
  [[nodiscard]] double length() const override { return steps_.length(); }
  [[nodiscard]] bool is_leaving() const { return start().leaves_another() && has_one_point(); }

  void begin() override {
    if (!steps_.begin(start())) return finish("the structure resonates undamped");
    append();
  }

  void append() {
    SolutionPoint point = solution_point(series_);
    if (limits().phases > 0)
      point.motion = sample_series(series_.motion(), limits().phases * series_.order());
    // Intervals of contact.
    const auto count = std::reduce(station().intervals.begin(), station().intervals.end());
    CurveTracer::append(std::move(point), station().x, station().slope, count);
  }

  void advance() override {
    auto step = steps_.attempt();
    if (steps_.outside()) return finish("end of the interval");
    if (!step) return;
    if (const int p = divisor(step->next); p > 0) return end_at_smaller_period(p);
    const bool leaves = step->leaves;
    take_events(*step);
    accept(std::move(*step));
    if (leaves && !is_done()) finish("end of the interval");
  }

  // The prime by which the period divides at the end of the step, or on it; 0: none.
  int divisor(const SeriesStation& next) {
    const bool leaving = start().leaves_repetition && has_one_point();
    for (const int p : prime_factors(start().multiple)) {
      const bool turned =
          unrepeated_part(station().x, series_, p).dot(unrepeated_part(next.x, series_, p)) < 0.0;
      if (steps_.repeats(p) || (!leaving && turned)) return p;
    }
    return 0;
  }

  // What follows are motions of the smaller period, or the same once more, a period later.
  void end_at_smaller_period(int p) {
    constexpr double kNear = 1e-3;
    if (steps_.length() > kNear) return steps_.shorten(0.5);
    if (start().leaves_repetition && has_one_point())
      result().rejected = "the corrector fell back on the branch that was to be left";
    finish(fmt::format("the period divides by {}", p));
  }

  // Special points on the step, and the curves that begin there.
  void take_events(const SeriesStep& step) {
    SeriesEvents events = events_on_step(steps_.curve(), station(), step.length, step.next, is_leaving());
    for (SpecialPoint& special : events.special) add(std::move(special));
    std::move(events.others.begin(), events.others.end(), std::back_inserter(result().others));
    if (events.grazing) grazings_.push_back(*std::move(events.grazing));
  }

  void accept(SeriesStep step) {
    if (!steps_.take(std::move(step))) return finish("the structure resonates undamped");
    append();
    if (station().x.head(series_.size()).norm() > kMostGrown) return finish(kGrown);
    end_if_over();
  }

  SeriesSteps steps_;
  SeriesCurve& series_;  // of the steps
  std::vector<Eigen::VectorXd> grazings_;
};

class SeriesDiagram final : public MethodDiagram<SeriesStart> {
 public:
  SeriesDiagram(const SeriesFamily& family, const CurveLimits& limits)
      : MethodDiagram(limits), family_(family) {}

 private:
  std::optional<SeriesStart> contact_free(double frequency) override {
    SeriesCurve curve(family_, 1);
    const bool free = evaluate_without_force(curve, frequency) &&
                      curve.receptance().rigid_count() == 0 &&  // else one of a family, to any mean
                      std::ranges::all_of(curve.contacts(), [](const auto& c) { return c.empty(); });
    return free ? std::optional(into_interval(curve)) : std::nullopt;
  }

  std::optional<SeriesStart> on_curve(const EndAnswer& answer) override {
    SeriesCurve curve(family_, 1);
    if (!evaluate_without_force(curve, answer.problem.frequency)) return std::nullopt;
    const Eigen::VectorXd x =
        curve.unknowns(carried_spectrum(curve.receptance(), *answer.motion), answer.problem.frequency);
    return correct_at_parameter(curve, x) ? std::optional(into_interval(curve)) : std::nullopt;
  }

  static bool evaluate_without_force(SeriesCurve& curve, double frequency) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(curve.size() + 1);
    x[curve.size()] = frequency / curve.family().frequency_unit;
    return curve.evaluate(x);
  }

  [[nodiscard]] SeriesStart into_interval(SeriesCurve& curve) const {
    const bool upwards = family_.is_below_middle(curve.frequency());
    return {.multiple = 1, .x = curve.x(), .tangent = first_tangent(curve, upwards), .origin = {}};
  }

  [[nodiscard]] bool is_known(const SeriesStart& start) const override {
    return !start.leaves_another() && contain(start.multiple, start.x);
  }

  TracedBranch<SeriesStart> trace(const SeriesStart& start) override {
    SeriesTracer tracer(family_, start, limits(), *this, allowed(2 * start.multiple));
    TracedBranch<SeriesStart> traced = tracer.run();
    std::erase_if(traced.others, [&](const SeriesStart& other) { return !allowed(other.multiple); });
    for (const Eigen::VectorXd& grazing : tracer.grazings()) {
      for (int multiple = 2; allowed(multiple); ++multiple)
        if (auto other = grazing_branch(family_, grazing, multiple))
          traced.others.push_back(std::move(*other));
    }
    return traced;
  }

  [[nodiscard]] bool allowed(int multiple) const {
    return multiple == 1 || (multiple * family_.problem.subharmonic <= limits().max_order &&
                             (2 * multiple * family_.harmonics + 1) * contacts() <= kMostUnknowns);
  }

  [[nodiscard]] Eigen::VectorXd begun_later(const Eigen::VectorXd& x, int periods, int shift) const override {
    return signorini::begun_later(x, periods * family_.harmonics, static_cast<double>(shift) / periods);
  }
  [[nodiscard]] double rounding_of(const Eigen::VectorXd& x) const override {
    return signorini::rounding_of(x);
  }

  [[nodiscard]] Eigen::Index contacts() const { return family_.problem.contact_count(); }

  const SeriesFamily& family_;
};

// What the method makes of the scene with so many harmonics.
SeriesFamily family_of(const ParametrisedScene& scene, const HarmonicOptions& options, const LawAt& law_at,
                       int harmonics) {
  SeriesFamily family{curve_family(scene.at(scene.from), scene.from, scene.to)};
  family.harmonics = harmonics;
  family.law_at = law_at;
  const bool sampled = options.contact_integral() == Quadrature::sampled;
  family.integral = sampled ? ContactIntegral::sampled : ContactIntegral::exact;
  family.samples = sampled ? options.fixed_samples(harmonics).value_or(kSampledPerHarmonic * harmonics)
                           : kResolvingSamples * std::max(harmonics, kFewestOnGrid);
  family.opposite = opposite_contacts(family.problem);
  return family;
}

}  // namespace

BranchDiagram series_diagram(const ParametrisedScene& scene, const Method& method,
                             const HarmonicOptions& options, const LawAt& law_at, const CurveLimits& limits) {
  const Problem problem = scene.at(scene.from);
  if (problem.contact_count() == 0) return {.unfinished = "the scene has no contact"};
  const auto unknowns = [&](int harmonics) { return (2 * harmonics + 1) * problem.contact_count(); };
  int harmonics = options.first_harmonics(problem);
  BranchDiagram diagram;
  try {
    std::vector<std::string> notes;
    std::vector<EndAnswer> answers;
    if (unknowns(harmonics) <= kMostUnknowns) answers = end_answers(scene, method, limits, notes);
    int needed = harmonics;
    for (const EndAnswer& answer : answers)
      if (!options.harmonics) needed = std::max(needed, answer.motion->bandwidth().value_or(0));
    harmonics = std::max(harmonics, std::min(needed, kMostFollowed));
    if (needed > harmonics)
      notes.push_back(
          fmt::format("the curve has {} harmonics, answers at its ends take {}; --set harmonics={} follows "
                      "with as many",
                      harmonics, needed, needed));
    if (unknowns(harmonics) > kMostUnknowns)
      return {.unfinished = fmt::format("{} unknowns are more than {}", unknowns(harmonics), kMostUnknowns)};
    const SeriesFamily family = family_of(scene, options, law_at, harmonics);
    diagram = SeriesDiagram(family, limits).run(scene, answers);
    diagram.notes.insert(diagram.notes.begin(), notes.begin(), notes.end());
    const auto loses = [](const Contact& contact) { return restitution_of(contact.law) < 1.0; };
    if (const auto lossy = std::ranges::find_if(problem.contacts, loses); lossy != problem.contacts.end())
      diagram.notes.push_back(fmt::format("curves of harmonic balance have restitution 1, the scene has {:g}",
                                          restitution_of(lossy->law)));
  } catch (const std::runtime_error& error) {  // of a structure that cannot be factorised
    diagram.unfinished = error.what();
  }
  return diagram;
}

}  // namespace signorini
