#pragma once
// Whether branches consist of orbits of their scene.

#include <gtest/gtest.h>

#include <memory>

#include "methods/orbit/continuation/branch.hpp"
#include "methods/orbit/exact_orbit.hpp"

namespace signorini::test {

/// Every end has its reason, no motion passes a stop by more than 1e-9, and every third point within a branch
/// is polished, which finds its own way, to an orbit of the scene; but that a polish refuses impacts that
/// nearly graze. \return how many were polished
inline int expect_orbits_of(const Problem& problem, const BranchDiagram& diagram) {
  int compared = 0;
  EXPECT_FALSE(diagram.branches.empty());
  for (const Branch& branch : diagram.branches) {
    EXPECT_FALSE(branch.began.empty() || branch.ended.empty());
    EXPECT_NE(branch.ended, "the corrector fails") << branch.sequence;
    for (const BranchPoint& point : branch.points) {
      for (std::size_t j = 0; j < problem.contacts.size(); ++j)
        EXPECT_LE(point.x_max[j] - problem.contacts[j].gap, 1e-9)
            << branch.sequence << " at " << point.parameter << ", " << branch.ended;
    }
    for (std::size_t i = 1; i + 1 < branch.points.size(); i += 3, ++compared) {
      Problem at = with_subharmonic(problem, branch.points[i].order);
      at.frequency = branch.points[i].parameter;
      const ExactOrbit orbit = polish_sequence(std::make_shared<OrbitModel>(at), branch.points[i].orbit);
      EXPECT_TRUE(orbit.certified() || orbit.outcome == OrbitOutcome::grazing)
          << branch.sequence << " at " << at.frequency << ": " << orbit.reason;
    }
  }
  return compared;
}

}  // namespace signorini::test
