#include "methods/exact_orbit/exact_diagram.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "methods/orbit/continuation/diagram.hpp"
#include "methods/orbit/continuation/one_impact_orbits.hpp"
#include "methods/orbit/exact_trajectory.hpp"
#include "methods/orbit/orbit_guess.hpp"
#include "methods/orbit/reduced/reduced_orbit.hpp"

namespace signorini {

namespace {

constexpr int kValues = 11;  // inside the interval

class Beginnings {
 public:
  Beginnings(OrbitFamily& family, const Method& method, const CurveLimits& limits)
      : family_(family), method_(method), limits_(limits) {}

  std::vector<SequencedOrbit> find() {
    if (family_.driven()) {  // else at rest
      add_contact_free();
      add_answers();
    }
    add_one_impact();
    for (const KnownMotion& known : limits_.begin_at)
      if (family_.driven()) add(known);
    if (orbits_.empty() && failure_) std::rethrow_exception(failure_);
    return std::move(orbits_);
  }

  /// What the method answers at a value of the parameter, within a share of the time that is left.
  std::vector<SequencedOrbit> answers_at(double parameter) {
    orbits_.clear();
    if (family_.driven()) add_answer(parameter, Deadline::first_of(limits_.deadline, share_of_time()));
    return std::move(orbits_);
  }

  /// Why `find` has found none.
  [[nodiscard]] std::string reason() const {
    if (!family_.driven())
      return "no free motion was found to begin from: those of one impact on a rigid stop are looked for";
    return "no orbit was found to begin from" + (refusal_.empty() ? "" : ": " + refusal_);
  }

 private:
  void add_contact_free() {
    for (const double end : {family_.scene().from, family_.scene().to})
      if (auto free = contact_free_orbit(family_, end)) orbits_.push_back(std::move(*free));
  }

  void add_answers() {
    const Deadline share = share_of_time();  // for those inside
    add_answer(family_.scene().from, limits_.deadline);
    add_answer(family_.scene().to, limits_.deadline);
    for (int i = 0; i < kValues && !share.passed(); ++i) add_answer(value_inside(i), limits_.deadline);
  }

  [[nodiscard]] Deadline share_of_time() const {
    constexpr double kShare = 0.1;
    return Deadline::after(std::max(0.0, kShare * limits_.deadline.left()));
  }

  void add_answer(double parameter, const Deadline& deadline) {
    const Problem problem = family_.scene().at(parameter);
    if (limits_.expired() || prefers_reduction(problem)) return;
    if (const Support support = method_.supports(problem); !support.ok) {
      refusal_ = support.reason;
      return;
    }
    try {
      const Solution solution = method_.prepare(problem)->solve({.guess = {}, .deadline = deadline});
      if (solution.verdict == Verdict::converged)
        add({parameter, solution.trajectory});
      else
        refusal_ = solution.message;
    } catch (const std::runtime_error&) {  // a resonance, or a mean load that nothing balances
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
  std::exception_ptr failure_;  // of the last answer that could not be asked for
  std::string refusal_;         // of the last answer that is none
};

}  // namespace

OrbitDiagram exact_diagram(const ParametrisedScene& scene, const Method& method, const CurveLimits& limits) {
  OrbitFamily family(scene);
  Beginnings beginnings(family, method, limits);
  OrbitDiagram diagram = trace_diagram(family, beginnings.find(), limits,
                                       [&](double parameter) { return beginnings.answers_at(parameter); });
  if (diagram.branches.empty() && diagram.unfinished.empty() && diagram.notes.empty())
    diagram.unfinished = beginnings.reason();
  return diagram;
}

}  // namespace signorini
