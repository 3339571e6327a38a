#include "methods/harmonic_balance/witness_grids.hpp"

#include <gtest/gtest.h>

#include "tests/support/impact_oscillator.hpp"

namespace signorini {
namespace {

ContactReceptance receptance_of(int harmonics, int contacts) {
  ContactReceptance receptance;
  receptance.receptance.assign(static_cast<std::size_t>(harmonics) + 1,
                               Eigen::MatrixXcd::Identity(contacts, contacts));
  receptance.free_response = Eigen::MatrixXcd::Zero(harmonics + 1, contacts);
  return receptance;
}

TEST(WitnessGrids, CarryTheHarmonicsOnFourNodesEach) {
  EXPECT_TRUE(carries_harmonics(256, receptance_of(64, 1)));
  EXPECT_FALSE(carries_harmonics(256, receptance_of(65, 1)));
  EXPECT_TRUE(carries_harmonics(4096, receptance_of(20, 2)));
  EXPECT_FALSE(carries_harmonics(4096, receptance_of(20, 3)));
}

TEST(WitnessGrids, RiseFromCoarseToFine) {
  const Problem problem = test::to_problem({.frequency = 2.2, .gap = 0.2});
  const std::optional<Resolutions> grids = witness_grids(problem);
  ASSERT_TRUE(grids);
  ASSERT_EQ(grids->count(), 3U);
  EXPECT_EQ(grids->value(0), 256);
  EXPECT_EQ(grids->value(2), 4096);
}

TEST(WitnessGrids, AreNoneForManyContacts) {
  Problem problem = test::to_problem({.frequency = 2.2, .gap = 0.2});
  const Contact contact = problem.contacts.front();
  while (problem.contact_count() <= 32) problem.contacts.push_back(contact);
  EXPECT_FALSE(witness_grids(problem));
}

}  // namespace
}  // namespace signorini
