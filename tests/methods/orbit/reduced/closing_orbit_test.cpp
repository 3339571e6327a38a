#include "methods/orbit/reduced/closing_orbit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "methods/discretisation/trajectories.hpp"
#include "methods/linear_flow/linear_flow.hpp"
#include "methods/marching/periodic_march.hpp"
#include "methods/orbit/reduced/corrected_orbit.hpp"
#include "methods/orbit/reduced/reduced_orbit.hpp"
#include "problems/linear_algebra/general_eigen.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::closing_orbit_test {
namespace {

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

// Displacements, speeds and forces of all contacts.
void expect_same_motion(const ExactOrbit& few, const ExactOrbit& all) {
  ASSERT_TRUE(few.certified()) << few.reason;
  ASSERT_TRUE(all.certified()) << all.reason;
  const Samples a = few.trajectory->sample(500), b = all.trajectory->sample(500);
  EXPECT_LT(difference(a.x, b.x), 1e-10);
  EXPECT_LT(difference(a.velocity, b.velocity), 1e-7);
  EXPECT_LT(difference(a.force, b.force), 1e-7);
}

// A small block above a pad of two rows of nodes on one side, of which those near its end close, no two at
// once.
Problem long_pad(const ProportionalDamping& damping) {
  return test::padded_block_problem(
      {.elements = {12, 3, 3}, .patch = {{{0.5, 2.0}, {0.0, 0.2}}}, .damping = damping});
}

struct Damped : testing::TestWithParam<ProportionalDamping> {};

// With the equations of all contacts, displacements, speeds and forces are the same at every contact, those
// that stay open included: contacts relax with the first damping, follow statically with the second.
TEST_P(Damped, AnOrbitOfThoseThatCloseIsThatOfAllContacts) {
  const Problem block = long_pad(GetParam());
  const ContactSpace space(block);
  const ReducedOrbit found = find_reduced_orbit(block, space, {});
  ASSERT_TRUE(found.corrected.orbit.certified()) << found.corrected.orbit.reason;
  const ExactTrajectory& orbit = *found.corrected.orbit.trajectory;
  std::vector<int> closing = pushing_contacts(orbit);
  EXPECT_EQ(closing, orbit.acting_contacts());
  ASSERT_FALSE(closing.empty());
  ASSERT_LT(2 * static_cast<int>(closing.size()), block.contact_count());

  const CondensedStructure structure = condensed(space.small());
  const OrbitSearch few = find_closing_orbit(block, structure, closing, orbit, {});
  const OrbitSearch all = OrbitFinder(block, structure).find(orbit);
  ASSERT_NO_FATAL_FAILURE(expect_same_motion(few.orbit, all.orbit));
  EXPECT_LT(difference(few.orbit.trajectory->force_spectrum(20).cwiseAbs(),
                       all.orbit.trajectory->force_spectrum(20).cwiseAbs()),
            1e-9);
  EXPECT_NEAR(largest_magnitude(few.orbit.multipliers.values),
              largest_magnitude(all.orbit.multipliers.values), 1e-8);
  EXPECT_EQ(few.orbit.trajectory->events()->size(), all.orbit.trajectory->events()->size());
}

// Without one of the contacts that close the orbit passes its stop; it joins.
TEST_P(Damped, ContactsThatPassTheirStopsJoin) {
  const Problem block = long_pad(GetParam());
  const ContactSpace space(block);
  const ReducedOrbit found = find_reduced_orbit(block, space, {});
  ASSERT_TRUE(found.corrected.orbit.certified()) << found.corrected.orbit.reason;
  const ExactTrajectory& orbit = *found.corrected.orbit.trajectory;
  const std::vector<int> all = pushing_contacts(orbit);
  ASSERT_GT(all.size(), 1U);
  std::vector<int> closing(all.begin(), all.end() - 1);
  const CondensedStructure structure = condensed(space.small());
  const OrbitSearch joined = find_closing_orbit(block, structure, closing, orbit, {});
  ASSERT_TRUE(joined.orbit.certified()) << joined.orbit.reason;
  EXPECT_TRUE(std::ranges::includes(closing, all));  // others may pass their stops meanwhile
  EXPECT_GT(joined.attempts, 1);
  const OrbitSearch whole = OrbitFinder(block, structure).find(orbit);
  EXPECT_LT(difference(joined.orbit.trajectory->sample(100).x, whole.orbit.trajectory->sample(100).x), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(ClosingOrbit, Damped,
                         testing::Values(ProportionalDamping{.alpha = 0.02, .beta = 0.1},
                                         ProportionalDamping{.alpha = 0.02, .beta = 0.0}));

// By complex modes and by exponentials, and each derivative against differences of the one before: of a
// motion with two contacts closed and the load's waves.
TEST_P(Damped, OpenContactsAreLookedAtAlikeByModesAndByExponentials) {
  const Problem block = long_pad(GetParam());
  const ContactSpace space(block, {.small = 12, .whole = 60});
  const CondensedStructure structure = with_open_contacts(
      displaced(space.small(), Eigen::MatrixXcd::Constant(4, block.contact_count(), {1e-3, 2e-3}),
                block.base_frequency()),
      {2, 5, 7});
  const ContactDynamics dynamics(block, structure);
  const int open = block.contact_count() - 3;
  State state = dynamics.at_rest();
  state.u.setLinSpaced(0.01, 0.02);
  state.v.setLinSpaced(-0.03, 0.01);
  const ContactMode mode = dynamics.mode({false, true, true});
  const auto modal = linear_flow(dynamics, mode),
             exponential = linear_flow(dynamics, mode, FlowForm::exponential);
  const auto a = modal->arc(), b = exponential->arc();
  a->start(0.5, state);
  b->start(0.5, state);
  constexpr double kStep = 1e-4;
  const std::vector<double> times{0.5, 1.5, 4.0 - kStep, 4.0, 4.0 + kStep};
  const auto by_modes = a->open_displacements(times, 2, 0, open);
  const auto by_exponentials = b->open_displacements(times, 2, 0, open);
  for (std::size_t order = 0; order < 3; ++order) {
    ASSERT_EQ(by_modes[order].rows(), open);
    EXPECT_LT(difference(by_modes[order], by_exponentials[order]), 1e-7) << order;
    EXPECT_NEAR(a->displacement(3 + 4, 1.5, static_cast<int>(order)), by_modes[order](4, 1),
                1e-12 * by_modes[order].cwiseAbs().maxCoeff())
        << order;
    if (order == 0) continue;
    const Eigen::VectorXd slope = (by_modes[order - 1].col(4) - by_modes[order - 1].col(2)) / (2.0 * kStep);
    EXPECT_LT(difference(slope, by_modes[order].col(3)), 1e-5) << order;
  }
}

// No contact acts, all are looked at: the motion is the linear one.
TEST(ClosingOrbit, OfContactsThatNeverCloseIsTheLinearMotion) {
  const Problem far = test::padded_block_problem({.elements = {12, 3, 3}, .gap = 1e3});
  const ContactSpace space(far);
  const ReducedOrbit found = find_reduced_orbit(far, space, {});
  ASSERT_TRUE(found.corrected.bar) << found.corrected.refusal << found.corrected.orbit.reason;
  const ExactTrajectory& orbit = *found.corrected.orbit.trajectory;
  EXPECT_TRUE(orbit.acting_contacts().empty());
  EXPECT_EQ(orbit.contact_count(), far.contact_count());
  const OrbitSearch all = OrbitFinder(far, condensed(space.whole())).find(orbit);
  ASSERT_TRUE(all.orbit.certified()) << all.orbit.reason;
  EXPECT_LT(difference(orbit.sample(100).x, all.orbit.trajectory->sample(100).x),
            *found.corrected.bar + 1e-9);
}

// Springs at all nodes of the pad.
TEST(ClosingOrbit, OfSpringsIsThatOfAllContacts) {
  Problem block = test::padded_block_problem(
      {.elements = {12, 3, 3}, .patch = {{{0.9, 2.0}, {0.0, 0.1}}}, .damping = {.alpha = 0.02, .beta = 0.0}});
  block.set_law(Penalty{.stiffness = std::vector<double>(block.contacts.size(), 2e-3)});
  const ContactSpace space(block);
  const CondensedStructure structure = condensed(space.small());
  ContactMarch march(space.small(), march_grid(block, 256));
  const PeriodicMarch marched = march_to_periodic_motion(march);
  const NodalTrajectory motion(block.period(), marched.motion, marched.force);
  std::vector<int> closing = pushing_contacts(motion);
  ASSERT_FALSE(closing.empty());
  ASSERT_LT(static_cast<int>(closing.size()), block.contact_count());
  const OrbitSearch few = find_closing_orbit(block, structure, closing, motion, {});
  const OrbitSearch all = OrbitFinder(block, structure).find(motion);
  expect_same_motion(few.orbit, all.orbit);
}

}  // namespace
}  // namespace signorini::closing_orbit_test
