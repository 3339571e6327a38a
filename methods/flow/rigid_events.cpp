#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "methods/flow/impact_groups.hpp"
#include "methods/flow/stop_events.hpp"
#include "methods/solvers/constants.hpp"
#include "methods/solvers/lcp/lcp.hpp"
#include "problems/linear_algebra/products.hpp"
#include "problems/linear_algebra/sparse/sparse_products.hpp"

namespace signorini {

std::optional<Eigen::VectorXd> newton_impulses(const Eigen::MatrixXd& delassus,
                                               const Eigen::VectorXd& approach,
                                               const Eigen::VectorXd& restitution) {
  // w = -(x'_+ + e max(x'_-, 0)) = G z + q with z = -p.
  const Eigen::VectorXd q = -(approach + restitution.cwiseProduct(approach.cwiseMax(0.0)));
  const auto z = solve_small_lcp(delassus, q, std::vector<bool>(static_cast<std::size_t>(q.size()), false));
  if (!z) return std::nullopt;
  return Eigen::VectorXd(-*z);
}

namespace {

// The damping that a body feels at its contact alone, over its mass there.
double drag_at(const FlowStructure& structure, int contact) {
  const auto jump = structure.velocity_per_impulse.col(contact);
  return jump.dot(sparse_image(structure.damping, jump)) / structure.delassus(contact, contact);
}

}  // namespace

std::optional<double> left_out_by_chatter(const ContactDynamics& dynamics, int contact, double speed,
                                          double acceleration, double jerk) {
  constexpr double kSlowForce = 0.5;  // its rate over that at which impacts fade
  const double e = dynamics.restitution(contact);
  if (!(acceleration > 0.0)) return std::nullopt;
  const double height = 0.5 * speed * speed / acceleration;
  if (e < 1.0) return height * e / (1.0 - e);
  const double fading = drag_at(dynamics.structure(), contact) * acceleration;
  return std::abs(jerk + fading) <= kSlowForce * fading ? std::optional(height) : std::nullopt;
}

// The left side of an event and what the impact law made of it.
struct RigidEvents::Impact {
  std::vector<int> contacts;            // touching
  Eigen::VectorXd approach;             // x'_- of each
  Eigen::VectorXd restitution;          // e of each, 0 where a chatter ends
  Eigen::VectorXd impulse;              // p of each
  std::vector<double> rest_of_chatter;  // [s], of each
  State before;
  Eigen::VectorXd rate;                // (u, xi, v)' on the left side
  Eigen::VectorXd acceleration, jerk;  // u'', u''' there
};

RigidEvents::RigidEvents(const ContactDynamics& dynamics, double tolerance)
    : StopEvents(dynamics),
      tolerance_(tolerance),
      touch_(event_noise(tolerance) * dynamics.scales().displacement),
      rest_(event_noise(tolerance) * dynamics.scales().velocity),
      weightless_(std::max(0.01 * tolerance, 1024.0 * kEpsilon) * dynamics.scales().acceleration) {
  if (dynamics.stops().mixed()) giving_.emplace(dynamics, tolerance);
}

// How long the impacts after one of speed v last, if they are carried to their limit at once; else empty.
std::optional<double> RigidEvents::rest_of_chatter(int contact, double v, double a, double jerk) const {
  const MotionScales& scales = dynamics_.scales();
  const double e = dynamics_.restitution(contact);
  const bool geometric = e > 0.0 && e < 1.0 && a > 0.0;
  const double rest = geometric ? 2.0 * e * v / (a * (1.0 - e)) : 0.0;
  if (v <= tolerance_ * scales.velocity || e == 0.0) return rest;
  if (e == 1.0 && a > 0.0) {
    constexpr double kManyFlights = 128.0, kAnyway = 0.1;
    const bool many = 0.75 * a > kManyFlights * drag_at(dynamics_.structure(), contact) * v;
    const auto height = left_out_by_chatter(dynamics_, contact, v, a, jerk);
    const bool faded = height && *height <= (many ? 1.0 : kAnyway) * kFadedHeight * scales.displacement;
    return faded ? std::optional(0.0) : std::nullopt;
  }
  if (!geometric) return std::nullopt;
  if (std::abs(jerk) * rest > 0.5 * a) return std::nullopt;  // the force may vanish before the limit
  const double displaced = 0.5 * v * rest;
  const double flight_height = 0.5 * e * e * v * v / a;
  const bool unseen = displaced <= 0.1 * tolerance_ * scales.displacement ||
                      flight_height <= 1024.0 * kEpsilon * scales.displacement;
  return unseen ? std::optional(rest) : std::nullopt;
}

void RigidEvents::collide(FlowState& flow, Impact& impact) const {
  const auto count = static_cast<Eigen::Index>(impact.contacts.size());
  impact.restitution.resize(count);
  for (Eigen::Index i = 0; i < count; ++i)
    impact.restitution[i] = dynamics_.restitution(impact.contacts[static_cast<std::size_t>(i)]);
  impact.impulse = Eigen::VectorXd::Zero(count);
  impact.rest_of_chatter.assign(impact.contacts.size(), 0.0);
  if (count == 0 || impact.approach.maxCoeff() <= rest_) return;

  for (Eigen::Index i = 0; i < count; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const auto w = dynamics_.structure().directions.col(impact.contacts[index]);
    const double v = impact.approach[i];
    if (v <= 0.0) continue;
    const auto rest =
        rest_of_chatter(impact.contacts[index], v, w.dot(impact.acceleration), w.dot(impact.jerk));
    if (!rest) continue;
    impact.restitution[i] = 0.0;
    impact.rest_of_chatter[index] = *rest;
  }
  const auto impulses =
      newton_impulses(block_of(dynamics_.structure().delassus, impact.contacts, impact.contacts),
                      impact.approach, impact.restitution);
  if (!impulses) throw FlowError("no impulses satisfy the impact law: the stops depend on each other");
  impact.impulse = *impulses;
  flow.state.v +=
      image_by_columns(dynamics_.structure().velocity_per_impulse, impact.contacts, impact.impulse);
}

// The events of one instant: an impulse belongs to the closing that it ends in, unless the end of a chatter
// comes between them.
void RigidEvents::log(const Impact& impact, const FlowState& before, const std::vector<bool>& closed,
                      FlowRecord& record) const {
  using Kind = ContactEvent::Kind;
  for (std::size_t i = 0; i < impact.contacts.size(); ++i) {
    const int j = impact.contacts[i];
    const bool was = before.closed[static_cast<std::size_t>(j)], is = closed[static_cast<std::size_t>(j)];
    const double impulse = std::min(0.0, impact.impulse[static_cast<Eigen::Index>(i)]);
    const double rest = impact.rest_of_chatter[i];
    const bool closes = is && !was, at_once = closes && rest == 0.0;
    if (impulse < 0.0 && !at_once)
      record.events.push_back({.kind = Kind::impact, .contact = j, .time = before.time, .impulse = impulse});
    if (was == is) continue;
    record.events.push_back({.kind = closes ? Kind::close : Kind::open,
                             .contact = j,
                             .time = before.time + (closes ? rest : 0.0),
                             .impulse = at_once ? impulse : 0.0});
  }
}

// The entries of the sequence that they are: one for each group of contacts that feel each other's impulses,
// named by the contact that triggers it or, of another group, by the first one that strikes; what else
// changes does so with the trigger.
std::vector<SequenceEvent> RigidEvents::entries(const Impact& impact, const FlowState& before,
                                                const std::vector<bool>& closed, int trigger) const {
  using Kind = ContactEvent::Kind;
  const auto row = [&](int j) { return std::ranges::find(impact.contacts, j) - impact.contacts.begin(); };
  const auto strikes = [&](int j) {
    return impact.approach[row(j)] > rest_ && !before.closed[static_cast<std::size_t>(j)];
  };
  std::vector<int> pushed;
  for (std::size_t i = 0; i < impact.contacts.size(); ++i)
    if (impact.impulse[static_cast<Eigen::Index>(i)] < 0.0) pushed.push_back(impact.contacts[i]);
  std::vector<SequenceEvent> entries{{.contact = trigger, .time = before.time}};
  const auto groups = impact_groups(dynamics_.structure(), pushed);
  for (const std::vector<int>& group : groups) {
    const auto first = std::ranges::find_if(group, strikes);
    const bool own =
        groups.size() == 1 || first == group.end() || std::ranges::find(group, trigger) != group.end();
    if (!own) entries.push_back({.contact = *first, .time = before.time});
    SequenceEvent& entry = own ? entries.front() : entries.back();
    for (const int j : group) {
      entry.pushed.push_back(j);
      const auto at = row(j);
      entry.restitution.push_back(impact.approach[at] > rest_ ? impact.restitution[at] : 0.0);
    }
  }
  std::ranges::sort(entries, {}, &SequenceEvent::contact);
  const auto owner = [&](int j) {
    return std::ranges::find_if(entries, [j](const SequenceEvent& entry) {
      return std::ranges::find(entry.pushed, j) != entry.pushed.end();
    });
  };
  std::vector<bool> now = before.closed;
  for (auto entry = entries.begin(); entry != entries.end(); ++entry) {
    for (int j = 0; j < dynamics_.contact_count(); ++j) {
      const auto of = owner(j);
      if (of == entry || (of == entries.end() && entry->contact == trigger))
        now[static_cast<std::size_t>(j)] = closed[static_cast<std::size_t>(j)];
    }
    entry->closed = now;
    const auto index = static_cast<std::size_t>(entry->contact);
    if (entry->contact >= 0)
      entry->kind = before.closed[index] ? Kind::open : closed[index] ? Kind::close : Kind::impact;
  }
  return entries;
}

// With the contacts P that took an impulse, x'_+ = -e x'_- there, or at rest where they rested:
// dv+/dv- = I - M^-1 W_P G_PP^-1 diag(1 + e) W_P^T. The term in n^T is the shift of the instant: a state
// closer to its stop meets it earlier by n^T dy / (n^T F-), and the two sides of the event differ by F+ - R
// F- for that long. Entries of one instant follow one another.
Eigen::MatrixXd RigidEvents::saltation(const Impact& impact, const std::vector<SequenceEvent>& entries,
                                       const FlowState& after, const ContactMode& mode) const {
  const int n = dynamics_.size(), states = dynamics_.states();
  const FlowStructure& structure = dynamics_.structure();
  Eigen::MatrixXd S = Eigen::MatrixXd::Identity(states, states);
  Eigen::VectorXd before = impact.rate, y(states), rate(states);
  y << after.state.u, impact.before.v;
  for (const SequenceEvent& entry : entries) {
    const bool last = &entry == &entries.back();
    Eigen::MatrixXd R = Eigen::MatrixXd::Identity(n, n);
    if (!entry.pushed.empty()) {
      R += product(columns_of(structure.velocity_per_impulse, entry.pushed),
                   structure.impulse_of_velocity(entry.pushed, entry.restitution));
    }
    y.tail(n) = last ? after.state.v : image(R, Eigen::VectorXd(y.tail(n)));
    dynamics_.rate(last ? mode : dynamics_.mode(entry.closed), after.time, y, rate);
    Eigen::MatrixXd one = Eigen::MatrixXd::Identity(states, states);
    one.bottomRightCorner(n, n) = R;
    if (const Eigen::RowVectorXd earlier = earlier_by_state(entry, before); earlier.size() > 0) {
      before.tail(n) = image(R, Eigen::VectorXd(before.tail(n)));
      one += (rate - before) * earlier;
    }
    S = last && entries.size() == 1 ? std::move(one) : product(one, S);
    before = rate;
  }
  if (const ContactMode held = dynamics_.stops().part(mode, true);
      !held.active.empty()) {  // what it holds cannot deviate
    const Eigen::MatrixXd hold =
        product(columns_of(structure.velocity_per_impulse, held.active),
                product_by_transposed(held.response, columns_of(structure.directions, held.active)));
    S.topRows(n) -= product(hold, S.topRows(n));
    S.bottomRows(n) -= product(hold, S.bottomRows(n));
  }
  if (giving_) giving_->admit(mode, S);
  return S;
}

// n^T / (n^T F-) of the contact that triggers an event at which the rates jump; empty where none does.
Eigen::RowVectorXd RigidEvents::earlier_by_state(const SequenceEvent& entry,
                                                 const Eigen::VectorXd& before) const {
  const int n = dynamics_.size(), j = entry.contact;
  if (j < 0) return {};
  const bool rigid = dynamics_.rigid(j);
  const bool halts =
      rigid ? !entry.pushed.empty() : dynamics_.halts(j) && entry.kind == ContactEvent::Kind::close;
  if (!halts) return {};
  const auto w = dynamics_.structure().directions.col(j);
  const double speed = w.dot(before.head(n)) + (rigid ? 0.0 : before[n + j]);
  if (!(speed > rest_)) return {};
  Eigen::RowVectorXd earlier = Eigen::RowVectorXd::Zero(before.size());
  earlier.head(n) = w.transpose() / speed;
  if (!rigid) earlier[n + j] = 1.0 / speed;
  return earlier;
}

void RigidEvents::resolve(FlowState& flow, int trigger, FlowRecord& record) const {
  Impact impact;
  const FlowStructure& structure = dynamics_.structure();
  const int n = dynamics_.size();
  const Eigen::VectorXd gap =
      structure.gaps - image_by_transposed(structure.directions, flow.state.u.head(n));
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    if (!dynamics_.rigid(j)) continue;
    if (flow.closed[static_cast<std::size_t>(j)] || gap[j] <= touch_ || j == trigger)
      impact.contacts.push_back(j);
  }
  const MotionDerivatives left = dynamics_.derivatives(dynamics_.mode(flow.closed), flow.time, flow.state, 3);
  impact.before = flow.state;
  impact.acceleration = left.u.col(2).head(n);
  impact.jerk = left.u.col(3).head(n);
  impact.rate.resize(dynamics_.states());
  impact.rate << left.u.col(1), impact.acceleration;
  impact.approach = image_by_transposed_columns(structure.directions, impact.contacts, flow.state.v);
  collide(flow, impact);

  // Of the contacts at rest those are held that the accelerations press on their stops, or their rates.
  std::vector<bool> resting(flow.closed.size(), false), closed = resting;
  if (giving_) {
    closed = giving_->closed_after(flow, trigger, (impact.impulse.array() < 0.0).any());
    for (int j = 0; j < dynamics_.contact_count(); ++j)
      if (dynamics_.rigid(j)) closed[static_cast<std::size_t>(j)] = false;
  }
  for (const int j : impact.contacts) {
    resting[static_cast<std::size_t>(j)] = std::abs(structure.directions.col(j).dot(flow.state.v)) <= rest_;
  }
  decide(flow.time, flow.state, {{.derivative = 2, .floor = weightless_}, {.derivative = 3, .floor = 0.0}},
         std::move(resting), closed);
  const ContactMode mode = dynamics_.mode(closed);
  hold(flow.state, mode);
  log(impact, flow, closed, record);
  log_changes(flow.closed, closed, flow.time, record);
  const std::vector<SequenceEvent> sequence = entries(impact, flow, closed, trigger);
  if (trigger >= 0) record.sequence.insert(record.sequence.end(), sequence.begin(), sequence.end());
  if (record.tangent) {
    record.order_matters |= coupling_of(structure, flow.closed, sequence) != ImpactCoupling::none;
    flow.closed = closed;
    record.derivative = product(saltation(impact, sequence, flow, mode), record.derivative);
  }
  flow.closed = closed;
}

FlowState RigidEvents::place(double time, const State& state) const {
  const std::vector<bool> open(static_cast<std::size_t>(dynamics_.contact_count()), false);
  FlowState flow{.time = time, .state = state, .closed = open};
  FlowRecord ignored;
  const FlowStructure& structure = dynamics_.structure();
  std::vector<int> rigid;
  for (int j = 0; j < dynamics_.contact_count(); ++j)
    if (dynamics_.rigid(j)) rigid.push_back(j);
  const Eigen::VectorXd gap = entries_of(
      structure.gaps - image_by_transposed(structure.directions, state.u.head(dynamics_.size())), rigid);
  if (gap.size() > 0 && gap.minCoeff() < 0.0) {
    // The nearest displacement in the metric of M: u - M^-1 W z.
    flow.state.u.head(dynamics_.size()) -=
        image_by_columns(structure.velocity_per_impulse, rigid, moving_back(structure.delassus, rigid, gap));
  }
  if (giving_) flow = giving_->place(time, flow.state);
  resolve(flow, -1, ignored);
  return flow;
}

void RigidEvents::hold(State& state, const ContactMode& of_all) const {
  if (const ContactMode mode = dynamics_.stops().part(of_all, true); !mode.active.empty()) {
    const FlowStructure& structure = dynamics_.structure();
    const Eigen::MatrixXd rows = columns_of(structure.directions, mode.active).transpose();
    const Eigen::MatrixXd back =
        product(columns_of(structure.velocity_per_impulse, mode.active), mode.response);
    auto u = state.u.head(dynamics_.size());
    u -= image(back, image(rows, u) - entries_of(structure.gaps, mode.active));
    state.v -= image(back, image(rows, state.v));
  }
  if (giving_) giving_->hold(state, of_all);
}

}  // namespace signorini
