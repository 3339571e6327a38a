#include "methods/orbit/orbit_equations.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace signorini {

void require_time(const Expired& expired) {
  if (expired && expired()) throw std::runtime_error("the time is up");
}

OrbitEquations::OrbitEquations(OrbitModel& model, const OrbitGuess& guess, Expired expired)
    : model_(model),
      sequence_(guess),
      expired_(std::move(expired)),
      n_(model.dynamics.size()),
      m_(static_cast<Eigen::Index>(guess.events.size())),
      x_unit_(model.dynamics.scales().displacement),
      v_unit_(model.dynamics.scales().velocity),
      t_unit_(1.0 / model.dynamics.structure().frequency) {
  // Unknowns and equations are divided by the scales of the motion, so that one tolerance fits lengths,
  // speeds, forces and instants, and |J^-1| says something about all of them.
  const ContactDynamics& dynamics = model_.dynamics;
  first_.resize(size());
  first_.head(n_) = guess.start.state.u / x_unit_;
  first_.segment(n_, n_) = guess.start.state.v / v_unit_;
  flows_.push_back(&model_.flows.of(guess.start.closed));
  for (Eigen::Index i = 0; i < m_; ++i) {
    const SequenceEvent& event = guess.events[static_cast<std::size_t>(i)];
    first_[2 * n_ + i] = (event.time - guess.start.time) / t_unit_;
    require_time(expired_);
    flows_.push_back(&model_.flows.of(event.closed));
    EventLaw law;
    law.of_force = event.kind == ContactEvent::Kind::open;
    law.unit = law.of_force ? dynamics.force_scale(event.contact) : x_unit_;
    if (!event.pushed.empty()) {
      law.impulse = dynamics.structure().impulse_of_velocity(event.pushed, event.restitution);
      law.response = dynamics.structure().velocity_per_impulse(Eigen::all, event.pushed);
    }
    laws_.push_back(std::move(law));
  }
  for (const LinearFlow* flow : flows_) arcs_.push_back(flow->arc());
  crossings_.resize(static_cast<std::size_t>(m_));
  residual_.resize(size());
  jacobian_.resize(size(), size());
  sensitivity_.resize(2 * n_, size());
}

// Equation i, its row, and the state and its sensitivities on the right side of event i.
void OrbitEquations::pass_event(Eigen::Index i) {
  const auto index = static_cast<std::size_t>(i);
  const SequenceEvent& event = sequence_.events[index];
  const ContactDynamics& dynamics = model_.dynamics;
  const LinearArc& arc = *arcs_[index];
  const EventLaw& law = laws_[index];
  const double time = event.time;
  const auto known = 2 * n_ + i + 1;  // columns that can be nonzero so far
  const Eigen::Index row = 2 * n_ + i;
  arc.state(time, state_);
  arc.acceleration(time, a_);
  // A later event instant carries the state on along the motion, by F_- = (v, a) dt.
  sensitivity_.col(row).head(n_) = t_unit_ * state_.v;
  sensitivity_.col(row).tail(n_) = t_unit_ * a_;
  EventCrossing& crossing = crossings_[index];
  crossing.approach = arc.displacement(event.contact, time, 1);
  const Eigen::RowVectorXd gradient = flows_[index]->gradient(event.contact, law.of_force);
  jacobian_.row(row).head(known).noalias() = gradient * sensitivity_.leftCols(known) / law.unit;
  if (law.of_force) {
    residual_[row] = arc.force(event.contact, time) / law.unit;
    jacobian_(row, row) = t_unit_ * arc.force(event.contact, time, 1) / law.unit;
  } else {
    residual_[row] =
        (arc.displacement(event.contact, time) - dynamics.structure().gaps[event.contact]) / law.unit;
    jacobian_(row, row) = t_unit_ * crossing.approach / law.unit;
  }
  jacobian_.row(row).tail(size() - known).setZero();
  if (event.pushed.empty()) return;
  crossing.speeds = dynamics.structure().directions(Eigen::all, event.pushed).transpose() * state_.v;
  crossing.impulses = law.impulse * state_.v;
  // The law of impact is linear in v_-: the sensitivities pass it by the same R = I + M^-1 W_S (dp/dv_-).
  // Together with -F_+ dt at the beginning of the next arc this is the saltation, R F_- - F_+.
  state_.v += law.response * crossing.impulses;
  auto rates = sensitivity_.bottomLeftCorner(n_, known);
  rates += law.response * (law.impulse * rates).eval();
}

bool OrbitEquations::evaluate(const Eigen::VectorXd& unknowns) {
  const double start = sequence_.start.time;
  state_.u = x_unit_ * unknowns.head(n_);
  state_.v = v_unit_ * unknowns.segment(n_, n_);
  sensitivity_.setZero();
  sensitivity_.topLeftCorner(n_, n_).diagonal().setConstant(x_unit_);
  sensitivity_.block(n_, n_, n_, n_).diagonal().setConstant(v_unit_);
  largest_state_ = 1.0;
  double begin = start;
  for (Eigen::Index i = 0; i <= m_; ++i) {
    require_time(expired_);
    const auto index = static_cast<std::size_t>(i);
    LinearArc& arc = *arcs_[index];
    arc.start(begin, state_);
    const double end = i == m_ ? start + model_.period : start + t_unit_ * unknowns[2 * n_ + i];
    const Eigen::Index known = 2 * n_ + i;
    if (i > 0) {  // a later beginning leaves the arc less time: -F_+ dt
      arc.acceleration(begin, a_);
      sensitivity_.col(known - 1).head(n_) -= t_unit_ * state_.v;
      sensitivity_.col(known - 1).tail(n_) -= t_unit_ * a_;
    }
    sensitivity_.leftCols(known) =
        (flows_[index]->transition(end - begin) * sensitivity_.leftCols(known)).eval();
    if (i == m_) {
      arc.state(end, state_);
      break;
    }
    sequence_.events[index].time = end;
    pass_event(i);
    largest_state_ = std::max({largest_state_, state_.u.lpNorm<Eigen::Infinity>() / x_unit_,
                               state_.v.lpNorm<Eigen::Infinity>() / v_unit_});
    begin = end;
  }
  residual_.head(n_) = state_.u / x_unit_ - unknowns.head(n_);
  residual_.segment(n_, n_) = state_.v / v_unit_ - unknowns.segment(n_, n_);
  jacobian_.topRows(n_) = sensitivity_.topRows(n_) / x_unit_;
  jacobian_.middleRows(n_, n_) = sensitivity_.bottomRows(n_) / v_unit_;
  jacobian_.topLeftCorner(2 * n_, 2 * n_).diagonal().array() -= 1.0;  // of - y_0
  return residual_.allFinite() && jacobian_.allFinite();
}

Eigen::MatrixXd OrbitEquations::monodromy() const {
  // Up to here the instants were free; now they follow the state (theory.md, section 6).
  Eigen::MatrixXd P = jacobian_.topLeftCorner(2 * n_, 2 * n_);
  P.diagonal().array() += 1.0;  // dP/dy_0 without the - y_0 of the closure
  if (m_ == 0) return P;
  // dh/dt is lower triangular: an event depends on those before it.
  const Eigen::MatrixXd along = jacobian_.bottomRightCorner(m_, m_);
  if (along.diagonal().cwiseAbs().minCoeff() == 0.0) return {};
  P -= jacobian_.topRightCorner(2 * n_, m_) *
       along.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd(jacobian_.bottomLeftCorner(m_, 2 * n_)));
  return P;
}

OrbitGuess OrbitEquations::orbit(const Eigen::VectorXd& unknowns) const {
  OrbitGuess result = sequence_;
  result.start.state = {.u = x_unit_ * unknowns.head(n_), .v = v_unit_ * unknowns.segment(n_, n_)};
  for (Eigen::Index i = 0; i < m_; ++i)
    result.events[static_cast<std::size_t>(i)].time = result.start.time + t_unit_ * unknowns[2 * n_ + i];
  return result;
}

}  // namespace signorini
