#include "methods/orbit/polish.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <utility>

#include "methods/orbit/modal_green_function.hpp"
#include "methods/solvers/condition_estimate.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

class Polish {
 public:
  Polish(const std::shared_ptr<OrbitModel>& model, const OrbitGuess& guess, const PolishOptions& options)
      : model_(model), options_(options), equations_(*model, guess), start_(guess) {}

  ExactOrbit run() {
    orbit_.origin = start_.origin;
    unknowns_ = equations_.guess();
    if (!equations_.evaluate(unknowns_)) {
      fail("the flow is not finite");
      return std::move(orbit_);
    }
    orbit_.residual = norm();
    if (iterate()) judge();
    return std::move(orbit_);
  }

 private:
  [[nodiscard]] double norm() const { return equations_.residual().lpNorm<Eigen::Infinity>(); }
  [[nodiscard]] double attainable() const { return 32.0 * kEpsilon * equations_.largest_state(); }
  [[nodiscard]] double accepted() const { return std::max(options_.tolerance, attainable()); }

  void fail(const std::string& reason, OrbitOutcome outcome = OrbitOutcome::no_convergence) {
    orbit_.outcome = outcome;
    orbit_.reason = reason;
  }

  // The part of a step that leaves each interval between events a fifth of its length.
  [[nodiscard]] double longest_part(const Eigen::VectorXd& step) const {
    constexpr double kKept = 0.2;
    double part = 1.0, before = 0.0, moved = 0.0;
    const Eigen::Index m = equations_.events(), first = equations_.size() - m;
    const double end = model_->period * model_->dynamics.frequency();
    for (Eigen::Index i = 0; i <= m; ++i) {
      const double at = i == m ? end : unknowns_[first + i], move = i == m ? 0.0 : step[first + i];
      const double shrinks = moved - move, length = at - before;
      if (shrinks > 0.0 && part * shrinks > (1.0 - kKept) * length)
        part = std::max(0.0, (1.0 - kKept) * length / shrinks);
      before = at;
      moved = move;
    }
    return part;
  }

  // Newton's method; false if it ended without a solution.
  bool iterate() {
    constexpr double kMerging = 1e-3;
    int shortened = 0;
    bool polished = false;
    while (orbit_.residual > accepted() || !polished) {
      polished = orbit_.residual <= accepted();  // one step more: it costs little and halves the noise
      if (orbit_.iterations >= options_.max_iterations) {
        fail(fmt::format("no convergence in {} Newton steps (residual {:.2g})", orbit_.iterations,
                         orbit_.residual));
        return false;
      }
      lu_.compute(equations_.jacobian());
      const Eigen::VectorXd step = -lu_.solve(equations_.residual());
      if (!step.allFinite()) {
        if (polished) break;
        fail("the equations are singular (a multiplier is 1, or an impact grazes)");
        return false;
      }
      const double part = longest_part(step);
      shortened = part < kMerging ? shortened + 1 : 0;
      if (shortened >= 3) {
        fail(fmt::format("the steps close an interval (residual {:.2g})", orbit_.residual),
             OrbitOutcome::events_merge);
        return false;
      }
      ++orbit_.iterations;
      if (!descend(step, part, polished)) return polished || at_noise();
    }
    return true;
  }

  // A residual that no longer falls counts as converged if it is at the round-off of its evaluation.
  bool at_noise() {
    constexpr double kNoise = 100.0;  // cancellation between the arcs of a sequence, beyond `attainable`
    if (orbit_.residual <= std::max(accepted(), kNoise * attainable())) return true;
    fail(fmt::format("no descent along the Newton step (residual {:.2g})", orbit_.residual));
    return false;
  }

  bool descend(const Eigen::VectorXd& step, double part, bool polishing) {
    constexpr int kHalvings = 12;
    const Eigen::VectorXd from = unknowns_;
    const double before = orbit_.residual;
    for (int k = 0; k < (polishing ? 1 : kHalvings); ++k, part *= 0.5) {
      unknowns_ = from + part * step;
      if (!equations_.evaluate(unknowns_)) continue;
      orbit_.residual = norm();
      if (orbit_.residual < (1.0 - 0.1 * part) * before) return true;
      // Far away the closure is bilinear in state and instants: a full step may raise the residual once.
    }
    unknowns_ = from;
    equations_.evaluate(unknowns_);
    orbit_.residual = before;
    return false;
  }

  void judge() {
    orbit_.attainable = attainable();
    const OrbitGuess solved = equations_.orbit(unknowns_);
    const auto trajectory =
        std::make_shared<ExactTrajectory>(model_, solved, equations_.arcs(), equations_.passages());
    orbit_.trajectory = trajectory;
    orbit_.admissibility =
        check_admissible(*model_, solved, equations_, options_.admissibility, options_.chatter);
    measure_error(solved);
    conclude(solved);
    trajectory->set_quality({.residual = orbit_.residual,
                             .error_bar = orbit_.error_bar,
                             .amplification = orbit_.amplification,
                             .multipliers = orbit_.multipliers,
                             .admissible = orbit_.admissibility.ok});
  }

  void conclude(const OrbitGuess& solved) {
    constexpr double kUndetermined = 1e-3;  // an error bar of this size determines nothing
    const Admissibility& found = orbit_.admissibility;
    if (!(orbit_.error_bar < kUndetermined)) {
      fail(
          fmt::format("the equations are singular (a multiplier is 1, or an impact grazes): error bar {:.2g}",
                      orbit_.error_bar));
      return;
    }
    if (!found.ok) {
      orbit_.outcome = OrbitOutcome::not_admissible;
      orbit_.reason = found.reason;
      return;
    }
    if (found.impacts > 0 && found.weakest_impact < options_.grazing) {
      orbit_.outcome = OrbitOutcome::grazing;
      orbit_.reason =
          fmt::format("an impact grazes its stop (approach speed {:.2g} of the scale)", found.weakest_impact);
      return;
    }
    const Eigen::MatrixXd monodromy = equations_.monodromy();
    if (monodromy.size() > 0 && monodromy.allFinite()) orbit_.multipliers = monodromy.eigenvalues();
    orbit_.outcome = found.chatter ? OrbitOutcome::chatter : OrbitOutcome::converged;
    const auto closings =
        std::count_if(solved.events.begin(), solved.events.end(),
                      [](const SequenceEvent& event) { return event.kind == ContactEvent::Kind::close; });
    orbit_.reason =
        found.chatter
            ? fmt::format("complete chattering: {} impacts resolved, then contact", found.impacts)
            : fmt::format("periodic orbit, impacts {}, phases of contact {}", found.impacts, closings);
    if (closings == 0 && std::count(solved.start.closed.begin(), solved.start.closed.end(), true) > 0)
      orbit_.reason += " (closed throughout)";
  }

  // Instants count with the displacement that they cost.
  [[nodiscard]] Eigen::VectorXd weights() const {
    Eigen::VectorXd weight = Eigen::VectorXd::Ones(equations_.size());
    for (Eigen::Index i = 0; i < equations_.events(); ++i) {
      const double v = equations_.passages()[static_cast<std::size_t>(i)].approach;
      weight[equations_.size() - equations_.events() + i] = std::abs(v) / model_->dynamics.scales().velocity;
    }
    return weight;
  }

  // The second evaluation of a purely impulsive orbit; false if it is none.
  bool by_green_function() {
    const OrbitGuess& solved = orbit_.trajectory->orbit();
    const auto touching = [](const std::vector<bool>& closed) {
      return std::find(closed.begin(), closed.end(), true) != closed.end();
    };
    if (touching(solved.start.closed)) return false;
    for (const SequenceEvent& event : solved.events) {
      if (event.kind != ContactEvent::Kind::impact || touching(event.closed)) return false;
    }
    const ModalGreenFunction green(model_->dynamics, model_->period);
    if (!green.defined()) return false;
    const MotionScales& scales = model_->dynamics.scales();
    const std::vector<Impulse> impulses = orbit_.trajectory->impulses();
    constexpr int kInstants = 17;
    for (int i = 0; i < kInstants; ++i) {
      const double time = solved.start.time + model_->period * i / kInstants;
      const State a = green.state(time, impulses), b = orbit_.trajectory->at(time);
      orbit_.error_bar =
          std::max({orbit_.error_bar, (a.u - b.u).lpNorm<Eigen::Infinity>() / scales.displacement,
                    (a.v - b.v).lpNorm<Eigen::Infinity>() / scales.velocity});
    }
    return true;
  }

  void measure_error(const OrbitGuess& solved) {
    lu_.compute(equations_.jacobian());
    orbit_.condition = condition_from(lu_.rcond());
    const Eigen::VectorXd weight = weights();
    const Eigen::MatrixXd inverse = weight.asDiagonal() * lu_.inverse();
    const double noise = orbit_.residual + attainable();
    orbit_.error_bar =
        inverse.cwiseAbs().rowwise().sum().maxCoeff() * (noise + orbit_.admissibility.chatter_error);
    if (!options_.second_evaluation || by_green_function()) return;
    OrbitModel other(*model_, FlowForm::exponential);
    OrbitEquations again(other, solved);
    if (!again.evaluate(again.guess())) return;
    orbit_.error_bar = std::max(orbit_.error_bar, (inverse * again.residual()).lpNorm<Eigen::Infinity>());
  }

  std::shared_ptr<OrbitModel> model_;
  const PolishOptions& options_;
  OrbitEquations equations_;
  const OrbitGuess& start_;
  ExactOrbit orbit_;
  Eigen::VectorXd unknowns_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

}  // namespace

std::string describe(OrbitOutcome outcome) {
  switch (outcome) {
    case OrbitOutcome::converged:
      return "converged";
    case OrbitOutcome::chatter:
      return "complete chattering";
    case OrbitOutcome::grazing:
      return "grazing";
    case OrbitOutcome::not_admissible:
      return "not admissible";
    case OrbitOutcome::events_merge:
      return "two events merge";
    case OrbitOutcome::no_convergence:
      return "no convergence";
  }
  return {};
}

ExactOrbit polish_sequence(const std::shared_ptr<OrbitModel>& model, const OrbitGuess& guess,
                           const PolishOptions& options) {
  try {
    return Polish(model, guess, options).run();
  } catch (const std::exception& error) {  // a mode whose flow cannot be formed
    ExactOrbit orbit;
    orbit.origin = guess.origin;
    orbit.reason = error.what();
    return orbit;
  }
}

}  // namespace signorini
