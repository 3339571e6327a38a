#include <algorithm>

#include "methods/flow/stretch.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

ClosedFormStretch::ClosedFormStretch(LinearFlows& flows, double tolerance)
    : Stretch(event_noise(tolerance)), flows_(flows) {}

void ClosedFormStretch::start(const ContactMode&, const FlowState& flow, double end, bool dense) {
  constexpr double kSteps = 8.0, kDenseSteps = 16.0;  // per fastest period
  const FlowStructure& structure = flows_.dynamics().structure();
  begin_ = end_ = flow.time;
  stop_ = end;
  arc_ = flows_.of(flow.closed).arc();
  arc_->start(flow.time, flow.state);
  angle_ = kTwoPi / (dense ? kDenseSteps : kSteps);
  // Interpolation between nodes meets the derivatives of a mode up to the highest that is kept.
  const double longest = angle_ / structure.frequency;
  terms_ = dense ? arc_->fading_rates(noise(), longest, kNodeOrder) : arc_->fading_rates(noise());
}

void ClosedFormStretch::step() {
  begin_ = end_;
  end_ = std::min(stop_, begin_ + angle_ / fastest_left(terms_, begin_));
}

Guard ClosedFormStretch::guard(int contact, double time) const {
  const ContactDynamics& dynamics = flows_.dynamics();
  if (arc_->mode().closed(contact)) {
    const double unit = dynamics.stops().coupling()(contact, contact);
    return {.value = -unit * arc_->force(contact, time), .rate = -unit * arc_->force(contact, time, 1)};
  }
  return {.value = dynamics.structure().gaps[contact] - arc_->displacement(contact, time),
          .rate = -arc_->displacement(contact, time, 1)};
}

std::vector<Guard> ClosedFormStretch::guards(double time) const {
  std::vector<Guard> all;
  for (int j = 0; j < flows_.dynamics().contact_count(); ++j) all.push_back(guard(j, time));
  return all;
}

FlowNode ClosedFormStretch::node(double time, const State&) const {
  const int contacts = flows_.dynamics().contact_count();
  FlowNode node{.time = time,
                .x = Eigen::MatrixXd(contacts, kNodeOrder + 1),
                .lambda = Eigen::MatrixXd(contacts, kNodeOrder)};
  for (int j = 0; j < contacts; ++j) {
    for (int order = 0; order <= kNodeOrder; ++order) node.x(j, order) = arc_->displacement(j, time, order);
    for (int order = 0; order < kNodeOrder; ++order) node.lambda(j, order) = arc_->force(j, time, order);
  }
  return node;
}

}  // namespace signorini
