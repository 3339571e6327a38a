#include "methods/orbit/starts/one_impact_orbits.hpp"

#include <Eigen/Core>
#include <cmath>
#include <memory>
#include <optional>

#include "methods/orbit/periodic_closure.hpp"
#include "methods/solvers/bracketed_zero.hpp"
#include "problems/linear_algebra/lu.hpp"

namespace signorini {

namespace {

// The contact-free motion and the response to impulses every n periods.
class ImpactBalance {
 public:
  ImpactBalance(OrbitModel& model, int contact, int order)
      : structure_(model.dynamics.structure()),
        contact_(contact),
        period_(order * structure_.forcing_period),
        e_(model.dynamics.restitution(contact)),
        flow_(model.flows.of(open_)) {
    const auto free = contact_free_motion(model);
    const Eigen::Index n = structure_.size();
    struck_.tail(n) = structure_.velocity_per_impulse.col(contact);
    const PeriodicClosure closure(flow_, structure_.scales, period_);
    const Eigen::VectorXd w = structure_.directions.col(contact);
    if (!free || !closure.unique()) {
      border(w);
      return;
    }
    after_ = closure.solve(struck_);
    g0_ = w.dot(after_.head(n));
    g_after_ = w.dot(after_.tail(n));
    g_before_ = g_after_ - w.dot(struck_.tail(n));
    arc_->start(0.0, *free);
  }

  // Whether there is one impulse to each phase.
  [[nodiscard]] bool defined() const {
    return bordered_ ? bordered_->regular() : g0_ != 0.0 && std::isfinite(g0_);
  }
  [[nodiscard]] double impulse(double time) const {
    if (bordered_) return struck_at(time)[structure_.states()];
    return (structure_.gaps[contact_] - arc_->displacement(contact_, time)) / g0_;
  }
  // Of the law of impact [m/s].
  [[nodiscard]] double defect(double time) const {
    if (bordered_) {
      const Eigen::VectorXd struck = struck_at(time);
      const Eigen::Index p = structure_.positions(), n = structure_.size();
      const auto w = structure_.directions.col(contact_);
      return (1.0 + e_) * w.dot(struck.segment(p, n)) - e_ * struck[p + n] * w.dot(struck_.tail(n));
    }
    return (1.0 + e_) * arc_->displacement(contact_, time, 1) + impulse(time) * (g_after_ + e_ * g_before_);
  }
  // The orbit with its impact at a time, from half a period before.
  [[nodiscard]] OrbitGuess orbit(double time) const {
    const Eigen::Index p = structure_.positions(), n = structure_.size();
    OrbitGuess guess{.start = {.time = time - 0.5 * period_, .state = {}, .closed = open_},
                     .events = {},
                     .origin = "one impact"};
    if (bordered_) {
      const Eigen::VectorXd struck = struck_at(time);
      arc_->start(time, {.u = struck.head(p), .v = struck.segment(p, n)});
      arc_->state(time + 0.5 * period_, guess.start.state);
    } else {
      arc_->state(guess.start.time, guess.start.state);
      const Eigen::VectorXd y = impulse(time) * (flow_.transition(0.5 * period_) * after_);
      guess.start.state.u += y.head(p);
      guess.start.state.v += y.tail(n);
    }
    guess.events.push_back({.kind = ContactEvent::Kind::impact,
                            .contact = contact_,
                            .time = time,
                            .pushed = {contact_},
                            .restitution = {e_},
                            .closed = open_});
    return guess;
  }

 private:
  // Where free motions return by themselves: the contact's place is one more equation.
  void border(const Eigen::VectorXd& w) {
    const Eigen::Index n = structure_.size(), states = structure_.states();
    units_.resize(states + 1);
    units_ << state_units(flow_, structure_.scales), structure_.scales.velocity / w.dot(struck_.tail(n));
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(states + 1, states + 1);
    matrix.topLeftCorner(states, states) = -flow_.transition(period_);
    matrix.diagonal().head(states).array() += 1.0;
    matrix.col(states).head(states) = -struck_;
    matrix.row(states).head(n) = w.transpose();
    rows_ = units_;
    rows_[states] = structure_.scales.displacement;
    bordered_.emplace(Eigen::MatrixXd(rows_.cwiseInverse().asDiagonal() * matrix * units_.asDiagonal()));
  }
  // The state right after an impact at a time and its impulse, Ns + 1.
  [[nodiscard]] Eigen::VectorXd struck_at(double time) const {
    State end{.u = Eigen::VectorXd::Zero(structure_.positions()),
              .v = Eigen::VectorXd::Zero(structure_.size())};
    arc_->start(time, end);
    arc_->state(time + period_, end);
    Eigen::VectorXd right(structure_.states() + 1);
    right << end.u, end.v, structure_.gaps[contact_];
    return units_.cwiseProduct(bordered_->solve(right.cwiseQuotient(rows_)));
  }

  const FlowStructure& structure_;
  const int contact_;
  const double period_, e_;
  const std::vector<bool> open_ =
      std::vector<bool>(static_cast<std::size_t>(structure_.contact_count()), false);
  const LinearFlow& flow_;
  Eigen::VectorXd struck_ = Eigen::VectorXd::Zero(structure_.states());  // by a unit impulse, Ns
  Eigen::VectorXd after_;  // the state right after periodic ones, Ns
  double g0_ = 0.0, g_after_ = 0.0, g_before_ = 0.0;
  std::unique_ptr<LinearArc> arc_ = flow_.arc();  // the contact-free motion
  std::optional<CompleteLuFactors> bordered_;     // [I - Phi, -M^-1 W; W^T, 0] in these units
  Eigen::VectorXd units_, rows_;
};

}  // namespace

std::vector<SequencedOrbit> one_impact_orbits(OrbitFamily& family, double parameter, int contact, int order) {
  constexpr int kSamples = 256;
  const auto model = family.model(parameter);
  if (!model->dynamics.rigid(contact)) return {};
  const ImpactBalance balance(*model, contact, order);
  if (!balance.defined()) return {};
  const FlowStructure& structure = model->dynamics.structure();
  const double T = structure.forcing_period;
  std::vector<SequencedOrbit> orbits;
  const auto add = [&](double time) {
    if (balance.impulse(time) < 0.0)
      orbits.push_back(sequenced(family, balance.orbit(time), order * T, structure.frequency, parameter));
  };
  if (!family.driven()) {
    add(0.5 * T);
    return orbits;
  }
  const auto defect = [&](double time) { return balance.defect(time); };
  double before = defect(0.0);
  for (int i = 1; i <= kSamples; ++i) {
    const double low = (i - 1) * T / kSamples, high = i * T / kSamples;
    const double after = defect(high);
    if (before * after < 0.0) {
      if (const auto zero = bracketed_zero(defect, {low, before, high, after}, kEpsilon * T)) add(zero->a);
    }
    before = after;
  }
  return orbits;
}

}  // namespace signorini
