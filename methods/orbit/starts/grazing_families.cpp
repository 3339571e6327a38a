#include "methods/orbit/starts/grazing_families.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "methods/orbit/family/orbit_section.hpp"
#include "problems/linear_algebra/lu.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

namespace {

// By a number of periods of K passages each, of n K.
std::vector<int> rotated(const std::vector<int>& hits, int by, int touches, int passages) {
  std::vector<int> result;
  for (const int hit : hits) result.push_back((hit + by * touches) % passages);
  std::sort(result.begin(), result.end());
  return result;
}

// The first of its rotations, and no repetition of a shorter pattern.
bool represents_its_class(const std::vector<int>& hits, int touches, int passages) {
  for (int by = 1; by < passages / touches; ++by) {
    const std::vector<int> other = rotated(hits, by, touches, passages);
    if (other < hits || other == hits) return false;
  }
  return true;
}

// Whether an event marks a passage alone.
bool is_passage(const SequenceEvent& event) {
  return event.kind == ContactEvent::Kind::impact && event.pushed.empty();
}

// What follows an impulse at one touch.
struct TouchResponse {
  Eigen::MatrixXd monodromy;      // from the touch, Ns x Ns
  Eigen::VectorXd impulse;        // the state right after a unit impulse, Ns
  Eigen::MatrixXd displacements;  // of all touches until the touch comes again, K x Ns
};

// The other touches as events that push nothing, in the order in which they follow.
SequencedOrbit with_passages(const SequencedOrbit& orbit, const std::vector<GrazingTouch>& touches,
                             std::size_t from) {
  std::vector<PlacedEvent> placed;
  for (std::size_t a = 0; a < touches.size(); ++a) {
    if (a == from) continue;
    const double phase = touches[a].phase - touches[from].phase;
    placed.emplace_back(phase < 0.0 ? phase + orbit.end() : phase,
                        SequenceEvent{.kind = ContactEvent::Kind::impact, .contact = touches[a].contact});
  }
  return with_more(orbit, placed);
}

// The derivative of the displacement at a passage with respect to the state at the section, the instants of
// the orbit's own events before it following by `instants`.
Eigen::RowVectorXd displacement_row(ExtendedEquations& marked, Eigen::Index i,
                                    const Eigen::MatrixXd& instants) {
  const SequencedOrbit& orbit = marked.orbit();
  const Eigen::MatrixXd& J = marked.jacobian();
  Eigen::RowVectorXd row = J.row(orbit.states() + i).head(orbit.states());
  Eigen::Index own = 0;
  for (Eigen::Index l = 0; l < i; ++l) {
    if (!is_passage(orbit.events[static_cast<std::size_t>(l)]))
      row += J(orbit.states() + i, orbit.states() + l) * instants.row(own++);
  }
  return row * marked.model().dynamics.scales().displacement;
}

std::optional<TouchResponse> response_to(OrbitFamily& family, const SequencedOrbit& base,
                                         const std::vector<GrazingTouch>& touches, std::size_t from) {
  ExtendedEquations given(family, base);
  if (!given.evaluate(base.x)) return std::nullopt;
  const SequencedOrbit there = with_section(base, given, touches[from].phase);
  const SequencedOrbit marked = with_passages(there, touches, from);
  ExtendedEquations own(family, there), all(family, marked);
  if (!own.evaluate(there.x) || !all.evaluate(marked.x)) return std::nullopt;
  const ContactDynamics& dynamics = own.model().dynamics;
  const Eigen::Index states = there.states(), n = dynamics.size(), m = there.count();
  const auto count = static_cast<Eigen::Index>(touches.size());
  TouchResponse result{.monodromy = own.monodromy(),
                       .impulse = Eigen::VectorXd::Zero(states),
                       .displacements = Eigen::MatrixXd::Zero(count, states)};
  if (result.monodromy.rows() != states || !result.monodromy.allFinite()) return std::nullopt;
  const FlowStructure& structure = dynamics.structure();
  const int contact = touches[from].contact;
  auto own_displacement = result.displacements.row(static_cast<Eigen::Index>(from));
  result.impulse.tail(n) = structure.velocity_per_impulse.col(contact) / family.units().velocity;
  own_displacement.head(n) = structure.directions.col(contact).transpose() * family.units().displacement;
  if (structure.relaxing() > 0) {  // what pushes a damped stop moves its face at once
    result.impulse.segment(n, structure.relaxing()) =
        structure.displacement_per_impulse(contact) / family.units().displacement;
    own_displacement[n + contact] = family.units().displacement;
  }
  Eigen::MatrixXd instants(m, states);
  if (m > 0) {
    const Eigen::MatrixXd& J = own.jacobian();
    instants = -lu_solve(J.block(states, states, m, m), Eigen::MatrixXd(J.block(states, 0, m, states)));
  }
  std::size_t touch = from;
  for (Eigen::Index i = 0; i < marked.count(); ++i) {
    if (!is_passage(marked.events[static_cast<std::size_t>(i)])) continue;
    touch = (touch + 1) % touches.size();
    result.displacements.row(static_cast<Eigen::Index>(touch)) = displacement_row(all, i, instants);
  }
  return result;
}

}  // namespace

Eigen::MatrixXd grazing_response(OrbitFamily& family, const SequencedOrbit& base,
                                 const std::vector<GrazingTouch>& touches, int periods) {
  constexpr double kNone = 1e-9;     // of the state after the impulses: their displacement vanishes
  constexpr double kUnique = 1e-10;  // of a pivot of I - M^n, in CurveUnits: the state returns by itself
  const auto K = static_cast<int>(touches.size());
  Eigen::MatrixXd C(K * periods, K * periods);
  for (int b = 0; b < K; ++b) {
    const auto response = response_to(family, base, touches, static_cast<std::size_t>(b));
    if (!response) return {};
    const Eigen::MatrixXd& M = response->monodromy;
    Eigen::MatrixXd power = Eigen::MatrixXd::Identity(M.rows(), M.cols());
    for (int k = 0; k < periods; ++k) power = product(power, M);
    const LuFactors lu(Eigen::MatrixXd::Identity(M.rows(), M.cols()) - power);
    if (!(lu.pivots().cwiseAbs().minCoeff() > kUnique)) return {};
    Eigen::VectorXd y = lu.solve(response->impulse);
    for (int k = 0; k < periods; ++k, y = image(M, y)) {
      const Eigen::VectorXd moved = image(response->displacements, y);
      if (k == 0 && !(std::abs(moved[b]) > kNone * response->displacements.row(b).norm() * y.norm()))
        return {};
      for (int a = 0; a < K; ++a) {
        // Touches before b in the period come in the next one.
        const int after = a < b ? k + 1 : k;
        for (int q = 0; q < periods; ++q) C(((q + after) % periods) * K + a, q * K + b) = moved[a];
      }
    }
  }
  return C;
}

std::vector<GrazingFamily> impact_patterns(const Eigen::MatrixXd& response, const Eigen::VectorXd& rates) {
  constexpr double kTouching = -1e-12;  // of the penetration: a passage that just does not strike
  const auto passages = static_cast<int>(response.rows()), touches = static_cast<int>(rates.size());
  std::vector<GrazingFamily> families;
  for (unsigned support = 1; support < (1U << static_cast<unsigned>(passages)); ++support) {
    std::vector<int> hits;
    for (int k = 0; k < passages; ++k) {
      if ((support >> static_cast<unsigned>(k)) & 1U) hits.push_back(k);
    }
    if (!represents_its_class(hits, touches, passages)) continue;
    const Eigen::VectorXd penetration = rates.replicate(passages / touches, 1);
    for (const double side : {1.0, -1.0}) {
      const Eigen::VectorXd J = CompleteLuFactors(response(hits, hits)).solve(side * penetration(hits));
      const Eigen::VectorXd gaps = image_by_columns(response, hits, J) - side * penetration;
      if (!J.allFinite() || !(J.minCoeff() > 0.0) ||
          !(gaps.minCoeff() > kTouching * std::max(1.0, gaps.maxCoeff())))
        continue;
      families.push_back({.periods = passages / touches, .hits = hits, .beyond = side > 0.0, .impulses = J});
    }
  }
  return families;
}

std::optional<std::vector<GrazingFamily>> grazing_families(OrbitFamily& family, const SequencedOrbit& base,
                                                           const std::vector<GrazingTouch>& touches,
                                                           int most_periods) {
  std::vector<GrazingFamily> all;
  Eigen::VectorXd rates(static_cast<Eigen::Index>(touches.size()));
  for (std::size_t a = 0; a < touches.size(); ++a) rates[static_cast<Eigen::Index>(a)] = touches[a].rate;
  for (int n = 1; n <= most_periods && n * static_cast<int>(touches.size()) <= kMostPassages; ++n) {
    const Eigen::MatrixXd response = grazing_response(family, base, touches, n);
    if (response.size() == 0) return std::nullopt;
    for (GrazingFamily& found : impact_patterns(response, rates)) all.push_back(std::move(found));
  }
  return all;
}

}  // namespace signorini
