#include "methods/exact_orbit/exact_diagram.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "methods/orbit/continuation/branch_section.hpp"
#include "methods/orbit/continuation/diagram.hpp"
#include "methods/orbit/continuation/linear_mode_starts.hpp"
#include "methods/orbit/exact_trajectory.hpp"
#include "methods/orbit/orbit_guess.hpp"
#include "methods/orbit/reduced/reduced_orbit.hpp"
#include "methods/orbit/starts/one_impact_orbits.hpp"

namespace signorini {

namespace {

constexpr int kValues = 11;  // inside the interval

class Beginnings {
 public:
  Beginnings(OrbitFamily& family, const Method& method, const CurveLimits& limits)
      : family_(family), method_(method), limits_(limits) {}

  std::vector<SequencedOrbit> find() {
    if (family_.driven()) {
      add_contact_free();
      add_answers();
    } else {
      add_linear_modes();
    }
    add_one_impact();
    for (const KnownMotion& known : limits_.begin_at)
      if (family_.driven()) attempt([&] { add(known); });
    if (orbits_.empty() && failure_) std::rethrow_exception(failure_);
    return std::move(orbits_);
  }

  /// Of nonlinear modes whose linear one lies in the interval.
  std::vector<CurveStart> starts() { return std::move(starts_); }

  /// The least of these [J].
  [[nodiscard]] double least_energy() const { return least_energy_; }

  /// What the method answers at a value of the parameter, within a share of the time that is left.
  std::vector<SequencedOrbit> answers_at(double parameter) {
    orbits_.clear();
    if (family_.driven()) add_answer(parameter, Deadline::first_of(limits_.deadline, share_of_time()));
    return std::move(orbits_);
  }

  /// Why `find` has found none.
  [[nodiscard]] std::string reason() const {
    return (family_.driven() ? "no orbit was found to begin from"
                             : "no free motion was found to begin from") +
           (refusal_.empty() ? "" : ": " + refusal_);
  }

 private:
  void add_contact_free() {
    for (const double end : {family_.scene().from, family_.scene().to})
      if (auto free = contact_free_orbit(family_, end)) orbits_.push_back(std::move(*free));
  }

  // The nonlinear modes, those whose linear one lies outside the interval followed up to it.
  void add_linear_modes() {
    const ParametrisedScene& scene = family_.scene();
    refusal_ = "nonlinear modes are followed over the frequency or the energy";
    if (scene.parameter != kFrequency) return;
    LinearModeStarts found = linear_mode_starts(family_);
    refusal_ = found.obstacle;
    if (found.starts.empty() && refusal_.empty())
      refusal_ = "no mode that reaches a stop has a frequency in the interval at any energy";
    for (LinearModeStart& mode : found.starts) {
      least_energy_ = std::min(least_energy_, mode.energy);
      if (scene.contains(mode.frequency))
        starts_.push_back(std::move(mode.start));
      else
        follow_to_interval(std::move(mode));
    }
  }

  void follow_to_interval(LinearModeStart mode) {
    constexpr double kBeside = 1e-6;  // of the frequency: the mode begins inside
    const bool below = mode.frequency < family_.scene().low();
    ParametrisedScene wider = family_.scene();
    wider.from = (below ? 1.0 - kBeside : 1.0 + kBeside) * mode.frequency;
    wider.to = below ? family_.scene().low() : family_.scene().high();
    OrbitFamily before(wider, family_.units());
    CurveLimits limits = limits_;
    limits.take = {};
    limits.at.clear();
    limits.max_order = 1;
    for (const OrbitBranch& branch :
         trace_diagram(before, {}, limits, {}, {std::move(mode.start)}).branches) {
      for (SequencedOrbit& orbit : orbits_at(family_, branch, wider.to)) orbits_.push_back(std::move(orbit));
    }
  }

  void add_answers() {
    const Deadline share = share_of_time();  // for those inside
    add_answer(family_.scene().from, limits_.deadline);
    add_answer(family_.scene().to, limits_.deadline);
    for (int i = 0; i < kValues && !share.passed(); ++i) add_answer(value_inside(i), limits_.deadline);
  }

  // A tenth of what is left.
  [[nodiscard]] Deadline share_of_time() const {
    return Deadline::after(std::max(0.0, 0.1 * limits_.deadline.left()));
  }

  void add_answer(double parameter, const Deadline& deadline) {
    const Problem problem = family_.scene().at(parameter);
    if (limits_.expired() || prefers_reduction(problem)) return;
    if (const Support support = method_.supports(problem); !support.ok) {
      refusal_ = support.reason;
      return;
    }
    attempt([&] {
      const Solution solution = method_.prepare(problem)->solve({.guess = {}, .deadline = deadline});
      if (solution.verdict == Verdict::converged)
        add({parameter, solution.trajectory});
      else
        refusal_ = solution.message;
    });
  }

  // What may fail by a resonance, or by a mean load that nothing balances.
  void attempt(const std::function<void()>& work) {
    try {
      work();
    } catch (const std::runtime_error&) {
      failure_ = std::current_exception();
    }
  }

  void add_one_impact() {
    const int contacts = family_.scene().at(family_.scene().from).contact_count();
    for (int i = 0; i < kValues && !limits_.expired(); ++i) {
      for (int order = 1; order <= (family_.driven() ? limits_.max_order : 1); ++order) {
        for (int contact = 0; contact < contacts; ++contact) {
          for (SequencedOrbit& orbit : one_impact_orbits(family_, value_inside(i), contact, order))
            orbits_.push_back(std::move(orbit));
        }
      }
    }
  }

  void add(const KnownMotion& known) {
    const Problem problem = family_.scene().at(known.parameter);
    if (!known.motion || prefers_reduction(problem)) return;  // an orbit of the reduced structure
    const double period = known.motion->period();
    const auto order = static_cast<int>(std::lround(period * problem.frequency / kTwoPi));
    if (order < 1 || order > std::max(limits_.max_order, problem.subharmonic)) return;
    if (const auto exact = std::dynamic_pointer_cast<const ExactTrajectory>(known.motion)) {
      orbits_.push_back(sequenced(family_, exact->orbit(), period, problem.frequency, known.parameter));
      return;
    }
    OrbitModel model(with_subharmonic(problem, order));
    if (const auto orbit = orbit_guess(model, *known.motion))
      orbits_.push_back(sequenced(family_, *orbit, period, problem.frequency, known.parameter));
  }

  // No fraction of the interval that its ends or a resonance would make a special one.
  [[nodiscard]] double value_inside(int i) const {
    const ParametrisedScene& scene = family_.scene();
    return scene.from + (i + 0.47) / kValues * (scene.to - scene.from);
  }

  OrbitFamily& family_;
  const Method& method_;
  const CurveLimits& limits_;
  std::vector<SequencedOrbit> orbits_;
  std::vector<CurveStart> starts_;
  double least_energy_ = std::numeric_limits<double>::infinity();
  std::exception_ptr failure_;  // of the last answer that could not be asked for
  std::string refusal_;         // of the last answer that is none, or of the modes
};

// The parts of a branch of free motions within an interval of their energy, which becomes the parameter.
std::vector<OrbitBranch> within(const OrbitBranch& branch, const ParametrisedScene& energies) {
  constexpr double kRounding = 1e-10;
  const double margin = kRounding * std::max(std::abs(energies.low()), std::abs(energies.high()));
  const auto inside = [&](const SolutionPoint& point) {
    return *point.energy >= energies.low() - margin && *point.energy <= energies.high() + margin;
  };
  std::vector<OrbitBranch> parts;
  const std::size_t count = branch.points.size();
  for (std::size_t begin = 0; begin < count; ++begin) {
    if (!inside(branch.points[begin])) continue;
    std::size_t end = begin;
    OrbitBranch part;
    part.sequence = branch.sequence;
    for (; end < count && inside(branch.points[end]); ++end) {
      part.points.push_back(branch.points[end]);
      part.points.back().parameter = *branch.points[end].energy;
      part.orbits.push_back(branch.orbits[end]);
    }
    for (std::size_t k = 0; k < branch.special.size(); ++k) {
      const SpecialPoint& special = branch.special[k];
      if (special.after < begin || special.after > end || !inside(special.point)) continue;
      part.special.push_back(special);
      part.special.back().after -= begin;
      part.special.back().point.parameter = *special.point.energy;
      part.special_orbits.push_back(branch.special_orbits[k]);
    }
    part.began = begin == 0 ? branch.began : kEndOfInterval;
    part.ended = end == count ? branch.ended : kEndOfInterval;
    if (part.points.size() > 1) parts.push_back(std::move(part));
    begin = end;
  }
  return parts;
}

// Free motions over their energy: their frequency is an unknown of the curves all the same.
OrbitDiagram energy_diagram(const ParametrisedScene& scene, const Method& method, const CurveLimits& limits) {
  const Problem problem = scene.at(scene.middle());
  const auto band = free_motion_band(problem);
  if (!band)
    return {.unfinished = problem.contact_count() == 0 ? "there is no contact"
                                                       : "no spring holds the structure in place"};
  OrbitFamily family(over_frequency(problem, band->low, band->high));
  CurveLimits inner = limits;
  inner.at.push_back(scene.low());
  inner.take = {};
  Beginnings beginnings(family, method, limits);
  const std::vector<SequencedOrbit> orbits = beginnings.find();
  const ParameterRange energies{.low = std::min(scene.low(), (1.0 - 1e-9) * beginnings.least_energy()),
                                .high = scene.high()};
  OrbitDiagram diagram = trace_diagram(family, orbits, inner, {}, beginnings.starts(), energies);
  std::vector<OrbitBranch> parts;
  for (const OrbitBranch& branch : diagram.branches) {
    for (OrbitBranch& part : within(branch, scene)) {
      if (limits.take) limits.take(part);
      parts.push_back(std::move(part));
    }
  }
  diagram.branches = std::move(parts);
  if (diagram.branches.empty() && diagram.unfinished.empty() && diagram.notes.empty())
    diagram.unfinished = beginnings.reason();
  return diagram;
}

}  // namespace

OrbitDiagram exact_diagram(const ParametrisedScene& scene, const Method& method, const CurveLimits& limits) {
  if (scene.parameter == kEnergy) return energy_diagram(scene, method, limits);
  OrbitFamily family(scene);
  Beginnings beginnings(family, method, limits);
  const std::vector<SequencedOrbit> orbits = beginnings.find();
  OrbitDiagram diagram = trace_diagram(
      family, orbits, limits, [&](double parameter) { return beginnings.answers_at(parameter); },
      beginnings.starts());
  if (diagram.branches.empty() && diagram.unfinished.empty() && diagram.notes.empty())
    diagram.unfinished = beginnings.reason();
  return diagram;
}

}  // namespace signorini
