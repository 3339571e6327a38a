#include "methods/orbit/orbit_equations.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "methods/flow/impact_groups.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/singular_values.hpp"

namespace signorini {

void require_time(const Expired& expired) {
  if (expired && expired()) throw std::runtime_error("the time is up");
}

OrbitModel::OrbitModel(ContactDynamics known, double of_orbits, FlowForm form,
                       std::shared_ptr<SharedModes> shared)
    : dynamics(std::move(known)), flows(dynamics, form, std::move(shared)), period(of_orbits) {}

OrbitModel::OrbitModel(const Problem& problem, std::shared_ptr<SharedModes> shared)
    : OrbitModel(ContactDynamics(problem), problem.period(), FlowForm::automatic, std::move(shared)) {}

OrbitModel::OrbitModel(const OrbitModel& other, double frequency, std::shared_ptr<SharedModes> shared)
    : OrbitModel(ContactDynamics(other.dynamics, frequency),
                 other.period * other.dynamics.structure().frequency / frequency, FlowForm::automatic,
                 std::move(shared)) {}

OrbitEquations::OrbitEquations(OrbitModel& model, const OrbitGuess& guess, Expired expired, Columns columns)
    : model_(model), sequence_(guess), expired_(std::move(expired)), kind_(columns) {
  // Unknowns and equations are divided by the scales of the motion, so that one tolerance fits lengths,
  // speeds, forces and instants, and |J^-1| says something about all of them.
  const ContactDynamics& dynamics = model_.dynamics;
  first_.resize(size());
  first_.head(p_) = guess.start.state.u / x_unit_;
  first_.segment(p_, n_) = guess.start.state.v / v_unit_;
  flows_.push_back(&model_.flows.of(guess.start.closed));
  for (Eigen::Index i = 0; i < m_; ++i) {
    const SequenceEvent& event = guess.events[static_cast<std::size_t>(i)];
    first_[states_ + i] = (event.time - guess.start.time) / t_unit_;
    require_time(expired_);
    flows_.push_back(&model_.flows.of(event.closed));
    EventLaw law;
    law.of_force = event.kind == ContactEvent::Kind::open;
    law.unit = law.of_force ? dynamics.force_scale(event.contact) : x_unit_;
    if (!event.pushed.empty()) {
      law.impulse = dynamics.structure().impulse_of_velocity(event.pushed, event.restitution);
      law.response = columns_of(dynamics.structure().velocity_per_impulse, event.pushed);
    }
    laws_.push_back(std::move(law));
  }
  for (const LinearFlow* flow : flows_) arcs_.push_back(flow->arc());
  crossings_.resize(static_cast<std::size_t>(m_));
  residual_.resize(size());
  jacobian_.resize(size(), size());
  sensitivity_.resize(states_, size());
}

// The sensitivities at the end of arc i.
void OrbitEquations::carry(Eigen::Index i, double duration) {
  const LinearFlow& flow = *flows_[static_cast<std::size_t>(i)];
  const Eigen::Index known = of_state_ + i;
  if (kind_ == Columns::all && i == 0) {  // from the units alone
    sensitivity_.leftCols(known) = flow.transition(duration);
    sensitivity_.leftCols(p_) *= x_unit_;
    sensitivity_.middleCols(p_, n_) *= v_unit_;
    return;
  }
  if (kind_ == Columns::all) {
    sensitivity_.leftCols(known) = product(flow.transition(duration), sensitivity_.leftCols(known));
    return;
  }
  TransitionFactors factors = flow.transition_factors(duration);
  if (i > 0) {
    sensitivity_.leftCols(known) =
        product(factors.writing, product(factors.reading, sensitivity_.leftCols(known)));
    return;
  }
  of_state_ = factors.writing.cols();
  sensitivity_.leftCols(of_state_) = factors.writing;
  reading_ = std::move(factors.reading);
  reading_.leftCols(p_) *= x_unit_;
  reading_.rightCols(n_) *= v_unit_;
}

// Equation i, and what the impulses of event i make of the state and its sensitivities.
void OrbitEquations::pass_event(Eigen::Index i, bool derivatives) {
  const auto index = static_cast<std::size_t>(i);
  const SequenceEvent& event = sequence_.events[index];
  const LinearArc& arc = *arcs_[index];
  const EventLaw& law = laws_[index];
  const FlowStructure& structure = model_.dynamics.structure();
  EventCrossing& crossing = crossings_[index];
  arc.state(event.time, state_);
  crossing.approach = arc.displacement(event.contact, event.time, 1);
  residual_[states_ + i] =
      (law.of_force ? arc.force(event.contact, event.time)
                    : arc.displacement(event.contact, event.time) - structure.gaps[event.contact]) /
      law.unit;
  if (derivatives) differentiate_event(i);
  if (event.pushed.empty()) return;
  crossing.speeds = image_by_transposed_columns(structure.directions, event.pushed, state_.v);
  crossing.impulses = image(law.impulse, state_.v);
  // The law of impact is linear in v_-: the sensitivities pass it by the same R = I + M^-1 W_S (dp/dv_-).
  // Together with -F_+ dt at the beginning of the next arc this is the saltation, R F_- - F_+.
  state_.v += image(law.response, crossing.impulses);
  if (!derivatives) return;
  auto rates = sensitivity_.bottomLeftCorner(n_, of_state_ + i + 1);
  rates += product(law.response, product(law.impulse, rates));
}

// The row of event i, and the sensitivities before it with those by its own instant.
void OrbitEquations::differentiate_event(Eigen::Index i) {
  const auto index = static_cast<std::size_t>(i);
  const SequenceEvent& event = sequence_.events[index];
  const LinearArc& arc = *arcs_[index];
  const EventLaw& law = laws_[index];
  const auto known = of_state_ + i + 1;  // columns that can be nonzero so far
  const Eigen::Index row = states_ + i;
  arc.rate(event.time, rate_);
  // A later event instant carries the state on along the motion, by F_- dt.
  sensitivity_.col(known - 1) = t_unit_ * rate_;
  const Eigen::RowVectorXd gradient = flows_[index]->gradient(event.contact, law.of_force);
  Eigen::RowVectorXd by_all = row_image(gradient, sensitivity_.leftCols(known));
  by_all /= law.unit;
  if (kind_ == Columns::all) {
    jacobian_.row(row).head(known) = by_all;
  } else {
    jacobian_.row(row).head(states_) = row_image(by_all.head(of_state_), reading_);
    jacobian_.row(row).segment(states_, i + 1) = by_all.tail(i + 1);
  }
  jacobian_(row, row) =
      t_unit_ * (law.of_force ? arc.force(event.contact, event.time, 1) : crossings_[index].approach) /
      law.unit;
  jacobian_.row(row).tail(m_ - i - 1).setZero();
}

void OrbitEquations::differentiate_closure() {
  if (kind_ == Columns::all) {
    jacobian_.topRows(p_) = sensitivity_.topRows(p_) / x_unit_;
    jacobian_.middleRows(p_, n_) = sensitivity_.bottomRows(n_) / v_unit_;
  } else {
    set_product(jacobian_.topLeftCorner(states_, states_), sensitivity_.leftCols(of_state_), reading_);
    jacobian_.topRightCorner(states_, m_) = sensitivity_.middleCols(of_state_, m_);
    jacobian_.topRows(p_) /= x_unit_;
    jacobian_.middleRows(p_, n_) /= v_unit_;
  }
  jacobian_.topLeftCorner(states_, states_).diagonal().array() -= 1.0;  // of - y_0
}

void OrbitEquations::pass(const Eigen::VectorXd& unknowns, bool derivatives) {
  const double start = sequence_.start.time;
  state_.u = x_unit_ * unknowns.head(p_);
  state_.v = v_unit_ * unknowns.segment(p_, n_);
  if (derivatives) {
    of_state_ = states_;
    sensitivity_.setZero();
  }
  largest_state_ = 1.0;
  double begin = start;
  for (Eigen::Index i = 0; i <= m_; ++i) {
    require_time(expired_);
    const auto index = static_cast<std::size_t>(i);
    LinearArc& arc = *arcs_[index];
    arc.start(begin, state_);
    const double end = i == m_ ? start + model_.period : start + t_unit_ * unknowns[states_ + i];
    if (derivatives && i > 0) {  // a later beginning leaves the arc less time: -F_+ dt
      const Eigen::Index last = of_state_ + i - 1;
      arc.rate(begin, rate_);
      sensitivity_.col(last) -= t_unit_ * rate_;
    }
    if (derivatives) carry(i, end - begin);
    if (i == m_) {
      arc.state(end, state_);
      break;
    }
    sequence_.events[index].time = end;
    pass_event(i, derivatives);
    largest_state_ = std::max({largest_state_, state_.u.lpNorm<Eigen::Infinity>() / x_unit_,
                               state_.v.lpNorm<Eigen::Infinity>() / v_unit_});
    begin = end;
  }
  residual_.head(p_) = state_.u / x_unit_ - unknowns.head(p_);
  residual_.segment(p_, n_) = state_.v / v_unit_ - unknowns.segment(p_, n_);
  if (derivatives) differentiate_closure();
}

bool OrbitEquations::evaluate(const Eigen::VectorXd& unknowns) {
  pass(unknowns, true);
  return residual_.allFinite() && jacobian_.allFinite();
}

bool OrbitEquations::evaluate_residual(const Eigen::VectorXd& unknowns) {
  pass(unknowns, false);
  return residual_.allFinite();
}

Eigen::MatrixXd OrbitEquations::monodromy() const {
  // Up to here the instants were free; now they follow the state (theory.md, section 6).
  Eigen::MatrixXd P = jacobian_.topLeftCorner(states_, states_);
  P.diagonal().array() += 1.0;  // dP/dy_0 without the - y_0 of the closure
  std::vector<Eigen::Index> moving;
  for (Eigen::Index i = 0; i < m_; ++i)
    if (jumps(sequence_.events[static_cast<std::size_t>(i)])) moving.push_back(states_ + i);
  if (moving.empty()) return P;
  const Eigen::MatrixXd along = jacobian_(moving, moving);
  if (along.diagonal().cwiseAbs().minCoeff() == 0.0) return {};
  const Eigen::MatrixXd instants =
      -lower_solve(along, Eigen::MatrixXd(jacobian_(moving, Eigen::seqN(0, states_))));
  return P + product(Eigen::MatrixXd(jacobian_(Eigen::seqN(0, states_), moving)), instants);
}

// Whether u'' or xi' does at an event.
bool OrbitEquations::jumps(const SequenceEvent& event) const {
  const bool lets_go = event.kind == ContactEvent::Kind::open;
  return lets_go ? model_.dynamics.rigid(event.contact) : model_.dynamics.halts(event.contact);
}

Eigen::MatrixXd OrbitEquations::instants_by_state() const {
  // dh/dt is lower triangular: an event depends on those before it.
  const Eigen::MatrixXd along = jacobian_.bottomRightCorner(m_, m_);
  if (m_ == 0 || along.diagonal().cwiseAbs().minCoeff() == 0.0) return {};
  return -lower_solve(along, jacobian_.bottomLeftCorner(m_, states_));
}

bool OrbitEquations::may_overtake(Eigen::Index i, Eigen::Index k) const {
  const auto& of = sequence_.events;
  const SequenceEvent &a = of[static_cast<std::size_t>(k)], &b = of[static_cast<std::size_t>(i)];
  return a.contact != b.contact && !a.pushed.empty() && !b.pushed.empty() &&
         coupling_of(model_.dynamics.structure(), a, b) != ImpactCoupling::mass;
}

std::vector<int> OrbitGuess::closings() const {
  std::vector<int> count(start.closed.size(), 0);
  for (std::size_t i = 0; i < events.size(); ++i) {
    for (std::size_t j = 0; j < count.size(); ++j) {
      if (events[i].closed[j] && !closed_before(i)[j]) ++count[j];
    }
  }
  return count;
}

OrbitGuess OrbitEquations::orbit(const Eigen::VectorXd& unknowns) const {
  OrbitGuess result = sequence_;
  result.start.state = {.u = x_unit_ * unknowns.head(p_), .v = v_unit_ * unknowns.segment(p_, n_)};
  for (Eigen::Index i = 0; i < m_; ++i)
    result.events[static_cast<std::size_t>(i)].time = result.start.time + t_unit_ * unknowns[states_ + i];
  return result;
}

bool any_closed(const std::vector<bool>& closed) { return std::ranges::find(closed, true) != closed.end(); }

bool touches(const OrbitGuess& path) { return !path.events.empty() || any_closed(path.start.closed); }

std::optional<FamilyInverse> family_inverse(const Eigen::MatrixXd& J, Eigen::Index states) {
  constexpr double kSingular = 1e-9, kAtRest = 1e-6;
  const SingularValues found = singular_vectors(J);
  const Eigen::Index rank = (found.values.array() > kSingular * found.values[0]).count();
  const Eigen::MatrixXd family = found.V.rightCols(found.values.size() - rank);
  if (rank == 0 || family.cols() == 0 || family.bottomRows(J.cols() - states / 2).norm() > kAtRest)
    return std::nullopt;
  return FamilyInverse{.inverse = found.V.leftCols(rank) *
                                  found.values.head(rank).cwiseInverse().asDiagonal() *
                                  found.U.leftCols(rank).transpose(),
                       .condition = found.values[0] / found.values[rank - 1]};
}

std::optional<FamilyInverse> family_inverse(const OrbitEquations& equations, double reciprocal_condition) {
  constexpr double kFamilyCondition = 1e-12;  // reciprocal: beyond it a step is rounding
  if (reciprocal_condition > kFamilyCondition || !touches(equations.sequence())) return std::nullopt;
  return family_inverse(equations.jacobian(), equations.size() - equations.events());
}

}  // namespace signorini
