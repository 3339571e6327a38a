#include <algorithm>

#include "methods/flow/stretch.hpp"
#include "methods/solvers/constants.hpp"

namespace signorini {

ClosedFormStretch::ClosedFormStretch(LinearFlows& flows, double tolerance)
    : Stretch(event_noise(tolerance)), flows_(flows) {}

void ClosedFormStretch::start(const ContactMode&, const FlowState& flow, double end, bool dense) {
  constexpr double kSteps = 8.0, kDenseSteps = 16.0;  // per fastest period
  begin_ = end_ = flow.time;
  stop_ = end;
  arc_.reset();
  flows_.bound_memory();
  arc_ = flows_.of(flow.closed).arc();
  arc_->start(flow.time, flow.state);
  angle_ = kTwoPi / (dense ? kDenseSteps : kSteps);
  // Interpolation between nodes meets the derivatives of a mode up to the highest that is kept.
  terms_ = dense ? arc_->fading_rates(noise(), angle_, kNodeOrder) : arc_->fading_rates(noise());
}

void ClosedFormStretch::step() {
  begin_ = end_;
  end_ = std::min(stop_, begin_ + angle_ / fastest_left(terms_, begin_));
}

Guard ClosedFormStretch::guard(int contact, double time) const {
  const bool closed = arc_->mode().closed(contact);
  const auto output = [&](int order) {
    return closed ? arc_->force(contact, time, order) : arc_->displacement(contact, time, order);
  };
  return guard_of(flows_.dynamics(), contact, closed, output(0), output(1));
}

std::vector<Guard> ClosedFormStretch::guards(double time) const {
  const int contacts = flows_.dynamics().contact_count();
  const Eigen::MatrixXd outputs = arc_->outputs_at(time, 1);
  std::vector<Guard> all;
  Eigen::Index force = contacts;  // row of the next one
  for (int j = 0; j < contacts; ++j) {
    const bool closed = arc_->mode().closed(j);
    const Eigen::Index row = closed ? force++ : j;
    all.push_back(guard_of(flows_.dynamics(), j, closed, outputs(row, 0), outputs(row, 1)));
  }
  return all;
}

FlowNode ClosedFormStretch::node(double time) const {
  const int contacts = flows_.dynamics().contact_count();
  const Eigen::MatrixXd outputs = arc_->outputs_at(time, kNodeOrder);
  FlowNode node{
      .time = time, .x = outputs.topRows(contacts), .lambda = Eigen::MatrixXd::Zero(contacts, kNodeOrder)};
  for (std::size_t c = 0; c < arc_->mode().active.size(); ++c)
    node.lambda.row(arc_->mode().active[c]) =
        outputs.row(contacts + static_cast<Eigen::Index>(c)).head(kNodeOrder);
  return node;
}

}  // namespace signorini
