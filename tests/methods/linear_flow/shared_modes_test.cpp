// Flows with modes that another scene has found, against flows of their own.

#include "methods/linear_flow/shared_modes.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <stdexcept>

#include "tests/support/exact_scenes.hpp"

namespace signorini::shared_modes_test {
namespace {

const std::vector<bool> kOpen{false, false, false}, kClosed{false, false, true};

// The largest difference of two motions from one state after 1.3 s, over the state.
double difference(const LinearFlow& a, const LinearFlow& b) {
  const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(a.size(), -1.0, 2.0);
  Eigen::VectorXd ends[2];
  for (int k = 0; k < 2; ++k) {
    const auto arc = (k == 0 ? a : b).arc();
    State end;
    arc->start(0.4, {.u = u, .v = -u});
    arc->state(1.7, end);
    ends[k].resize(2 * u.size());
    ends[k] << end.u, end.v;
  }
  return (ends[0] - ends[1]).norm() / ends[1].norm();
}

// How often modes are found for a chain of three masses, its last contact open and closed, then for the same
// with a change; flows of the latter are its own.
long found_after(const std::function<void(Problem&)>& change) {
  const Problem before = test::stopped_chain(3, 0.0, 3);
  Problem after = before;
  change(after);
  const auto shared = std::make_shared<SharedModes>();
  const ContactDynamics first(before), second(after);
  LinearFlows known(first, FlowForm::automatic, shared), with(second, FlowForm::automatic, shared),
      own(second);
  for (const auto& closed : {kOpen, kClosed}) {
    (void)known.of(closed);
    EXPECT_LT(difference(with.of(closed), own.of(closed)), 1e-13);
  }
  return shared->found();
}

TEST(SharedModes, AreFoundOnceWhereTheStructureStays) {
  EXPECT_EQ(found_after([](Problem&) {}), 2);
  EXPECT_EQ(found_after([](Problem& chain) { chain.frequency *= 1.7; }), 2);
  EXPECT_EQ(found_after([](Problem& chain) { chain.force[0].cos *= 3.0; }), 2);
  EXPECT_EQ(found_after([](Problem& chain) { chain.contacts[2].gap += 0.3; }), 2);
}

TEST(SharedModes, ServeASceneAtAnotherFrequency) {
  const Problem chain = test::stopped_chain(3, 0.0, 3);
  Problem faster = chain;
  faster.frequency *= 1.7;
  const auto shared = std::make_shared<SharedModes>();
  const ContactDynamics first(chain), second(first, faster.frequency), apart(faster);
  LinearFlows known(first, FlowForm::automatic, shared), with(second, FlowForm::automatic, shared),
      own(apart);
  for (const auto& closed : {kOpen, kClosed, kOpen}) {
    (void)known.of(closed);
    EXPECT_LT(difference(with.of(closed), own.of(closed)), 1e-13);
  }
  EXPECT_EQ(shared->found(), 2);
}

TEST(SharedModes, AreForFlowsOfSoManyCoordinates) {
  const ContactDynamics three(test::stopped_chain(3, 0.0, 3));
  const auto flow = [&](int most) {
    return linear_flow(three, three.mode(kOpen), FlowForm::automatic, std::make_shared<SharedModes>(most));
  };
  EXPECT_EQ(flow(3)->size(), 3);
  EXPECT_THROW(flow(2), std::runtime_error);
}

// Three coordinates take less than a megabyte: a limit below lets flows and modes go.
TEST(LinearFlows, GoWithTheirModesWhereTheyTakeTooMuchMemory) {
  const ContactDynamics three(test::stopped_chain(3, 0.0, 3));
  const auto shared = std::make_shared<SharedModes>();
  LinearFlows flows(three, FlowForm::automatic, shared);
  (void)flows.of(kOpen);
  flows.bound_memory();
  (void)flows.of(kOpen);
  EXPECT_EQ(shared->found(), 1);
  flows.bound_memory(1.0);
  LinearFlows own(three);
  EXPECT_LT(difference(flows.of(kOpen), own.of(kOpen)), 1e-13);
  EXPECT_EQ(shared->found(), 2);
}

TEST(SharedModes, AreFoundAnewForAnotherStructure) {
  EXPECT_EQ(found_after([](Problem& chain) {
              chain.edit_structure([](Structure& s) { s.stiffness.coeffRef(1, 1) += 1e-9; });
            }),
            4);
  EXPECT_EQ(found_after([](Problem& chain) {
              chain.edit_structure([](Structure& s) { s.damping.coeffRef(0, 0) *= 2.0; });
            }),
            4);
  EXPECT_EQ(found_after([](Problem& chain) {
              chain.edit_structure([](Structure& s) { s.mass.coeffRef(2, 2) *= 2.0; });
            }),
            4);
}

// Over short times all modes are alive, over long ones few.
TEST(TransitionFactors, MultiplyToTheTransition) {
  const Problem chain = test::stopped_chain(3, 0.0, 3);
  const ContactDynamics dynamics(chain);
  LinearFlows flows(dynamics);
  Eigen::Index before = 100;
  for (const double duration : {0.01, 1.0, 30.0, 3000.0}) {
    const LinearFlow& flow = flows.of(kOpen);
    const TransitionFactors factors = flow.transition_factors(duration);
    EXPECT_LT((factors.writing * factors.reading - flow.transition(duration)).norm(), 1e-12);
    EXPECT_LE(factors.writing.cols(), before);
    before = factors.writing.cols();
  }
  EXPECT_LT(before, 6);
}

}  // namespace
}  // namespace signorini::shared_modes_test
