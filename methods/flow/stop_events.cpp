#include "methods/flow/stop_events.hpp"

#include <algorithm>

#include "methods/solvers/lcp/lcp.hpp"
#include "problems/linear_algebra/products.hpp"

namespace signorini {

void StopEvents::decide(double time, const State& state, const std::vector<Order>& orders,
                        std::vector<bool> undecided, std::vector<bool>& closed) const {
  const FlowStructure& structure = dynamics_.structure();
  const auto first = std::ranges::find(undecided, true) - undecided.begin();
  if (first == dynamics_.contact_count()) return;
  // As all undecided are.
  const bool rigid = dynamics_.rigid(static_cast<int>(first));
  const bool relaxing = structure.relaxes(static_cast<int>(first));
  for (const auto& [order, floor] : orders) {
    std::vector<int> involved;
    std::vector<bool> held;
    for (int j = 0; j < dynamics_.contact_count(); ++j) {
      const auto index = static_cast<std::size_t>(j);
      const bool alike = dynamics_.rigid(j) == rigid && structure.relaxes(j) == relaxing;
      if (!alike || (!closed[index] && !undecided[index])) continue;
      involved.push_back(j);
      held.push_back(closed[index]);
    }
    if (std::find(held.begin(), held.end(), false) == held.end()) return;
    // u^(k) is that of the contacts closed so far: at rigid stops their force is part of it, and z of a held
    // contact only what the ones still to close change about it.
    // Where contacts relax, the derivative of x is known two orders below that of u.
    const MotionDerivatives motion =
        dynamics_.derivatives(dynamics_.mode(closed), time, state, std::max(2, order) + (relaxing ? 2 : 0));
    Eigen::VectorXd gap;
    if (relaxing) {
      gap = -structure.xi_times.cwiseProduct(motion.x.col(order));
    } else {
      gap = -structure.unloaded(time, motion.u.col(order), order);
    }
    if (order == 0) gap += structure.gaps;
    const Eigen::MatrixXd A = dynamics_.stops().coupling()(involved, involved);
    const Eigen::VectorXd q = gap(involved);
    const auto z = solve_small_lcp(A, q, held);
    if (!z) throw FlowError("no contact forces satisfy the contact law: the stops depend on each other");
    const Eigen::VectorXd w = A * *z + q;
    for (std::size_t i = 0; i < involved.size(); ++i) {
      const auto index = static_cast<std::size_t>(involved[i]);
      const auto row = static_cast<Eigen::Index>(i);
      if (held[i]) continue;
      closed[index] = (*z)[row] * A(row, row) > floor;
      undecided[index] = !closed[index] && w[row] <= floor;
    }
  }
}

Eigen::VectorXd StopEvents::moving_back(const Eigen::MatrixXd& A, const std::vector<int>& contacts,
                                        const Eigen::VectorXd& gap) {
  auto z = solve_small_lcp(block_of(A, contacts, contacts), gap, std::vector<bool>(contacts.size(), false));
  if (!z) throw FlowError("no displacement satisfies all gaps");
  return *std::move(z);
}

ContactEvent::Kind StopEvents::change_of(const std::vector<bool>& closed, int contact) {
  return closed[static_cast<std::size_t>(contact)] ? ContactEvent::Kind::close : ContactEvent::Kind::open;
}

void StopEvents::log_changes(const std::vector<bool>& before, const std::vector<bool>& closed, double time,
                             FlowRecord& record) const {
  for (int j = 0; j < dynamics_.contact_count(); ++j) {
    const auto index = static_cast<std::size_t>(j);
    if (!dynamics_.rigid(j) && closed[index] != before[index])
      record.events.push_back({.kind = change_of(closed, j), .contact = j, .time = time});
  }
}

}  // namespace signorini
