#include "methods/orbit/family/extended_equations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "methods/orbit/family/event_instants.hpp"
#include "problems/linear_algebra/cholesky.hpp"

namespace signorini {

namespace {

// The law of impact may be what changes along the curve. Contacts that rest pass an impulse on.
std::vector<SequenceEvent> events_of(const SequencedOrbit& orbit, const ContactDynamics& dynamics) {
  std::vector<SequenceEvent> events = orbit.events;
  for (SequenceEvent& event : events) {
    if (event.kind != ContactEvent::Kind::impact) continue;
    for (std::size_t k = 0; k < event.restitution.size(); ++k) {
      if (!event.closed[static_cast<std::size_t>(event.pushed[k])])
        event.restitution[k] = dynamics.restitution(event.pushed[k]);
    }
  }
  return events;
}

// What a damped stop lets go moves at the rate 1 / beta: its divided row is in units of that motion, in
// others it would be all rounding.
double share_of_unit(const SequenceEvent& before, const SequenceEvent& event,
                     const ContactDynamics& dynamics) {
  const bool released = before.kind == ContactEvent::Kind::open && event.kind == ContactEvent::Kind::close;
  if (!released || dynamics.rigid(event.contact) || !dynamics.halts(event.contact)) return 1.0;
  return std::min(1.0, dynamics.structure().relaxation[event.contact] * dynamics.structure().frequency);
}

}  // namespace

ExtendedEquations::~ExtendedEquations() = default;

ExtendedEquations::ExtendedEquations(OrbitFamily& family, SequencedOrbit orbit)
    : family_(family), orbit_(std::move(orbit)) {
  jacobian_.resize(size(), size() + 1);
}

double ExtendedEquations::parameter() const { return orbit_.parameter() * family_.units().parameter; }

double ExtendedEquations::frequency() const { return model_->dynamics.structure().frequency; }

Eigen::VectorXd ExtendedEquations::state_factors(const OrbitModel& model) const {
  const MotionScales& own = model.dynamics.scales();
  Eigen::VectorXd factors(model.dynamics.states());
  factors.head(model.dynamics.positions()).setConstant(family_.units().displacement / own.displacement);
  factors.tail(model.dynamics.size()).setConstant(family_.units().velocity / own.velocity);
  return factors;
}

std::unique_ptr<OrbitEquations> ExtendedEquations::evaluated(OrbitModel& model, const Eigen::VectorXd& x,
                                                             bool derivatives) const {
  const FlowStructure& structure = model.dynamics.structure();
  if (model.dynamics.states() != orbit_.states()) return nullptr;  // a mass has vanished, or appeared
  model.period = orbit_.order * structure.forcing_period;
  const OrbitGuess sequence{.start = {.time = orbit_.section / structure.frequency,
                                      .state = model.dynamics.at_rest(),
                                      .closed = orbit_.closed},
                            .events = events_of(orbit_, model.dynamics),
                            .origin = {}};
  auto equations =
      std::make_unique<OrbitEquations>(model, sequence, Expired{}, OrbitEquations::Columns::alive);
  Eigen::VectorXd unknowns = x.head(size());
  unknowns.head(orbit_.states()).array() *= state_factors(model).array();
  const bool finite = derivatives ? equations->evaluate(unknowns) : equations->evaluate_residual(unknowns);
  return finite ? std::move(equations) : nullptr;
}

// Rows of the closure in CurveUnits, so that they are those of y(2 pi n) - y_0 in the unknowns; the units of
// the events' equations do not matter.
Eigen::VectorXd ExtendedEquations::residual_of(const OrbitEquations& equations, const OrbitModel& model,
                                               const Eigen::VectorXd& x) const {
  Eigen::VectorXd residual = equations.residual();
  const Eigen::VectorXd factors = state_factors(model);
  residual.head(factors.size()).array() /= factors.array();
  for (Eigen::Index i = 1; i < orbit_.count(); ++i) {
    if (divided(x, i) > 0) residual[orbit_.states() + i] = divided_difference(equations, model, x, i);
  }
  return residual;
}

int ExtendedEquations::divided(const Eigen::VectorXd& x, Eigen::Index i) const {
  constexpr double kBrief = 0.1;  // rad: longer flights have no double zero to rounding
  if (i == 0) return 0;
  const SequenceEvent &before = orbit_.event(i - 1), &event = orbit_.event(i);
  if (event.contact != before.contact) return 0;
  const ContactDynamics& dynamics = model_->dynamics;
  if (!dynamics.halts(event.contact)) return 1;
  const Eigen::Index row = orbit_.states() + i;
  if (event.kind == ContactEvent::Kind::open || std::abs(x[row] - x[row - 1]) > kBrief) return 0;
  if (before.kind == ContactEvent::Kind::open) return dynamics.rigid(event.contact) ? 3 : 2;
  const bool to_rest = before.kind == ContactEvent::Kind::impact && before.pushed.size() == 1 &&
                       before.restitution.front() == 0.0;
  return to_rest ? 2 : 0;
}

// By Taylor's series where its last term is rounding, else as it stands: the difference then loses no more
// than two digits. Of threefold zeros it loses 1 / length^3, and the series goes as far as it must.
double ExtendedEquations::divided_difference(const OrbitEquations& equations, const OrbitModel& model,
                                             const Eigen::VectorXd& x, Eigen::Index i) const {
  const ContactDynamics& dynamics = model.dynamics;
  const SequenceEvent &before = orbit_.event(i - 1), &event = orbit_.event(i);
  const LinearArc& arc = *equations.arcs()[static_cast<std::size_t>(i)];
  const int j = event.contact, first = divided(x, i), terms = first == 1 ? 8 : 32;
  const bool of_force = event.kind == ContactEvent::Kind::open;
  const double unit = (of_force ? dynamics.force_scale(j) : dynamics.scales().displacement) /
                      share_of_unit(before, event, dynamics);
  const double omega = dynamics.structure().frequency;
  const auto z = [&](double phase, int order) {
    const double t = (orbit_.section + phase) / omega;
    return of_force ? arc.force(j, t, order) : arc.displacement(j, t, order);
  };
  const double begin = x[orbit_.states() + i - 1], length = x[orbit_.states() + i] - begin;
  double factor = 1.0, below = z(begin, 0);  // 1 / (k! omega^k); what the terms below `first` are together
  for (int k = 1; k < first; ++k) {
    factor /= k * omega;
    below += factor * std::pow(length, k) * z(begin, k);
  }
  double sum = 0.0, largest = 0.0, term = 0.0, power = factor;
  for (int k = first; k < first + terms; ++k, power *= length) {
    power /= k * omega;
    term = power * z(begin, k);
    largest = std::max(largest, std::abs(term));
    sum += term;
  }
  if (std::abs(term) <= kEpsilon * largest) return sum / unit;
  return (z(begin + length, 0) - below) / (std::pow(length, first) * unit);
}

// Both are the same function of the state, up to a factor: the one that vanishes at the event.
double ExtendedEquations::ratio_of_rows(Eigen::Index i) const {
  const ContactDynamics& dynamics = model_->dynamics;
  const SequenceEvent &before = orbit_.event(i - 1), &after = orbit_.event(i);
  const std::vector<bool>& mode = i > 1 ? orbit_.event(i - 2).closed : orbit_.closed;
  const auto of_force = [](const SequenceEvent& event) { return event.kind == ContactEvent::Kind::open; };
  const auto unit = [&](const SequenceEvent& event) {
    return of_force(event) ? dynamics.force_scale(event.contact) : dynamics.scales().displacement;
  };
  const Eigen::RowVectorXd of_before =
      model_->flows.of(mode).gradient(before.contact, of_force(before)) / unit(before);
  const Eigen::RowVectorXd of_after =
      model_->flows.of(before.closed).gradient(after.contact, of_force(after)) / unit(after);
  return of_after.dot(of_before) / of_before.squaredNorm();
}

// Where a stop that was pressed lets go, its contact is accelerated by what the force was: x'' = -G lambda, G
// of the stop while those that stay closed hold theirs. A damped one gives it that velocity, G = C / beta.
double ExtendedEquations::ratio_at_release(Eigen::Index i) const {
  const ContactDynamics& dynamics = model_->dynamics;
  const SequenceEvent& opening = orbit_.event(i - 1);
  std::vector<int> held;
  const int j = opening.contact;
  const bool rigid = dynamics.rigid(j);
  for (int k = 0; k < dynamics.contact_count(); ++k) {
    if (opening.closed[static_cast<std::size_t>(k)] && dynamics.rigid(k) == rigid) held.push_back(k);
  }
  const Eigen::MatrixXd& G = dynamics.stops().coupling();
  double own = G(j, j);
  if (!held.empty()) {
    const Eigen::VectorXd felt = G(held, j);
    own -= felt.dot(ldlt_solve(G(held, held), felt));
  }
  if (!rigid) own /= dynamics.structure().relaxation[j];
  return -own * dynamics.force_scale(j) / dynamics.scales().displacement;
}

// Where a length is short of what differences of rows can resolve the row is taken at that length: as with
// dR/dp, the error delays Newton's method and moves no point.
bool ExtendedEquations::divide_rows(const Eigen::VectorXd& x) {
  constexpr std::array<double, 4> kLeast{0.0, 1e-6, 1e-3, 3e-3};  // rad, by the power
  std::vector<Eigen::Index> rows;
  Eigen::VectorXd apart = x;
  for (Eigen::Index i = 1; i < orbit_.count(); ++i) {
    const int power = divided(x, i);
    if (power == 0) continue;
    const double least = kLeast.at(static_cast<std::size_t>(power));
    const Eigen::Index row = orbit_.states() + i;
    rows.push_back(row);
    const double length = x[row] - x[row - 1];
    if (std::abs(length) < least) apart[row] = x[row - 1] + std::copysign(least, length);
  }
  if (rows.empty()) return true;
  std::unique_ptr<OrbitEquations> beside;
  if (apart != x) {
    beside = evaluated(*model_, apart);
    if (!beside) return false;
  }
  const OrbitEquations& there = beside ? *beside : *equations_;
  const Eigen::VectorXd factors = state_factors(*model_);
  Eigen::MatrixXd J = there.jacobian();
  J.leftCols(factors.size()) *= factors.asDiagonal();
  for (const Eigen::Index row : rows) {
    const Eigen::Index i = row - orbit_.states();
    const int power = divided(apart, i);
    const double length = apart[row] - apart[row - 1];
    const double time = length / frequency();
    const bool released = power > 1 && orbit_.event(i - 1).kind == ContactEvent::Kind::open;
    const double taken = power == 3 ? 0.5 * time * time : time;
    const double ratio = released ? taken * ratio_at_release(i) : ratio_of_rows(i);
    const double divisor =
        std::pow(length, power) / share_of_unit(orbit_.event(i - 1), orbit_.event(i), model_->dynamics);
    const double slope = power * divided_difference(there, *model_, apart, i) / length;
    jacobian_.row(row).head(size()) = (J.row(row) - ratio * J.row(row - 1)) / divisor;
    jacobian_(row, row) -= slope;
    jacobian_(row, row - 1) += slope;
  }
  return true;
}

void ExtendedEquations::settle(Eigen::VectorXd& x) {
  if (!x.allFinite()) return;
  try {
    const auto model = family_.model(x[size()] * family_.units().parameter);
    if (model->dynamics.states() != orbit_.states()) return;
    if (std::ranges::none_of(orbit_.events, [&](const SequenceEvent& event) {
          return event.kind == ContactEvent::Kind::close && model->dynamics.rigid(event.contact) &&
                 model->dynamics.restitution(event.contact) > 0.0;
        }))
      return;
    orbit_.events = events_of(orbit_, model->dynamics);
    if (const auto phases = event_instants(*model, orbit_, family_.units(), x))
      x.segment(orbit_.states(), orbit_.count()) = *phases;
  } catch (const std::runtime_error&) {  // no flow of a mode: the evaluation fails likewise
  }
}

bool ExtendedEquations::take(const Eigen::VectorXd& x, bool derivatives) {
  if (!x.allFinite()) return false;
  try {
    const auto model = family_.model(x[x.size() - 1] * family_.units().parameter);
    auto equations = evaluated(*model, x, derivatives);
    if (!equations) return false;
    model_ = model;
    equations_ = std::move(equations);
  } catch (const std::runtime_error&) {  // no flow of a mode
    return false;
  }
  orbit_.x = x;
  orbit_.events = events_of(orbit_, model_->dynamics);
  residual_ = residual_of(*equations_, *model_, x);
  return residual_.allFinite();
}

bool ExtendedEquations::evaluate_motion(const Eigen::VectorXd& x) { return take(x, false); }

// Guards and what lies hidden on a step are looked for by motions alone, and come back to its end.
bool ExtendedEquations::evaluate(const Eigen::VectorXd& x) {
  if (whole_.x.size() == x.size() && whole_.x == x) {
    orbit_.x = x;
    orbit_.events = whole_.events;
    residual_ = whole_.residual;
    model_ = whole_.model;
    equations_ = whole_.equations;
    return true;
  }
  whole_.x.resize(0);
  if (!take(x, true)) return false;
  const Eigen::VectorXd factors = state_factors(*model_);
  const Eigen::Index states = factors.size();
  auto square = jacobian_.leftCols(size());
  square = equations_->jacobian();
  square.leftCols(states) *= factors.asDiagonal();
  square.topRows(states).array().colwise() /= factors.array();
  if (!divide_rows(x)) return false;
  whole_ = {.x = x, .residual = residual_, .events = orbit_.events, .model = model_, .equations = equations_};
  return true;
}

Eigen::VectorXd ExtendedEquations::residual_beside(double step) const {
  Eigen::VectorXd beside = orbit_.x;
  beside[size()] += step;
  try {
    const auto model = family_.model(beside[size()] * family_.units().parameter);
    if (const auto equations = evaluated(*model, beside, false))
      return residual_of(*equations, *model, beside);
  } catch (const std::runtime_error&) {  // no scene, or no flow of a mode
  }
  return Eigen::VectorXd::Constant(size(), std::numeric_limits<double>::quiet_NaN());
}

const Eigen::MatrixXd& ExtendedEquations::jacobian() {
  constexpr double kNear = 1e-6;  // in units of the curve
  if (column_at_.size() == orbit_.x.size() && (column_at_ - orbit_.x).lpNorm<Eigen::Infinity>() < kNear)
    return jacobian_;
  jacobian_.col(size()) = (residual_beside(kDifference) - residual_) / kDifference;
  if (jacobian_.col(size()).allFinite()) column_at_ = orbit_.x;
  return jacobian_;
}

Eigen::MatrixXd ExtendedEquations::accurate_jacobian() const {
  constexpr double kStep = 1e-4;  // in units of the curve
  constexpr std::array<std::pair<double, double>, 4> kWeights{
      {{1.0, 8.0}, {-1.0, -8.0}, {2.0, -1.0}, {-2.0, 1.0}}};
  Eigen::MatrixXd J = jacobian_;
  J.col(size()).setZero();
  for (const auto& [steps, weight] : kWeights)
    J.col(size()) += weight / (12.0 * kStep) * residual_beside(steps * kStep);
  return J;
}

Eigen::MatrixXd ExtendedEquations::conditions() const {
  if (family_.driven() || orbit_.count() == 0) return Eigen::MatrixXd(0, size() + 1);
  return Eigen::RowVectorXd::Unit(size() + 1, orbit_.states());
}

Eigen::VectorXd ExtendedEquations::state_at(double phase) const {
  State state;
  arc(orbit_.passed(phase)).state(time_of(phase), state);
  Eigen::VectorXd y(orbit_.states());
  y << state.u / family_.units().displacement, state.v / family_.units().velocity;
  return y;
}

Eigen::MatrixXd ExtendedEquations::monodromy() const {
  const Eigen::MatrixXd M = equations_->monodromy();
  if (M.size() == 0) return M;
  const Eigen::VectorXd factors = state_factors(*model_);
  return factors.cwiseInverse().asDiagonal() * M * factors.asDiagonal();
}

}  // namespace signorini
