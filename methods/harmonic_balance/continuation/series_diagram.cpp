#include "methods/harmonic_balance/continuation/series_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <deque>
#include <numbers>
#include <optional>
#include <utility>

#include "methods/continuation/arc_length.hpp"
#include "methods/discretisation/fourier_series.hpp"
#include "methods/harmonic_balance/continuation/series_symmetry.hpp"
#include "methods/harmonic_balance/series_solution.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

/// Unknowns up to which a Jacobian is factorised at each point.
constexpr Eigen::Index kMostUnknowns = 3000;

class SeriesDiagram {
 public:
  SeriesDiagram(SeriesFamily family, const SeriesMethod& method, const CurveLimits& limits)
      : family_(std::move(family)), method_(method), limits_(limits) {}

  BranchDiagram run(double from, double to) {
    for (const double frequency : {from, to}) add_contact_free(frequency);
    for (const double frequency : {from, to}) add_answer(frequency);
    if (starts_.empty() && diagram_.unfinished.empty())
      diagram_.unfinished = "the method has no answer at either end of the interval";
    while (!starts_.empty() && diagram_.unfinished.empty()) trace_next();
    return std::move(diagram_);
  }

 private:
  // The motion without contact forces, which solves the equations where it stays off every stop.
  void add_contact_free(double frequency) {
    SeriesCurve curve(family_, 1);
    const Eigen::MatrixXcd none = Eigen::MatrixXcd::Zero(curve.harmonics() + 1, contacts());
    if (!curve.evaluate(curve.unknowns(none, frequency))) return;
    const bool free = std::all_of(curve.contacts().begin(), curve.contacts().end(),
                                  [](const auto& c) { return c.empty(); });
    if (free) add_start(curve, "contact-free motion");
  }

  // The method's own answer, corrected to the equations of the curve.
  void add_answer(double frequency) {
    Problem problem = family_.problem;
    problem.frequency = frequency;
    const Solution solution = method_.prepare(problem)->solve({.guess = {}, .deadline = limits_.deadline});
    if (solution.verdict != Verdict::converged || !solution.trajectory) {
      diagram_.notes.push_back(
          fmt::format("no answer of the method at {:.10g} rad/s: {}", frequency, solution.message));
      return;
    }
    SeriesCurve curve(family_, 1);
    const Eigen::VectorXd x =
        curve.unknowns(force_spectrum(*solution.trajectory, curve.harmonics()), frequency);
    if (correct_at_parameter(curve, x))
      add_start(curve, "answer of the method");
    else
      diagram_.notes.push_back(
          fmt::format("the answer of the method at {:.10g} rad/s is not on a curve", frequency));
  }

  // Into the interval from one of its ends.
  void add_start(SeriesCurve& curve, const std::string& origin) {
    const bool upwards = curve.frequency() < 0.5 * (family_.low + family_.high);
    starts_.push_back({.multiple = curve.multiple(),
                       .x = curve.x(),
                       .tangent = first_tangent(curve, upwards),
                       .origin = fmt::format("{} at {:.10g} rad/s", origin, curve.frequency())});
  }

  void trace_next() {
    // Motions of the shortest period first.
    const auto next =
        std::min_element(starts_.begin(), starts_.end(),
                         [](const SeriesStart& a, const SeriesStart& b) { return a.multiple < b.multiple; });
    const SeriesStart start = std::move(*next);
    starts_.erase(next);
    if (!start.leaves_repetition && start.crossed.size() == 0 && known(start.multiple, start.x)) return;
    if (static_cast<int>(diagram_.branches.size()) >= limits_.max_branches) {
      diagram_.unfinished = fmt::format("limit of {} branches", limits_.max_branches);
      return;
    }
    TracedSeries traced = trace_series(
        family_, start, limits_, allowed(2 * start.multiple),
        [&](const Eigen::VectorXd& x, std::size_t intervals) { return known(start.multiple, x, intervals); });
    if (limits_.expired()) diagram_.unfinished = "the time is up";
    if (!traced.rejected.empty()) {
      diagram_.notes.push_back(fmt::format("{}: {}", start.origin, traced.rejected));
      return;
    }
    for (SeriesStart& other : traced.others)
      if (allowed(other.multiple)) starts_.push_back(std::move(other));
    for (const Eigen::VectorXd& grazing : traced.grazings) add_grazing_branches(grazing);
    diagram_.branches.push_back(traced.branch);
    if (limits_.take) limits_.take(traced.branch);
    traced_.push_back(std::move(traced));
  }

  void add_grazing_branches(const Eigen::VectorXd& grazing) {
    for (int multiple = 2; allowed(multiple); ++multiple) {
      if (auto start = grazing_branch(family_, grazing, multiple)) starts_.push_back(std::move(*start));
    }
  }

  [[nodiscard]] bool allowed(int multiple) const {
    return multiple == 1 || (multiple * family_.problem.subharmonic <= limits_.max_order &&
                             (2 * multiple * family_.harmonics + 1) * contacts() <= kMostUnknowns);
  }

  [[nodiscard]] Eigen::Index contacts() const { return family_.problem.contact_count(); }

  // Whether unknowns lie on a branch that was followed, at any of the periods that they may be shifted by,
  // where it has so many intervals of contact.
  [[nodiscard]] bool known(int multiple, const Eigen::VectorXd& x,
                           std::optional<std::size_t> intervals = {}) const {
    for (int shift = 0; shift < multiple; ++shift) {
      const double share = static_cast<double>(shift) / multiple;
      const Eigen::VectorXd later = begun_later(x, multiple * family_.harmonics, share);
      for (const TracedSeries& traced : traced_)
        if (traced.multiple == multiple && traced.points.pass_by(later, rounding_of(later), intervals))
          return true;
    }
    return false;
  }

  SeriesFamily family_;
  const SeriesMethod& method_;
  const CurveLimits& limits_;
  std::deque<SeriesStart> starts_;
  std::vector<TracedSeries> traced_;
  BranchDiagram diagram_;
};

}  // namespace

BranchDiagram series_diagram(const ParametrisedScene& scene, const SeriesMethod& method,
                             const CurveLimits& limits) {
  const double from = scene.from, to = scene.to;
  const Problem problem = scene.at(from);
  if (problem.contact_count() == 0) return {.unfinished = "the scene has no contact"};
  SeriesFamily family = series_family(problem, from, to);
  family.harmonics = method.options.first_harmonics(problem);
  if ((2 * family.harmonics + 1) * problem.contact_count() > kMostUnknowns)
    return {.unfinished = fmt::format("{} unknowns are more than {}",
                                      (2 * family.harmonics + 1) * problem.contact_count(), kMostUnknowns)};
  family.law_at = method.law_at;
  const bool sampled = method.options.contact_integral() == Quadrature::sampled;
  family.integral = sampled ? ContactIntegral::sampled : ContactIntegral::exact;
  family.samples = sampled ? method.options.fixed_samples(family.harmonics).value_or(32 * family.harmonics)
                           : kResolvingSamples * std::max(family.harmonics, kFewestOnGrid);
  try {
    family.opposite = opposite_contacts(family.problem);
    BranchDiagram diagram = SeriesDiagram(std::move(family), method, limits).run(from, to);
    const auto* law = std::get_if<Restitution>(&problem.law);
    if (law != nullptr && law->e < 1.0)
      diagram.notes.push_back(
          fmt::format("curves of harmonic balance have restitution 1, the scene has {:g}", law->e));
    return diagram;
  } catch (const std::runtime_error& error) {  // of a structure that cannot be factorised
    return {.unfinished = error.what()};
  }
}

}  // namespace signorini
