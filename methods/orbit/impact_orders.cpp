#include "methods/orbit/impact_orders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "problems/linear_algebra/general_eigen.hpp"

namespace signorini {

namespace {

constexpr std::size_t kMostOrders = 128, kMostPermuted = 5;
constexpr double kSame = 1e-9;  // of maps, of multipliers at 1 and of instants: rounding

using Order = std::vector<std::size_t>;

// Where in the sequence the events of one instant begin and end, of each with several.
std::vector<std::pair<std::size_t, std::size_t>> instants_of(const std::vector<double>& phases) {
  std::vector<std::pair<std::size_t, std::size_t>> instants;
  for (std::size_t i = 0; i < phases.size();) {
    std::size_t end = i + 1;
    while (end < phases.size() && phases[end] - phases[end - 1] <= kOneInstant) ++end;
    if (end > i + 1) instants.emplace_back(i, end);
    i = end;
  }
  return instants;
}

std::vector<double> phases_of(const ContactDynamics& dynamics, const OrbitGuess& orbit) {
  std::vector<double> phases;
  for (const SequenceEvent& event : orbit.events)
    phases.push_back((event.time - orbit.start.time) * dynamics.structure().frequency);
  return phases;
}

// Whether the order of two events of one instant makes another sequence.
bool exchanges(const FlowStructure& structure, const SequenceEvent& a, const SequenceEvent& b, bool all) {
  if (a.contact == b.contact || a.pushed.empty() || b.pushed.empty()) return false;
  const ImpactCoupling coupling = coupling_of(structure, a, b);
  return coupling == ImpactCoupling::dampers || (all && coupling == ImpactCoupling::none);
}

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

// Of the events of one instant those that exchange with another, and the pairs of them.
struct Exchanges {
  Order moved;
  Pairs pairs;  // the first one before the second
};

Exchanges exchanges_of(const FlowStructure& structure, std::span<const SequenceEvent> events, bool all) {
  Exchanges found;
  for (std::size_t i = 0; i < events.size(); ++i) {
    bool moves = false;
    for (std::size_t k = 0; k < events.size(); ++k) {
      if (k == i || !exchanges(structure, events[i], events[k], all)) continue;
      moves = true;
      if (k > i) found.pairs.emplace_back(i, k);
    }
    if (moves) found.moved.push_back(i);
  }
  return found;
}

// The orders of the events of one instant that differ in which of two that exchange is first.
std::vector<Order> orders_of_instant(const FlowStructure& structure, std::span<const SequenceEvent> events,
                                     bool all) {
  const std::size_t n = events.size();
  auto [moved, pairs] = exchanges_of(structure, events, all);
  if (moved.size() > kMostPermuted) return {};
  std::vector<Order> orders;
  std::vector<std::vector<bool>> known;  // of each pair whether it is as given
  const Order places = moved;
  do {
    Order order(n), place(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = 0; i < moved.size(); ++i) order[places[i]] = moved[i];
    for (std::size_t i = 0; i < n; ++i) place[order[i]] = i;
    std::vector<bool> as_given;
    for (const auto& [a, b] : pairs) as_given.push_back(place[a] < place[b]);
    if (std::ranges::find(known, as_given) != known.end()) continue;
    known.push_back(std::move(as_given));
    orders.push_back(std::move(order));
  } while (std::ranges::next_permutation(moved).found);
  return orders;
}

// The linear part of the period map of one order.
struct Part {
  ImpactOrder order;
  Eigen::VectorXcd values;
  bool expands = false;
};

// Whether a neighbour along d, or along -d, meets the stops in the order of the events.
bool keeps_order(const Eigen::VectorXd& instants, const Pairs& pairs) {
  const double least = kSame * instants.lpNorm<Eigen::Infinity>();
  const auto holds = [&](double sign) {
    return std::ranges::all_of(pairs, [&](const auto& pair) {
      const auto first = static_cast<Eigen::Index>(pair.first),
                 second = static_cast<Eigen::Index>(pair.second);
      return sign * (instants[second] - instants[first]) >= -least;
    });
  };
  return holds(1.0) || holds(-1.0);
}

Part part_of(const FlowStructure& structure, const OrbitGuess& orbit, const std::vector<double>& phases,
             const OrbitEquations& equations) {
  Part part;
  Pairs pairs;  // of all instants
  for (const auto& [begin, end] : instants_of(phases)) {
    const Exchanges here =
        exchanges_of(structure, std::span(orbit.events).subspan(begin, end - begin), false);
    for (const auto& [i, k] : here.pairs) pairs.emplace_back(begin + i, begin + k);
    std::vector<int> contacts;
    for (const std::size_t i : here.moved)
      contacts.push_back(structure.scene_contact(orbit.events[begin + i].contact));
    if (!contacts.empty()) part.order.contacts.push_back(std::move(contacts));
  }
  const GeneralEigen eigen = general_eigen(equations.monodromy());
  const Eigen::MatrixXd instants = equations.instants_by_state();
  if (!eigen.converged || instants.size() == 0) return part;
  part.values = eigen.values;
  part.order.largest = eigen.values.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < eigen.values.size(); ++i) {
    if (eigen.values[i].imag() != 0.0 || !(eigen.values[i].real() > 1.0 + kSame)) continue;
    if (keeps_order(instants * eigen.vectors.col(i).real(), pairs)) part.expands = true;
  }
  return part;
}

}  // namespace

ImpactCoupling simultaneous_coupling(const ContactDynamics& dynamics, const OrbitGuess& orbit) {
  ImpactCoupling strongest = ImpactCoupling::none;
  if (!dynamics.rigid()) return strongest;
  const std::span events(orbit.events);
  for (std::size_t i = 0; i < events.size(); ++i)
    strongest =
        std::max(strongest, coupling_of(dynamics.structure(), orbit.closed_before(i), events.subspan(i, 1)));
  for (const auto& [begin, end] : instants_of(phases_of(dynamics, orbit))) {
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = begin; k < i; ++k)
        strongest = std::max(strongest, coupling_of(dynamics.structure(), events[k], events[i]));
    }
  }
  return strongest;
}

std::vector<SequenceEvent> reordered(const std::vector<SequenceEvent>& events,
                                     const std::vector<bool>& before, const std::vector<std::size_t>& order) {
  std::vector<SequenceEvent> result;
  std::vector<bool> closed = before;
  for (const std::size_t i : order) {
    const std::vector<bool>& was = i == 0 ? before : events[i - 1].closed;
    for (std::size_t j = 0; j < closed.size(); ++j) {
      if (events[i].closed[j] != was[j]) closed[j] = events[i].closed[j];
    }
    result.push_back(events[i]);
    result.back().closed = closed;
  }
  return result;
}

std::vector<std::vector<std::size_t>> impact_orders(const FlowStructure& structure,
                                                    const std::vector<SequenceEvent>& events,
                                                    const std::vector<double>& phases, bool all) {
  Order given(events.size());
  std::iota(given.begin(), given.end(), std::size_t{0});
  std::vector<Order> orders{given};
  for (const auto& [begin, end] : instants_of(phases)) {
    const std::vector<Order> here =
        orders_of_instant(structure, std::span(events).subspan(begin, end - begin), all);
    if (here.empty() || orders.size() * here.size() > kMostOrders) return {};
    std::vector<Order> product;
    for (const Order& order : orders) {
      for (const Order& one : here) {
        product.push_back(order);
        for (std::size_t i = 0; i < one.size(); ++i) product.back()[begin + i] = begin + one[i];
      }
    }
    orders = std::move(product);
  }
  return orders;
}

OrbitMultipliers multipliers_of_orbit(OrbitModel& model, const OrbitGuess& orbit,
                                      const OrbitEquations& equations, const Expired& expired) {
  const FlowStructure& structure = model.dynamics.structure();
  OrbitMultipliers result;
  const Eigen::MatrixXd given = equations.monodromy();
  const ImpactCoupling coupling = simultaneous_coupling(model.dynamics, orbit);
  if (coupling == ImpactCoupling::mass) return {.undefined = kDependsOnOrder};
  if (given.size() == 0 || !given.allFinite()) return result;
  if (coupling == ImpactCoupling::none) return {.values = general_eigenvalues(given)};
  const std::vector<double> phases = phases_of(model.dynamics, orbit);
  const auto orders = impact_orders(structure, orbit.events, phases, false);
  if (orders.empty()) return {.undefined = kDependsOnOrder};
  bool same = true;
  std::optional<Part> expanding;
  for (const Order& order : orders) {
    OrbitGuess other = orbit;
    other.events = reordered(orbit.events, orbit.start.closed, order);
    OrbitEquations there(model, other, expired);
    if (!there.evaluate(there.guess())) return {.undefined = kDependsOnOrder};
    const Eigen::MatrixXd monodromy = there.monodromy();
    if (monodromy.size() == 0) return {.undefined = kDependsOnOrder};
    same = same && (monodromy - given).norm() <= kSame * given.norm();
    Part part = part_of(structure, other, phases, there);
    if (part.values.size() == 0) return {.undefined = kDependsOnOrder};
    result.orders.push_back(part.order);
    if (part.expands && (!expanding || part.order.largest > expanding->order.largest))
      expanding = std::move(part);
  }
  if (same) return {.values = general_eigenvalues(given)};
  if (expanding)
    result.values = expanding->values;
  else
    result.undefined = kDependsOnOrder;
  return result;
}

std::string describe_orders(const OrbitMultipliers& multipliers) {
  std::string text = multipliers.undefined;
  for (const ImpactOrder& order : multipliers.orders) {
    const bool first = &order == &multipliers.orders.front();
    std::string contacts;
    for (const std::vector<int>& instant : order.contacts) {
      if (!contacts.empty()) contacts += ',';
      for (const int contact : instant) contacts += (contacts.empty() ? "" : " ") + std::to_string(contact);
    }
    text += fmt::format("{}{:.6g} ({}{})", first ? "; largest multiplier " : ", ", order.largest,
                        first ? "contacts " : "", contacts);
  }
  return text;
}

}  // namespace signorini
